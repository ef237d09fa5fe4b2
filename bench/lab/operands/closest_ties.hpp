// SPDX-License-Identifier: GPL-3.0-or-later
// The operands on which correct rounding takes longest: those whose results lie closest to a tie.
#pragma once

#include "bench/lab/operands/boundary.hpp"

namespace operands {

// Of a correctly rounded function of Q16.16, beside its boundary cases; none of others.
std::vector<BoundaryCase> closest_ties(const reference::Subject& subject);

}  // namespace operands
