// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the programs of driver/ with the user's file, and runs those for the host.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace advise {

// The program fails in a format.
class Failure : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

// Both throw Failure with one line: the compiler's first error.
void compile_for_host(const std::filesystem::path& program, const char* driver,
                      const std::vector<std::string>& options, const std::filesystem::path& output);
void compile_for_chip(const std::filesystem::path& program,
                      const std::vector<std::string>& definitions,
                      const std::filesystem::path& output);

using Words = std::vector<std::string>;

// The lines that a program of the driver prints, as words separated by tabs. Throws
// std::invalid_argument if it crashes or exceeds the time limit.
std::vector<Words> lines_of(const std::filesystem::path& user, std::vector<std::string> command);

}  // namespace advise
