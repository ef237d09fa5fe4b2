// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of the splits of 16 bits with less than 8 fraction bits on the simulated chip, for
// every input: the portable code bit for bit, and within 0.55 ulp of the function.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/portable/log.hpp>
#include <fixedpoint/portable/sin.hpp>
#include <string>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/device/tests/program_folder.hpp"

namespace {

namespace portable = fixedpoint::portable;
using simulator::Chip;
using simulator::DeviceFunction;

template <class Split>
class CoarseSplits : public testing::Test {
  protected:
    static constexpr int F = Split::value;

    CoarseSplits() : chip_(simulator::Elf(program_folder() + "/coarse_splits.elf")) {
        chip_.run_until_function("main");
    }

    static std::string symbol(const char* operation) {
        return fmt::format("fixedpoint_{}_q{}_{}", operation, 16 - F, F);
    }
    // The error of double is about 2^-38 ulp.
    static double error(double (*function)(double), int a, int result) {
        return std::abs(result - std::ldexp(function(std::ldexp(a, -F)), F));
    }
    void expect(const char* operation, int least, double (*function)(double),
                std::int16_t (*computed)(std::int16_t)) {
        DeviceFunction kernel(chip_, symbol(operation), {2, {2}});
        for (int a = INT16_MIN; a <= INT16_MAX; ++a) {
            const auto result = kernel(static_cast<std::int16_t>(a)).template as<std::int16_t>();
            ASSERT_EQ(result, computed(static_cast<std::int16_t>(a))) << operation << " " << a;
            if (a >= least) {
                ASSERT_LE(error(function, a, result), 0.55) << operation << " " << a;
            }
        }
    }

    Chip chip_;
};

template <int F>
using Split = std::integral_constant<int, F>;
using Splits =
    testing::Types<Split<0>, Split<1>, Split<2>, Split<3>, Split<4>, Split<5>, Split<6>, Split<7>>;
TYPED_TEST_SUITE(CoarseSplits, Splits, );

TYPED_TEST(CoarseSplits, Sine) {
    this->expect("sin", INT16_MIN, std::sin, portable::sin<std::int16_t, TypeParam::value>);
}
TYPED_TEST(CoarseSplits, Cosine) {
    this->expect("cos", INT16_MIN, std::cos, portable::cos<std::int16_t, TypeParam::value>);
}
TYPED_TEST(CoarseSplits, Logarithm) {
    this->expect("log", 1, std::log, portable::log<std::int16_t, TypeParam::value>);
}
TYPED_TEST(CoarseSplits, SineAndCosine) {
    constexpr int F = TypeParam::value;
    DeviceFunction sincos(this->chip_, this->symbol("sincos"), {0, {2, 2}});
    const std::uint16_t address = this->chip_.allocate(4);
    for (int a = INT16_MIN; a <= INT16_MAX; ++a) {
        const auto angle = static_cast<std::int16_t>(a);
        sincos(angle, address);
        std::int16_t both[2];
        this->chip_.read(address, {reinterpret_cast<std::uint8_t*>(both), sizeof both});
        ASSERT_EQ(both[0], (portable::sin<std::int16_t, F>(angle))) << a;
        ASSERT_EQ(both[1], (portable::cos<std::int16_t, F>(angle))) << a;
    }
}

}  // namespace
