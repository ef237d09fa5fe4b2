// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of a judgement. Small, so that 2^32 of them cost little.
#pragma once

namespace reference {

struct Judgement {
    // Result less target, in ulp. The target is the unrounded exact result (for wrapping operations
    // the nearest number equal to it modulo 2^W), or the pinned result where `defined`. Of a
    // vector, the error of the component with the largest. Infinite if either is not a finite
    // number.
    double error_ulp = 0;
    // Its magnitude in the unit of the result; of a vector the largest, which may be another
    // component's. Set only for regular results, and not by the bulk judge.
    double error = 0;
    // The target is not an exact result in range but a pinned one: overflow that saturates or
    // becomes infinite, a zero divisor, a domain error, a NaN.
    bool defined = false;
    // The result is one that the definition allows.
    bool as_defined = true;
    // The exact value of an exponential or a power is below half an ulp: the result 0 says nothing
    // about the accuracy of the function. No other function comes this close to 0 for more than
    // single operands.
    bool underflow = false;
    // Why nothing was judged (the other members are then meaningless); null if it was.
    const char* excluded = nullptr;

    // The result rounds an exact value that the format can hold: these are the operands on which a
    // function does its work. Means of errors and of cycles include only these.
    constexpr bool regular() const { return excluded == nullptr && !defined && !underflow; }
};

}  // namespace reference
