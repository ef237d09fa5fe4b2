// SPDX-License-Identifier: MIT
/// \file
/// Numbers as Arduino Printables: Serial.println(printable(x)) or, with three decimals,
/// printable(x, 3). The vtable that this needs belongs to the wrapper: numbers stay free of one,
/// and a program that uses print(Serial, x) does not contain it.
#pragma once

#ifdef ARDUINO
#include <Print.h>
// A macro of avr-libc's <stdlib.h>, which the core's header includes: see integer.hpp.
#undef abs

#include <fixedpoint/serial.hpp>

namespace fixedpoint {

/// What printable returns.
template <class Number>
class PrintableNumber : public ::Printable {
  public:
    /// Prints `number` with so many decimals, or shortest.
    constexpr PrintableNumber(Number number, uint8_t decimals)
        : number_(number), decimals_(decimals) {}
    /// Prints as print(out, number, decimals) does, and returns the characters written.
    size_t printTo(::Print& out) const override {
        return decimals_ == shortest ? print(out, number_) : print(out, number_, decimals_);
    }
    /// Instead of a number of decimals: the shortest text that parse reads as the number.
    static constexpr uint8_t shortest = 255;

  private:
    Number number_;
    uint8_t decimals_;
};

/// x for Arduino's print and println, with so many decimals, or as the shortest text that parse
/// reads as x.
template <int IntegerBits, int F, class A>
constexpr PrintableNumber<Fixed<IntegerBits, F, A>> printable(
    Fixed<IntegerBits, F, A> x,
    uint8_t decimals = PrintableNumber<Fixed<IntegerBits, F, A>>::shortest) {
    return {x, decimals};
}

}  // namespace fixedpoint
#endif
