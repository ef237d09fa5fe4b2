// SPDX-License-Identifier: GPL-3.0-or-later
// The exact value of a raw, and of every operation on exact operands, in no format: rational if the
// result is, otherwise a real of over 300 bits from MPFR. Boost's number types take seconds to
// compile: judge.hpp offers the same for raws without including them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include "reference/numbers.hpp"
#include "reference/operation.hpp"

namespace reference {

// The exact number that a raw stands for. is_finite(format, raw) must be true.
Rational value(const NumberFormat& format, std::int64_t raw);

// The distance between neighbours: 2^-F; of a float, the distance within the binade of `at`.
Rational ulp(const NumberFormat& format, const Rational& at = 1);

// The raw nearest to an exact number, rounded half up (floats: half to even). A number out of range
// gives the nearest finite raw.
std::int64_t nearest_raw(const NumberFormat& format, const Rational& number);

using Exact = std::variant<Rational, Real>;

// Result number `component`: 0 except for operations with several results. The operands must lie in
// the operation's domain (a divisor is not 0, a root or logarithm exists, a normalised vector is
// not zero). The count of a shift must be at most a few hundred.
Exact exact(Operation operation, std::span<const Rational> operands, std::size_t component = 0);

// pi with the precision of a Real.
const Real& pi();

// The result in double precision by GSL, whose code shares nothing with MPFR; nothing if GSL does
// not have the function.
std::optional<double> second_opinion(Operation operation, std::span<const double> operands);

}  // namespace reference
