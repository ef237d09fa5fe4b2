/* SPDX-License-Identifier: MIT
 * What program.c leaves behind. */
#ifndef FIXEDPOINT_TESTS_C_PROGRAM_H
#define FIXEDPOINT_TESTS_C_PROGRAM_H

#include <stdint.h>

/* The parts of program.c, each of which fits the chip; CMakeLists.txt makes as many programs. */
#define C_PARTS 8

struct c_results {
    uint16_t count; /* of the functions called */
    uint32_t hash[48];
#ifndef __AVR__
    const char* name[48];
#endif
};

#endif
