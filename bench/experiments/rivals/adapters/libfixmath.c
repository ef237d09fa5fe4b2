/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <fix16.h>

#include "adapter.h"

fix16_t SUBJECT(add, q16_16)(fix16_t a, fix16_t b) { return fix16_add(a, b); }
fix16_t SUBJECT(subtract, q16_16)(fix16_t a, fix16_t b) { return fix16_sub(a, b); }
fix16_t SUBJECT(multiply, q16_16)(fix16_t a, fix16_t b) { return fix16_mul(a, b); }
fix16_t SUBJECT(divide, q16_16)(fix16_t a, fix16_t b) { return fix16_div(a, b); }
fix16_t SUBJECT(remainder, q16_16)(fix16_t a, fix16_t b) { return fix16_mod(a, b); }
fix16_t SUBJECT(sqrt, q16_16)(fix16_t a) { return fix16_sqrt(a); }
fix16_t SUBJECT(sin, q16_16)(fix16_t a) { return fix16_sin(a); }
fix16_t SUBJECT(cos, q16_16)(fix16_t a) { return fix16_cos(a); }
fix16_t SUBJECT(atan, q16_16)(fix16_t a) { return fix16_atan(a); }
fix16_t SUBJECT(atan2, q16_16)(fix16_t y, fix16_t x) { return fix16_atan2(y, x); }
fix16_t SUBJECT(exp, q16_16)(fix16_t a) { return fix16_exp(a); }
fix16_t SUBJECT(log, q16_16)(fix16_t a) { return fix16_log(a); }
