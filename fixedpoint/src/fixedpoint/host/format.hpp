// SPDX-License-Identifier: MIT
/// \file
/// Fixed-point numbers for fmt; format_specification.hpp describes the specification.
#pragma once

#include <fmt/format.h>

#include <fixedpoint/host/format_specification.hpp>

template <int IntegerBits, int F, class A>
class fmt::formatter<fixedpoint::Fixed<IntegerBits, F, A>>
    : public fixedpoint::NumberFormatter<fmt::format_error> {};
