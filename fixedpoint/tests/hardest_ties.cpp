// SPDX-License-Identifier: MIT
// hardest_ties FRACTION_BITS [FUNCTION]: of all numbers of a 32-bit format, those whose results are
// closest to a tie without being one, as the line
//     function operands ties: operand (binary logarithm of the distance in ulp) ...
//
// All are evaluated in double, within 2^-20 ulp; those within 2^-17 ulp of a tie then with 113
// bits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "float128.hpp"

namespace {

struct Tie {
    double distance;
    int32_t operand;

    bool operator<(const Tie& other) const { return distance < other.distance; }
};

struct Interval {
    double first, last;
};

template <class InDouble, class Exact>
void search(std::string_view name, int fraction, Interval interval, InDouble in_double,
            Exact exact) {
    constexpr std::size_t shown = 8, kept = 1 << 16;
    const double one = std::ldexp(1.0, fraction), limit = std::ldexp(1.0, 31);
    const auto first = static_cast<int64_t>(std::max(-limit, std::ceil(interval.first * one)));
    const auto last = static_cast<int64_t>(std::min(limit - 1, std::floor(interval.last * one)));
    std::vector<Tie> closest;
    int ties = 0;
    for (int64_t operand = first; operand <= last; ++operand) {
        const double ulps = in_double(double(operand) / one) * one;
        if (std::fabs(ulps - std::floor(ulps) - 0.5) > 0x1p-17 || std::fabs(ulps) > limit) continue;
        const Real result = exact(Real(operand) / Real(one)) * Real(one);
        const Real distance = fabsf128(result - floorf128(result) - Real(0.5));
        if (distance == 0) {
            ++ties;
            continue;
        }
        closest.push_back({static_cast<double>(distance), static_cast<int32_t>(operand)});
        if (closest.size() < kept) continue;
        std::nth_element(closest.begin(), closest.begin() + shown, closest.end());
        closest.resize(shown);
    }
    std::sort(closest.begin(), closest.end());
    closest.resize(std::min(closest.size(), shown));
    fmt::print("{} {} {}:", name, last - first + 1, ties);
    for (const Tie& tie : closest) fmt::print(" {} ({:.1f})", tie.operand, std::log2(tie.distance));
    fmt::print("\n");
}

}  // namespace

int main(int arguments, char** argument) {
    const int fraction = arguments > 1 ? std::atoi(argument[1]) : -1;
    if (arguments > 3 || fraction < 0 || fraction > 31 ||
        (fraction == 0 && argument[1][0] != '0')) {
        fmt::print(stderr, "usage: hardest_ties FRACTION_BITS [FUNCTION], with 0 to 31 bits\n");
        return 2;
    }
    const std::string_view chosen = arguments > 2 ? argument[2] : "";
    const double ulp = std::ldexp(1.0, -fraction), most = std::ldexp(1.0, 31 - fraction);
    const double log = std::log(most) + ulp, lowest = -(fraction + 2) * M_LN2;
    bool found = false;
#define SEARCH(name, first, last)                                                  \
    if (chosen.empty() || chosen == #name) {                                       \
        found = true;                                                              \
        search(                                                                    \
            #name, fraction, {first, last}, [](double x) { return std::name(x); }, \
            [](Real x) { return name##f128(x); });                                 \
    }
    SEARCH(sin, -most, most)
    SEARCH(cos, -most, most)
    SEARCH(tan, -most, most)
    SEARCH(asin, -1, 1)
    SEARCH(acos, -1, 1)
    SEARCH(atan, -most, most)
    SEARCH(exp, lowest, log)
    SEARCH(exp2, -(fraction + 2.0), 31.0 - fraction)
    SEARCH(expm1, lowest, std::log1p(most))
    SEARCH(log, ulp, most)
    SEARCH(log2, ulp, most)
    SEARCH(log10, ulp, most)
    SEARCH(log1p, -1 + ulp, most)
    SEARCH(sinh, -log - 1, log + 1)
    SEARCH(cosh, -log - 1, log + 1)
    SEARCH(tanh, lowest, -lowest)
    SEARCH(cbrt, -most, most)
#undef SEARCH
    if (!found) fmt::print(stderr, "hardest_ties: unknown function '{}'\n", chosen);
    return found ? 0 : 2;
}
