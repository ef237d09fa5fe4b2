/* SPDX-License-Identifier: GPL-3.0-or-later
 * fixedptc has one format per build: FIXEDPT_WBITS is set on the command line. */
#include <fixedptc.h>

#include "adapter.h"

#if FIXEDPT_WBITS == 16
#define FORMAT q16_16
#else
#define FORMAT q24_8
#endif
#define OF_FORMAT(operation) SUBJECT_OF_FORMAT(operation, FORMAT)
#define SUBJECT_OF_FORMAT(operation, format) SUBJECT(operation, format)

int32_t OF_FORMAT(add)(int32_t a, int32_t b) { return fixedpt_add(a, b); }
int32_t OF_FORMAT(subtract)(int32_t a, int32_t b) { return fixedpt_sub(a, b); }
int32_t OF_FORMAT(multiply)(int32_t a, int32_t b) { return fixedpt_mul(a, b); }
int32_t OF_FORMAT(divide)(int32_t a, int32_t b) { return fixedpt_div(a, b); }
int32_t OF_FORMAT(sqrt)(int32_t a) { return fixedpt_sqrt(a); }
int32_t OF_FORMAT(sin)(int32_t a) { return fixedpt_sin(a); }
int32_t OF_FORMAT(cos)(int32_t a) { return fixedpt_cos(a); }
int32_t OF_FORMAT(exp)(int32_t a) { return fixedpt_exp(a); }
int32_t OF_FORMAT(log)(int32_t a) { return fixedpt_ln(a); }
