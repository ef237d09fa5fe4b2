// SPDX-License-Identifier: MIT
#include "exact.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace exact {
namespace {

// Wide enough for every value of 64-bit formats times 10^255.
using Int = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    2048, 2048, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;
// Its own error is negligible compared with an ulp of 63 fraction bits, even for angles with 63
// integer bits.
using Real = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<192, boost::multiprecision::digit_base_2>>;

Int floor_of(const Int& numerator, const Int& denominator) {
    const Int quotient = numerator / denominator;
    return numerator < 0 && quotient * denominator != numerator ? Int(quotient - 1) : quotient;
}

// numerator / denominator to nearest, half up.
Int nearest(const Int& numerator, const Int& denominator) {
    return denominator < 0 ? nearest(-numerator, -denominator)
                           : floor_of(2 * numerator + denominator, 2 * denominator);
}

Int power_of_two(int exponent) { return Int(1) << exponent; }

Rounded in_range(const Int& n, int width, bool is_signed = true) {
    const Int modulus = power_of_two(width);
    const Int low = is_signed ? Int(-modulus / 2) : Int(0), high = low + modulus - 1;
    Int wrapped = n - floor_of(n - low, modulus) * modulus;
    Int saturated = n < low ? low : n > high ? high : n;
    const bool fits = wrapped == n;
    const auto bits = [](const Int& a) {
        return a < 0 ? -static_cast<int64_t>(static_cast<uint64_t>(-(a + 1))) - 1
                     : static_cast<int64_t>(static_cast<uint64_t>(a));
    };
    return {bits(wrapped), bits(saturated), fits};
}

Rounded ratio(const Int& numerator, const Int& denominator, Format format) {
    return in_range(nearest(numerator, denominator), format.width);
}

// sqrt(numerator / denominator) to nearest, half up.
Int nearest_root(const Int& numerator, const Int& denominator) {
    return (boost::multiprecision::sqrt(Int(4 * numerator / denominator)) + 1) / 2;
}

template <class Number>
Number value(Function function, const Number& a) {
    using std::atan, std::cos, std::exp, std::log, std::sin, std::sqrt;
    switch (function) {
        case Function::sin:
            return sin(a);
        case Function::cos:
            return cos(a);
        case Function::atan:
            return atan(a);
        case Function::exp:
            // Beyond +-100 every format saturates.
            return exp(a < -100 ? Number(-100) : a > 100 ? Number(100) : a);
        case Function::log:
            return log(a);
        case Function::sqrt:
            return sqrt(a);
        case Function::reciprocal_sqrt:
            return 1 / sqrt(a);
    }
    return a;
}

template <class Number>
Rounded rounded(const Number& scaled, Format format) {
    using std::floor;
    const Number nearest = floor(Number(scaled + 0.5));
    const Number low(smallest(format.width)), high(largest(format.width));
    if (nearest < low) return {0, smallest(format.width), false};
    if (nearest > high) return {0, largest(format.width), false};
    const auto raw = static_cast<int64_t>(nearest);
    return {raw, raw, true};
}

template <class Number>
double error_in_ulp(const Number& scaled, int64_t result, Format format) {
    using std::abs;
    const Number low(smallest(format.width)), high(largest(format.width));
    const Number& saturated = scaled < low ? low : scaled > high ? high : scaled;
    return static_cast<double>(abs(Number(Number(result) - saturated)));
}

template <class Use>
auto with_function(Function function, int64_t a, Format format, const Use& use) {
    using std::ldexp;
    if (format.width == 64) {
        return use(ldexp(value(function, Real(ldexp(Real(a), -format.fraction))), format.fraction));
    }
    return use(
        std::ldexp(value(function, std::ldexp(static_cast<long double>(a), -format.fraction)),
                   format.fraction));
}
template <class Use>
auto with_angle(int64_t y, int64_t x, Format format, const Use& use) {
    using std::ldexp;
    if (format.width == 64) return use(Real(ldexp(Real(atan2(Real(y), Real(x))), format.fraction)));
    return use(std::ldexp(std::atan2(static_cast<long double>(y), static_cast<long double>(x)),
                          format.fraction));
}

Int squares(const int64_t* v, int n) {
    Int sum = 0;
    for (int i = 0; i < n; ++i) sum += Int(v[i]) * v[i];
    return sum;
}

}  // namespace

int64_t smallest(int width) { return std::numeric_limits<int64_t>::min() >> (64 - width); }
int64_t largest(int width) { return std::numeric_limits<int64_t>::max() >> (64 - width); }

Rounded add(int64_t a, int64_t b, Format format) { return in_range(Int(a) + b, format.width); }
Rounded subtract(int64_t a, int64_t b, Format format) { return in_range(Int(a) - b, format.width); }
Rounded multiply_add(int64_t a, int64_t b, int64_t c, Format format) {
    const Int one = power_of_two(format.fraction);
    return ratio(Int(a) * b + c * one, one, format);
}
Rounded dot(const int64_t* a, const int64_t* b, int n, Format format) {
    Int sum = 0;
    for (int i = 0; i < n; ++i) sum += Int(a[i]) * b[i];
    return ratio(sum, power_of_two(format.fraction), format);
}
Rounded divide(int64_t a, int64_t b, Format format) {
    return ratio(a * power_of_two(format.fraction), b, format);
}
Rounded scale(__int128 a, int shift, int width, bool is_signed) {
    const Int scaled = shift < 0 ? nearest(Int(a), power_of_two(-shift)) : Int(a) << shift;
    return in_range(scaled, width, is_signed);
}
Rounded decimal(int64_t n, int decimals, Format format) {
    return ratio(n * power_of_two(format.fraction),
                 boost::multiprecision::pow(Int(10), static_cast<unsigned>(decimals)), format);
}
Rounded binary(int64_t mantissa, int exponent, Format format) {
    return scale(mantissa, exponent + format.fraction, format.width);
}
Rounded reciprocal_sqrt(int64_t a, Format format) {
    return in_range(nearest_root(power_of_two(3 * format.fraction), a), format.width);
}
Rounded length(const int64_t* v, int n, Format format) {
    return in_range(nearest_root(squares(v, n), 1), format.width);
}
Rounded normalised(const int64_t* v, int i, Format format) {
    const Int component = nearest_root(Int(v[i]) * v[i] << (2 * format.fraction), squares(v, 3));
    return in_range(v[i] < 0 ? Int(-component) : component, format.width);
}

bool is_nearest_float(int64_t a, int64_t mantissa, int exponent, int digits, Format format) {
    if (a == 0) return mantissa == 0;
    // a / 2^F = a 2^-F; both sides in units of the smaller power of two.
    const int unit = std::min(exponent, -format.fraction);
    const Int difference =
        (Int(a) << (-format.fraction - unit)) - (Int(mantissa) << (exponent - unit));
    const Int twice = 2 * abs(difference), ulp = power_of_two(exponent - unit);
    // Below a power of two the neighbour is half as far away.
    const bool at_power = abs(Int(mantissa)) == power_of_two(digits - 1);
    const bool towards_zero = (difference < 0) == (mantissa > 0);
    const Int gap = at_power && towards_zero ? Int(ulp / 2) : ulp;
    if (at_power && towards_zero && ulp == 1) return difference == 0;
    return twice < gap || (twice == gap && (mantissa & 1) == 0);
}

Rounded constant(Constant which, Format format) {
    using namespace boost::math::constants;
    const Real values[] = {ln_two<Real>(), root_two<Real>(), phi<Real>(),    pi<Real>(),
                           e<Real>(),      ln_ten<Real>(),   two_pi<Real>(), radian<Real>()};
    return rounded(Real(ldexp(values[static_cast<int>(which)], format.fraction)), format);
}

Rounded function(Function which, int64_t a, Format format) {
    return with_function(which, a, format, [&](const auto& x) { return rounded(x, format); });
}
double function_error(Function which, int64_t a, int64_t result, Format format) {
    return with_function(which, a, format,
                         [&](const auto& x) { return error_in_ulp(x, result, format); });
}
Rounded atan2(int64_t y, int64_t x, Format format) {
    return with_angle(y, x, format, [&](const auto& angle) { return rounded(angle, format); });
}
double atan2_error(int64_t y, int64_t x, int64_t result, Format format) {
    return with_angle(y, x, format,
                      [&](const auto& angle) { return error_in_ulp(angle, result, format); });
}
double normalise_error(const int64_t* v, int i, int64_t result, Format format) {
    const Real length = sqrt(Real(squares(v, 3)));
    return error_in_ulp(Real(ldexp(Real(Real(v[i]) / length), format.fraction)), result, format);
}

std::vector<int64_t> raws(int width, int random_ones) {
    std::vector<int64_t> numbers;
    if (width <= exhaustive_width) {
        for (int64_t n = smallest(width); n <= largest(width); ++n) numbers.push_back(n);
        return numbers;
    }
    const auto add = [&](uint64_t n) {
        numbers.push_back(static_cast<int64_t>(n << (64 - width)) >> (64 - width));
    };
    std::mt19937_64 random(20);
    for (int bit = 0; bit < width; ++bit) {
        const uint64_t one = uint64_t(1) << bit;
        for (int offset = -2; offset <= 2; ++offset) {
            add(one + static_cast<uint64_t>(offset));
            add(static_cast<uint64_t>(offset) - one);
        }
        for (int i = 0; i < random_ones; ++i) {
            const uint64_t n = random() >> (63 - bit);
            add(n);
            add(-n);
        }
    }
    return numbers;
}

}  // namespace exact
