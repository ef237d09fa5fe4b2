/* SPDX-License-Identifier: GPL-3.0-or-later
 * fp64lib: IEEE 754 binary64, as patterns of 64 bits. */
#include <fp64lib.h>

#include "adapter.h"

/* A jump, since around a call avr-gcc would save and move the registers of the operands. */
#define IS(operation, function)                                     \
    __attribute__((naked)) void SUBJECT(operation, float64)(void) { \
        __asm__("jmp %x0" : : "p"(function));                       \
    }

IS(add, fp64_add)
IS(subtract, fp64_sub)
IS(multiply, fp64_mul)
IS(divide, fp64_div)
IS(remainder, fp64_fmod)
IS(sqrt, fp64_sqrt)
IS(cbrt, fp64_cbrt)
IS(pow, fp64_pow)
IS(sin, fp64_sin)
IS(cos, fp64_cos)
IS(tan, fp64_tan)
IS(asin, fp64_asin)
IS(acos, fp64_acos)
IS(atan, fp64_atan)
IS(atan2, fp64_atan2)
IS(exp, fp64_exp)
IS(exp2, fp64_exp2)
IS(log, fp64_log)
IS(log2, fp64_log2)
IS(log10, fp64_log10)
IS(sinh, fp64_sinh)
IS(cosh, fp64_cosh)
IS(tanh, fp64_tanh)
/* It expects its third operand below the frame of its caller, which must have one. */
float64_t SUBJECT(multiply_add, float64)(float64_t a, float64_t b, float64_t c) {
    return fp64_fma(a, b, c);
}
float64_t SUBJECT(length2, float64)(const float64_t* v) { return fp64_hypot(v[0], v[1]); }
