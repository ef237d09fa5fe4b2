// SPDX-License-Identifier: MIT
// The formats that a test of a generic operation is instantiated for: every split of 8 bits, and of
// the wider numbers the ends, the middle and splits that are not whole bytes; and the pairs of
// operands that it goes through.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "exact.hpp"

using Formats =
    testing::Types<exact::Format<int8_t, 0>, exact::Format<int8_t, 1>, exact::Format<int8_t, 2>,
                   exact::Format<int8_t, 3>, exact::Format<int8_t, 4>, exact::Format<int8_t, 5>,
                   exact::Format<int8_t, 6>, exact::Format<int8_t, 7>, exact::Format<int8_t, 8>,
                   exact::Format<int16_t, 0>, exact::Format<int16_t, 5>, exact::Format<int16_t, 8>,
                   exact::Format<int16_t, 15>, exact::Format<int16_t, 16>,
                   exact::Format<int32_t, 0>, exact::Format<int32_t, 1>, exact::Format<int32_t, 8>,
                   exact::Format<int32_t, 13>, exact::Format<int32_t, 16>,
                   exact::Format<int32_t, 24>, exact::Format<int32_t, 31>,
                   exact::Format<int32_t, 32>, exact::Format<int64_t, 0>, exact::Format<int64_t, 1>,
                   exact::Format<int64_t, 16>, exact::Format<int64_t, 32>,
                   exact::Format<int64_t, 47>, exact::Format<int64_t, 63>>;

// All pairs of 8-bit numbers; of wider ones each with a few chosen at random, and with 0, 1, -1 and
// the limits.
template <class Raw, class Check>
void for_each_pair(Check check) {
    const std::vector<Raw> numbers = exact::raws<Raw>();
    std::mt19937_64 random(3);
    for (const Raw a : numbers) {
        if (sizeof(Raw) == 1) {
            for (const Raw b : numbers) check(a, b);
            continue;
        }
        for (int i = 0; i < 4; ++i) check(a, numbers[random() % numbers.size()]);
        for (const Raw b : {Raw(0), Raw(1), Raw(-1), fixedpoint::RawLimits<Raw>::min,
                            fixedpoint::RawLimits<Raw>::max}) {
            check(a, b);
            check(b, a);
        }
        if (testing::Test::HasFatalFailure()) return;
    }
}
