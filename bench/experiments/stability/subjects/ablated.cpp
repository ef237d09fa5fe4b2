// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {
namespace {

template <class Scalar>
std::vector<Subject> without_a_mend(const char* scalar, const char* arithmetic, double largest,
                                    double ulp) {
    return subjects_of_methods<Scalar, PositionsFirst, WorstContactFirst, OpposedContacts,
                               TangentRods, LateBounces, Impulses>(scalar, arithmetic, largest,
                                                                   ulp);
}

}  // namespace

std::vector<Subject> subjects_of_ablated() {
    using Scalar = fixedpoint::Fixed<16, 16, Recording>;
    const double largest = to_double(Scalar::max()), ulp = to_double(Scalar::ulp());
    return without_a_mend<Scalar>("q16_16", "nearest", largest, ulp);
}

std::vector<Subject> subjects_of_ablated_in_double() {
    return without_a_mend<double>("double", "ieee", std::numeric_limits<double>::max(), 0);
}

}  // namespace stability
