// SPDX-License-Identifier: GPL-3.0-or-later
// Saturating sums take the processor's overflow flag whichever operand is a constant: their cycles
// tell it from the portable code, which gives the same results in four times as many.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "fixedpoint/tests/exact.hpp"

namespace {

using simulator::DeviceFunction;

constexpr std::int32_t constant = 0x12345678;
constexpr exact::Format q16_16 = {32, 16};
// call 4, ret 4, the sum 14 at most, the constant 4, and moves of operands.
constexpr std::uint32_t most_cycles = 40;

std::string folder() {
    const char* other = std::getenv("DEVICE_PROGRAMS");
    return other ? other : PROGRAM_FOLDER;
}

class SaturatingSums : public testing::Test {
  protected:
    SaturatingSums() : chip_(simulator::Elf(folder() + "/saturating_sums.elf")) {
        chip_.run_until_function("main");
    }
    template <class... Operands>
    void expect(const char* name, std::int64_t expected, Operands... operands) {
        DeviceFunction function(chip_, name, {4, {int(sizeof(operands))...}});
        const auto outcome = function(operands...);
        EXPECT_EQ(outcome.template as<std::int32_t>(), expected) << name;
        EXPECT_LE(outcome.cycles, most_cycles) << name;
    }
    simulator::Chip chip_;
};

TEST_F(SaturatingSums, AreExactAndFastWithAndWithoutConstants) {
    const std::vector<std::int64_t> raws = exact::raws(32);
    for (const std::int64_t raw : raws) {
        const auto a = std::int32_t(raw);
        expect("sum_with_constant", exact::add(raw, constant, q16_16).saturated, a);
        expect("constant_and_sum", exact::add(raw, constant, q16_16).saturated, a);
        expect("difference_with_constant", exact::subtract(raw, constant, q16_16).saturated, a);
        expect("difference_from_constant", exact::subtract(constant, raw, q16_16).saturated, a);
        for (const std::int64_t other : {raws.front(), raws[raws.size() / 3], -raw, raws.back()}) {
            const auto b = std::int32_t(other);
            expect("sum", exact::add(raw, b, q16_16).saturated, a, b);
            expect("difference", exact::subtract(raw, b, q16_16).saturated, a, b);
        }
    }
}

}  // namespace
