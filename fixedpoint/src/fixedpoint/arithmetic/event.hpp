// SPDX-License-Identifier: MIT
/// \file
/// The events that Checked reports to its hook, and the operations in which they happen.
#pragma once

#include <fixedpoint/portable/reported_operations.hpp>

namespace fixedpoint {

/// Why a result is not the exact one, rounded: it is out of range, a divisor is 0, an argument is
/// outside the domain, or a product or quotient other than 0 was rounded to 0.
enum class Event : unsigned char { overflow, division_by_zero, domain_error, underflow };

/// The operation in which an event happened. dot stands for dot2 and dot3, length for length2,
/// length3 and hypot.
enum class Operation : unsigned char { FIXEDPOINT_REPORTED_OPERATIONS(FIXEDPOINT_ENUMERATOR) };

}  // namespace fixedpoint
