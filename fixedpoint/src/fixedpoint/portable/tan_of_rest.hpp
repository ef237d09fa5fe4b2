// SPDX-License-Identifier: MIT
// The tangent and the cotangent of an angle in the first octant, in Q32.32, bit for bit as
// avr/tan_of_rest.S computes them, where the error budget is.
#pragma once

#include <fixedpoint/portable/column_of_product.hpp>
#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/tangent_64_table.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// a 2^-16, rounded half up.
constexpr int32_t rounded_half(int32_t a) { return (a + (int32_t(1) << 15)) >> 16; }

// The tangent of x 2^-56 or, if `inverse`, its cotangent. x must be at most 201.5 2^48, and for the
// cotangent at least 48 2^48.
template <class Raw, int>
FIXEDPOINT_CONSTEXPR Raw tan_of_rest(Raw x, uint8_t inverse) {
    const uint64_t position = static_cast<uint64_t>(x);
    const int node = static_cast<int>((position + (uint64_t(1) << 47)) >> 48);
    const int64_t t = static_cast<int64_t>(position >> 8) - (int64_t(node) << 40);  // 2^-48
    const int32_t coarse = static_cast<int32_t>(t >> 24);                           // 2^-24
    const int32_t square = rounded_half(coarse * coarse);                           // 2^-32
    const int32_t third = rounded_half(coarse * square) * 21845;                    // 2^-56
    const int64_t tangent = t + (third >> 8);                                       // 2^-48
    const uint64_t base = read_program_memory(Tangent64Table<>::tangent[node]);     // 2^-48
    const uint32_t slope = static_cast<uint32_t>(base >> 16);                       // 2^-32
    const uint32_t factor = static_cast<uint32_t>(tangent >> 8);                    // 2^-40
    const uint32_t product =
        static_cast<uint32_t>((0x180 + uint64_t(column_of_product(slope, factor, 3)) +
                               (uint64_t(column_of_product(slope, factor, 4)) << 8) +
                               (uint64_t(column_of_product(slope, factor, 5)) << 16) +
                               (uint64_t(column_of_product(slope, factor, 6)) << 24)) >>
                              8);
    const int32_t fall = static_cast<int32_t>(product - (t < 0 ? slope : 0));  // 2^-40
    const int64_t height = static_cast<int64_t>(base) + tangent;
    const int64_t width = (int64_t(1) << 48) - int64_t(fall) * 256;
    return inverse != 0 ? divide<int64_t, 32>(width, height) : divide<int64_t, 32>(height, width);
}

}  // namespace portable
}  // namespace fixedpoint
