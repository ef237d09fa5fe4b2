// SPDX-License-Identifier: MIT
// The functions of fixedpoint_c.h, in the default arithmetic. On the AVR the functions with a
// kernel are here too, under the names by which languages other than C call them.
#define FIXEDPOINT_C_KERNEL(symbol)
#include <fixedpoint.h>
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

template <class Number>
Number number(typename Number::Raw raw) {
    return Number::from_raw(raw);
}

}  // namespace

#define UNARY(q, Number, name) \
    q q##_##name(q a) { return name(number<Number>(a)).raw(); }
#define BINARY(q, Number, name) \
    q q##_##name(q a, q b) { return name(number<Number>(a), number<Number>(b)).raw(); }
#define SINE_AND_COSINE(q, Number, name)               \
    void q##_##name(q angle, q* sine_and_cosine) {     \
        const auto both = name(number<Number>(angle)); \
        sine_and_cosine[0] = both.sine.raw();          \
        sine_and_cosine[1] = both.cosine.raw();        \
    }
#define QUOTIENT_AND_REMAINDER(q, Number, name)                       \
    void q##_##name(q a, q b, q* quotient_and_remainder) {            \
        const auto both = name(number<Number>(a), number<Number>(b)); \
        quotient_and_remainder[0] = both.quotient;                    \
        quotient_and_remainder[1] = both.remainder.raw();             \
    }
#define OPERATOR(q, Number, name, symbol) \
    q q##_##name(q a, q b) { return (number<Number>(a) symbol number<Number>(b)).raw(); }
#define SHIFT(q, Number, name, symbol) \
    q q##_##name(q a, uint8_t count) { return (number<Number>(a) symbol count).raw(); }
#define OF_VECTOR(q, Number, name) \
    q q##_##name(const q* v) { return Nearest::name<q, Number::fraction_bits>(v); }
#define OF_VECTORS(q, Number, name) \
    q q##_##name(const q* a, const q* b) { return Nearest::name<q, Number::fraction_bits>(a, b); }

#define FORMAT(q, Number)                                                                   \
    OPERATOR(q, Number, add, +)                                                             \
    OPERATOR(q, Number, subtract, -)                                                        \
    OPERATOR(q, Number, multiply, *)                                                        \
    OPERATOR(q, Number, divide, /)                                                          \
    OPERATOR(q, Number, remainder, %)                                                       \
    SHIFT(q, Number, shift_left, <<)                                                        \
    SHIFT(q, Number, shift_right, >>)                                                       \
    q q##_negate(q a) { return (-number<Number>(a)).raw(); }                                \
    UNARY(q, Number, abs)                                                                   \
    UNARY(q, Number, sqrt)                                                                  \
    UNARY(q, Number, reciprocal_sqrt)                                                       \
    UNARY(q, Number, sin)                                                                   \
    UNARY(q, Number, cos)                                                                   \
    UNARY(q, Number, atan)                                                                  \
    UNARY(q, Number, exp)                                                                   \
    UNARY(q, Number, log)                                                                   \
    UNARY(q, Number, tan)                                                                   \
    UNARY(q, Number, asin)                                                                  \
    UNARY(q, Number, acos)                                                                  \
    UNARY(q, Number, exp2)                                                                  \
    UNARY(q, Number, expm1)                                                                 \
    UNARY(q, Number, log2)                                                                  \
    UNARY(q, Number, log10)                                                                 \
    UNARY(q, Number, log1p)                                                                 \
    UNARY(q, Number, sinh)                                                                  \
    UNARY(q, Number, cosh)                                                                  \
    UNARY(q, Number, tanh)                                                                  \
    UNARY(q, Number, cbrt)                                                                  \
    q q##_pow(q x, q y) { return pow(number<Number>(x), number<Number>(y)).raw(); }         \
    q q##_atan2(q y, q x) { return atan2(number<Number>(y), number<Number>(x)).raw(); }     \
    UNARY(q, Number, sin_turns)                                                             \
    UNARY(q, Number, cos_turns)                                                             \
    SINE_AND_COSINE(q, Number, sincos_turns)                                                \
    BINARY(q, Number, atan2_turns)                                                          \
    UNARY(q, Number, sin_degrees)                                                           \
    UNARY(q, Number, cos_degrees)                                                           \
    SINE_AND_COSINE(q, Number, sincos_degrees)                                              \
    BINARY(q, Number, atan2_degrees)                                                        \
    QUOTIENT_AND_REMAINDER(q, Number, divrem)                                               \
    QUOTIENT_AND_REMAINDER(q, Number, divmod)                                               \
    q q##_lerp(q a, q b, q t) {                                                             \
        return lerp(number<Number>(a), number<Number>(b), number<Number>(t)).raw();         \
    }                                                                                       \
    UNARY(q, Number, smoothstep)                                                            \
    BINARY(q, Number, midpoint)                                                             \
    BINARY(q, Number, abs_diff)                                                             \
    BINARY(q, Number, copysign)                                                             \
    int8_t q##_sign(q a) { return static_cast<int8_t>(sign(number<Number>(a))); }           \
    q q##_isqrt(q n) { return isqrt(n); }                                                   \
    q q##_power(q x, int32_t n) { return power(number<Number>(x), n).raw(); }               \
    q q##_multiply_add(q a, q b, q c) {                                                     \
        return multiply_add(number<Number>(a), number<Number>(b), number<Number>(c)).raw(); \
    }                                                                                       \
    void q##_sincos(q angle, q* sine_and_cosine) {                                          \
        Nearest::sincos<q, Number::fraction_bits>(angle, sine_and_cosine);                  \
    }                                                                                       \
    OF_VECTORS(q, Number, dot2)                                                             \
    OF_VECTORS(q, Number, dot3)                                                             \
    OF_VECTOR(q, Number, length2)                                                           \
    OF_VECTOR(q, Number, length3)                                                           \
    void q##_normalise3(const q* v, q* unit) {                                              \
        Nearest::normalise3<q, Number::fraction_bits>(v, unit);                             \
    }                                                                                       \
    q q##_from_int32(int32_t n) { return Number::from_integer(n).raw(); }                   \
    int32_t q##_to_int32(q a) { return convert<int32_t>(number<Number>(a)); }               \
    q q##_from_float(float x) { return from_float<Number>(x).raw(); }                       \
    float q##_to_float(q a) { return to_float<float>(number<Number>(a)); }                  \
    fixedpoint_text_status q##_parse(const char* text, q* number) {                         \
        return parse_text<Number>(text, number);                                            \
    }                                                                                       \
    size_t q##_print(q a, char* text, size_t capacity) {                                    \
        return terminated(Shortest<Number>{number<Number>(a)}, text, capacity);             \
    }                                                                                       \
    size_t q##_print_decimals(q a, uint8_t decimals, char* text, size_t capacity) {         \
        return terminated(Decimals<Number>{number<Number>(a), decimals}, text, capacity);   \
    }                                                                                       \
    static_assert(Number##_TEXT_CAPACITY == text_capacity<Number>() + 1, "and a zero");

// On the AVR a double is a float.
#ifdef __AVR__
#define FORMAT_DOUBLE(q, Number)
#else
#define FORMAT_DOUBLE(q, Number)                                        \
    q q##_from_double(double x) { return from_float<Number>(x).raw(); } \
    double q##_to_double(q a) { return to_float<double>(number<Number>(a)); }
#endif

#define CONVERSION(to, To, from, From) \
    to to##_from_##from(from a) { return convert<To>(number<From>(a)).raw(); }

using Q8_24 = Fixed<8, 24>;
FORMAT(q4_4, Q4_4)
FORMAT(q8_8, Q8_8)
FORMAT(q16_16, Q16_16)
FORMAT(q8_24, Q8_24)
FORMAT(q32_32, Q32_32)
FORMAT_DOUBLE(q4_4, Q4_4)
FORMAT_DOUBLE(q8_8, Q8_8)
FORMAT_DOUBLE(q16_16, Q16_16)
FORMAT_DOUBLE(q8_24, Q8_24)
FORMAT_DOUBLE(q32_32, Q32_32)
CONVERSION(q4_4, Q4_4, q8_8, Q8_8)
CONVERSION(q4_4, Q4_4, q16_16, Q16_16)
CONVERSION(q4_4, Q4_4, q8_24, Q8_24)
CONVERSION(q4_4, Q4_4, q32_32, Q32_32)
CONVERSION(q8_8, Q8_8, q4_4, Q4_4)
CONVERSION(q8_8, Q8_8, q16_16, Q16_16)
CONVERSION(q8_8, Q8_8, q8_24, Q8_24)
CONVERSION(q8_8, Q8_8, q32_32, Q32_32)
CONVERSION(q16_16, Q16_16, q4_4, Q4_4)
CONVERSION(q16_16, Q16_16, q8_8, Q8_8)
CONVERSION(q16_16, Q16_16, q8_24, Q8_24)
CONVERSION(q16_16, Q16_16, q32_32, Q32_32)
CONVERSION(q8_24, Q8_24, q4_4, Q4_4)
CONVERSION(q8_24, Q8_24, q8_8, Q8_8)
CONVERSION(q8_24, Q8_24, q16_16, Q16_16)
CONVERSION(q8_24, Q8_24, q32_32, Q32_32)
CONVERSION(q32_32, Q32_32, q4_4, Q4_4)
CONVERSION(q32_32, Q32_32, q8_8, Q8_8)
CONVERSION(q32_32, Q32_32, q16_16, Q16_16)
CONVERSION(q32_32, Q32_32, q8_24, Q8_24)
