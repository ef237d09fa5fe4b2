// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/logarithm_of_factor.py
// For node i, 1 + i / 64: 1 - decrease / 256 is the factor nearest to its reciprocal, and logarithm is
// that of the reciprocal of the factor, in units of 2^-56, like ln 2.
#pragma once

#include <stdint.h>

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct LogarithmOfFactor {
    static constexpr uint8_t decrease[65] FIXEDPOINT_PROGRAM_MEMORY = {
          0,   4,   8,  11,  15,  19,  22,  25,  28,  32,  35,  38,  40,  43,  46,  49,
         51,  54,  56,  59,  61,  63,  65,  68,  70,  72,  74,  76,  78,  80,  82,  84,
         85,  87,  89,  91,  92,  94,  95,  97,  98, 100, 101, 103, 104, 106, 107, 108,
        110, 111, 112, 114, 115, 116, 117, 118, 119, 121, 122, 123, 124, 125, 126, 127,
        128};
    static constexpr uint64_t logarithm[65] FIXEDPOINT_PROGRAM_MEMORY = {
        0x0000000000000000ull, 0x000408159624d612ull, 0x000820aec4f3a222ull,
        0x000b3e4a796a5dacull, 0x000f7518e0035c3eull, 0x0013bdf5a7d1ee64ull,
        0x001700d30aeac0e1ull, 0x001a4e7640b1bc38ull, 0x001da727638446a2ull,
        0x00222f1d044fc8f8ull, 0x0025a2c2190d0274ull, 0x0029227b06676ac2ull,
        0x002b7e80d6a87b64ull, 0x002f131b0a8898e6ull, 0x0032b4b5b9ee02feull,
        0x003663b0aeb79c79ull, 0x0038dff78de01ee1ull, 0x003ca61dffce2024ull,
        0x003f3238d96766f3ull, 0x004310b59d858b8cull, 0x0045ad732eb3edcdull,
        0x00485115b43ae351ull, 0x004afbc1f3724d4eull, 0x004f0949dcccc60full,
        0x0051c63709c7106cull, 0x00548ab81ce28f5full, 0x005756f77d657cbfull,
        0x005a2b20fa71a850ull, 0x005d0761db19eec6ull, 0x005febe8ef605470ull,
        0x0062d8e6a22cb7d3ull, 0x0065ce8d0c4d5ab7ull, 0x00674cafa857b4ecull,
        0x006a4fb4f22b678eull, 0x006d5be81118a425ull, 0x00707181a4fe8e76ull,
        0x0071ffe71d155325ull, 0x007524091b7be9aeull, 0x0076b9d521325857ull,
        0x0079ed0b0f76b5cdull, 0x007b8a855ad04f94ull, 0x007ecd62bde92211ull,
        0x008072d72d903d59ull, 0x0083c5f8299e2b41ull, 0x008573b71682a7d2ull,
        0x0088d7c11e3ad53dull, 0x008a8e1fb794b091ull, 0x008c47720791e533ull,
        0x008fc31afe30b2c7ull, 0x00918586c5f5e4bfull, 0x00934b1089a6dc94ull,
        0x0096dfaabd86fa16ull, 0x0098aed221a03459ull, 0x009a81456cec642eull,
        0x009c5710b8cbb73aull, 0x009e304061b5fda9ull, 0x00a00ce1092e5499ull,
        0x00a3d0a93f45169aull, 0x00a5b7eb7cb860fcull, 0x00a7a2d41ad270caull,
        0x00a991713433c2baull, 0x00ab83d135dc6333ull, 0x00ad7a02e1b24efdull,
        0x00af74155120c901ull, 0x00b17217f7d1cf7aull};
    static constexpr int64_t ln2() { return 0x00b17217f7d1cf7aull; }
};
template <class Any>
constexpr uint8_t LogarithmOfFactor<Any>::decrease[];
template <class Any>
constexpr uint64_t LogarithmOfFactor<Any>::logarithm[];

}  // namespace portable
}  // namespace fixedpoint
