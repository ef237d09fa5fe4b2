// SPDX-License-Identifier: MIT
// Functions of 113 bits, as the truth for tests of correct rounding, and a result rounded.
#pragma once

#include <cstdint>
#include <fixedpoint/integer.hpp>

__extension__ typedef __float128 Real;

extern "C" {
#define REAL_FUNCTION(name) Real name##f128(Real) noexcept;
REAL_FUNCTION(fabs)
REAL_FUNCTION(floor)
REAL_FUNCTION(sqrt)
REAL_FUNCTION(sin)
REAL_FUNCTION(cos)
REAL_FUNCTION(tan)
REAL_FUNCTION(asin)
REAL_FUNCTION(acos)
REAL_FUNCTION(atan)
REAL_FUNCTION(exp)
REAL_FUNCTION(exp2)
REAL_FUNCTION(expm1)
REAL_FUNCTION(log)
REAL_FUNCTION(log2)
REAL_FUNCTION(log10)
REAL_FUNCTION(log1p)
REAL_FUNCTION(sinh)
REAL_FUNCTION(cosh)
REAL_FUNCTION(tanh)
REAL_FUNCTION(cbrt)
#undef REAL_FUNCTION
Real atan2f128(Real, Real) noexcept;
Real powf128(Real, Real) noexcept;
}
inline Real reciprocal_sqrtf128(Real a) { return 1 / sqrtf128(a); }

// The number of Raw closest to the value, half up.
template <class Raw>
Raw rounded(Real value, int fraction) {
    using fixedpoint::RawLimits;
    const Real nearest = floorf128(value * Real(uint64_t(1) << fraction) + Real(0.5));
    return nearest > Real(RawLimits<Raw>::max)   ? RawLimits<Raw>::max
           : nearest < Real(RawLimits<Raw>::min) ? RawLimits<Raw>::min
                                                 : static_cast<Raw>(static_cast<int64_t>(nearest));
}

// Operands at which a function has a value.
inline bool anywhere(Real) { return true; }
inline bool above_zero(Real a) { return a > 0; }
inline bool above_minus_one(Real a) { return a > -1; }
inline bool to_one(Real a) { return a >= -1 && a <= 1; }
