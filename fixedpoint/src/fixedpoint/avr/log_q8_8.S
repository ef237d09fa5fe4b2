// SPDX-License-Identifier: MIT
// The logarithm in Q8.8: log_q8_8.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "log_q8_8.inc"

    logarithm_kernel 8, 8

#endif
