// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/pseudo_division.py
// ln(1 + 2^-i) for i = 1, 2, ... and ln 2, with Bits - 6 fraction bits of the working word.
#pragma once

#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Word, class Any = void>
struct PseudoDivisionConstants;

template <class Any>
struct PseudoDivisionConstants<uint32_t, Any> {
    static constexpr uint32_t logarithm[12] FIXEDPOINT_PROGRAM_MEMORY = {
        0x019f323fu,
        0x00e47fbeu,
        0x00789c1eu,
        0x003e1462u,
        0x001f829bu,
        0x000fe054u,
        0x0007f80bu,
        0x0003fe01u,
        0x0001ff80u,
        0x0000ffe0u,
        0x00007ff8u,
        0x00003ffeu};
    static constexpr uint32_t ln2() { return 0x02c5c860u; }
};
template <class Any>
constexpr uint32_t PseudoDivisionConstants<uint32_t, Any>::logarithm[];

template <class Any>
struct PseudoDivisionConstants<uint64_t, Any> {
    static constexpr uint64_t logarithm[28] FIXEDPOINT_PROGRAM_MEMORY = {
        0x019f323ecbf984bfull,
        0x00e47fbe3cd4d10dull,
        0x00789c1db8abcb98ull,
        0x003e14618022c54dull,
        0x001f829b0e783300ull,
        0x000fe054587e01f2ull,
        0x0007f80a9ac419e2ull,
        0x0003fe0154562178ull,
        0x0001ff802a9ab10eull,
        0x0000ffe005545588ull,
        0x00007ff800aa9aacull,
        0x00003ffe00155455ull,
        0x00001fff8002aa9bull,
        0x00000fffe0005554ull,
        0x000007fff8000aabull,
        0x000003fffe000155ull,
        0x000001ffff80002bull,
        0x000000ffffe00005ull,
        0x0000007ffff80001ull,
        0x0000003ffffe0000ull,
        0x0000001fffff8000ull,
        0x0000000fffffe000ull,
        0x00000007fffff800ull,
        0x00000003fffffe00ull,
        0x00000001ffffff80ull,
        0x00000000ffffffe0ull,
        0x000000007ffffff8ull,
        0x000000003ffffffeull};
    static constexpr uint64_t ln2() { return 0x02c5c85fdf473de7ull; }
};
template <class Any>
constexpr uint64_t PseudoDivisionConstants<uint64_t, Any>::logarithm[];

template <class Any>
struct PseudoDivisionConstants<Word128, Any> {
    static constexpr Word128 logarithm[34] FIXEDPOINT_PROGRAM_MEMORY = {
        Word128(0x019f323ecbf984bfull, 0x2b68d766f4052218ull),
        Word128(0x00e47fbe3cd4d10dull, 0x612ec0f797fdcd12ull),
        Word128(0x00789c1db8abcb97ull, 0xa7aa1fff87fa7855ull),
        Word128(0x003e14618022c54cull, 0xc2f992e2ddd665e2ull),
        Word128(0x001f829b0e783300ull, 0x4cf8fc13c7bc8a7full),
        Word128(0x000fe054587e01f1ull, 0xe7cf6d3a69bd5eabull),
        Word128(0x0007f80a9ac419e2ull, 0x3f0dda40e4770a0bull),
        Word128(0x0003fe0154562178ull, 0x09410d6ad369a96full),
        Word128(0x0001ff802a9ab10eull, 0x678a78e854f8ec6bull),
        Word128(0x0000ffe005545588ull, 0x7de026828c92649aull),
        Word128(0x00007ff800aa9aacull, 0x44199e2b62cc632dull),
        Word128(0x00003ffe00155455ull, 0x622177809b89c7b8ull),
        Word128(0x00001fff8002aa9aull, 0xab110e6678af0afcull),
        Word128(0x00000fffe0005554ull, 0x5558887dde026fa7ull),
        Word128(0x000007fff8000aaaull, 0x9aaac4441999e2beull),
        Word128(0x000003fffe000155ull, 0x545556222177780aull),
        Word128(0x000001ffff80002aull, 0xaa9aaab1110e6668ull),
        Word128(0x000000ffffe00005ull, 0x5554555588887ddeull),
        Word128(0x0000007ffff80000ull, 0xaaaa9aaaac44441aull),
        Word128(0x0000003ffffe0000ull, 0x1555545555622221ull),
        Word128(0x0000001fffff8000ull, 0x02aaaa9aaaab1111ull),
        Word128(0x0000000fffffe000ull, 0x0055555455555889ull),
        Word128(0x00000007fffff800ull, 0x000aaaaa9aaaaac4ull),
        Word128(0x00000003fffffe00ull, 0x0001555554555556ull),
        Word128(0x00000001ffffff80ull, 0x00002aaaaa9aaaabull),
        Word128(0x00000000ffffffe0ull, 0x0000055555545555ull),
        Word128(0x000000007ffffff8ull, 0x000000aaaaaa9aabull),
        Word128(0x000000003ffffffeull, 0x0000001555555455ull),
        Word128(0x000000001fffffffull, 0x80000002aaaaaa9bull),
        Word128(0x000000000fffffffull, 0xe000000055555554ull),
        Word128(0x0000000007ffffffull, 0xf80000000aaaaaabull),
        Word128(0x0000000003ffffffull, 0xfe00000001555555ull),
        Word128(0x0000000001ffffffull, 0xff800000002aaaabull),
        Word128(0x0000000000ffffffull, 0xffe0000000055555ull)};
    static constexpr Word128 ln2() { return Word128(0x02c5c85fdf473de6ull, 0xaf278ece600fcbdbull); }
};
template <class Any>
constexpr Word128 PseudoDivisionConstants<Word128, Any>::logarithm[];

}  // namespace portable
}  // namespace fixedpoint
