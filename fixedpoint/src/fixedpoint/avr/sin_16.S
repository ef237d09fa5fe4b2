// SPDX-License-Identifier: MIT
// The sine and the cosine in the 16-bit formats with fewer than 8 fraction bits: sin_q8_8.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "sin_q8_8.inc"

    .macro kernels integer, fraction
    sine_kernels \integer, \fraction
    .endm

#include "coarse_splits_16.inc"

#endif
