// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_small.py
// Parabolas of ln on 16 cells of [1, 2]: the bend in units of 2^-8, the slope in 2^-16, the
// value in 2^-24.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// Any is void: a template's static member may stand in a header.
template <class Any = void>
struct LogarithmSmallTable {
    static constexpr uint8_t bend[16] FIXEDPOINT_PROGRAM_MEMORY = {
        121, 107,  96,  86,  78,  71,
         65,  59,  55,  50,  47,  43,
         40,  38,  35,  33};
    static constexpr uint16_t slope[16] FIXEDPOINT_PROGRAM_MEMORY = {
        65501, 61642, 58226, 55158, 52405, 49913,
        47649, 45569, 43684, 41925, 40325, 38821,
        37436, 36156, 34942, 33818};
    static constexpr uint32_t value[16] FIXEDPOINT_PROGRAM_MEMORY = {
               5,  1017148,  1976094,  2883198,  3743750,  4562307,
         5342767,  6088567,  6802563,  7487475,  8145456,  8778665,
         9388809,  9977515, 10546313, 11096429};
};
template <class Any>
constexpr uint8_t LogarithmSmallTable<Any>::bend[];
template <class Any>
constexpr uint16_t LogarithmSmallTable<Any>::slope[];
template <class Any>
constexpr uint32_t LogarithmSmallTable<Any>::value[];

}  // namespace portable
}  // namespace fixedpoint
