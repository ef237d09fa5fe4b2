/* SPDX-License-Identifier: GPL-3.0-or-later
 * Q16.16 as a first attempt usually does it: through the compiler's 64-bit integers. */
#include "adapter.h"

int32_t SUBJECT(multiply, q16_16)(int32_t a, int32_t b) { return ((int64_t)a * b) >> 16; }
int32_t SUBJECT(divide, q16_16)(int32_t a, int32_t b) { return ((int64_t)a << 16) / b; }
int32_t SUBJECT(multiply, q8_24)(int32_t a, int32_t b) { return ((int64_t)a * b) >> 24; }
int32_t SUBJECT(divide, q8_24)(int32_t a, int32_t b) { return ((int64_t)a << 24) / b; }
int64_t SUBJECT(multiply, int64)(int64_t a, int64_t b) { return a * b; }
int64_t SUBJECT(divide, int64)(int64_t a, int64_t b) { return a / b; }
