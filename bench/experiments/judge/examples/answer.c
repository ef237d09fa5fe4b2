/* SPDX-License-Identifier: GPL-3.0-or-later
 * Answers the operands of a square root of Q16.16, rounded to nearest, for `fixbench judge --pipe`:
 *
 *     fixbench operands --operation sqrt --format q16_16 | ./answer | fixbench judge --pipe --as
 * sqrt:q16_16
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static int32_t square_root(int32_t a) {
    uint64_t square, root = 0;
    if (a <= 0) return 0;
    square = (uint64_t)a << 16;
    for (uint64_t bit = (uint64_t)1 << 23; bit; bit >>= 1)
        if ((root | bit) * (root | bit) <= square) root |= bit;
    return (int32_t)(root + (square - root * root > root));
}

int main(void) {
    char line[4096];
    int32_t a;
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "#")] = '\0';
        if (sscanf(line, "%" SCNd32, &a) == 1)
            printf("%" PRId32 " %" PRId32 "\n", a, square_root(a));
    }
    return 0;
}
