// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/table_3_2/table_3_2.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "bench/experiments/table_3_2/division.hpp"
#include "this_build.hpp"

namespace table_3_2 {
namespace {

const std::filesystem::path folder = build_folder() / "bench/experiments/table_3_2";
const Operands seven_by_three{{7, 3}, {3.75, 1.25}, false};

std::vector<Program> programs() { return load_programs(folder / "programs.csv"); }

Program plain_program() {
    for (const Program& program : programs()) {
        if (program.flags == "-Os" && program.loop == "int" && program.operators == "inlined" &&
            program.shift == "constant" && program.widening == "after") {
            return program;
        }
    }
    throw std::runtime_error("no plain program");
}

// By hand: lds takes 2 per byte of both operands, sub and sbc 1 per byte, sts 2 per byte, sbiw 2
// and brne 2.
TEST(Harness, CyclesOfAPassAreThoseCountedByHand) {
    Harness harness(plain_program().elf);
    EXPECT_EQ(harness.cycles("assign", {"int16_t", "subtract"}, seven_by_three, 5), 7 * 2 + 4);
    EXPECT_EQ(harness.cycles("assign", {"int32_t", "subtract"}, seven_by_three, 5), 7 * 4 + 4);
    // One more load and one more addition per byte.
    EXPECT_EQ(harness.cycles("accumulate", {"int16_t", "add"}, seven_by_three, 5), 10 * 2 + 4);
}

// 30000 passes of 18 cycles are 33.75 ms; the timer's interrupt takes half a percent more.
TEST(Harness, MillisecondsAreThoseOfTheCore) {
    Harness harness(plain_program().elf);
    const auto ms = harness.milliseconds("assign", {"int16_t", "subtract"}, seven_by_three);
    EXPECT_GE(ms, 33u);
    EXPECT_LE(ms, 35u);
    const auto longer = harness.milliseconds("assign", {"int32_t", "divide"}, seven_by_three);
    const double undisturbed =
        undisturbed_ms(harness.cycles("assign", {"int32_t", "divide"}, seven_by_three, 5));
    EXPECT_NEAR(longer / undisturbed, 1.0055, 0.0015);
}

TEST(Harness, SaysWhichCellIsMissing) {
    Harness harness(plain_program().elf);
    EXPECT_THROW(harness.cycles("assign", {"int16_t", "power"}, seven_by_three, 1),
                 simulator::ElfError);
}

TEST(Judge, WithinTenPercentIsReproduced) {
    const Hypothesis hypothesis{plain_program(), "assign", seven_by_three};
    EXPECT_EQ(judge(100, 109, hypothesis, {}).verdict, "reproduced");
    EXPECT_EQ(judge(100, 91, hypothesis, {}).verdict, "reproduced");
    EXPECT_EQ(judge(100, 111, hypothesis, {}).verdict, "not reproducible");
}

// Both ends belong to the 10%, for published figures of every size.
TEST(Judge, ExactlyTenPercentIsReproduced) {
    const Hypothesis hypothesis{plain_program(), "assign", seven_by_three};
    Hypothesis other = hypothesis;
    other.form = "accumulate";
    for (int published = 10; published <= 5000; published += 10) {
        for (const int side : {-1, 1}) {
            const int at = published + side * published / 10, beyond = at + side;
            EXPECT_EQ(judge(published, at, hypothesis, {}).verdict, "reproduced") << published;
            EXPECT_EQ(judge(published, beyond, hypothesis, {}).verdict, "not reproducible");
            EXPECT_EQ(
                judge(published, 1, hypothesis, {Alternative{other, double(at)}, 1, 3}).verdict,
                "explained");
            EXPECT_EQ(
                judge(published, 1, hypothesis, {Alternative{other, double(beyond)}, 1, 3}).verdict,
                "not reproducible");
        }
    }
    EXPECT_EQ(judge(200, 190, hypothesis, {}).reason, "-5.0% under the table's hypothesis");
    EXPECT_EQ(judge(200, 300, hypothesis, {}).reason, "no alternative tried");
}

TEST(Hypothesis, AnAlternativeDiffersOnOneAxisOrOnTheFormAndOneMore) {
    const Program program{"", "-Os", "int", "inlined", "constant", "after"};
    const Hypothesis best{program, "assign", seven_by_three};
    Hypothesis other = best;
    EXPECT_FALSE(is_alternative(best, other));
    other.program.loop = "long";
    EXPECT_TRUE(is_alternative(best, other));
    other.program.shift = "variable";
    EXPECT_FALSE(is_alternative(best, other));
    other.program.shift = best.program.shift;
    other.form = "replace";
    EXPECT_TRUE(is_alternative(best, other));
    other.operands.raw = !other.operands.raw;
    EXPECT_FALSE(is_alternative(best, other));
    other.program.loop = best.program.loop;
    EXPECT_TRUE(is_alternative(best, other));
}

// The first that is as good as the best, has the usual flags and does not leave early.
TEST(Hypothesis, ThePreferredOneIsAsGoodAsTheBest) {
    const auto fit = [](double sum, const char* flags, const char* loop, Operands operands) {
        Program program{};
        program.flags = flags;
        program.loop = loop;
        return Fit{{program, "assign", operands}, sum, 0};
    };
    const Operands plain = seven_by_three, by_zero{{7, 3}, {3.75, 0}, false},
                   too_large{{7, 3}, {1e30, 1e30}, false};
    const auto rank = [&](const std::vector<Fit>& fits) { return &preferred(fits) - fits.data(); };
    EXPECT_EQ(rank({fit(1, "-O2", "int", plain), fit(1.05, "-Os", "int", plain)}), 1);
    EXPECT_EQ(rank({fit(1, "-O2", "int", plain), fit(1.15, "-Os", "int", plain)}), 0);
    EXPECT_EQ(rank({fit(1, "-O2", "int", plain), fit(1.05, "-Os", "long", plain)}), 0);
    EXPECT_EQ(rank({fit(1, "-Os", "int", by_zero), fit(1, "-Os", "int", too_large),
                    fit(2, "-O2", "int", plain), fit(2.05, "-Os", "int", plain)}),
              3);
    EXPECT_THROW(preferred({fit(1, "-Os", "int", by_zero)}), std::invalid_argument);
}

TEST(Judge, AnAlternativeExplainsWhenItComesWithinTenPercent) {
    const Hypothesis hypothesis{plain_program(), "assign", seven_by_three};
    Hypothesis other = hypothesis;
    other.form = "accumulate";
    const Verdict explained = judge(100, 70, hypothesis, {Alternative{other, 96}, 9, 3});
    EXPECT_EQ(explained.verdict, "explained");
    EXPECT_EQ(
        explained.reason,
        "96 ms (-4.0%) with c += a op b in place of c = a op b; 3 of 9 alternatives come within "
        "10%");
    const Verdict failed = judge(100, 70, hypothesis, {Alternative{other, 80}, 9, 3});
    EXPECT_EQ(failed.verdict, "not reproducible");
    EXPECT_EQ(failed.reason,
              "nearest of 9 alternatives: 80 ms (-20.0%) with c += a op b in place of c = a op b");
}

TEST(Hypothesis, TheSearchFindsTheBestKnown) {
    std::vector<Program> usual;
    for (const Program& program : programs()) {
        if (program.flags == "-Os" && program.loop == "int") usual.push_back(program);
    }
    const std::vector<Fit> fits = search(usual, load_published(), [] {});
    EXPECT_EQ(fits.size(), usual.size() * forms().size() * operand_pairs().size());
    EXPECT_EQ(values(preferred(fits).hypothesis), values(best_known(programs())));
}

TEST(Division, AFitFindsTheCoefficientsOfALaw) {
    std::vector<Division> divisions;
    for (std::int32_t a = -40; a <= 40; a += 3) {
        for (std::int32_t b = -70001; b <= 70001; b += 10000) {
            const std::uint64_t q = published_quotient(a, b);
            const int cycles = 500 + 200 * quotient_bytes(a, b) + 8 * std::popcount(q) +
                               (a < 0) * 7 + (b < 0) * 11 + (a < 0 && b < 0) * 3 - (q == 0) * 9;
            divisions.push_back({a, b, static_cast<std::uint32_t>(cycles)});
        }
    }
    const DivisionLaw law = fit_division_law(divisions);
    EXPECT_NEAR(law.constant, 500, 1e-6);
    EXPECT_NEAR(law.per_byte, 200, 1e-6);
    EXPECT_NEAR(law.per_one, 8, 1e-6);
    EXPECT_NEAR(law.max_residual, 0, 1e-6);
    // Two bytes whose eight ones and eight zeros take 8 * 8 cycles.
    EXPECT_NEAR(law.bytes_for(500 + 2 * 200 + 8 * 8), 2, 1e-6);
    divisions.front().cycles += 100;
    EXPECT_GT(fit_division_law(divisions).max_residual, 50);
}

TEST(Division, QuotientBytesAreCountedWithoutLeadingZeros) {
    EXPECT_EQ(quotient_bytes(0, 1), 0);
    EXPECT_EQ(quotient_bytes(1 << 16, 1 << 16), 3);  // 0x10000
    EXPECT_EQ(quotient_bytes((1 << 16) - 1, 1 << 16), 2);
    EXPECT_EQ(quotient_bytes(INT32_MIN, 1), 6);
}

// The law is exact: not a cycle is unexplained for any operands.
TEST(Division, TheDevicesDivisionFollowsTheLaw) {
    const DivisionStudy study =
        study_division(folder / "table_3_2_division.elf", seven_by_three, 500);
    EXPECT_LT(study.law.max_residual, 1e-6);
    EXPECT_NEAR(study.law.per_byte, 205, 1e-6);
    EXPECT_NEAR(study.law.per_one, 8, 1e-6);
    const Division& last = study.divisions.back();
    EXPECT_NEAR(study.law.predict(last.a, last.b), last.cycles, 1e-6);
}

// By hand: limits, resolution, floor(F log10 2) digits, half the resolution; for float the values
// of IEEE 754.
TEST(Table31, IsThatOfEachFormat) {
    using Rows = std::vector<std::vector<std::string>>;
    EXPECT_EQ(
        table_3_1().rows(),
        (Rows{
            {"q4_4", "8", "-8", "7.9375", "0.0625", "1", "0.0312"},
            {"q8_8", "16", "-128", "127.99609375", "0.00390625", "2", "0.00195"},
            {"q8_16", "24", "-128", "127.9999847412109375", "1.52588e-05", "4", "7.63e-06"},
            {"q12_12", "24", "-2048", "2047.999755859375", "0.000244141", "3", "0.000122"},
            {"q16_16", "32", "-32768", "32767.9999847412109375", "1.52588e-05", "4", "7.63e-06"},
            {"q8_24", "32", "-128", "127.999999940395355224609375", "5.96046e-08", "7", "2.98e-08"},
            {"q32_32", "64", "-2147483648", "2147483647.99999999976716935634613037109375",
             "2.32831e-10", "9", "1.16e-10"},
            {"float", "32", "-3.40282347e+38", "3.40282347e+38", "1.4013e-45", "6", "5.96e-08"}}));
}

}  // namespace
}  // namespace table_3_2
