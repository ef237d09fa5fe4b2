// SPDX-License-Identifier: MIT
// The sine and the cosine in Q8.8: sin_q8_8.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "sin_q8_8.inc"

    sine_kernels 8, 8

#endif
