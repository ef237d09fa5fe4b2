// SPDX-License-Identifier: GPL-3.0-or-later
// The quotients in a program, by its symbols. Each takes hundreds of bytes of flash, and where a
// constant is not folded the compiler links its own without a warning.
#pragma once

#include <regex>
#include <string>
#include <vector>

#include "bench/chip/simulator/elf.hpp"

namespace simulator {

// The compiler's integer quotients: __udivmodhi4, __divdi3, __udivmod64. Its floating-point
// quotients have names that end in sf.
inline constexpr const char* compilers_quotient = "^__u?(div|mod|divmod)([qhsd]i|psi|64)";

// The names of all functions that divide: those of the compiler, and the library's kernels and
// templates.
inline std::vector<std::string> quotients(const Elf& elf) {
    static const std::regex of_compiler(compilers_quotient), of_floats("^__divsf3"),
        of_library("fixedpoint.*(divide|divmod|divrem|remainder)");
    std::vector<std::string> found;
    for (const auto& [name, symbol] : elf.functions())
        for (const std::regex* kind : {&of_compiler, &of_floats, &of_library})
            if (std::regex_search(name, *kind)) found.push_back(name);
    return found;
}

}  // namespace simulator
