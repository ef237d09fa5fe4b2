// SPDX-License-Identifier: MIT
/// \file
/// Fixed-point numbers for std::format; format_specification.hpp describes the specification. Empty
/// if the standard library does not have std::format (C++20, __cpp_lib_format).
#pragma once

#if __cplusplus >= 202002L
#include <version>
#endif
#ifdef __cpp_lib_format
#include <fixedpoint/host/format_specification.hpp>
#include <format>

template <int IntegerBits, int F, class A>
struct std::formatter<fixedpoint::Fixed<IntegerBits, F, A>, char>
    : fixedpoint::NumberFormatter<std::format_error> {};
#endif
