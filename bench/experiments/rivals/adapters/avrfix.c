/* SPDX-License-Identifier: GPL-3.0-or-later
 * AVRfix: s7.8, s15.16 and s7.24; sums are the compiler's. */
#include <avrfix.h>
#include <stddef.h>

#include "adapter.h"

int16_t SUBJECT(multiply, q8_8)(int16_t a, int16_t b) { return smulskD(a, b); }
int16_t SUBJECT(divide, q8_8)(int16_t a, int16_t b) { return sdivskD(a, b); }

int32_t SUBJECT(multiply, q16_16)(int32_t a, int32_t b) { return mulkD(a, b); }
int32_t SUBJECT(divide, q16_16)(int32_t a, int32_t b) { return divkD(a, b); }
int32_t SUBJECT(sqrt, q16_16)(int32_t a) { return sqrtk(a); }
int32_t SUBJECT(sin, q16_16)(int32_t a) { return sink(a); }
int32_t SUBJECT(cos, q16_16)(int32_t a) { return cosk(a); }
/* Its first operand is x. */
int32_t SUBJECT(atan2, q16_16)(int32_t y, int32_t x) { return atan2k(x, y); }
int32_t SUBJECT(atan, q16_16)(int32_t a) { return atank(a); }
int32_t SUBJECT(log, q16_16)(int32_t a) { return logk(a); }

int32_t SUBJECT(multiply, q8_24)(int32_t a, int32_t b) { return lmullkD(a, b); }
int32_t SUBJECT(divide, q8_24)(int32_t a, int32_t b) { return ldivlkD(a, b); }
int32_t SUBJECT(sqrt, q8_24)(int32_t a) { return lsqrtlk(a); }
int32_t SUBJECT(sin, q8_24)(int32_t a) { return lsinlk(a); }
int32_t SUBJECT(cos, q8_24)(int32_t a) { return lcoslk(a); }
int32_t SUBJECT(atan2, q8_24)(int32_t y, int32_t x) { return latan2lk(x, y); }
int32_t SUBJECT(log, q8_24)(int32_t a) { return lloglk(a); }
