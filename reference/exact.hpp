// SPDX-License-Identifier: GPL-3.0-or-later
// The exact value of a raw, and of every operation on exact operands, in no format: rational where
// the result is, otherwise a real of over 300 bits from MPFR. Boost's number types take seconds to
// compile: judge.hpp asks the same questions of raws, without them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include "reference/numbers.hpp"
#include "reference/operation.hpp"

namespace reference {

// The exact number that a raw stands for. Precondition: is_finite(format, raw).
Rational value(const NumberFormat& format, std::int64_t raw);

// Distance between neighbours, 2^-F. Of a float the distance within the binade of `at`.
Rational ulp(const NumberFormat& format, const Rational& at = 1);

// The raw nearest to an exact number, ties toward +infinity (floats: ties to even); a number out of
// range gives the nearest finite raw.
std::int64_t nearest_raw(const NumberFormat& format, const Rational& number);

using Exact = std::variant<Rational, Real>;

// Component `component` of the result: 0 except in sincos and normalise3. Precondition: the
// operands lie in the operation's domain (no zero divisor, no root or logarithm of what has none,
// no vector of length zero normalised). The count of a shift is at most a few hundred.
Exact exact(Operation operation, std::span<const Rational> operands, std::size_t component = 0);

// pi with the precision of a Real.
const Real& pi();

// GSL's opinion in double precision on the functions of one and two operands that it has; it comes
// from code that shares nothing with MPFR.
std::optional<double> second_opinion(Operation operation, std::span<const double> operands);

}  // namespace reference
