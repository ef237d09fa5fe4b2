// SPDX-License-Identifier: MIT
/// \file
/// std::format of fixed-point numbers, as format_specification.hpp says, where the standard library
/// has it (C++20, __cpp_lib_format); elsewhere nothing.
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
