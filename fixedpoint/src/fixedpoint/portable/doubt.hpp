// SPDX-License-Identifier: MIT
// FIXEDPOINT_DOUBT: more than what a sum of the cores of 32 bits errs by, in units of 2^-31. The
// sine of the kernels errs most, by 9.6: its turns are not rounded to nearest.
//
// Correctly rounded functions of Q16.16, of hosts and of kernels, add half an ulp and this to a
// sum. Where what is then below an ulp is less than twice this, the exact result may lie on either
// side of a tie, and kernel/nearest.hpp decides.
#pragma once

#define FIXEDPOINT_DOUBT 10
