// SPDX-License-Identifier: MIT
// CorrectlyRounded in formats other than Q16.16 against functions of 113 bits: functions of one
// number, in every format of 8 bits and in formats of 16 and 32 bits from no fraction bits to no
// integer bits but the sign. Operands whose results are on a tie of the finer format or next to one
// are searched for; those of Q8.24 are the closest of all.
#include <gtest/gtest.h>

#include <fixedpoint/arithmetic/correctly_rounded.hpp>
#include <random>
#include <string>
#include <type_traits>
#include <utility>

#include "float128.hpp"

namespace {

using fixedpoint::CorrectlyRounded;
using fixedpoint::Nearest;
using fixedpoint::RawLimits;
namespace side_of_tie = fixedpoint::portable::side_of_tie;

// Each with the operands of Q8.24 whose results are closest to a tie, of all: hardest_ties.cpp.
#define FUNCTION(function, has_result_at, Side, ...)                \
    struct Function_##function {                                    \
        static constexpr const char* name = #function;              \
        static bool has_result(Real a) { return has_result_at(a); } \
        static Real exact(Real a) { return function##f128(a); }     \
        template <class Raw, int F>                                 \
        static Raw rounded(Raw a) {                                 \
            return CorrectlyRounded::function<Raw, F>(a);           \
        }                                                           \
        template <int F>                                            \
        static int64_t finer(int64_t a) {                           \
            return Nearest::function<int64_t, F>(a);                \
        }                                                           \
        template <int F>                                            \
        static bool reaches(int64_t n, int32_t a) {                 \
            return side_of_tie::Side::reaches<F>(n, a);             \
        }                                                           \
        static constexpr int32_t hardest[] = {__VA_ARGS__};         \
    };
FUNCTION(sin, anywhere, Sin, -507917683, 507917683, 576583709, -576583709)
FUNCTION(cos, anywhere, Cos, -351153182, 351153182, -759986350, 759986350)
FUNCTION(tan, anywhere, Tan, 1659305326, -1659305326, 1063088539, -1063088539)
FUNCTION(asin, to_one, Asin, 8927770, -8927770, -14578452, 14578452)
FUNCTION(acos, to_one, Acos, -7403321, -3269242, 7259071, 1864878)
FUNCTION(atan, anywhere, Atan, 34828955, -34828955, 1512579333, -1512579333)
FUNCTION(exp, anywhere, Exp, -59934499, -190503105, 65861178, -65619851)
FUNCTION(exp2, anywhere, Exp2, -197020703, -28080963, -138825541, -127798787)
FUNCTION(expm1, anywhere, Expm1, -59934499, -190503105, 65861178, -65619851)
FUNCTION(log, above_zero, Log, 582778896, 2041156516, 1256673429, 94607408)
FUNCTION(log2, above_zero, Log2, 812952438, 1625904876, 406476219, 1881452966)
FUNCTION(log10, above_zero, Log10, 1522739577, 1237540388, 1843037899, 1424359157)
FUNCTION(log1p, above_minus_one, Log1p, 566001680, 2024379300, 1239896213, 77830192)
FUNCTION(sinh, anywhere, Sinh, 76257927, -76257927, 77053929, -77053929)
FUNCTION(cosh, anywhere, Cosh, -73420766, 73420766, 12537346, -12537346)
FUNCTION(tanh, anywhere, Tanh, 1181742, -1181742, 5026408, -5026408)
FUNCTION(cbrt, anywhere, Cbrt, 263273158, -263273158, -258294526, 258294526)
#undef FUNCTION

template <class Function>
class CorrectRoundingInSplits : public testing::Test {
  protected:
    template <class Raw, int F>
    static void check(Raw a) {
        const Real value = Real(a) / Real(uint64_t(1) << F);
        if (!Function::has_result(value)) return;
        ASSERT_EQ((Function::template rounded<Raw, F>(a)), rounded<Raw>(Function::exact(value), F))
            << Function::name << " of " << int64_t(a) << " with " << F << " fraction bits";
    }
    template <class Raw, int F>
    static void check_every_number() {
        for (int32_t a = RawLimits<Raw>::min; a <= RawLimits<Raw>::max; ++a)
            check<Raw, F>(static_cast<Raw>(a));
    }
    template <class Raw, int... F>
    static void check_every_number(std::integer_sequence<int, F...>) {
        (check_every_number<Raw, F>(), ...);
    }

    template <int F>
    static void check_random_numbers() {
        std::mt19937 random(F);
        constexpr auto one = static_cast<int64_t>(uint64_t(1) << F);
        for (int i = 0; i < 3000; ++i) {
            check<int32_t, F>(static_cast<int32_t>(random()) >> random() % 32);
            // Results of steep functions are in range for operands in -16..16.
            check<int32_t, F>(fixedpoint::saturated<int32_t>(static_cast<int32_t>(random()) *
                                                             (one >> random() % 8) / (1 << 27)));
        }
        for (const int64_t edge : {int64_t(RawLimits<int32_t>::min), -2 * one, -one, int64_t(0),
                                   one, 2 * one, int64_t(RawLimits<int32_t>::max)}) {
            for (int64_t a = edge - 9; a <= edge + 9; ++a)
                if (a == static_cast<int32_t>(a)) check<int32_t, F>(static_cast<int32_t>(a));
        }
    }

    // The result, and the side of the tie closest to it, which must be closer than 2^-10 ulp.
    template <int F>
    static void check_beside_tie(int32_t a) {
        check<int32_t, F>(a);
        const Real exact =
            Function::exact(Real(a) / Real(uint64_t(1) << F)) * Real(uint64_t(1) << F);
        const Real below = floorf128(exact);
        if (below >= Real(RawLimits<int32_t>::max) || below < Real(RawLimits<int32_t>::min)) return;
        ASSERT_LT(fabsf128(exact - below - Real(0.5)), Real(1) / 1024);
        ASSERT_EQ(Function::template reaches<F>(2 * static_cast<int64_t>(below) + 1, a),
                  exact >= below + Real(0.5))
            << Function::name << " of " << a << " with " << F << " fraction bits";
    }
    template <int F>
    static void check_beside_ties() {
        constexpr int finer = fixedpoint::portable::finer_fraction<F>();
        constexpr uint32_t half = uint32_t(1) << (finer - F - 1);
        // Within 2^-10 ulp, but at least the units that count as ties.
        constexpr uint32_t near = finer - F <= 16 ? 0x20 : half >> 10;
        std::mt19937 random(F + 100);
        for (int i = 0; i < 20'000; ++i) {
            const int32_t a = static_cast<int32_t>(random()) >> random() % 24;
            if (!Function::has_result(Real(a) / Real(uint64_t(1) << F))) continue;
            const int64_t fine =
                Function::template finer<finer>(fixedpoint::portable::finer<int32_t, F>(a));
            if (((static_cast<uint32_t>(fine) + half + near) & (2 * half - 1)) <= 2 * near)
                check_beside_tie<F>(a);
        }
    }
};

using Functions =
    testing::Types<Function_sin, Function_cos, Function_tan, Function_asin, Function_acos,
                   Function_atan, Function_exp, Function_exp2, Function_expm1, Function_log,
                   Function_log2, Function_log10, Function_log1p, Function_sinh, Function_cosh,
                   Function_tanh, Function_cbrt>;
struct NameOfFunction {
    template <class Function>
    static std::string GetName(int) {
        return Function::name;
    }
};
TYPED_TEST_SUITE(CorrectRoundingInSplits, Functions, NameOfFunction);

TYPED_TEST(CorrectRoundingInSplits, OfEveryNumberOf8Bits) {
    this->template check_every_number<int8_t>(std::make_integer_sequence<int, 8>());
}
TYPED_TEST(CorrectRoundingInSplits, OfEveryNumberOf16Bits) {
    this->template check_every_number<int16_t>(std::integer_sequence<int, 0, 6, 8, 12, 14, 15>());
}
TYPED_TEST(CorrectRoundingInSplits, OfNumbersOf32Bits) {
    this->template check_random_numbers<0>();
    this->template check_random_numbers<8>();
    this->template check_random_numbers<15>();
    this->template check_random_numbers<17>();
    this->template check_random_numbers<24>();
    this->template check_random_numbers<28>();
    this->template check_random_numbers<31>();
}
TYPED_TEST(CorrectRoundingInSplits, BesideTies) {
    this->template check_beside_ties<8>();
    this->template check_beside_ties<24>();
    this->template check_beside_ties<31>();
    for (const int32_t a : TypeParam::hardest) this->template check_beside_tie<24>(a);
}

template <int... F>
void expect_reciprocal_roots(std::integer_sequence<int, F...>) {
    std::mt19937 random(1);
    const auto expect = [](int32_t a, int fraction, int32_t root) {
        ASSERT_EQ(root, rounded<int32_t>(
                            reciprocal_sqrtf128(Real(a) / Real(uint64_t(1) << fraction)), fraction))
            << a << " with " << fraction << " fraction bits";
    };
    for (int i = 0; i < 10'000; ++i) {
        const auto a = static_cast<int32_t>(1 + (random() >> (1 + random() % 31)));
        (expect(a, F, CorrectlyRounded::reciprocal_sqrt<int32_t, F>(a)), ...);
    }
}
TEST(CorrectRoundingInSplits, OfReciprocalRoots) {
    expect_reciprocal_roots(std::make_integer_sequence<int, 32>());
}

template <int F>
void expect_unit_vectors_and_lengths() {
    std::mt19937 random(F);
    for (int i = 0; i < 3000; ++i) {
        int32_t v[3], unit[3];
        Real sum = 0;
        for (int32_t& component : v) {
            component = static_cast<int32_t>(random()) >> random() % 32;
            sum += Real(component) * Real(component);
        }
        CorrectlyRounded::normalise3<int32_t, F>(v, unit);
        for (int k = 0; k < 3 && sum > 0; ++k)
            ASSERT_EQ(unit[k], rounded<int32_t>(Real(v[k]) / sqrtf128(sum), F)) << v[k];
        ASSERT_EQ((CorrectlyRounded::length3<int32_t, F>(v)), rounded<int32_t>(sqrtf128(sum), 0));
    }
}
TEST(CorrectRoundingInSplits, OfUnitVectorsAndLengths) {
    expect_unit_vectors_and_lengths<0>();
    expect_unit_vectors_and_lengths<8>();
    expect_unit_vectors_and_lengths<15>();
    expect_unit_vectors_and_lengths<24>();
    expect_unit_vectors_and_lengths<28>();
    expect_unit_vectors_and_lengths<31>();
}

// 2^-(F+1) is the only tie of exp2, and 1 / sqrt(2^(2F+2)) of the reciprocal root.
template <int F>
void expect_ties_up() {
    constexpr int32_t exponent = -(F + 1) * (int32_t(1) << F);
    EXPECT_EQ((CorrectlyRounded::exp2<int32_t, F>(exponent)), 1) << F;
    EXPECT_EQ((CorrectlyRounded::exp2<int32_t, F>(exponent - 1)), 0) << F;
}
TEST(CorrectRoundingInSplits, RoundsTiesUp) {
    expect_ties_up<0>();
    expect_ties_up<8>();
    expect_ties_up<16>();
    expect_ties_up<24>();
    expect_ties_up<26>();
    EXPECT_EQ((CorrectlyRounded::reciprocal_sqrt<int32_t, 8>(1 << 26)), 1);
    EXPECT_EQ((CorrectlyRounded::reciprocal_sqrt<int32_t, 8>((1 << 26) + 1)), 0);
}

// Truths of 113 bits are off by 2^-112.
template <int digits>
void expect_powers_within(Real relative_error) {
    std::mt19937_64 random(digits);
    for (int i = 0; i < 20'000; ++i) {
        const auto n = static_cast<int64_t>(random() >> 24) >> random() % 36;
        const bool reciprocal = (i & 1) != 0;
        const Real exponent = Real(n % (int64_t(46) << 32)) / Real(uint64_t(1) << 32);
        const auto power = side_of_tie::power_of_e<digits>(
            fixedpoint::portable::Word128(static_cast<uint64_t>(n % (int64_t(46) << 32))) << 90,
            reciprocal);
        Real exact = expf128(reciprocal ? -exponent : exponent);
        for (int e = power.exponent; e > 0; --e) exact /= 2;
        for (int e = power.exponent; e < 0; ++e) exact *= 2;
        const Real mantissa =
            (Real(power.mantissa.high) +
             Real(power.mantissa.low) / Real(uint64_t(1) << 32) / Real(uint64_t(1) << 32)) /
            Real(uint64_t(1) << 61);
        ASSERT_LT(fabsf128(mantissa / exact - 1), relative_error) << n;
    }
}
constexpr Real power_of_half(int n) { return n == 0 ? Real(1) : power_of_half(n - 1) / 2; }
TEST(SideOfTie, ComparesWithPowersWithin2ToTheMinus67) {
    expect_powers_within<66>(power_of_half(67));
}
TEST(SideOfTie, ComparesFineNumbersWithPowersWithin2ToTheMinus100) {
    expect_powers_within<100>(power_of_half(100));
}

Real of_126_bits(fixedpoint::portable::Word128 a) {
    const bool negative = fixedpoint::portable::is_negative(a);
    if (negative) a = fixedpoint::portable::negated(a);
    const Real magnitude = Real(a.high) * power_of_half(62) + Real(a.low) * power_of_half(126);
    return negative ? -magnitude : magnitude;
}
template <int f>
void expect_unit_vectors_within(Real error) {
    std::mt19937_64 random(f);
    for (int i = 0; i < 10'000; ++i) {
        const auto n = static_cast<int64_t>(random()) >> (31 + random() % 30);
        const auto unit = side_of_tie::unit_vector_at<f>(n);
        const Real angle = Real(n) / Real(uint64_t(1) << f);
        ASSERT_LT(fabsf128(of_126_bits(unit.sine) - sinf128(angle)), error) << n;
        ASSERT_LT(fabsf128(of_126_bits(unit.cosine) - cosf128(angle)), error) << n;
    }
}
TEST(SideOfTie, ComparesWithUnitVectorsWithin2ToTheMinus110) {
    expect_unit_vectors_within<0>(power_of_half(110));
    expect_unit_vectors_within<1>(power_of_half(110));
    expect_unit_vectors_within<24>(power_of_half(110));
    expect_unit_vectors_within<32>(power_of_half(110));
}

}  // namespace
