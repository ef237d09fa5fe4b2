/* SPDX-License-Identifier: MIT
 * Results of what has kernels in assembly, and of what has none, in a project without C++. */
#include <fixedpoint_c.h>

#include "console.h"

static void show(const char* name, const char* text) {
    while (*name) put(*name++);
    put(' ');
    while (*text) put(*text++);
    put('\n');
}

int main(void) {
    /* Not known to the compiler, so that the kernels run. */
    volatile q16_16 a = Q16_16_RATIO(3, 1), b = Q16_16_RATIO(-7, 5);
    char text[Q32_32_TEXT_CAPACITY];
    begin();
    q16_16_print(q16_16_multiply(a, b), text, sizeof text);
    show("product", text);
    q8_24_print(q8_24_divide(q8_24_from_q16_16(a), q8_24_from_q16_16(b)), text, sizeof text);
    show("quotient", text);
    q32_32_print(q32_32_sqrt(q32_32_from_q16_16(a)), text, sizeof text);
    show("root", text);
    q8_8_print_decimals(q8_8_log(q8_8_from_q16_16(a)), 2, text, sizeof text);
    show("logarithm", text);
    q16_16_print(q16_16_atan2(b, a), text, sizeof text);
    show("angle", text);
    end();
    return 0;
}
