// SPDX-License-Identifier: MIT
// The functions of fixedpoint_c.h, in the default arithmetic. On the AVR the functions with a
// kernel are here too, under the names by which languages other than C call them.
#define FIXEDPOINT_C_KERNEL(symbol)
#include <fixedpoint.h>
#include <fixedpoint/c_functions.h>
#include <fixedpoint_c.h>

using namespace fixedpoint;

namespace {

static_assert(static_cast<int>(TextStatus::ok) == FIXEDPOINT_TEXT_OK &&
                  static_cast<int>(TextStatus::empty) == FIXEDPOINT_TEXT_EMPTY &&
                  static_cast<int>(TextStatus::malformed) == FIXEDPOINT_TEXT_MALFORMED &&
                  static_cast<int>(TextStatus::out_of_range) == FIXEDPOINT_TEXT_OUT_OF_RANGE,
              "The statuses of C must be those of TextStatus.");

template <class Number>
fixedpoint_text_status parse_text(const char* text, typename Number::Raw* number) {
    const Parsed<Number> parsed = parse<Number>(text);
    *number = parsed.number.raw();
    return static_cast<fixedpoint_text_status>(parsed.status);
}

// Adds a terminating zero to what `print_into(text, capacity)` prints, which returns 0 if the text
// does not fit.
template <class Print>
size_t terminated(Print print_into, char* text, size_t capacity) {
    if (capacity == 0) return 0;
    const size_t length = print_into(text, capacity - 1);
    text[length] = '\0';
    return length;
}

template <class Number>
struct Shortest {
    Number number;
    size_t operator()(char* text, size_t capacity) const { return print(number, text, capacity); }
};
template <class Number>
struct Decimals {
    Number number;
    uint8_t decimals;
    size_t operator()(char* text, size_t capacity) const {
        constexpr uint8_t most = Number::fraction_bits;
        return print(number, decimals < most ? decimals : most, text, capacity);
    }
};

#define NUMBER(q, Q, I, F)          \
    using number_##q = Fixed<I, F>; \
    static_assert(Q##_TEXT_CAPACITY == text_capacity<number_##q>() + 1, "and a zero");
FIXEDPOINT_C_FORMATS(NUMBER)

// The operators by the names of their functions.
#define OPERATOR(name, symbol)        \
    template <class Number>           \
    Number name(Number a, Number b) { \
        return a symbol b;            \
    }
OPERATOR(add, +)
OPERATOR(subtract, -)
OPERATOR(multiply, *)
OPERATOR(divide, /)
OPERATOR(remainder, %)
template <class Number>
Number negate(Number a) {
    return -a;
}
template <class Number>
Number shift_left(Number a, uint8_t count) {
    return a << count;
}
template <class Number>
Number shift_right(Number a, uint8_t count) {
    return a >> count;
}

}  // namespace

#define FROM(q, raw) number_##q::from_raw(raw)
#define DEFINE_unary(q, name) \
    q q##_##name(q a) { return name(FROM(q, a)).raw(); }
#define DEFINE_binary(q, name) \
    q q##_##name(q a, q b) { return name(FROM(q, a), FROM(q, b)).raw(); }
#define DEFINE_negation DEFINE_unary
#define DEFINE_operator DEFINE_binary
#define DEFINE_ternary(q, name) \
    q q##_##name(q a, q b, q c) { return name(FROM(q, a), FROM(q, b), FROM(q, c)).raw(); }
#define DEFINE_shift(q, name) \
    q q##_##name(q a, uint8_t count) { return name(FROM(q, a), count).raw(); }
#define DEFINE_power(q, name) \
    q q##_##name(q x, int32_t n) { return name(FROM(q, x), n).raw(); }
#define DEFINE_sign(q, name) \
    int8_t q##_##name(q a) { return static_cast<int8_t>(name(FROM(q, a))); }
#define DEFINE_integer(q, name) \
    q q##_##name(q n) { return name(n); }
#define DEFINE_pair(q, name)                       \
    void q##_##name(q angle, q* sine_and_cosine) { \
        const auto both = name(FROM(q, angle));    \
        sine_and_cosine[0] = both.sine.raw();      \
        sine_and_cosine[1] = both.cosine.raw();    \
    }
#define DEFINE_direct_pair(q, name)                                          \
    void q##_##name(q angle, q* sine_and_cosine) {                           \
        Nearest::name<q, number_##q::fraction_bits>(angle, sine_and_cosine); \
    }
#define DEFINE_binary_pair(q, name)                        \
    void q##_##name(q a, q b, q* quotient_and_remainder) { \
        const auto both = name(FROM(q, a), FROM(q, b));    \
        quotient_and_remainder[0] = both.quotient;         \
        quotient_and_remainder[1] = both.remainder.raw();  \
    }
#define DEFINE_dot(q, name)                                       \
    q q##_##name(const q* a, const q* b) {                        \
        return Nearest::name<q, number_##q::fraction_bits>(a, b); \
    }
#define DEFINE_length(q, name) \
    q q##_##name(const q* v) { return Nearest::name<q, number_##q::fraction_bits>(v); }
#define DEFINE_direction(q, name) \
    void q##_##name(const q* v, q* unit) { Nearest::name<q, number_##q::fraction_bits>(v, unit); }
#define DEFINE(name, shape, q) DEFINE_##shape(q, name)
#define FUNCTIONS(q, ...) FIXEDPOINT_C_FUNCTIONS(DEFINE, q)
FIXEDPOINT_C_FORMATS(FUNCTIONS)

#define CONVERSION(from, to) \
    to to##_from_##from(from a) { return convert<number_##to>(FROM(from, a)).raw(); }
#define CONVERSIONS(q, ...)                                                            \
    FIXEDPOINT_C_BESIDE_##q(CONVERSION, q) q q##_from_int32(int32_t n) {               \
        return number_##q::from_integer(n).raw();                                      \
    }                                                                                  \
    int32_t q##_to_int32(q a) { return convert<int32_t>(FROM(q, a)); }                 \
    q q##_from_float(float x) { return from_float<number_##q>(x).raw(); }              \
    float q##_to_float(q a) { return to_float<float>(FROM(q, a)); }                    \
    fixedpoint_text_status q##_parse(const char* text, q* number) {                    \
        return parse_text<number_##q>(text, number);                                   \
    }                                                                                  \
    size_t q##_print(q a, char* text, size_t capacity) {                               \
        return terminated(Shortest<number_##q>{FROM(q, a)}, text, capacity);           \
    }                                                                                  \
    size_t q##_print_decimals(q a, uint8_t decimals, char* text, size_t capacity) {    \
        return terminated(Decimals<number_##q>{FROM(q, a), decimals}, text, capacity); \
    }
FIXEDPOINT_C_FORMATS(CONVERSIONS)

// On the AVR a double is a float.
#ifndef __AVR__
#define DOUBLE_CONVERSIONS(q, ...)                                          \
    q q##_from_double(double x) { return from_float<number_##q>(x).raw(); } \
    double q##_to_double(q a) { return to_float<double>(FROM(q, a)); }
FIXEDPOINT_C_FORMATS(DOUBLE_CONVERSIONS)
#endif
