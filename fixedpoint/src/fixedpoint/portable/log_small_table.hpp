// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_small.py
// Parabolas of ln(1 + x) on 16 cells of [0, 1]: the slope in units of 2^-16 and the value in
// 2^-24, plus half an ulp of Q16.16.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct LogarithmSmallTable {
    static constexpr uint16_t slope[16] FIXEDPOINT_PROGRAM_MEMORY = {
        65502, 61642, 58211, 55144, 52391, 49898, 47634, 45554,
        43652, 41909, 40293, 38805, 37419, 36123, 34926, 33802};
    static constexpr uint32_t value[16] FIXEDPOINT_PROGRAM_MEMORY = {
             122,  1017277,  1976246,  2883346,  3743900,  4562460,  5342929,  6088721,
         6802761,  7487632,  8145652,  8778824,  9388971,  9977717, 10546472, 11096591};
};
template <class Any>
constexpr uint16_t LogarithmSmallTable<Any>::slope[];
template <class Any>
constexpr uint32_t LogarithmSmallTable<Any>::value[];

}  // namespace portable
}  // namespace fixedpoint
