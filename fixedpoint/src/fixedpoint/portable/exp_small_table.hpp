// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_small.py
// e^(i/16) - 1 in units of 2^-32, for i = 0..11, and e^(j/256) - 1 in units of 2^-40, for
// j = 0..15, less its fifth byte, which is j.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// Any is void: a template's static member may stand in a header.
template <class Any = void>
struct ExponentialSmallTable {
    static constexpr uint32_t coarse[12] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000, 0x1082b578, 0x2216045b, 0x34cb8171, 0x48b5e3c4, 0x5de91760, 0x747a513e, 0x8c802478,
        0xa61298e2, 0xc14b4312, 0xde455df8, 0xfd1de618};
    static constexpr uint32_t fine[16] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000, 0x00802ab5, 0x02015600, 0x04848362, 0x080ab55e, 0x0c94ef7a, 0x12243641, 0x18b98f42,
        0x20560112, 0x28fa934f, 0x32a84e9c, 0x3d603ca8, 0x4923682a, 0x55f2dce6, 0x63cfa7ab, 0x72bad656};
};
template <class Any>
constexpr uint32_t ExponentialSmallTable<Any>::coarse[];
template <class Any>
constexpr uint32_t ExponentialSmallTable<Any>::fine[];

}  // namespace portable
}  // namespace fixedpoint
