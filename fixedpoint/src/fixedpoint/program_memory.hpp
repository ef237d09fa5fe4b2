// SPDX-License-Identifier: MIT
// Constants that stay in flash: FIXEDPOINT_PROGRAM_MEMORY places a table there, and
// read_program_memory(entry) reads an entry. On the host, and in a constant expression, an entry is
// an ordinary constant.
#pragma once

#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
#ifdef __clang__  // does not know the attribute of PROGMEM
#define FIXEDPOINT_PROGRAM_MEMORY __attribute__((section(".progmem.data.fixedpoint")))
#else
#define FIXEDPOINT_PROGRAM_MEMORY PROGMEM
#endif
#else
#define FIXEDPOINT_PROGRAM_MEMORY
#endif

namespace fixedpoint {

#ifdef __AVR__
inline uint8_t load_program_memory(const uint8_t* entry) { return pgm_read_byte(entry); }
inline uint16_t load_program_memory(const uint16_t* entry) { return pgm_read_word(entry); }
inline uint32_t load_program_memory(const uint32_t* entry) {
#ifdef __clang__  // does not support the four-register asm operands of pgm_read_dword
    const uint16_t* const halves = reinterpret_cast<const uint16_t*>(entry);
    return static_cast<uint32_t>(pgm_read_word(halves + 1)) << 16 | pgm_read_word(halves);
#else
    return pgm_read_dword(entry);
#endif
}
#if defined(__AVR_HAVE_LPMX__) && defined(__AVR_HAVE_MOVW__)
// Written in assembly, since the compiler would join the halves by a loop. The entry is passed in
// r25:r24, the result returned in r25:r18. The clobber list is for -fipa-ra, which would otherwise
// assume that these registers keep their values.
__attribute__((naked, noinline)) inline uint64_t load_program_memory(const uint64_t*) {
    __asm__(
        "movw r30, r24\n\tlpm r18, Z+\n\tlpm r19, Z+\n\tlpm r20, Z+\n\tlpm r21, Z+\n\t"
        "lpm r22, Z+\n\tlpm r23, Z+\n\tlpm r24, Z+\n\tlpm r25, Z\n\tret" ::
            : "r18", "r19", "r20", "r21", "r22", "r23", "r24", "r25", "r30", "r31");
}
#else
inline uint64_t load_program_memory(const uint64_t* entry) {
    const uint32_t* const halves = reinterpret_cast<const uint32_t*>(entry);
    return static_cast<uint64_t>(load_program_memory(halves + 1)) << 32 |
           load_program_memory(halves);
}
#endif

template <class T>
constexpr T read_program_memory(const T& entry) {
    return __builtin_constant_p(entry) ? entry : load_program_memory(&entry);
}
#else
template <class T>
constexpr T read_program_memory(const T& entry) {
    return entry;
}
#endif

}  // namespace fixedpoint
