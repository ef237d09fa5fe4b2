// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of a judgement. Small, so that 2^32 of them cost little.
#pragma once

namespace reference {

struct Judgement {
    // Result less target, in ulp. The target is the unrounded exact result (wrapping operations:
    // modulo 2^W, the nearest way round), or the pinned result where `defined`. Of a vector the
    // component with the largest. Infinite where one of the two is no finite number.
    double error_ulp = 0;
    // Its size in the unit of the result; of a vector the largest, which may be another
    // component's. Of regular results, which were not judged in bulk.
    double error = 0;
    // No rounding of an exact result in range but a pinned one: overflow that clamps or becomes
    // infinite, a zero divisor, a domain error, a not-a-number.
    bool defined = false;
    // The result is one that the definition allows.
    bool as_defined = true;
    // The exact value of exp is below half an ulp: the result 0 tells nothing of how exactly the
    // function is computed. No other function comes so near to 0 for more than single operands.
    bool underflow = false;
    // Why nothing was judged (the other members then say nothing); null where it was.
    const char* excluded = nullptr;

    // The result rounds an exact value that the format can hold: the operands on which a function
    // does its work. Neither means of errors nor means of cycles take others in.
    constexpr bool regular() const { return excluded == nullptr && !defined && !underflow; }
};

}  // namespace reference
