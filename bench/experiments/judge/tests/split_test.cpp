// SPDX-License-Identifier: GPL-3.0-or-later
// The fast judge of a split agrees with the exact one, for right results and for wrong ones.
#include "bench/experiments/judge/split.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bench/lab/operands/boundary.hpp"
#include "reference/judge.hpp"

namespace judge {
namespace {

using reference::Judgement;
using reference::Operation;

// A result that is right or nearly right, from the exact error of any result.
std::int64_t near(const reference::Subject& subject, std::span<const std::int64_t> operands,
                  std::mt19937_64& random) {
    std::int64_t result = 0;
    for (int i = 0; i < 2; ++i) {
        const Judgement judgement = reference::judge(subject, operands, std::span(&result, 1));
        if (judgement.excluded || !std::isfinite(judgement.error_ulp)) break;
        const double nearer = double(result) - judgement.error_ulp;
        if (std::abs(nearer) > std::ldexp(1.0, 62)) break;
        result = subject.format.extend(std::uint64_t(std::llround(nearer)));
    }
    return subject.format.extend(std::uint64_t(result) + random() % 3 - 1);
}

void compare(const reference::Subject& subject, std::span<const std::int64_t> operands,
             std::mt19937_64& random) {
    const SplitJudge fast = split_judge(subject);
    for (const std::int64_t result :
         {near(subject, operands, random), subject.format.extend(random())}) {
        const Judgement exact = reference::judge(subject, operands, std::span(&result, 1)),
                        judged = fast(subject.format, operands, std::span(&result, 1));
        const std::string where =
            fmt::format("{} of {} in {}: {}", reference::shape(subject.operation).name,
                        fmt::join(operands, " "), reference::format_name(subject.format), result);
        // Double has 53 bits, even for an error of half the range.
        ASSERT_NEAR(judged.error_ulp, exact.error_ulp,
                    std::ldexp(1, -14) + std::abs(exact.error_ulp) * 1e-15)
            << where;
        ASSERT_EQ(judged.defined, exact.defined) << where;
        ASSERT_EQ(judged.underflow, exact.underflow) << where;
        ASSERT_EQ(judged.excluded == nullptr, exact.excluded == nullptr) << where;
        ASSERT_EQ(judged.as_defined, exact.as_defined) << where;
    }
}

// A sanitizer checks paths and not results, so every other split suffices.
#ifdef SPARSE_OPERANDS
constexpr int split_step = 2;
#else
constexpr int split_step = 1;
#endif

TEST(SplitJudge, AgreesWithTheExactOne) {
    std::mt19937_64 random(1);
    std::size_t judged = 0;
    for (const int width : {8, 16, 32, 64}) {
        const int fractions[] = {0, 1, width / 2 - 1, width - 4, width - 2, width - 1};
        for (std::size_t f = 0; f < std::size(fractions); f += split_step)
            for (int i = 0; i <= int(Operation::convert); ++i) {
                const reference::NumberFormat format{reference::FormatKind::fixed, width,
                                                     fractions[f]};
                const reference::Subject subject{Operation(i), format,
                                                 reference::Arithmetic::nearest};
                if (split_judge(subject) == nullptr) continue;
                ++judged;
                std::vector<std::int64_t> operands(reference::shape(Operation(i)).operands);
                const auto cases = operands::boundary_cases(Operation(i), format);
                for (int k = 0; k < 15; ++k)
                    compare(subject, cases[random() % cases.size()].operands, random);
                for (int k = 0; k < 30; ++k) {
                    for (std::int64_t& raw : operands)  // of all magnitudes
                        raw = format.extend(random()) >> random() % unsigned(width);
                    compare(subject, operands, random);
                }
                if (testing::Test::HasFatalFailure()) return;
            }
    }
    EXPECT_GT(judged, 600u / split_step);
}

TEST(SplitJudge, OthersAreForTheExactJudge) {
    const reference::NumberFormat format{reference::FormatKind::fixed, 64, 40};
    EXPECT_EQ(split_judge({Operation::sin, format, reference::Arithmetic::nearest}), nullptr);
    EXPECT_EQ(split_judge({Operation::add, format, reference::Arithmetic::saturating}), nullptr);
    EXPECT_EQ(split_judge({Operation::shift_left, format, reference::Arithmetic::nearest}),
              nullptr);
    EXPECT_NE(split_judge({Operation::multiply, format, reference::Arithmetic::nearest}), nullptr);
}

}  // namespace
}  // namespace judge
