// SPDX-License-Identifier: MIT
// An unsigned 128-bit integer of two 64-bit halves, with the few operations that shift-and-add
// algorithms need; arithmetic modulo 2^128. The device's compiler does not have such a type; the
// host runs the same code.
//
// Operands are passed by reference, as a workaround: avr-gcc 5.4 caches constant calls by their
// class arguments, and an assignment to the variable passed as such an argument corrupts the cache.
#pragma once

#include <fixedpoint/portable/wide.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

struct Word128 {
    uint64_t high;
    uint64_t low;

    constexpr Word128() : high(0), low(0) {}
    constexpr Word128(uint64_t high_half, uint64_t low_half) : high(high_half), low(low_half) {}
    // Zero-extends an unsigned value; a non-negative signed one converts exactly.
    constexpr explicit Word128(uint64_t value) : high(0), low(value) {}

    template <class Integer>
    constexpr explicit operator Integer() const {
        return static_cast<Integer>(low);
    }

    friend constexpr Word128 operator+(const Word128& a, const Word128& b) {
        return {a.high + b.high + (a.low + b.low < a.low ? 1 : 0), a.low + b.low};
    }
    friend constexpr Word128 operator-(const Word128& a, const Word128& b) {
        return {a.high - b.high - (a.low < b.low ? 1 : 0), a.low - b.low};
    }
    friend FIXEDPOINT_CONSTEXPR Word128 operator*(const Word128& a, uint64_t b) {
        const Wide128 low_product = multiply_full(a.low, b);
        return {a.high * b + low_product.high, low_product.low};
    }
    friend constexpr Word128 operator<<(const Word128& a, int count) {
        return count == 0    ? a
               : count >= 64 ? Word128(a.low << (count - 64), 0)
                             : Word128(a.high << count | a.low >> (64 - count), a.low << count);
    }
    friend constexpr Word128 operator>>(const Word128& a, int count) {
        return count == 0    ? a
               : count >= 64 ? Word128(0, a.high >> (count - 64))
                             : Word128(a.high >> count, a.low >> count | a.high << (64 - count));
    }
    friend constexpr bool operator<(const Word128& a, const Word128& b) {
        return a.high != b.high ? a.high < b.high : a.low < b.low;
    }
    friend constexpr bool operator>(const Word128& a, const Word128& b) { return b < a; }
    friend constexpr bool operator>=(const Word128& a, const Word128& b) { return !(a < b); }
};

}  // namespace portable

constexpr portable::Word128 read_program_memory(const portable::Word128& entry) {
    return {read_program_memory(entry.high), read_program_memory(entry.low)};
}

}  // namespace fixedpoint
