// SPDX-License-Identifier: GPL-3.0-or-later
// Saturating sums use the processor's overflow flag whichever operand is a constant. Their cycles
// distinguish them from the portable code, which gives the same results in two to four times as
// many.
#include <gtest/gtest.h>

#include <string>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "bench/device/tests/program_folder.hpp"
#include "fixedpoint/tests/exact.hpp"

namespace {

using simulator::DeviceFunction;

// For 32 bits: call 4, ret 4, the sum at most 14, the constant 4, and moves of operands.
template <class Raw>
constexpr std::uint32_t max_cycles = 10 * sizeof(Raw);

class SaturatingSums : public testing::Test {
  protected:
    SaturatingSums() : chip_(simulator::Elf(program_folder() + "/saturating_sums.elf")) {
        chip_.run_until_function("main");
    }
    template <class Raw, class... Operands>
    void expect(const char* name, std::int64_t expected, Operands... operands) {
        const std::string symbol = name + ("_" + std::to_string(8 * sizeof(Raw)));
        DeviceFunction function(chip_, symbol, {sizeof(Raw), {int(sizeof(operands))...}});
        const auto outcome = function(operands...);
        EXPECT_EQ(outcome.template as<Raw>(), expected) << symbol;
        EXPECT_LE(outcome.cycles, max_cycles<Raw>) << symbol;
    }
    template <class Raw>
    void expect_all(Raw constant) {
        constexpr exact::Format format = {8 * sizeof(Raw), 4 * sizeof(Raw)};
        const std::vector<std::int64_t> raws = exact::raws(format.width);
        for (const std::int64_t raw : raws) {
            const auto a = Raw(raw);
            expect<Raw>("sum_with_constant", exact::add(raw, constant, format).saturated, a);
            expect<Raw>("constant_and_sum", exact::add(raw, constant, format).saturated, a);
            expect<Raw>("difference_with_constant",
                        exact::subtract(raw, constant, format).saturated, a);
            expect<Raw>("difference_from_constant",
                        exact::subtract(constant, raw, format).saturated, a);
            for (const std::int64_t other :
                 {raws.front(), raws[raws.size() / 3], -raw, raws.back()}) {
                const auto b = Raw(other);
                expect<Raw>("sum", exact::add(a, b, format).saturated, a, b);
                expect<Raw>("difference", exact::subtract(a, b, format).saturated, a, b);
            }
        }
    }
    simulator::Chip chip_;
};

TEST_F(SaturatingSums, AreExactAndFastWithAndWithoutConstants) {
    expect_all<std::int16_t>(0x1234);
    expect_all<std::int32_t>(0x12345678);
}

}  // namespace
