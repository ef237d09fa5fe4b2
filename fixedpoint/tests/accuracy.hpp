// SPDX-License-Identifier: MIT
// How far the functions are from the exact value, in ulp: every result within the documented bound,
// and the largest and the mean error of each format over fixed operands as accuracy.txt has them.
// The bound is what is promised; the two figures change with every constant of an algorithm.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "subjects.hpp"

// Of a function of one operand, or of atan2 where `function` is null.
struct Measured {
    const char* name;
    const exact::Function* function;
    std::vector<Subject> subjects;
    double bound;
};

void expect_accuracy(const Measured&);
