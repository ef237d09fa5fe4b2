// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/atan_degrees.py
// The arc tangents of i / 64 in degrees, in units of 2^-48.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct AtanDegreesTable {
    static constexpr uint64_t angle[65] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000000000, 0x00e52a1ab19876, 0x01ca3794e52e2a, 0x02af0be38bbc8a,
        0x03938aa64c2c9a, 0x047797bc7ab26d, 0x055b17599a292d, 0x063dee194294b0,
        0x0720011249ffa1, 0x080135e90f6b97, 0x08e172e0ca6858, 0x09c09eebc51903,
        0x0a9ea1ba69e152, 0x0b7b63c911990a, 0x0c56ce6c82e691, 0x0d30cbdd173219,
        0x0e0947407d7017, 0x0ee02cb216bc05, 0x0fb56949ec54c1, 0x1088eb2241f5cc,
        0x115aa15bcab87e, 0x122a7c208994d1, 0x12f86ca5693b95, 0x13c4652a9955f2,
        0x148e58fac13547, 0x15563c6919a8b4, 0x161c04ce8103ca, 0x16dfa8859d6535,
        0x17a11ee6220071, 0x1860603f4c96a8, 0x191d65d1b06e47, 0x19d829c863fc6e,
        0x1a90a731a61dc4, 0x1b46d9f70f341e, 0x1bfabed561cab5, 0x1cac53540d8a5e,
        0x1d5b95bc765110, 0x1e08851110321c, 0x1eb32104600588, 0x1f5b69efef01eb,
        0x200160cb3eaa8b, 0x20a50722c927c1, 0x21465f0f18ede9, 0x21e56b2c016aae,
        0x22822e90014ccc, 0x231cacc3d5e12c, 0x23b4e9ba45f42e, 0x244ae9c829a83f,
        0x24deb19cb3c478, 0x2570463a00202e, 0x25ffacedea0300, 0x268ceb4b2c9493,
        0x27180722cecb71, 0x27a1067ddbaf46, 0x2827ef9767377d, 0x28acc8d6df9324,
        0x292f98caaa39ef, 0x29b066230bc670, 0x2a2f37ad594751, 0x2aac144f716ed3,
        0x2b2703037bcca2, 0x2ba00ad3ec0d13, 0x2c1732d7c71162, 0x2c8c822f27956b,
        0x2d000000000000};
};
template <class Any>
constexpr uint64_t AtanDegreesTable<Any>::angle[];

}  // namespace portable
}  // namespace fixedpoint
