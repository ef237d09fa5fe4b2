// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/reciprocal_sqrt_q8_8.py
// 2^20 / sqrt(m) for 16-bit m.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct ReciprocalSqrtQ8_8Table {
    static constexpr uint16_t value[64] FIXEDPOINT_PROGRAM_MEMORY = {
        8191, 8066, 7945, 7832, 7722, 7617, 7516, 7419,
        7326, 7236, 7148, 7065, 6985, 6907, 6832, 6758,
        6688, 6619, 6553, 6488, 6424, 6364, 6305, 6248,
        6192, 6136, 6084, 6032, 5981, 5931, 5884, 5837,
        5792, 5704, 5618, 5538, 5460, 5385, 5315, 5245,
        5180, 5116, 5054, 4996, 4939, 4884, 4831, 4778,
        4729, 4680, 4632, 4588, 4542, 4500, 4458, 4417,
        4378, 4340, 4302, 4265, 4230, 4195, 4161, 4128};
    static constexpr uint8_t slope[64] FIXEDPOINT_PROGRAM_MEMORY = {
        127, 120, 113, 110, 105, 101,  96,  93,
         90,  85,  82,  79,  78,  76,  74,  71,
         68,  67,  66,  62,  59,  58,  58,  56,
         55,  52,  52,  50,  48,  47,  47,  45,
         89,  86,  81,  77,  74,  70,  69,  65,
         64,  60,  58,  57,  55,  54,  53,  49,
         49,  47,  44,  44,  42,  40,  40,  39,
         38,  37,  38,  35,  34,  32,  32,  32};
};
template <class Any>
constexpr uint16_t ReciprocalSqrtQ8_8Table<Any>::value[];
template <class Any>
constexpr uint8_t ReciprocalSqrtQ8_8Table<Any>::slope[];

}  // namespace portable
}  // namespace fixedpoint
