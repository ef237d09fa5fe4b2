// SPDX-License-Identifier: MIT
/// \file
/// What happens in an operation whose result is not what exact arithmetic would give, and which
/// operation it was: what Checked tells its hook.
#pragma once

namespace fixedpoint {

/// What a hook is told of.
enum class Event : unsigned char { overflow, division_by_zero, domain_error, underflow };

/// The operation that an event happened in; dot is dot2 and dot3, length is length2 and length3.
enum class Operation : unsigned char {
    add,
    subtract,
    negate,
    multiply,
    divide,
    remainder,
    shift_left,
    convert,
    sqrt,
    reciprocal_sqrt,
    log,
    multiply_add,
    dot,
    length,
    scale_down,
    cos,
    atan2,
    exp,
    normalise,
    ceil,
    round,
    from_float,
    from_decimal,
    tan,
    asin,
    acos,
    exp2,
    expm1,
    log2,
    log10,
    log1p,
    sinh,
    cosh,
    tanh,
    cbrt,
    pow,
    lerp,
    power,
};

}  // namespace fixedpoint
