// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/operands/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <map>

namespace operands {
namespace {

using reference::NumberFormat;
using reference::Operation;

__extension__ using Wide = __int128;

std::map<std::int64_t, std::string> table(const NumberFormat& format) {
    std::map<std::int64_t, std::string> found;
    for (const BoundaryOperand& operand : boundary_operands(format))
        found[operand.raw] = operand.what;
    return found;
}

TEST(Boundary, HoldsWhatItNames) {
    const auto found = table(reference::q16_16);
    EXPECT_EQ(found.at(0), "0");
    EXPECT_EQ(found.at(65536), "1");
    EXPECT_EQ(found.at(65537), "1 + ulp");
    EXPECT_EQ(found.at(-32768), "-0.5");
    EXPECT_EQ(found.at(INT32_MIN), "MIN, whose negative does not fit");
    EXPECT_EQ(found.at(51472), "1 pi/4, rounded");
    EXPECT_EQ(found.at(205887), "4 pi/4, rounded");
    // 11863283^2 = 2^47 - ..., the next square reaches 2^47.
    EXPECT_EQ(found.at(11863283), "the largest number whose square fits");
    // 2^32 / 3 > 2^31 - 1 >= 2^32 / 3 + ...: 1 / (3 ulp) = 21845.33 fits, 1 / (2 ulp) = 32768 does
    // not.
    EXPECT_EQ(found.at(3), "the smallest number whose reciprocal fits");
    EXPECT_EQ(found.at(0x55555555), "the pattern 0x55555555");
    EXPECT_EQ(found.at(1 << 20), "2^4");
}

TEST(Boundary, HoldsTheEdgesOfFloats) {
    const auto singles = table(reference::ieee_single);
    EXPECT_EQ(singles.at(0x7f7fffff), "MAX");
    EXPECT_EQ(singles.at(0x00800000), "the smallest normal");
    EXPECT_EQ(singles.at(INT32_MIN), "-0");
    const auto doubles = table(reference::ieee_double);
    const auto named = [&](double number) {
        return doubles.at(std::bit_cast<std::int64_t>(number));
    };
    EXPECT_EQ(named(DBL_MAX), "MAX");
    EXPECT_EQ(named(-HUGE_VAL), "-infinity");
    EXPECT_EQ(named(-0.0), "-0");
    EXPECT_EQ(named(-DBL_MIN), "the negative of the smallest normal");
    EXPECT_EQ(named(DBL_TRUE_MIN), "the smallest subnormal");
    EXPECT_EQ(named(std::nextafter(-1, 0)), "-1, toward 0");
    EXPECT_EQ(named(0x1p53), "2^53, above which odd integers are missing");
    EXPECT_EQ(named(0x1p-511), "the root of the smallest normal");
    EXPECT_EQ(named(std::nextafter(std::log(DBL_MAX), 0)), "ln MAX, the border of exp, toward 0");
    EXPECT_TRUE(std::isnan(
        std::bit_cast<double>(std::ranges::find(doubles, "not a number", [](const auto& row) {
                                  return row.second;
                              })->first)));
}

TEST(Boundary, IsSortedAndWithinEveryFormat) {
    for (const char* name :
         {"q4_4", "q8_8", "q16_16", "q32_32", "q1_15", "q1_63", "q8_24", "q64_0", "u8_8", "u0_32",
          "int8", "int64", "s8_7", "s16_47", "float", "float64"}) {
        const NumberFormat format = reference::parse_format(name);
        const auto operands = boundary_operands(format);
        EXPECT_GE(operands.size(), 40u) << name;
        for (std::size_t i = 0; i < operands.size(); ++i) {
            EXPECT_EQ(operands[i].raw, format.extend(std::uint64_t(operands[i].raw)));
            EXPECT_FALSE(operands[i].what.empty());
            if (i > 0) {
                EXPECT_LT(operands[i - 1].raw, operands[i].raw) << name;
            }
        }
    }
}

TEST(Boundary, CasesHaveTheOperationsArity) {
    for (const reference::OperationShape& shape : reference::operations) {
        for (const NumberFormat& format :
             {reference::q4_4, reference::q16_16, reference::ieee_single}) {
            const auto cases = boundary_cases(shape.operation, format);
            EXPECT_GE(cases.size(), 40u) << shape.name;
            EXPECT_TRUE(std::ranges::all_of(cases, [&](const BoundaryCase& row) {
                return row.operands.size() == shape.operands && !row.what.empty();
            }));
        }
    }
}

TEST(Boundary, TiesAreTies) {
    for (const NumberFormat& format : {reference::q4_4, reference::q16_16, reference::q32_32}) {
        for (const Operation operation : {Operation::multiply, Operation::divide}) {
            int count = 0;
            for (const BoundaryCase& row : boundary_cases(operation, format)) {
                if (row.what.find("half way") == row.what.npos) continue;
                // Twice the exact result in ulp, n / q, is an odd integer.
                const Wide a = row.operands[0], b = row.operands[1];
                const Wide unit = Wide(1) << format.fraction;
                const Wide n = operation == Operation::multiply ? 2 * a * b : 2 * a * unit;
                const Wide q = operation == Operation::multiply ? unit : b;
                EXPECT_EQ(int(n % q), 0);
                EXPECT_NE(int(n / q % 2), 0);
                ++count;
            }
            EXPECT_GE(count, 20);
        }
    }
}

}  // namespace
}  // namespace operands
