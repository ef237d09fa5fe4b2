// SPDX-License-Identifier: MIT
// Int24 and UnsignedInt24, the integers of 24 bits: three bytes of RAM everywhere. avr-gcc has them
// built in and keeps them in three registers. Elsewhere a class of three bytes stands for them,
// which converts to and from the built-in integers, modulo 2^24, as those do.
#pragma once

#include <stdint.h>

#include <fixedpoint/builtin.hpp>

namespace fixedpoint {

#ifdef __INT24_MAX__
#define FIXEDPOINT_HAS_INT24
/// The two's-complement integer of 24 bits.
__extension__ typedef __int24 Int24;
/// The unsigned integer of 24 bits.
__extension__ typedef __uint24 UnsignedInt24;
#else
/// \cond internal
template <bool>
struct IfInteger {};
template <>
struct IfInteger<true> {
    using Type = void;
};

// Word, int32_t or uint32_t, is the integer that expressions compute in, as int is for int16_t.
template <class Word>
class Integer24 {
  public:
    Integer24() = default;
    // The lower 24 bits of an integer.
    template <class Int, class = typename IfInteger<BuiltinNumber<Int>::is_integer>::Type>
    constexpr Integer24(Int n) : Integer24(static_cast<uint32_t>(n), Private()) {}
    constexpr operator Word() const {
        return static_cast<Word>(static_cast<Word>(static_cast<uint32_t>(high_) << 24) >> 8 |
                                 static_cast<Word>(middle_ << 8 | low_));
    }

  private:
    struct Private {};
    constexpr Integer24(uint32_t n, Private)
        : low_(static_cast<uint8_t>(n)),
          middle_(static_cast<uint8_t>(n >> 8)),
          high_(static_cast<uint8_t>(n >> 16)) {}

    uint8_t low_, middle_, high_;
};
/// \endcond
/// The two's-complement integer of 24 bits.
using Int24 = Integer24<int32_t>;
/// The unsigned integer of 24 bits.
using UnsignedInt24 = Integer24<uint32_t>;
#endif

template <>
struct BuiltinNumber<Int24> : BuiltinNumberOf<BuiltinKind::integer> {};
template <>
struct BuiltinNumber<UnsignedInt24> : BuiltinNumberOf<BuiltinKind::integer> {};

}  // namespace fixedpoint
