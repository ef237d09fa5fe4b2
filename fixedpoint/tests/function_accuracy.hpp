// SPDX-License-Identifier: MIT
// What the tests of functions share: the exact result's type, the distance from it in ulp, and
// operands worth testing.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <fixedpoint/integer.hpp>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace fixedpoint {
namespace tests {

// Its own error must vanish beside an ulp of the format: 64 fraction bits need more than a long
// double, and angles of 63 bits need that many digits beyond the binary point as well.
template <class Raw>
using Exact = std::conditional_t<sizeof(Raw) == 8,
                                 boost::multiprecision::number<boost::multiprecision::cpp_bin_float<
                                     192, boost::multiprecision::digit_base_2>>,
                                 long double>;

template <class Raw, int F>
Exact<Raw> exact_value(Raw raw) {
    using std::ldexp;
    return ldexp(Exact<Raw>(raw), -F);
}

// Distance of `result` from the exact value after clamping that to the format.
template <class Raw, int F>
double error_in_ulp(Raw result, const Exact<Raw>& exact) {
    using std::ldexp;
    Exact<Raw> scaled = ldexp(exact, F);
    const Exact<Raw> low(std::numeric_limits<Raw>::min()), high(std::numeric_limits<Raw>::max());
    if (scaled < low) scaled = low;
    if (scaled > high) scaled = high;
    const Exact<Raw> difference = Exact<Raw>(result) - scaled;
    return std::abs(static_cast<double>(difference));
}

// Zero, the extremes, powers of two (each `stride`th) and their neighbours, both signs.
template <class Raw>
std::vector<Raw> boundaries(int stride) {
    std::vector<Raw> values{0, std::numeric_limits<Raw>::min(), std::numeric_limits<Raw>::max()};
    for (int bit = 0; bit < RawLimits<Raw>::width - 1; bit += stride) {
        for (int offset = -1; offset <= 1; ++offset) {
            const Raw value = static_cast<Raw>((Raw(1) << bit) + offset);
            values.push_back(value);
            values.push_back(wrapping_negate(value));
        }
    }
    return values;
}

// Log-uniform magnitudes over the whole range, both signs.
template <class Raw>
Raw random_raw(std::mt19937_64& generator) {
    const int shift = static_cast<int>(generator() % RawLimits<Raw>::width);
    return static_cast<Raw>(static_cast<int64_t>(generator()) >>
                            (64 - RawLimits<Raw>::width + shift));
}

}  // namespace tests
}  // namespace fixedpoint
