// SPDX-License-Identifier: GPL-3.0-or-later
// CorrectlyRounded in formats that no program of the bench has, on the simulated chip: the results
// of the host, which fixedpoint/tests/correctly_rounded_splits_test.cpp compares with the exact
// ones. Every fourth operand or so is one whose result is on a tie of the finer format.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fixedpoint/arithmetic/correctly_rounded.hpp>
#include <random>
#include <string>
#include <vector>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/device/tests/program_folder.hpp"
#include "bench/lab/catalogue/subjects.h"

namespace {

using fixedpoint::CorrectlyRounded;
using fixedpoint::Integer;
using fixedpoint::Nearest;
using fixedpoint::RawLimits;
namespace portable = fixedpoint::portable;

template <int F>
bool is_tie(int64_t fine) {
    constexpr uint32_t half = uint32_t(1) << (portable::finer_fraction<F>() - F - 1);
    return (static_cast<uint32_t>(fine) & (2 * half - 1)) == half;
}

template <int I, int F>
class Split {
  public:
    using Raw = Integer<I + F>;

    explicit Split(const char* functions)
        : chip_(simulator::Elf(fmt::format("{}/correctly_rounded_split_{}_{}_{}.elf",
                                           program_folder(), functions, I, F))) {
        chip_.run_until_function("main");
    }
    template <class Finer>
    void expect(const char* function, Raw (*on_host)(Raw), Finer finer) {
        simulator::DeviceFunction on_chip(chip_,
                                          fmt::format("{}_split_correctly_rounded", function),
                                          {sizeof(Raw), {sizeof(Raw)}});
        on_chip.set_budget(10'000'000);
        for (const Raw a : operands(finer))
            ASSERT_EQ(on_chip(a).template as<Raw>(), on_host(a))
                << function << " of " << int64_t(a);
    }

  private:
    template <class Finer>
    static std::vector<Raw> operands(Finer finer) {
        std::vector<Raw> found = {0, 1, -1, RawLimits<Raw>::max, RawLimits<Raw>::min};
        std::mt19937 random(I);
        for (int i = 0; i < 24; ++i)
            found.push_back(static_cast<Raw>(static_cast<Raw>(random()) >> random() % (I + F)));
        int ties = 0;
        for (int i = 0; i < 400'000 && ties < 6; ++i) {
            const auto a = static_cast<Raw>(static_cast<Raw>(random()) >> random() % (I + F));
            if (!is_tie<F>(finer(portable::finer<Raw, F>(a)))) continue;
            found.push_back(a);
            ++ties;
        }
        return found;
    }
    simulator::Chip chip_;
};

#define EXPECT(name, ...)                                                \
    split.expect(#name, CorrectlyRounded::name<Raw, F>, [](int64_t a) {  \
        return Nearest::name<int64_t, portable::finer_fraction<F>()>(a); \
    });
template <int I, int F>
void expect_angles() {
    using Raw = Integer<I + F>;
    Split<I, F> split("angles");
    OPERATION_atan(EXPECT) OPERATION_sin(EXPECT) OPERATION_cos(EXPECT)
}
template <int I, int F>
void expect_arcs() {
    using Raw = Integer<I + F>;
    Split<I, F> split("arcs");
    ANGLE_OPERATIONS(EXPECT)
}
template <int I, int F>
void expect_powers() {
    using Raw = Integer<I + F>;
    Split<I, F> split("powers");
    EVERY_UNARY_POWER(EXPECT)
}
TEST(AnglesOfSplit, Q1_31) { expect_angles<1, 31>(); }
TEST(ArcsOfSplit, Q1_31) { expect_arcs<1, 31>(); }
TEST(PowersOfSplit, Q1_31) { expect_powers<1, 31>(); }
TEST(AnglesOfSplit, Q2_14) { expect_angles<2, 14>(); }
TEST(ArcsOfSplit, Q2_14) { expect_arcs<2, 14>(); }
TEST(PowersOfSplit, Q2_14) { expect_powers<2, 14>(); }
TEST(AnglesOfSplit, Q24_8) { expect_angles<24, 8>(); }
TEST(ArcsOfSplit, Q24_8) { expect_arcs<24, 8>(); }
TEST(PowersOfSplit, Q24_8) { expect_powers<24, 8>(); }

}  // namespace
