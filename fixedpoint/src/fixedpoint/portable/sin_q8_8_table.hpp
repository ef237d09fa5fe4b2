// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/sin_q8_8.py
// The sine of the first quarter turn.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct SinQ8_8Table {
    static constexpr uint16_t value[64] FIXEDPOINT_PROGRAM_MEMORY = {
          17,  218,  419,  620,  820, 1020, 1219, 1417,
        1615, 1812, 2007, 2202, 2395, 2587, 2777, 2965,
        3152, 3337, 3519, 3700, 3879, 4055, 4228, 4400,
        4568, 4734, 4897, 5057, 5214, 5368, 5518, 5666,
        5809, 5950, 6087, 6220, 6349, 6475, 6597, 6715,
        6828, 6938, 7043, 7145, 7242, 7334, 7422, 7506,
        7585, 7660, 7730, 7795, 7856, 7912, 7963, 8010,
        8051, 8088, 8120, 8147, 8169, 8186, 8199, 8206};
    static constexpr uint8_t slope[64] FIXEDPOINT_PROGRAM_MEMORY = {
        201, 201, 201, 200, 200, 199, 198, 198,
        197, 195, 195, 193, 192, 190, 188, 187,
        185, 182, 181, 179, 176, 173, 172, 168,
        166, 163, 160, 157, 154, 150, 148, 143,
        141, 137, 133, 130, 126, 122, 118, 113,
        110, 105, 102,  96,  92,  88,  84,  79,
         75,  70,  65,  61,  56,  51,  47,  41,
         37,  32,  27,  22,  18,  13,   7,   3};
};
template <class Any>
constexpr uint16_t SinQ8_8Table<Any>::value[];
template <class Any>
constexpr uint8_t SinQ8_8Table<Any>::slope[];

}  // namespace portable
}  // namespace fixedpoint
