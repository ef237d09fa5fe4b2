// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/atan_degrees.py
// The arc tangents of i / 32 in degrees, in units of 2^-48.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct AtanDegreesTable {
    static constexpr uint64_t angle[33] FIXEDPOINT_PROGRAM_MEMORY = {
        0x00000000000000, 0x01ca3794e52e2a, 0x03938aa64c2c9a, 0x055b17599a292d,
        0x0720011249ffa1, 0x08e172e0ca6858, 0x0a9ea1ba69e152, 0x0c56ce6c82e691,
        0x0e0947407d7017, 0x0fb56949ec54c1, 0x115aa15bcab87e, 0x12f86ca5693b95,
        0x148e58fac13547, 0x161c04ce8103ca, 0x17a11ee6220071, 0x191d65d1b06e47,
        0x1a90a731a61dc4, 0x1bfabed561cab5, 0x1d5b95bc765110, 0x1eb32104600588,
        0x200160cb3eaa8b, 0x21465f0f18ede9, 0x22822e90014ccc, 0x23b4e9ba45f42e,
        0x24deb19cb3c478, 0x25ffacedea0300, 0x27180722cecb71, 0x2827ef9767377d,
        0x292f98caaa39ef, 0x2a2f37ad594751, 0x2b2703037bcca2, 0x2c1732d7c71162,
        0x2d000000000000};
};
template <class Any>
constexpr uint64_t AtanDegreesTable<Any>::angle[];

}  // namespace portable
}  // namespace fixedpoint
