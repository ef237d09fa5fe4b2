// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_q8_8.py
// e^a at every 64th a in units of 2^-7 ulp, and the growth at each distance minus its
// quadratic part, in units of 2^-17.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct ExpQ8_8Table {
    static constexpr uint32_t power[45] FIXEDPOINT_PROGRAM_MEMORY = {
              63,       69,       92,      122,      172,      209,      283,      363,
             467,      600,      769,      989,     1269,     1629,     2093,     2687,
            3451,     4431,     5690,     7304,     9381,    12044,    15460,    19860,
           25500,    32742,    42042,    53980,    69315,    88999,   114281,   146738,
          188413,   241933,   310648,   398874,   512171,   657642,   844428,  1084266,
         1392223,  1787654,  2295393,  2947342,  3784458};
    static constexpr uint8_t growth[64] FIXEDPOINT_PROGRAM_MEMORY = {
        104,  99,  95,  90,  86,  81,  77,  72,
         67,  63,  57,  56,  51,  46,  43,  40,
         36,  32,  28,  25,  22,  18,  18,  15,
         12,   9,   9,   7,   6,   3,   3,   1,
          2,   0,   2,   2,   2,   4,   4,   6,
          8,   8,  12,  16,  19,  21,  26,  31,
         36,  42,  46,  53,  60,  67,  75,  79,
         89,  98, 110, 119, 129, 140, 151, 165};
};
template <class Any>
constexpr uint32_t ExpQ8_8Table<Any>::power[];
template <class Any>
constexpr uint8_t ExpQ8_8Table<Any>::growth[];

}  // namespace portable
}  // namespace fixedpoint
