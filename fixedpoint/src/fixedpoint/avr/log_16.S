// SPDX-License-Identifier: MIT
// The logarithm in the 16-bit formats with fewer than 8 fraction bits: log_q8_8.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "log_q8_8.inc"

    .macro kernels integer, fraction
    logarithm_kernel \integer, \fraction
    .endm

#include "coarse_splits_16.inc"

#endif
