// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <firmware/hardware/host.hpp>
#include <firmware/hardware/ring_buffer.hpp>

namespace firmware {
namespace {

struct Narrow : Configuration {
    static constexpr uint16_t servo_shortest = 1100;
    static constexpr uint16_t servo_longest = 1900;
};

TEST(ServoPulse, IsHeldToTheTravel) {
    EXPECT_EQ(servo_pulse<Narrow>(0), 2200);
    EXPECT_EQ(servo_pulse<Narrow>(2199), 2200);
    EXPECT_EQ(servo_pulse<Narrow>(2201), 2201);
    EXPECT_EQ(servo_pulse<Narrow>(3800), 3800);
    EXPECT_EQ(servo_pulse<Narrow>(3801), 3800);
    EXPECT_EQ(servo_pulse<Narrow>(65535), 3800);
}

TEST(Categories, AreASet) {
    EXPECT_EQ(set_of(), 0);
    EXPECT_EQ(set_of(Category::step, Category::operation), 0b10001);
    EXPECT_TRUE(contains(0b00100, Category::collision));
    EXPECT_FALSE(contains(0b11011, Category::collision));
}

// Every place is used, and the counts wrap.
TEST(RingBuffer, IsAQueue) {
    RingBuffer<16> ring{};
    int written = 0, read = 0;
    for (int round = 0; round < 1000; ++round) {
        for (int n = round * 7 % 17; n > 0 && ring.free() > 0; --n) ring.push(written++ % 251);
        EXPECT_EQ(ring.size(), written - read);
        EXPECT_EQ(ring.free(), 16 - (written - read));
        for (int n = round * 5 % 17; n > 0 && !ring.empty(); --n)
            ASSERT_EQ(ring.pop(), read++ % 251);
    }
    EXPECT_GT(read, 5000);
}

TEST(RingBuffer, OfTheLargestSizeDistinguishesFullFromEmpty) {
    RingBuffer<128> ring{};
    for (int i = 0; i < 128; ++i) ring.push(i);
    EXPECT_EQ(ring.free(), 0);
    EXPECT_FALSE(ring.empty());
    for (int i = 0; i < 128; ++i) EXPECT_EQ(ring.pop(), i);
    EXPECT_TRUE(ring.empty());
}

}  // namespace
}  // namespace firmware
