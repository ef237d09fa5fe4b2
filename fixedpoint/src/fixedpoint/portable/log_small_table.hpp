// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_small.py
// Parabolas of ln(1 + x) on 16 cells of [0, 1]: the slope in units of 2^-16, the bend in
// 2^-8, the value in 2^-24, plus half an ulp of Q16.16.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct LogarithmSmallTable {
    static constexpr uint16_t slope[16] FIXEDPOINT_PROGRAM_MEMORY = {
        65486, 61642, 58226, 55158, 52405, 49913, 47649, 45569,
        43684, 41925, 40325, 38821, 37435, 36156, 34942, 33818};
    static constexpr uint8_t bend[16] FIXEDPOINT_PROGRAM_MEMORY = {
        120, 107,  96,  86,  78,  71,  65,  59,
         55,  50,  47,  43,  40,  38,  35,  33};
    static constexpr uint32_t value[16] FIXEDPOINT_PROGRAM_MEMORY = {
             175,  1017276,  1976222,  2883326,  3743878,  4562435,  5342895,  6088695,
         6802691,  7487603,  8145584,  8778793,  9388940,  9977643, 10546441, 11096557};
};
template <class Any>
constexpr uint16_t LogarithmSmallTable<Any>::slope[];
template <class Any>
constexpr uint8_t LogarithmSmallTable<Any>::bend[];
template <class Any>
constexpr uint32_t LogarithmSmallTable<Any>::value[];

}  // namespace portable
}  // namespace fixedpoint
