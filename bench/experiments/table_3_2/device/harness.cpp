// SPDX-License-Identifier: GPL-3.0-or-later
// The published timing harness: for each type and operation a loop of 30000 on volatile operands,
// timed by the Arduino core's millis(). Each detail of loop, operators and arithmetic that the
// publication leaves open is a macro, each value of which is a hypothesis. The three loop forms
// share a program:
//   cell_assign_<type>_<operation>      c = a op b
//   cell_accumulate_<type>_<operation>  c += a op b
//   cell_replace_<type>_<operation>     a = a op b
// The host writes operands and the cell to time into .noinit, which the start-up code leaves
// unchanged, and reads `elapsed_ms` when `finished` is reached.

#include <Arduino.h>

#include <fixedpoint/published/atan2.hpp>
#include <fixedpoint/published/divide.hpp>
#include <fixedpoint/published/multiply.hpp>
#include <fixedpoint/published/sqrt.hpp>

#ifndef COUNTER
#define COUNTER int
#endif
// Operands: 0 globals, 1 locals of the cell.
#ifndef LOCAL_OPERANDS
#define LOCAL_OPERANDS 0
#endif
// The operators of the fixed-point types: 0 inlined, 1 functions with arguments by value, 2 such
// functions whose result passes through a constructor that is called, too, 3 functions with
// arguments by reference.
#ifndef OPERATORS
#define OPERATORS 0
#endif
// The count of the shift by the fraction bits: 0 a constant, 1 a variable.
#ifndef VARIABLE_SHIFT
#define VARIABLE_SHIFT 0
#endif
// Operands are widened: 0 after taking their magnitudes, 1 before.
#ifndef WIDENED_FIRST
#define WIDENED_FIRST 0
#endif

#define NOINIT __attribute__((section(".noinit"), used))
#define INLINED inline __attribute__((always_inline))
#define CALLED __attribute__((noinline, noclone))
#if OPERATORS == 0
#define OPERATOR INLINED
#else
#define OPERATOR CALLED
#endif

const int iterations = 30000;

// The arithmetic of the fixed-point types: the library's or, for a hypothesis on how it was
// written, the same steps written differently.
#if VARIABLE_SHIFT || WIDENED_FIRST

template <int F>
struct FractionBits {
    static uint8_t count;
};
#if VARIABLE_SHIFT
template <int F>
uint8_t FractionBits<F>::count __attribute__((used)) = F;
#define FRACTION_BITS(F) (FractionBits<F>::count)
#else
#define FRACTION_BITS(F) (F)
#endif

template <class Raw, int F>
struct Arithmetic {
    using Wide = fixedpoint::Wide<Raw>;
#if WIDENED_FIRST
    using Operand = Wide;
#else
    using Operand = Raw;
#endif
    static INLINED int make_positive(Operand& a, Operand& b) {
        int flip = 1;
        if (a < 0) {
            a = -a;
            flip = -flip;
        }
        if (b < 0) {
            b = -b;
            flip = -flip;
        }
        return flip;
    }
    static INLINED Raw multiply(Operand a, Operand b) {
        const int flip = make_positive(a, b);
        return static_cast<Raw>(((static_cast<Wide>(a) * b) >> FRACTION_BITS(F)) * flip);
    }
    static INLINED Raw divide(Operand a, Operand b) {
        const int flip = make_positive(a, b);
        return static_cast<Raw>(((static_cast<Wide>(a) << FRACTION_BITS(F)) / b) * flip);
    }
};

#else

template <class Raw, int F>
struct Arithmetic {
    static INLINED Raw multiply(Raw a, Raw b) {
        return fixedpoint::published::multiply<Raw, F>(a, b);
    }
    static INLINED Raw divide(Raw a, Raw b) { return fixedpoint::published::divide<Raw, F>(a, b); }
};

#endif

// What a cell calls: the operators of each type, and the addition in `c +=`.
template <class T>
struct Native {
    static INLINED T add(T a, T b) { return a + b; }
    static INLINED T subtract(T a, T b) { return a - b; }
    static INLINED T multiply(T a, T b) { return a * b; }
    static INLINED T divide(T a, T b) { return a / b; }
    static INLINED T shift_left_16(T a, T) { return a << 16; }
    static INLINED void accumulate(volatile T& c, T a) { c += a; }
};

struct Float : Native<float> {
    static INLINED float sqrt(float a, float) { return ::sqrt(a); }
};

template <class Raw, int F>
struct Fixed {
#if OPERATORS == 3
    using Argument = const volatile Raw&;
#else
    using Argument = Raw;
#endif
#if OPERATORS == 2
    // The empty statement keeps the compiler from seeing that the call does nothing.
    static CALLED Raw constructed(Raw raw) {
        asm volatile("");
        return raw;
    }
#else
    static INLINED Raw constructed(Raw raw) { return raw; }
#endif
    static OPERATOR Raw add(Argument a, Argument b) { return constructed(a + b); }
    static OPERATOR Raw subtract(Argument a, Argument b) { return constructed(a - b); }
    static OPERATOR Raw multiply(Argument a, Argument b) {
        return constructed(Arithmetic<Raw, F>::multiply(a, b));
    }
    static OPERATOR Raw divide(Argument a, Argument b) {
        return constructed(Arithmetic<Raw, F>::divide(a, b));
    }
    static OPERATOR Raw sqrt(Argument a, Argument) {
        return fixedpoint::published::sqrt<Raw, F>(a);
    }
    static OPERATOR Raw atan2(Argument a, Argument b) {
        return fixedpoint::published::atan2<Raw, F>(a, b);
    }
#if OPERATORS == 3
    static OPERATOR void accumulate(volatile Raw& c, Raw a) { c += a; }
#else
    static INLINED void accumulate(volatile Raw& c, Raw a) { c = add(c, a); }
#endif
};

#if LOCAL_OPERANDS
#define OPERANDS(type, T) volatile T a = type##_a, b = type##_b, c = type##_c;
#else
#define OPERANDS(type, T) volatile T &a = type##_a, &b = type##_b, &c = type##_c;
#endif
#define CELL(form, type, T, operation, step)                                               \
    extern "C" __attribute__((noinline, used)) void cell_##form##_##type##_##operation() { \
        OPERANDS(type, T)                                                                  \
        (void)b, (void)c;                                                                  \
        for (COUNTER i = 0; i < iterations; i++) step;                                     \
    }
#define CELLS(type, T, Number, operation)                                                \
    CELL(assign, type, T, operation, c = Number::operation(a, b))                        \
    CELL(accumulate, type, T, operation, Number::accumulate(c, Number::operation(a, b))) \
    CELL(replace, type, T, operation, a = Number::operation(a, b))
#define TYPE(type, T, Number)               \
    extern "C" {                            \
    volatile T type##_a NOINIT;             \
    volatile T type##_b NOINIT;             \
    volatile T type##_c NOINIT;             \
    }                                       \
    using Number_##type = Number;           \
    CELLS(type, T, Number_##type, add)      \
    CELLS(type, T, Number_##type, subtract) \
    CELLS(type, T, Number_##type, multiply) \
    CELLS(type, T, Number_##type, divide)
#define COMMA ,

TYPE(int16_t, int16_t, Native<int16_t>)
TYPE(int32_t, int32_t, Native<int32_t>)
TYPE(int64_t, int64_t, Native<int64_t>)
TYPE(fixed_8_8, int16_t, Fixed<int16_t COMMA 8>)
TYPE(fixed_16_16, int32_t, Fixed<int32_t COMMA 16>)
TYPE(float, float, Float)
CELLS(int64_t, int64_t, Number_int64_t, shift_left_16)
CELLS(fixed_16_16, int32_t, Number_fixed_16_16, sqrt)
CELLS(fixed_16_16, int32_t, Number_fixed_16_16, atan2)
CELLS(float, float, Number_float, sqrt)

extern "C" {
void (*volatile timed_cell)() NOINIT;
volatile uint32_t elapsed_ms NOINIT;

// Referenced by the core's delay(), which nothing calls.
void yield() {}

CALLED __attribute__((used)) void finished() {
    for (;;) {
    }
}
}

int main() {
    init();
    const uint32_t start = millis();
    timed_cell();
    elapsed_ms = millis() - start;
    finished();
}
