// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_q8_8.py
// The natural logarithm of 1 to 2.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct LogQ8_8Table {
    static constexpr uint16_t value[64] FIXEDPOINT_PROGRAM_MEMORY = {
          16,  144,  269,  392,  513,  633,  751,  867,
         981, 1094, 1206, 1316, 1424, 1531, 1637, 1741,
        1845, 1946, 2047, 2146, 2244, 2341, 2437, 2532,
        2625, 2718, 2809, 2900, 2989, 3078, 3166, 3252,
        3338, 3423, 3507, 3590, 3672, 3754, 3835, 3915,
        3994, 4072, 4150, 4227, 4303, 4378, 4453, 4527,
        4601, 4674, 4746, 4817, 4888, 4959, 5028, 5097,
        5166, 5234, 5301, 5368, 5435, 5500, 5566, 5630};
    static constexpr uint8_t slope[64] FIXEDPOINT_PROGRAM_MEMORY = {
        128, 125, 123, 121, 120, 118, 116, 114,
        114, 112, 110, 108, 107, 106, 105, 104,
        101, 101,  99,  98,  97,  96,  95,  93,
         93,  91,  91,  89,  89,  88,  86,  86,
         85,  84,  83,  82,  82,  81,  80,  79,
         78,  78,  77,  76,  75,  75,  74,  74,
         73,  72,  71,  71,  71,  69,  70,  69,
         68,  67,  67,  67,  65,  66,  64,  65};
};
template <class Any>
constexpr uint16_t LogQ8_8Table<Any>::value[];
template <class Any>
constexpr uint8_t LogQ8_8Table<Any>::slope[];

}  // namespace portable
}  // namespace fixedpoint
