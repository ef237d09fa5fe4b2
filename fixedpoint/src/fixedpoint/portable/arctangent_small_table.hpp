// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/arctangent_small.py
// atan(i/16) for i = 0..15 in units of 2^-24, plus half an ulp of Q16.16 and an offset that
// centres the errors of the remaining angle.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct ArctangentSmallTable {
    static constexpr uint32_t angle[16] FIXEDPOINT_PROGRAM_MEMORY = {
             120,  1047331,  2086448,  3109739,  4110178,  5081682,  6019292,  6919219,
         7778837,  8596589,  9371862, 10104826, 10796279, 11447495, 12060089, 12635905};
};
template <class Any>
constexpr uint32_t ArctangentSmallTable<Any>::angle[];

}  // namespace portable
}  // namespace fixedpoint
