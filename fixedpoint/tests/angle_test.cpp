// SPDX-License-Identifier: MIT
// Angles in turns and degrees against binary128, with argument reduction in exact integers: every
// operand of 8 and 16 bits in every split, boundary and random operands of wider formats.
#include <fixedpoint/angle.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>

#include "reference/function.hpp"
#include "subjects.hpp"

namespace {

using namespace fixedpoint;
using reference::Binary128;

const Binary128 pi = 4 * reference::functions::atan(Binary128(1));

// The distance in ulp from the exact value, which is saturated if it is out of range.
double error(int64_t result, Binary128 exact, int width, int fraction) {
    Binary128 ulps = exact * (Binary128(uint64_t(1) << (fraction / 2)) *
                              Binary128(uint64_t(1) << (fraction - fraction / 2)));
    const Binary128 largest = Binary128(exact::largest(width));
    if (ulps > largest) ulps = largest;
    if (ulps < -largest - 1) ulps = -largest - 1;
    const Binary128 distance = Binary128(result) - ulps;
    return static_cast<double>(distance < 0 ? -distance : distance);
}

// The sine of angle / (2^F per_turn) turns: exactly reduced, and exact at quarter turns.
Binary128 exact_sine(int64_t angle, int fraction, int per_turn, int quarters) {
    const __int128 turn = static_cast<__int128>(per_turn) << fraction;
    __int128 rest = (4 * static_cast<__int128>(angle) + quarters * turn) % (4 * turn);
    if (rest < 0) rest += 4 * turn;
    if (rest % turn == 0) {
        const int quadrant = static_cast<int>(rest / turn);
        return quadrant == 1 ? 1 : quadrant == 3 ? -1 : 0;
    }
    return reference::functions::sin(Binary128(rest) / Binary128(turn) * (pi / 2));
}

struct Sines {
    int64_t sine, cosine;
    bool agree;  // with the function that returns both
};
struct AngleSubject {
    exact::Format format;
    int per_turn;
    Sines (*compute)(int64_t angle);
};

template <class Raw, int F>
Sines sines_of_turns(int64_t angle) {
    const auto x = Fixed<RawLimits<Raw>::width - F, F>::from_raw(static_cast<Raw>(angle));
    const auto both = sincos_turns(x);
    const auto sine = sin_turns(x), cosine = cos_turns(x);
    return {sine.raw(), cosine.raw(), both.sine == sine && both.cosine == cosine};
}
template <class Raw, int F>
Sines sines_of_degrees(int64_t angle) {
    const auto x = Fixed<RawLimits<Raw>::width - F, F>::from_raw(static_cast<Raw>(angle));
    const auto both = sincos_degrees(x);
    const auto sine = sin_degrees(x), cosine = cos_degrees(x);
    return {sine.raw(), cosine.raw(), both.sine == sine && both.cosine == cosine};
}
template <class Raw, int... F>
void add_angles(std::vector<AngleSubject>& all, std::integer_sequence<int, F...>) {
    (all.push_back({{RawLimits<Raw>::width, F}, 1, sines_of_turns<Raw, F>}), ...);
    (
        [&] {
            if constexpr (F <= 54) {
                all.push_back({{RawLimits<Raw>::width, F}, 360, sines_of_degrees<Raw, F>});
            }
        }(),
        ...);
}
std::vector<AngleSubject> angle_subjects() {
    std::vector<AngleSubject> all;
    add_angles<int8_t>(all, std::make_integer_sequence<int, 8>());
    add_angles<int16_t>(all, std::make_integer_sequence<int, 16>());
    add_angles<Int24>(all, std::integer_sequence<int, 0, 2, 8, 12, 15, 16, 17, 23>());
    add_angles<int32_t>(all,
                        std::integer_sequence<int, 0, 1, 2, 8, 15, 16, 17, 23, 24, 25, 30, 31>());
    add_angles<int64_t>(
        all, std::integer_sequence<int, 0, 2, 16, 30, 31, 32, 33, 48, 50, 51, 54, 62, 63>());
    return all;
}

// The operands of exact.hpp and, for wider formats, the multiples of a quarter turn and their
// neighbours.
std::vector<int64_t> angles(const AngleSubject& subject) {
    const auto [width, fraction] = subject.format;
    std::vector<int64_t> numbers = exact::raws(width, 10);
    std::mt19937_64 random(31);
    if (numbers.size() > 4000) {
        std::shuffle(numbers.begin(), numbers.end(), random);
        numbers.resize(4000);
    }
    if (width == 8) return numbers;
    for (const int quarters : {0, 1, 2, 3, 4, 5, 7, 8, 1001, -1, -2, -3, -4, -6}) {
        const __int128 angle = (static_cast<__int128>(quarters * subject.per_turn) << fraction) / 4;
        for (int offset = -2; offset <= 2; ++offset) {
            const __int128 near = angle + offset;
            if (near >= exact::smallest(width) && near <= exact::largest(width))
                numbers.push_back(static_cast<int64_t>(near));
        }
    }
    for (int i = 0; i < 300; ++i) numbers.push_back(static_cast<int64_t>(random()) >> (64 - width));
    return numbers;
}

TEST(Angle, SinesAreFaithfulAndExactAtQuarterTurns) {
    for (const AngleSubject& subject : angle_subjects()) {
        const auto [width, fraction] = subject.format;
        SCOPED_TRACE(testing::Message()
                     << width << " bits, F = " << fraction << ", " << subject.per_turn);
        double worst = 0;
        for (const int64_t angle : angles(subject)) {
            const Sines sines = subject.compute(angle);
            ASSERT_TRUE(sines.agree) << angle;
            for (const int quarters : {0, 1}) {
                const int64_t result = quarters == 0 ? sines.sine : sines.cosine;
                const Binary128 exact = exact_sine(angle, fraction, subject.per_turn, quarters);
                const double ulps = error(result, exact, width, fraction);
                worst = std::max(worst, ulps);
                const bool is_quarter = exact == 0 || exact == 1 || exact == -1;
                ASSERT_TRUE(!is_quarter || ulps == 0) << angle;
                const __int128 one = static_cast<__int128>(1) << fraction;
                ASSERT_TRUE(result <= one && result >= -one) << angle;
            }
        }
        ASSERT_LT(worst, 0.75);
    }
}

struct VectorSubject {
    exact::Format format;
    double per_turn, bound;
    int64_t (*compute)(int64_t y, int64_t x);
};
template <class Raw, int F>
void add_vectors(std::vector<VectorSubject>& all) {
    using Number = Fixed<RawLimits<Raw>::width - F, F>;
    const exact::Format format = {RawLimits<Raw>::width, F};
    all.push_back({format, 1, F == 63 ? 1 : 0.75, [](int64_t y, int64_t x) -> int64_t {
                       return atan2_turns(Number::from_raw(static_cast<Raw>(y)),
                                          Number::from_raw(static_cast<Raw>(x)))
                           .raw();
                   }});
    if constexpr (F <= 54) {
        all.push_back({format, 360, 0.75, [](int64_t y, int64_t x) -> int64_t {
                           return atan2_degrees(Number::from_raw(static_cast<Raw>(y)),
                                                Number::from_raw(static_cast<Raw>(x)))
                               .raw();
                       }});
    }
}
template <class Raw, int... F>
void add_vectors(std::vector<VectorSubject>& all, std::integer_sequence<int, F...>) {
    (add_vectors<Raw, F>(all), ...);
}

TEST(Angle, OfAVectorIsFaithfulAndExactOnTheAxes) {
    std::vector<VectorSubject> all;
    add_vectors<int8_t>(all, std::make_integer_sequence<int, 8>());
    add_vectors<int16_t>(all, std::integer_sequence<int, 0, 2, 8, 13, 14, 15>());
    add_vectors<Int24>(all, std::integer_sequence<int, 0, 12, 16, 17, 23>());
    add_vectors<int32_t>(all, std::integer_sequence<int, 0, 2, 16, 23, 24, 25, 30, 31>());
    add_vectors<int64_t>(all, std::integer_sequence<int, 0, 2, 24, 25, 32, 54, 55, 62, 63>());
    for (const VectorSubject& subject : all) {
        const auto [width, fraction] = subject.format;
        SCOPED_TRACE(testing::Message()
                     << width << " bits, F = " << fraction << ", " << subject.per_turn);
        std::mt19937_64 random(5);
        const auto check = [&, width = width, fraction = fraction](int64_t y, int64_t x) {
            const int64_t result = subject.compute(y, x);
            if (y == 0 && x == 0) {
                ASSERT_EQ(result, 0);
                return;
            }
            const bool on_axis = y == 0 || x == 0;
            const Binary128 turns =
                on_axis ? Binary128(y > 0   ? 0.25
                                    : y < 0 ? -0.25
                                    : x < 0 ? 0.5
                                            : 0)
                        : reference::functions::atan2(Binary128(y), Binary128(x)) / (2 * pi);
            const double ulps = error(result, turns * subject.per_turn, width, fraction);
            ASSERT_LT(ulps, subject.bound) << y << ", " << x << ": " << result;
            const bool is_exact = on_axis && (subject.per_turn == 360 || fraction >= 2);
            ASSERT_TRUE(!is_exact || ulps == 0) << y << ", " << x;
        };
        int count = 0;
        if (width == 8) {
            for (int y = -128; y < 128; ++y) {
                for (int x = -128; x < 128; ++x) check(y, x);
                if (HasFatalFailure()) return;
            }
            continue;
        }
        const std::vector<int64_t> numbers = exact::raws(width, 10);
        while (++count < 2000) {
            check(numbers[random() % numbers.size()], numbers[random() % numbers.size()]);
            check(static_cast<int64_t>(random()) >> (64 - width),
                  static_cast<int64_t>(random()) >> (64 - width));
            if (HasFatalFailure()) return;
        }
        for (const int64_t limit :
             {exact::smallest(width), exact::largest(width), int64_t(1), int64_t(-1)}) {
            check(limit, 0);
            check(0, limit);
            check(limit, exact::smallest(width));
            check(1, limit);
        }
    }
}

template <class Number, int Bits>
void expect_sines_of_turn() {
    const double fraction = Number::fraction_bits;
    std::mt19937_64 random(2);
    for (int i = 0; i < 20000; ++i) {
        const auto raw =
            static_cast<UnsignedInteger<Bits>>(i < 8 ? uint64_t(i) << (Bits - 3) : random());
        const auto turn = Turn<Bits>::from_raw(raw);
        const auto both = sincos<Number>(turn);
        ASSERT_TRUE(both.sine == sin<Number>(turn) && both.cosine == cos<Number>(turn));
        const int width = RawLimits<typename Number::Raw>::width;
        ASSERT_LT(error(both.sine.raw(), exact_sine(raw, Bits, 1, 0), width, int(fraction)), 0.75)
            << raw;
        ASSERT_LT(error(both.cosine.raw(), exact_sine(raw, Bits, 1, 1), width, int(fraction)), 0.75)
            << raw;
    }
}
TEST(Turn, SinesAreThoseOfTheAngle) {
    expect_sines_of_turn<Q4_4, 16>();
    expect_sines_of_turn<Q8_8, 16>();
    expect_sines_of_turn<Q8_8, 32>();
    expect_sines_of_turn<Fixed<1, 15>, 16>();
    expect_sines_of_turn<Q16_16, 16>();
    expect_sines_of_turn<Q16_16, 32>();
    expect_sines_of_turn<Fixed<8, 24>, 32>();
    expect_sines_of_turn<Q32_32, 32>();
    expect_sines_of_turn<Fixed<2, 62>, 32>();
}
TEST(Turn, WrapsAsAnglesDo) {
    using Angle = Turn<16>;
    for (int a = -70000; a < 70000; a += 7) {
        const Angle angle = Angle::from_turns(Q16_16::from_raw(a));
        ASSERT_EQ(angle.raw(), static_cast<uint16_t>(a));
        ASSERT_EQ(angle.turns<Q16_16>().raw(), static_cast<int16_t>(a));
        const Angle other = Angle::from_raw(static_cast<uint16_t>(3 * a));
        ASSERT_TRUE((angle + other).raw() == static_cast<uint16_t>(4 * a) &&
                    angle - other == -angle * 2 && 3 * angle == other && angle * -3L == -other &&
                    angle + angle != angle - Angle::from_raw(1) - angle);
        Angle sum = angle;
        ASSERT_TRUE((sum += other) == angle + other && (sum -= other) == angle);
    }
    static_assert(Turn<32>::from_turns(Q8_8::from_raw(-64)).raw() == 0xc0000000,
                  "a quarter turn back");
    static_assert(Angle::from_turns(Q32_32::from_raw(0x8000)).raw() == 1, "half up");
    static_assert(Angle::from_raw(0x8000).turns<Q8_8>().raw() == -128, "from -1/2");
}

}  // namespace
