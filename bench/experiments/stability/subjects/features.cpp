// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {

std::vector<Subject> subjects_of_features() {
    using Scalar = fixedpoint::Fixed<16, 16, Recording>;
    return subjects_of_methods<Scalar, SortedPairs, CachedSortedPairs, ThreeDimensions>(
        "q16_16", "nearest", to_double(Scalar::max()), to_double(Scalar::ulp()));
}

}  // namespace stability
