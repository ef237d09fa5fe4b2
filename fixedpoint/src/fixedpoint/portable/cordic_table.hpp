// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/cordic.py
// atan(2^-i) for i = 1, 2, ..., pi, pi/2 and the gain of the rotations, the product of
// cos(atan(2^-i)), each with Bits - 2 fraction bits of the working word; 2/pi with Bits / 2.
#pragma once

#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Word, class Any = void>
struct CordicConstants;

template <class Any>
struct CordicConstants<uint32_t, Any> {
    static constexpr int largest_fraction_bits = 20;
    static constexpr int arctangent_count = 9;
    static constexpr uint32_t arctangent[9] FIXEDPOINT_PROGRAM_MEMORY = {
        0x1dac6705u,
        0x0fadbafdu,
        0x07f56ea7u,
        0x03feab77u,
        0x01ffd55cu,
        0x00fffaabu,
        0x007fff55u,
        0x003fffebu,
        0x001ffffdu};
    static constexpr uint32_t pi() {
        return 0xc90fdaa2u;
    }
    static constexpr uint32_t gain() {
        return 0x36f656c6u;
    }
    static constexpr uint32_t two_over_pi() {
        return 0x0000a2fau;
    }
    static constexpr uint32_t half_pi() {
        return 0x6487ed51u;
    }
};
template <class Any>
constexpr uint32_t CordicConstants<uint32_t, Any>::arctangent[];

template <class Any>
struct CordicConstants<uint64_t, Any> {
    static constexpr int largest_fraction_bits = 52;
    static constexpr int arctangent_count = 19;
    static constexpr uint64_t arctangent[19] FIXEDPOINT_PROGRAM_MEMORY = {
        0x1dac670561bb4f69ull,
        0x0fadbafc96406eb1ull,
        0x07f56ea6ab0bdb72ull,
        0x03feab76e59fbd39ull,
        0x01ffd55bba97624bull,
        0x00fffaaadddb94d6ull,
        0x007fff5556eeea5dull,
        0x003fffeaaab7776eull,
        0x001ffffd5555bbbcull,
        0x000fffffaaaaaddeull,
        0x0007fffff555556full,
        0x0003fffffeaaaaabull,
        0x0001ffffffd55555ull,
        0x0000fffffffaaaabull,
        0x00007fffffff5555ull,
        0x00003fffffffeaabull,
        0x00001ffffffffd55ull,
        0x00000fffffffffabull,
        0x000007fffffffff5ull};
    static constexpr uint64_t pi() {
        return 0xc90fdaa22168c235ull;
    }
    static constexpr uint64_t gain() {
        return 0x36f656c59df04dbbull;
    }
    static constexpr uint64_t two_over_pi() {
        return 0x00000000a2f9836eull;
    }
    static constexpr uint64_t half_pi() {
        return 0x6487ed5110b4611aull;
    }
};
template <class Any>
constexpr uint64_t CordicConstants<uint64_t, Any>::arctangent[];

template <class Any>
struct CordicConstants<Word128, Any> {
    static constexpr int largest_fraction_bits = 63;
    static constexpr int arctangent_count = 23;
    static constexpr Word128 arctangent[23] FIXEDPOINT_PROGRAM_MEMORY = {
        Word128(0x1dac670561bb4f68ull, 0xadfc88bd978751a0ull),
        Word128(0x0fadbafc96406eb1ull, 0x56dc79ef5f7a217eull),
        Word128(0x07f56ea6ab0bdb71ull, 0x9644bcc4f9f44478ull),
        Word128(0x03feab76e59fbd38ull, 0xdb2c9e4b7038b835ull),
        Word128(0x01ffd55bba97624aull, 0x84ef3aeedbb518c4ull),
        Word128(0x00fffaaadddb94d5ull, 0xbbe78c564015f760ull),
        Word128(0x007fff5556eeea5cull, 0xb40311a8fddf3058ull),
        Word128(0x003fffeaaab7776eull, 0x52ec4abedadb53e0ull),
        Word128(0x001ffffd5555bbbbull, 0xa9729ab7aac08947ull),
        Word128(0x000fffffaaaaadddull, 0xddb94b968067ef3bull),
        Word128(0x0007fffff555556eull, 0xeeeea5ca5d895893ull),
        Word128(0x0003fffffeaaaaabull, 0x777776e52e5356f5ull),
        Word128(0x0001ffffffd55555ull, 0x5bbbbbba972972d0ull),
        Word128(0x0000fffffffaaaaaull, 0xaadddddddb94b94cull),
        Word128(0x00007fffffff5555ull, 0x5556eeeeeeea5ca6ull),
        Word128(0x00003fffffffeaaaull, 0xaaaab77777776e53ull),
        Word128(0x00001ffffffffd55ull, 0x555555bbbbbbbba9ull),
        Word128(0x00000fffffffffaaull, 0xaaaaaaaddddddddeull),
        Word128(0x000007fffffffff5ull, 0x555555556eeeeeefull),
        Word128(0x000003fffffffffeull, 0xaaaaaaaaab777777ull),
        Word128(0x000001ffffffffffull, 0xd5555555555bbbbcull),
        Word128(0x000000ffffffffffull, 0xfaaaaaaaaaaadddeull),
        Word128(0x0000007fffffffffull, 0xff555555555556efull)};
    static constexpr Word128 pi() {
        return Word128(0xc90fdaa22168c234ull, 0xc4c6628b80dc1cd1ull);
    }
    static constexpr Word128 gain() {
        return Word128(0x36f656c59df04dbaull, 0xd9877ade5e6a30c7ull);
    }
    static constexpr Word128 two_over_pi() {
        return Word128(0x0000000000000000ull, 0xa2f9836e4e44152aull);
    }
    static constexpr Word128 half_pi() {
        return Word128(0x6487ed5110b4611aull, 0x62633145c06e0e69ull);
    }
};
template <class Any>
constexpr Word128 CordicConstants<Word128, Any>::arctangent[];

}  // namespace portable
}  // namespace fixedpoint
