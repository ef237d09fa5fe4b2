// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/operands/operand_class.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "bench/lab/operands/range.hpp"

namespace operands {
namespace {

using reference::NumberFormat;
using reference::Operation;

constexpr int draws = 20000;

std::vector<double> sample(Operation operation, const char* format_name, OperandClass operand_class,
                           std::uint64_t seed = 1) {
    const NumberFormat format = reference::parse_format(format_name);
    Sampler sampler(operation, format, operand_class, seed);
    std::vector<std::int64_t> operands(reference::shape(operation).operands);
    std::vector<double> values;
    for (int i = 0; i < draws; ++i) {
        sampler.next(operands);
        for (const std::int64_t raw : operands) values.push_back(reference::to_double(format, raw));
    }
    return values;
}

double share(const std::vector<double>& values, double least, double greatest) {
    int inside = 0;
    for (const double value : values) inside += value >= least && value < greatest;
    return double(inside) / double(values.size());
}

TEST(OperandClass, NamesAreReadAndPrinted) {
    for (const OperandClass operand_class : operand_classes)
        EXPECT_EQ(parse_class(class_name(operand_class)), operand_class);
    EXPECT_THROW(parse_class("tiny"), std::invalid_argument);
}

TEST(OperandClass, TheSameSeedGivesTheSameOperands) {
    for (const OperandClass operand_class : operand_classes) {
        const auto first = sample(Operation::multiply, "q16_16", operand_class, 5);
        EXPECT_EQ(first, sample(Operation::multiply, "q16_16", operand_class, 5));
        if (operand_class != OperandClass::published) {
            EXPECT_NE(first, sample(Operation::multiply, "q16_16", operand_class, 6));
        }
    }
}

TEST(OperandClass, TheFirstDrawsStayWhatTheyAre) {
    // Committed figures depend on these operands.
    Sampler sampler(Operation::multiply, reference::q16_16, OperandClass::physics, 1);
    std::int64_t operands[2];
    sampler.next(operands);
    EXPECT_EQ(operands[0], 1303);
    EXPECT_EQ(operands[1], 14932);
}

TEST(OperandClass, SmallIsUniformBelowOne) {
    for (const char* format : {"q4_4", "q8_8", "q16_16", "q32_32", "s16_15", "float", "float64"}) {
        const auto values = sample(Operation::multiply, format, OperandClass::small);
        EXPECT_EQ(share(values, -1, 1), 1) << format;
        EXPECT_EQ(share(values, 0, 1e-30), 0) << format;
        EXPECT_NEAR(share(values, -1, 0), 0.5, 0.01) << format;
        EXPECT_NEAR(share(values, 0.5, 1), 0.25, 0.03) << format;
    }
    for (const double value : sample(Operation::add, "int16", OperandClass::small))
        ASSERT_EQ(std::abs(value), 1);
}

TEST(OperandClass, PhysicsIsLogUniform) {
    for (const char* format : {"q16_16", "q32_32", "s16_15", "float", "float64"}) {
        const auto values = sample(Operation::divide, format, OperandClass::physics);
        EXPECT_EQ(share(values, -20.0001, -0.0099) + share(values, 0.0099, 20.0001), 1) << format;
        const double decade = std::log(10) / std::log(2000) / 2;
        EXPECT_NEAR(share(values, 0.01, 0.1), decade, 0.01) << format;
        EXPECT_NEAR(share(values, 0.1, 1), decade, 0.01) << format;
        EXPECT_NEAR(share(values, -10, -1), decade, 0.01) << format;
        // Also within a binade.
        const double half_binade = std::log(1.5) / std::log(2000) / 2;
        EXPECT_NEAR(share(values, 1, 1.5), half_binade, 0.005) << format;
    }
}

TEST(OperandClass, PhysicsIsClippedToTheFormat) {
    const auto values = sample(Operation::divide, "q4_4", OperandClass::physics);
    EXPECT_EQ(share(values, -7.95, -0.06) + share(values, 0.06, 7.95), 1);
    EXPECT_GT(share(values, 7, 7.95), 0);
    const auto integers = sample(Operation::divide, "int16", OperandClass::physics);
    EXPECT_EQ(share(integers, -20.5, -0.5) + share(integers, 0.5, 20.5), 1);
    EXPECT_GT(share(integers, 16, 20.5), 0);
}

TEST(OperandClass, FullCoversEveryBinade) {
    const auto values = sample(Operation::divide, "q16_16", OperandClass::full);
    EXPECT_EQ(share(values, 0, 1e-9), 0);
    EXPECT_NEAR(share(values, 1, 2), 0.5 / 31, 0.004);
    EXPECT_NEAR(share(values, 16384, 32768), 0.5 / 31, 0.004);
    EXPECT_NEAR(share(values, -32769, -16384), 0.5 / 31, 0.004);
    EXPECT_GT(share(values, 0.00001, 0.00002), 0.005);
    const auto singles = sample(Operation::divide, "float", OperandClass::full);
    EXPECT_NEAR(share(singles, 1e20, HUGE_VAL), 0.12, 0.01);
    const auto doubles = sample(Operation::divide, "float64", OperandClass::full);
    EXPECT_NEAR(share(doubles, 0x1p512, HUGE_VAL), 0.125, 0.01);
    EXPECT_NEAR(share(doubles, -0x1p-512, 0), 0.125, 0.01);
}

TEST(OperandClass, UniformTakesEveryRawAlike) {
    Sampler sampler(Operation::divide, reference::q4_4, OperandClass::uniform, 1);
    std::vector<int> counts(256);
    std::int64_t operands[2];
    for (int i = 0; i < 128 * 1000; ++i) {
        sampler.next(operands);
        for (const std::int64_t raw : operands) ++counts.at(std::size_t(raw + 128));
    }
    // The sum of squared deviations over 256 cells is 255 +- 23; more than 5 standard deviations is
    // not chance.
    double deviation = 0;
    for (const int count : counts) deviation += (count - 1000.0) * (count - 1000.0) / 1000;
    EXPECT_NEAR(deviation, 255, 5 * 23);
    // Also in pairs: the path of a quotient depends on both.
    const auto values = sample(Operation::multiply, "q32_32", OperandClass::uniform);
    EXPECT_NEAR(share(values, 0, 0x1p30), 0.25, 0.01);
    EXPECT_NEAR(share(values, -0x1p31, -0x1p30), 0.25, 0.01);
    for (const char* format : {"float", "float64"})
        for (const double number : sample(Operation::add, format, OperandClass::uniform))
            ASSERT_TRUE(std::isfinite(number));
}

TEST(OperandClass, LowBitsOfWideRawsAreRandom) {
    Sampler sampler(Operation::multiply, reference::q32_32, OperandClass::full, 1);
    std::int64_t operands[2];
    int odd = 0;
    for (int i = 0; i < draws; ++i) {
        sampler.next(operands);
        odd += operands[0] & 1;
    }
    EXPECT_NEAR(double(odd) / draws, 0.5, 0.02);
}

TEST(OperandClass, RootsAndLogarithmsGetPositiveOperands) {
    for (const Operation operation : {Operation::sqrt, Operation::reciprocal_sqrt, Operation::log,
                                      Operation::log1p, Operation::pow}) {
        for (const OperandClass operand_class : operand_classes)
            EXPECT_EQ(share(sample(operation, "q16_16", operand_class), 0, HUGE_VAL), 1);
    }
}

TEST(OperandClass, ShiftCountsStayBelowTheWidth) {
    Sampler sampler(Operation::shift_left, reference::q8_8, OperandClass::physics, 1);
    std::int64_t operands[2], least = 99, greatest = -1;
    for (int i = 0; i < 1000; ++i) {
        sampler.next(operands);
        least = std::min(least, operands[1]);
        greatest = std::max(greatest, operands[1]);
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(greatest, 15);
}

TEST(OperandClass, ExponentsOfPowersAreSmallIntegers) {
    for (const char* name : {"q16_16", "float"}) {
        const reference::NumberFormat format = reference::parse_format(name);
        Sampler sampler(Operation::power, format, OperandClass::full, 1);
        std::int64_t operands[2];
        std::set<double> drawn;
        for (int i = 0; i < 1000; ++i) {
            sampler.next(operands);
            drawn.insert(format.is_float() ? reference::to_double(format, operands[1])
                                           : double(operands[1]));
        }
        EXPECT_EQ(drawn.size(), 17u);
        EXPECT_EQ(*drawn.begin(), -8);
        EXPECT_EQ(*drawn.rbegin(), 8);
    }
}

// In a format without fraction bits, 1 is the only physical operand of asin.
TEST(OperandClass, AClassMayContainASingleNumber) {
    for (const double value : sample(Operation::asin, "q16_0", OperandClass::physics))
        EXPECT_EQ(std::abs(value), 1);
}

TEST(OperandClass, PublishedIsOnePair) {
    EXPECT_EQ(distinct_samples(OperandClass::published, 1000), 1u);
    EXPECT_EQ(distinct_samples(OperandClass::full, 1000), 1000u);
    const auto values = sample(Operation::dot2, "q16_16", OperandClass::published);
    EXPECT_EQ(values[0], values[2]);
    EXPECT_EQ(values[1], values[3]);
    EXPECT_EQ(values[0], values[4]);
}

TEST(Range, PartsJoinToTheWhole) {
    EXPECT_EQ(every_raw(reference::q4_4), (Range{-128, 127}));
    EXPECT_EQ(every_raw(reference::q16_16).size(), std::uint64_t(1) << 32);
    EXPECT_EQ(every_raw(reference::ieee_single).size(), std::uint64_t(1) << 32);
    EXPECT_THROW(every_raw(reference::q32_32), std::invalid_argument);
    for (const std::uint64_t count : {1, 2, 3, 7, 255, 256}) {
        std::int64_t next = -128;
        for (std::uint64_t i = 0; i < count; ++i) {
            const Range shard = part({-128, 127}, i, count);
            EXPECT_EQ(shard.first, next);
            EXPECT_GE(shard.size(), 256 / count);
            next = shard.last + 1;
        }
        EXPECT_EQ(next, 128);
    }
    EXPECT_THROW(part({0, 9}, 3, 3), std::invalid_argument);
    EXPECT_THROW(part({0, 9}, 0, 11), std::invalid_argument);
}

}  // namespace
}  // namespace operands
