// SPDX-License-Identifier: MIT
// Why the lever's numbers need no saturation: whatever sensors and dial read, none of its sums and
// products leaves Q16.16. The lever's scalar here checks every operation.
#include <gtest/gtest.h>

#include <firmware/lever.hpp>
#include <fixedpoint/arithmetic/checked.hpp>
#include <random>

namespace firmware {
namespace {

int wrapped = 0;
struct Count {
    static void notify(fixedpoint::Event event, fixedpoint::Operation operation) {
        wrapped += event == fixedpoint::Event::overflow &&
                   operation != fixedpoint::Operation::divide &&
                   operation != fixedpoint::Operation::length;
    }
};
using Watched = fixedpoint::Fixed<16, 16, fixedpoint::Checked<Count>>;

constexpr engine::BinaryStep<10> step;
// A sanitizer checks paths and not results, so fewer readings suffice.
#ifdef SPARSE_OPERANDS
constexpr int reading_step = 341, rounds = 10000;
#else
constexpr int reading_step = 33, rounds = 1000000;
#endif
constexpr int most = 2 * 1023;  // of a sum of two readings

struct Uncorrected : LeverChoices<Watched> {};
struct Corrected : LeverChoices<Watched> {
    static constexpr bool frame_correction = true;
};
struct Undamped : LeverChoices<Watched> {
    static constexpr bool selective_damping = false;
};
template <class Choices>
class LeverRange : public testing::Test {};
using AllChoices = testing::Types<Uncorrected, Corrected, Undamped>;
TYPED_TEST_SUITE(LeverRange, AllChoices);

Readings readings(int a, int b, int dial_sum) {
    return {{static_cast<uint16_t>(a), static_cast<uint16_t>(b), static_cast<uint16_t>(dial_sum)}};
}

TYPED_TEST(LeverRange, HoldsForEveryPushOfAnyLength) {
    wrapped = 0;
    // Every pair of sensor readings, with the arm short, long and changing.
    for (int first = 0; first <= most; first += reading_step)
        for (int second = 0; second <= most; second += reading_step)
            for (int dial_sum : {0, most}) {
                Lever<TypeParam> lever;
                for (int i = 0; i < 200; ++i) lever.step(readings(first, second, dial_sum), step);
                for (int i = 0; i < 100; ++i)
                    lever.step(readings(second, first, most - dial_sum), step);
            }
    EXPECT_EQ(wrapped, 0);
}

TYPED_TEST(LeverRange, HoldsWhateverChangesFromStepToStep) {
    wrapped = 0;
    std::mt19937 random(1);
    Lever<TypeParam> lever;
    for (int i = 0; i < rounds; ++i) {
        // Between noise around rest and wires torn off and reconnected in every step.
        const int far = i % 2000 < 1000 ? most : 60;
        const auto sensor = [&] {
            const int reading = 2 * 870 + static_cast<int>(random() % (2 * far + 1)) - far;
            return std::min(most, std::max(0, reading));
        };
        lever.step(readings(sensor(), sensor(), static_cast<int>(random() % (most + 1))), step);
    }
    EXPECT_EQ(wrapped, 0);
}

// The check itself works.
TEST(LeverRangeWatch, SeesWhatLeavesTheRange) {
    wrapped = 0;
    const Watched large = Watched::from_integer(30000);
    static_cast<void>(large + large);
    static_cast<void>(large * large);
    EXPECT_EQ(wrapped, 2);
}

}  // namespace
}  // namespace firmware
