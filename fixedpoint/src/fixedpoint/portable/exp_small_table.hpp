// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_small.py
// b for i = 0..11, and ln(1 + b/256) in units of 2^-32, less than 1/256 below i/16; and
// e^(j/256) - 1 in units of 2^-40, for j = 0..16, less its fifth byte, which is j.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// Any is void: a template's static member may stand in a header.
template <class Any = void>
struct ExponentialSmallTable {
    static constexpr uint8_t factor[12] FIXEDPOINT_PROGRAM_MEMORY = {
          0,  16,  33,  52,  72,  93, 116, 140,
        165, 193, 221, 252};
    static constexpr uint32_t logarithm[12] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000, 0x0f851860, 0x1f0a30c0, 0x2f571204, 0x3f7230db, 0x4f553e97, 0x5fabe0ee, 0x6fad3677,
        0x7f593c84, 0x8fd51a5c, 0x9f519c9c, 0xaf701549};
    static constexpr uint32_t fine[17] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000, 0x00802ab5, 0x02015600, 0x04848362, 0x080ab55e, 0x0c94ef7a, 0x12243641, 0x18b98f42,
        0x20560112, 0x28fa934f, 0x32a84e9c, 0x3d603ca8, 0x4923682a, 0x55f2dce6, 0x63cfa7ab, 0x72bad656,
        0x82b577d3};
};
template <class Any>
constexpr uint8_t ExponentialSmallTable<Any>::factor[];
template <class Any>
constexpr uint32_t ExponentialSmallTable<Any>::logarithm[];
template <class Any>
constexpr uint32_t ExponentialSmallTable<Any>::fine[];

}  // namespace portable
}  // namespace fixedpoint
