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
           8,  109,  209,  309,  410,  510,  609,  708,
         807,  906, 1004, 1101, 1197, 1293, 1388, 1482,
        1576, 1668, 1759, 1850, 1939, 2027, 2114, 2200,
        2284, 2367, 2448, 2528, 2607, 2683, 2759, 2833,
        2904, 2975, 3043, 3110, 3175, 3237, 3298, 3357,
        3414, 3469, 3522, 3572, 3621, 3667, 3711, 3753,
        3792, 3830, 3865, 3897, 3928, 3956, 3981, 4005,
        4025, 4044, 4061, 4073, 4086, 4092, 4096, 4099};
    static constexpr uint8_t slope[64] FIXEDPOINT_PROGRAM_MEMORY = {
        101, 100, 101, 101, 100,  99, 100, 100,
         99,  97,  96,  96,  96,  95,  95,  94,
         92,  91,  91,  89,  88,  87,  86,  84,
         83,  81,  80,  79,  77,  76,  73,  71,
         71,  68,  67,  64,  62,  61,  59,  57,
         55,  52,  50,  49,  46,  44,  42,  39,
         38,  35,  32,  31,  28,  26,  24,  20,
         20,  16,  10,  12,   5,   9,   0,   0};
};
template <class Any>
constexpr uint16_t SinQ8_8Table<Any>::value[];
template <class Any>
constexpr uint8_t SinQ8_8Table<Any>::slope[];

}  // namespace portable
}  // namespace fixedpoint
