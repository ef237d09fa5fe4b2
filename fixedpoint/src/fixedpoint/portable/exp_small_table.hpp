// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_small.py
// b for i = 0..11, and ln(1 + b/256) in units of 2^-32, less than 1/256 below i/16; and
// j/256 - ln(1 + j/256) for j = 0..17 in units of 2^-40, plus the correction of the kernel.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct ExponentialSmallTable {
    static constexpr uint8_t factor[12] FIXEDPOINT_PROGRAM_MEMORY = {
          0,  16,  34,  52,  72,  93, 116, 139,
        166, 193, 221, 252};
    static constexpr uint32_t logarithm[12] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000, 0x0f851860, 0x1fec9132, 0x2f571204, 0x3f7230db, 0x4f553e97, 0x5fabe0ee, 0x6f07822c,
        0x7ff4b821, 0x8fd51a5c, 0x9f519c9b, 0xaf701549};
    static constexpr uint32_t shortfall[18] FIXEDPOINT_PROGRAM_MEMORY = {
        0x0000007c, 0x007fab66, 0x01fd59cb, 0x0477148c, 0x07eaea5c, 0x0c56efaa, 0x11b93e87, 0x180ff690,
        0x1f593cde, 0x27933bea, 0x30bc237d, 0x3ad22898, 0x45d38563, 0x51be7918, 0x5e9147ef, 0x6c4a3b0e,
        0x7ae7a073, 0x8a67cae3};
};
template <class Any>
constexpr uint8_t ExponentialSmallTable<Any>::factor[];
template <class Any>
constexpr uint32_t ExponentialSmallTable<Any>::logarithm[];
template <class Any>
constexpr uint32_t ExponentialSmallTable<Any>::shortfall[];

}  // namespace portable
}  // namespace fixedpoint
