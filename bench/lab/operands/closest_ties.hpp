// SPDX-License-Identifier: GPL-3.0-or-later
// The operands on which correct rounding takes longest: those whose results are closest to a tie.
#pragma once

#include "bench/lab/operands/boundary.hpp"

namespace operands {

// The operands for a correctly rounded function of Q16.16, in addition to its boundary cases; none
// for other subjects.
std::vector<BoundaryCase> closest_ties(const reference::Subject& subject);

}  // namespace operands
