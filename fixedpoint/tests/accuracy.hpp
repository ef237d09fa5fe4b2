// SPDX-License-Identifier: MIT
// The errors of the functions in ulp: every result must be within the documented bound, and the
// largest and the mean error of each format over fixed operands must be those in accuracy.txt. The
// bound is the promise; the two figures change with every constant of an algorithm.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "subjects.hpp"

// For a function of one operand, or for atan2 if `function` is null.
struct Measured {
    const char* name;
    const exact::Function* function;
    std::vector<Subject> subjects;
    double bound;
};

void expect_accuracy(const Measured&);
