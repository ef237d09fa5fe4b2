// SPDX-License-Identifier: GPL-3.0-or-later
// The exact value of every operation on exact operands, in no format: rational where the result
// is, otherwise a real of over 300 bits from MPFR.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include "reference/numbers.hpp"
#include "reference/operation.hpp"

namespace reference {

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
