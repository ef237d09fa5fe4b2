// SPDX-License-Identifier: GPL-3.0-or-later
// The effect of each AVR instruction on registers, flags and memory. Translated code includes this
// header and consists of calls of it; the compiler removes flags that nothing reads. Everything is
// inlined by force: in a long translation the compiler would stop inlining, and keep every flag.
// Source: Atmel, "AVR Instruction Set Manual" (DS40002198).
#pragma once

#include <cstdint>

namespace instructions::semantics {

using Byte = std::uint8_t;
using Word = std::uint16_t;

struct Status {
    bool c = false, z = false, n = false, v = false, s = false, h = false, t = false, i = false;
};

constexpr Word word(Byte low, Byte high) { return Word(low | high << 8); }

[[gnu::always_inline]] inline void set_negative_and_sign(Byte result, Status& f) {
    f.n = result >> 7;
    f.s = f.n != f.v;
}

[[gnu::always_inline]] inline void add(Byte& d, Byte r, Status& f, bool carry = false) {
    const unsigned sum = unsigned(d) + r + carry;
    const Byte result = Byte(sum);
    f.h = (d & 15) + (r & 15) + carry > 15;
    f.c = sum > 255;
    f.v = ((d ^ result) & (r ^ result)) >> 7;
    f.z = result == 0;
    set_negative_and_sign(result, f);
    d = result;
}
[[gnu::always_inline]] inline void adc(Byte& d, Byte r, Status& f) { add(d, r, f, f.c); }

[[gnu::always_inline]] inline Byte difference(Byte d, Byte r, bool borrow, Status& f) {
    const Byte result = Byte(d - r - borrow);
    f.h = (d & 15) < (r & 15) + borrow;
    f.c = d < unsigned(r) + borrow;
    f.v = ((d ^ r) & (d ^ result)) >> 7;
    set_negative_and_sign(result, f);
    return result;
}
[[gnu::always_inline]] inline void cp(Byte d, Byte r, Status& f) {
    f.z = difference(d, r, false, f) == 0;
}
[[gnu::always_inline]] inline void sub(Byte& d, Byte r, Status& f) {
    d = difference(d, r, false, f);
    f.z = d == 0;
}
// Zero stays set only if the lower bytes were zero, too.
[[gnu::always_inline]] inline void cpc(Byte d, Byte r, Status& f) {
    f.z &= difference(d, r, f.c, f) == 0;
}
[[gnu::always_inline]] inline void sbc(Byte& d, Byte r, Status& f) {
    d = difference(d, r, f.c, f);
    f.z &= d == 0;
}
[[gnu::always_inline]] inline void neg(Byte& d, Status& f) {
    const Byte r = d;
    d = 0;
    sub(d, r, f);
}

[[gnu::always_inline]] inline void set_logic(Byte result, Status& f) {
    f.v = false;
    f.z = result == 0;
    set_negative_and_sign(result, f);
}
[[gnu::always_inline]] inline void and_(Byte& d, Byte r, Status& f) { set_logic(d &= r, f); }
[[gnu::always_inline]] inline void or_(Byte& d, Byte r, Status& f) { set_logic(d |= r, f); }
[[gnu::always_inline]] inline void eor(Byte& d, Byte r, Status& f) { set_logic(d ^= r, f); }
[[gnu::always_inline]] inline void com(Byte& d, Status& f) {
    set_logic(d = Byte(~d), f);
    f.c = true;
}

[[gnu::always_inline]] inline void inc(Byte& d, Status& f) {
    ++d;
    f.v = d == 0x80;
    f.z = d == 0;
    set_negative_and_sign(d, f);
}
[[gnu::always_inline]] inline void dec(Byte& d, Status& f) {
    --d;
    f.v = d == 0x7f;
    f.z = d == 0;
    set_negative_and_sign(d, f);
}

[[gnu::always_inline]] inline void shift_right(Byte& d, bool top, Status& f) {
    f.c = d & 1;
    d = Byte(d >> 1 | top << 7);
    f.n = d >> 7;
    f.v = f.n != f.c;
    f.s = f.n != f.v;
    f.z = d == 0;
}
[[gnu::always_inline]] inline void lsr(Byte& d, Status& f) { shift_right(d, false, f); }
[[gnu::always_inline]] inline void asr(Byte& d, Status& f) { shift_right(d, d >> 7, f); }
[[gnu::always_inline]] inline void ror(Byte& d, Status& f) { shift_right(d, f.c, f); }

[[gnu::always_inline]] inline void set_product(unsigned product, Byte& r0, Byte& r1, Status& f) {
    f.c = product >> 15 & 1;
    f.z = Word(product) == 0;
    r0 = Byte(product);
    r1 = Byte(product >> 8);
}
[[gnu::always_inline]] inline void mul(Byte d, Byte r, Byte& r0, Byte& r1, Status& f) {
    set_product(unsigned(d) * r, r0, r1, f);
}
[[gnu::always_inline]] inline void muls(Byte d, Byte r, Byte& r0, Byte& r1, Status& f) {
    set_product(unsigned(std::int8_t(d) * std::int8_t(r)), r0, r1, f);
}
[[gnu::always_inline]] inline void mulsu(Byte d, Byte r, Byte& r0, Byte& r1, Status& f) {
    set_product(unsigned(std::int8_t(d) * int(r)), r0, r1, f);
}
// The fractional products are shifted left by one; the carry is the bit that is lost.
[[gnu::always_inline]] inline void set_fractional_product(unsigned product, Byte& r0, Byte& r1,
                                                          Status& f) {
    set_product(product << 1, r0, r1, f);
    f.c = product >> 15 & 1;
}
[[gnu::always_inline]] inline void fmul(Byte d, Byte r, Byte& r0, Byte& r1, Status& f) {
    set_fractional_product(unsigned(d) * r, r0, r1, f);
}
[[gnu::always_inline]] inline void fmuls(Byte d, Byte r, Byte& r0, Byte& r1, Status& f) {
    set_fractional_product(unsigned(std::int8_t(d) * std::int8_t(r)), r0, r1, f);
}
[[gnu::always_inline]] inline void fmulsu(Byte d, Byte r, Byte& r0, Byte& r1, Status& f) {
    set_fractional_product(unsigned(std::int8_t(d) * int(r)), r0, r1, f);
}

[[gnu::always_inline]] inline void set_word(Byte& low, Byte& high, Word after, Status& f) {
    f.z = after == 0;
    low = Byte(after);
    high = Byte(after >> 8);
    set_negative_and_sign(high, f);
}
[[gnu::always_inline]] inline void adiw(Byte& low, Byte& high, Byte k, Status& f) {
    const Word before = word(low, high), after = Word(before + k);
    f.v = (~before & after) >> 15;
    f.c = (before & ~after) >> 15 & 1;
    set_word(low, high, after, f);
}
[[gnu::always_inline]] inline void sbiw(Byte& low, Byte& high, Byte k, Status& f) {
    const Word before = word(low, high), after = Word(before - k);
    f.v = (before & ~after) >> 15 & 1;
    f.c = (~before & after) >> 15;
    set_word(low, high, after, f);
}

// X+, Y+, Z+ and -X, -Y, -Z: returns the address and moves the pointer.
[[gnu::always_inline]] inline Word moved_after(Byte& low, Byte& high) {
    const Word address = word(low, high);
    low = Byte(address + 1);
    high = Byte((address + 1) >> 8);
    return address;
}
[[gnu::always_inline]] inline Word moved_before(Byte& low, Byte& high) {
    const Word address = Word(word(low, high) - 1);
    low = Byte(address);
    high = Byte(address >> 8);
    return address;
}

// Thrown by a call that does something that a function must not do.
struct Fault {
    const char* what;
    unsigned where;
};

// Data space as a function may use it: it may read its operands, results and stack, and write its
// results and stack. Areas are [begin, end) in data-space addresses.
template <Word operands_begin, Word operands_end, Word results_begin, Word results_end,
          Word ram_end>
struct Memory {
    static constexpr Word ram_begin = 0x100;
    Byte* bytes;  // ram_end bytes
    Word sp;

    [[gnu::always_inline]] Byte load(unsigned address) const {
        const bool operand = address >= operands_begin && address < operands_end;
        if (!operand && !is_writable(address)) [[unlikely]]
            throw Fault{"reads outside of its operands and its stack, data address", address};
        return bytes[address];
    }
    [[gnu::always_inline]] void store(unsigned address, Byte value) {
        if (!is_writable(address)) [[unlikely]]
            throw Fault{"writes outside of its results and its stack, data address", address};
        bytes[address] = value;
    }
    [[gnu::always_inline]] bool is_writable(unsigned address) const {
        return (address >= results_begin && address < results_end) ||
               (address > sp && address < ram_end);
    }
    [[gnu::always_inline]] void push(Byte value) {
        if (sp < ram_begin || sp < results_end || sp < operands_end || sp >= ram_end) [[unlikely]]
            throw Fault{"runs out of its stack, stack pointer", sp};
        bytes[sp--] = value;
    }
    [[gnu::always_inline]] Byte pop() {
        if (++sp >= ram_end) [[unlikely]]
            throw Fault{"pops more than was pushed, stack pointer", sp};
        return bytes[sp];
    }
    // The high byte of a return address is at the lower address.
    [[gnu::always_inline]] void push_address(Word word_address) {
        push(Byte(word_address));
        push(Byte(word_address >> 8));
    }
    [[gnu::always_inline]] void return_to(Word word_address) {
        const Byte high = pop(), low = pop();
        if (word(low, high) != word_address) [[unlikely]]
            throw Fault{"returns to another address than it was called from, word address",
                        word(low, high)};
    }

    // The I/O addresses of the stack pointer and the status register.
    static constexpr int spl = 0x3d, sph = 0x3e, sreg = 0x3f;
    template <int address>
    Byte in(const Status& f) const {
        static_assert(address == spl || address == sph || address == sreg);
        if (address == spl) return Byte(sp);
        if (address == sph) return Byte(sp >> 8);
        return Byte(f.c | f.z << 1 | f.n << 2 | f.v << 3 | f.s << 4 | f.h << 5 | f.t << 6 |
                    f.i << 7);
    }
    template <int address>
    void out(Byte value, Status& f) {
        static_assert(address == spl || address == sph || address == sreg);
        if (address == spl) sp = word(value, Byte(sp >> 8));
        if (address == sph) sp = word(Byte(sp), value);
        if (address == sreg) {
            const auto bit = [&](int i) { return bool(value >> i & 1); };
            f = {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6), bit(7)};
        }
    }
};

// The content on entry of register `number`, if the calling convention gives it no meaning: another
// value in each call, so that a function that relies on one or loses one is detected.
constexpr Byte unspecified(std::uint64_t pattern, int number) {
    return Byte((pattern >> number % 8 * 8) ^ unsigned(number) * 37);
}

}  // namespace instructions::semantics
