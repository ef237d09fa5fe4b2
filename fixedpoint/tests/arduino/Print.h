// SPDX-License-Identifier: MIT
// What the Arduino core declares of Print and Printable, for tests on the host.
#pragma once

#include <stddef.h>

#include <string>

class Print;

class Printable {
  public:
    virtual size_t printTo(Print& out) const = 0;
};

class Print {
  public:
    std::string characters;

    size_t write(const char* text, size_t length) {
        characters.append(text, length);
        return length;
    }
    size_t print(const Printable& x) { return x.printTo(*this); }
};
