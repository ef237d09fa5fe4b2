// SPDX-License-Identifier: MIT
// One operation in many formats as a table of plain functions, so that a test is compiled once and
// loops over the formats at run time; and the operands of such tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fixedpoint/integer.hpp>
#include <random>
#include <utility>
#include <vector>

#include "exact.hpp"

struct Subject {
    exact::Format format;
    int64_t (*compute)(const int64_t* operands);
};

// Wrap is a lambda without captures: []<class Raw, int F>(const int64_t* v) -> int64_t {...}.
template <class Raw, int F, class Wrap>
constexpr Subject subject(Wrap) {
    return {{fixedpoint::RawLimits<Raw>::width, F},
            [](const int64_t* v) { return Wrap().template operator()<Raw, F>(v); }};
}
template <class Raw, class Wrap, int... F>
void add_subjects(std::vector<Subject>& subjects, Wrap wrap, std::integer_sequence<int, F...>) {
    (subjects.push_back(subject<Raw, F>(wrap)), ...);
}

// Every split of 8 bits, and for wider numbers the extremes, the middle and splits that are not
// whole bytes.
template <class Wrap>
std::vector<Subject> subjects(Wrap wrap) {
    std::vector<Subject> all;
    add_subjects<int8_t>(all, wrap, std::make_integer_sequence<int, 8>());
    add_subjects<int16_t>(all, wrap, std::integer_sequence<int, 0, 5, 8, 13, 14, 15>());
    add_subjects<fixedpoint::Int24>(all, wrap, std::integer_sequence<int, 0, 7, 12, 16, 22, 23>());
    add_subjects<int32_t>(all, wrap, std::integer_sequence<int, 0, 1, 8, 13, 16, 24, 27, 28, 31>());
    add_subjects<int64_t>(all, wrap,
                          std::integer_sequence<int, 0, 1, 16, 32, 47, 59, 60, 62, 63>());
    return all;
}

// All splits of 8, 16, 24 and 32 bits; of 64 bits those at which an algorithm changes its words.
template <class Wrap>
std::vector<Subject> subjects_of_every_split(Wrap wrap) {
    std::vector<Subject> all;
    add_subjects<int8_t>(all, wrap, std::make_integer_sequence<int, 8>());
    add_subjects<int16_t>(all, wrap, std::make_integer_sequence<int, 16>());
    add_subjects<fixedpoint::Int24>(all, wrap, std::make_integer_sequence<int, 24>());
    add_subjects<int32_t>(all, wrap, std::make_integer_sequence<int, 32>());
    add_subjects<int64_t>(all, wrap,
                          std::integer_sequence<int, 0, 1, 2, 6, 15, 18, 19, 31, 32, 33, 47, 50, 51,
                                                56, 60, 62, 63>());
    return all;
}

// All pairs of 8-bit numbers. For wider ones, pairs of boundary and random numbers, and each of
// them with 0, 1, -1 and the limits.
template <class Check>
void for_each_pair(int width, Check check) {
    if (width == 8) {
        for (int a = -128; a < 128; ++a) {
            for (int b = -128; b < 128; b += exact::operand_step) check(int64_t(a), int64_t(b));
        }
        return;
    }
    std::vector<int64_t> numbers = exact::raws(width, 20);
    std::mt19937_64 random(3);
    if (numbers.size() > 4000) {
        std::shuffle(numbers.begin(), numbers.end(), random);
        numbers.resize(4000);
    }
    const int64_t edges[] = {0, 1, -1, exact::smallest(width), exact::largest(width)};
    for (std::size_t n = 0; n < numbers.size(); n += exact::operand_step) {
        const int64_t a = numbers[n];
        for (int i = 0; i < 4; ++i) check(a, numbers[random() % numbers.size()]);
        // Uniformly distributed operands; the other classes are not.
        check(static_cast<int64_t>(random()) >> (64 - width),
              static_cast<int64_t>(random()) >> (64 - width));
        for (const int64_t b : edges) {
            check(a, b);
            check(b, a);
        }
        if (testing::Test::HasFatalFailure()) return;
    }
}
