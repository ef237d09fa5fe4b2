// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {
namespace {

template <class Scalar>
std::vector<Subject> for_chains(const char* scalar, const char* arithmetic, double largest,
                                double ulp) {
    return subjects_of_methods<Scalar, OneIteration, WarmStarted, scenes::Direct, DirectSprings,
                               GaussSeidelSprings, ImplicitMidpoint>(scalar, arithmetic, largest,
                                                                     ulp);
}
template <int I>
std::vector<Subject> in_format(const char* scalar) {
    using Scalar = fixedpoint::Fixed<I, I, Recording>;
    return for_chains<Scalar>(scalar, "nearest", to_double(Scalar::max()),
                              to_double(Scalar::ulp()));
}

}  // namespace

std::vector<Subject> subjects_of_chains() {
    std::vector<Subject> all = in_format<16>("q16_16");
    for (const auto& list :
         {in_format<32>("q32_32"),
          for_chains<float>("float", "ieee", std::numeric_limits<float>::max(), 0)})
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

std::vector<Subject> subjects_of_chains_in_double() {
    return for_chains<double>("double", "ieee", std::numeric_limits<double>::max(), 0);
}

}  // namespace stability
