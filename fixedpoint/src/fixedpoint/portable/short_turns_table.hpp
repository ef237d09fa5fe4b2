// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/short_turns.py
// The arcs of tangents i / 16, i / 256, i / 4096, i / 65536, pi / 2 and pi modulo 1,
// in units of 2^-88: the upper bits and the lower 24; and how many there are of each tangent.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct ShortTurnsTable {
    static constexpr uint64_t upper[72] FIXEDPOINT_PROGRAM_MEMORY = {
        0x0000000000000000ull, 0x0ffaaddb967ef4e3ull, 0x1fd5ba9aac2f6dc6ull, 0x2f72f6979cb6044dull,
        0x3eb6ebf25901bac5ull, 0x4d89dcdc1faf2f34ull, 0x5bd86507937bc239ull, 0x6993bb0f308ff2dbull,
        0x76b19c1586ed3da2ull, 0x832bf4a6d9867e2aull, 0x8f005d5ef7f59f9bull, 0x9a2f80e671bdda20ull,
        0xa4bc7d1934f70924ull, 0xaeac4c38b4d8c080ull, 0xb8053e2bc2319e73ull, 0xc0ce85b8ac526640ull,
        0x0000000000000000ull, 0x00ffffaaaaddddb9ull, 0x01fffd555bbba972ull, 0x02fff70030986134ull,
        0x03ffeaab776e5356ull, 0x04ffd657c629bfedull, 0x05ffb80612970d6bull, 0x06ff8db7ca45c470ull,
        0x07ff556eea5d892aull, 0x08ff0d2e17624bb1ull, 0x09feb2f8b4e4ec8bull, 0x0afe44d2fd1d96a5ull,
        0x0bfdc0c2186d14fcull, 0x0cfd24cc34c26fa6ull, 0x0dfc6ef89ce221ceull, 0x0efb9d4fcf8c40fbull,
        0x0ffaaddb967ef4e3ull, 0x0000000000000000ull, 0x000ffffffaaaaaadull, 0x001fffffd55555bbull,
        0x002fffff70000309ull, 0x003ffffeaaaab777ull, 0x004ffffd65557c65ull, 0x005ffffb80006133ull,
        0x006ffff8daab7cc0ull, 0x007ffff55556eeeeull, 0x008ffff0d002e21cull, 0x009fffeb2aaf8ca9ull,
        0x00afffe4455d3275ull, 0x00bfffdc000c2661ull, 0x00cfffd23abccbcbull, 0x00dfffc6d56f9813ull,
        0x00efffb9b0251418ull, 0x0000000000000000ull, 0x0000ffffffffaaaaull, 0x0001fffffffd5555ull,
        0x0002fffffff70000ull, 0x0003ffffffeaaaaaull, 0x0004ffffffd65555ull, 0x0005ffffffb80000ull,
        0x0006ffffff8daaaaull, 0x0007ffffff555555ull, 0x0008ffffff0d0000ull, 0x0009fffffeb2aaaaull,
        0x000afffffe445555ull, 0x000bfffffdc00000ull, 0x000cfffffd23aaabull, 0x000dfffffc6d5556ull,
        0x000efffffb9b0002ull, 0x000ffffffaaaaaadull, 0x0010fffff99a5559ull, 0x0011fffff8680005ull,
        0x0012fffff711aab2ull, 0x0013fffff595555full, 0x921fb54442d18469ull, 0x243f6a8885a308d3ull};
    static constexpr uint32_t lower[72] FIXEDPOINT_PROGRAM_MEMORY = {
        0x000000u, 0x6cb279u, 0x5912f3u, 0x1ec2d4u, 0x5b71e8u, 0xe2d5dau, 0xc55191u, 0x213e4bu,
        0xb7f223u, 0x4b6a0au, 0x5c835eu, 0x4226f9u, 0x19a87fu, 0x14725eu, 0xcb2da5u, 0x89dd63u,
        0x000000u, 0x4bb12bu, 0xd00c47u, 0x6d7f45u, 0xef9e31u, 0xec153du, 0xce7604u, 0xf209c4u,
        0x13bcecu, 0x0c123du, 0x918539u, 0x76e77fu, 0xf220e1u, 0x4520f6u, 0xc0396au, 0x6b928fu,
        0x6cb279u, 0x000000u, 0xdddddcu, 0xbbba97u, 0x998613u, 0x76e52eu, 0x529bcau, 0x296fc7u,
        0xf45805u, 0xa5ca6bu, 0x25fbe1u, 0x4de55eu, 0xe0e0e9u, 0x84b1aeu, 0xb7ca0au, 0xc5a2afu,
        0xb8f5c7u, 0x000000u, 0xaaaadeu, 0x555bbcu, 0x00309au, 0xab7777u, 0x57c655u, 0x061333u,
        0xb7cc11u, 0x6eeeefu, 0x2e21cdu, 0xf8caabu, 0xd32788u, 0xc26666u, 0xccbd44u, 0xf98221u,
        0x5142ffu, 0xdddddcu, 0xaa98b8u, 0xc43994u, 0x391e70u, 0x19554au, 0x898cc5u, 0x13198au};
    static constexpr uint8_t entries[4] FIXEDPOINT_PROGRAM_MEMORY = {
        16, 17, 16, 21};
};
template <class Any>
constexpr uint64_t ShortTurnsTable<Any>::upper[];
template <class Any>
constexpr uint32_t ShortTurnsTable<Any>::lower[];
template <class Any>
constexpr uint8_t ShortTurnsTable<Any>::entries[];

}  // namespace portable
}  // namespace fixedpoint
