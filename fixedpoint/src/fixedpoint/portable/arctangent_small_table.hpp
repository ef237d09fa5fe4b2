// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/parabolas_small.py
// Parabolas of 256/257 atan(x) on 16 cells of [0, 1]: the bend in units of 2^-8, the slope
// in 2^-16, the value in 2^-24, with half an ulp of Q16.16.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// Any is void: a template's static member may stand in a header.
template <class Any = void>
struct ArctangentSmallTable {
    static constexpr uint8_t bend[16] FIXEDPOINT_PROGRAM_MEMORY = {
          8,  24,  38,  51,  62,  70,  76,  80,
         82,  83,  82,  80,  77,  73,  70,  66};
    static constexpr uint16_t slope[16] FIXEDPOINT_PROGRAM_MEMORY = {
        65329, 65079, 64319, 63103, 61477, 59494, 57243, 54796,
        52222, 49594, 46943, 44327, 41773, 39305, 36968, 34737};
    static constexpr uint32_t value[16] FIXEDPOINT_PROGRAM_MEMORY = {
              84,  1043220,  2078301,  3097614,  4094159,  5061908,  5995883,  6892323,
         7748591,  8563135,  9335400, 10065509, 10754280, 11402978, 12013153, 12586733};
};
template <class Any>
constexpr uint8_t ArctangentSmallTable<Any>::bend[];
template <class Any>
constexpr uint16_t ArctangentSmallTable<Any>::slope[];
template <class Any>
constexpr uint32_t ArctangentSmallTable<Any>::value[];

}  // namespace portable
}  // namespace fixedpoint
