// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/number_format.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/operation.hpp"

namespace reference {
namespace {

TEST(NumberFormat, NamesAreReadAndPrinted) {
    for (const char* name : {"u8_8",   "u16_16", "u0_16", "u32_0", "q4_4",  "q8_8",  "q16_16",
                             "q32_32", "q8_24",  "q1_15", "q16_0", "s8_7",  "s0_7",  "s16_15",
                             "s32_31", "s16_47", "int8",  "int16", "int32", "int64", "float"}) {
        EXPECT_EQ(format_name(parse_format(name)), name);
    }
    EXPECT_EQ(parse_format("float64"), ieee_double);
    EXPECT_EQ(parse_format("s16_15"), (NumberFormat{FormatKind::accum, 32, 15}));
    EXPECT_EQ(parse_format("q8_24"), (NumberFormat{FormatKind::fixed, 32, 24}));
    EXPECT_EQ(parse_format("u0_16"), unsigned_format(0, 16));
}

TEST(NumberFormat, UnknownNamesAreRejected) {
    for (const char* name :
         {"",      "u",     "u8",     "u8_9",   "u-1_17", "u08_8",          "u32_32",  "q",
          "q16",   "q16_",  "q_16",   "q16_17", "q0_16",  "q-1_17",         "q016_16", "int",
          "int24", "int-8", "double", "s16_16", "q4_4_",  "q99999999999_1", "Q16_16",  "q16_16 "}) {
        EXPECT_THROW(parse_format(name), std::invalid_argument) << name;
    }
}

TEST(NumberFormat, RangeAndResolution) {
    EXPECT_EQ(q4_4.min(), -128);
    EXPECT_EQ(q4_4.max(), 127);
    EXPECT_EQ(q32_32.min(), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(q32_32.max(), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(q8_8.extend(0x1ffff), -1);
    EXPECT_EQ(unsigned_format(8, 8).min(), 0);
    EXPECT_EQ(unsigned_format(8, 8).max(), 65535);
    EXPECT_EQ(unsigned_format(0, 32).max(), 4294967295);
    EXPECT_EQ(unsigned_format(8, 8).extend(0x1fffe), 65534);
    EXPECT_EQ(to_double(ieee_single, ieee_single.max()), FLT_MAX);
    EXPECT_EQ(to_double(ieee_single, ieee_single.min()), -FLT_MAX);
    EXPECT_EQ(to_double(ieee_double, ieee_double.max()), DBL_MAX);
    EXPECT_EQ(to_double(ieee_double, ieee_double.min()), -DBL_MAX);
    EXPECT_EQ(to_double(q16_16, -98304), -1.5);
}

TEST(NumberFormat, FloatsAreThoseOfC) {
    EXPECT_EQ(ieee_single.significand_bits(), FLT_MANT_DIG);
    EXPECT_EQ(ieee_single.infinity_exponent(), FLT_MAX_EXP);
    EXPECT_EQ(std::ldexp(1, ieee_single.min_exponent()), FLT_MIN);
    EXPECT_EQ(std::ldexp(1, ieee_single.min_place()), FLT_TRUE_MIN);
    EXPECT_EQ(ieee_double.significand_bits(), DBL_MANT_DIG);
    EXPECT_EQ(ieee_double.infinity_exponent(), DBL_MAX_EXP);
    EXPECT_EQ(std::ldexp(1, ieee_double.min_exponent()), DBL_MIN);
    EXPECT_EQ(std::ldexp(1, ieee_double.min_place()), DBL_TRUE_MIN);
    for (const NumberFormat& format : {ieee_single, ieee_double}) {
        EXPECT_EQ(to_double(format, format.infinity()), INFINITY);
        EXPECT_EQ(to_double(format, format.infinity() | format.sign()), -INFINITY);
        EXPECT_TRUE(is_nan(format, raw_of_double(format, NAN)));
        EXPECT_FALSE(is_finite(format, raw_of_double(format, -INFINITY)));
        for (const double number : {0.0, -1.0, 0.5, -DBL_TRUE_MIN, DBL_MAX, 0x1.fffffep-149}) {
            const double nearest = format.width == 32 ? double(float(number)) : number;
            EXPECT_EQ(to_double(format, raw_of_double(format, number)), nearest);
        }
    }
}

TEST(NumberFormat, FloatPatterns) {
    EXPECT_TRUE(is_nan(ieee_single, raw_of_float(NAN)));
    EXPECT_FALSE(is_finite(ieee_single, raw_of_float(INFINITY)));
    EXPECT_FALSE(is_finite(ieee_single, raw_of_float(NAN)));
    EXPECT_TRUE(is_finite(ieee_single, raw_of_float(FLT_MAX)));
    EXPECT_FALSE(is_nan(q16_16, raw_of_float(NAN)));
}

TEST(Symbol, NamesTheSubject) {
    const NamedSubject dot = parse_symbol("dot3_q16_16_default");
    EXPECT_EQ(dot.subject, (Subject{Operation::dot3, q16_16, Arithmetic::nearest}));
    EXPECT_EQ(dot.implementation, "default");
    const NamedSubject root = parse_symbol("reciprocal_sqrt_q8_8_saturating_small");
    EXPECT_EQ(root.subject, (Subject{Operation::reciprocal_sqrt, q8_8, Arithmetic::saturating}));
    EXPECT_EQ(root.implementation, "saturating_small");
    EXPECT_EQ(parse_symbol("log_q16_16_correctly_rounded").subject.arithmetic,
              Arithmetic::correctly_rounded);
    EXPECT_EQ(parse_symbol("divide_q8_8_half_to_even").subject.arithmetic,
              Arithmetic::half_to_even);
    EXPECT_EQ(parse_symbol("multiply_q8_8_downward").subject.arithmetic, Arithmetic::downward);
    EXPECT_EQ(parse_symbol("multiply_q8_8_toward_zero").subject.arithmetic,
              Arithmetic::toward_zero);
    EXPECT_EQ(parse_symbol("multiply_add_int16_native").subject,
              (Subject{Operation::multiply_add, parse_format("int16"), Arithmetic::integer}));
    EXPECT_EQ(parse_symbol("divide_u8_8_default").subject,
              (Subject{Operation::divide, unsigned_format(8, 8), Arithmetic::nearest}));
    EXPECT_EQ(parse_symbol("atan2_float_libc").subject,
              (Subject{Operation::atan2, ieee_single, Arithmetic::ieee}));
    EXPECT_EQ(parse_symbol("divide_s16_15_accum").subject.arithmetic, Arithmetic::accum);
    EXPECT_EQ(parse_symbol("convert_q8_8_q16_16_default").subject,
              (Subject{Operation::convert, q16_16, Arithmetic::nearest, q8_8}));
    EXPECT_EQ(parse_symbol("convert_float_q16_16_saturating").subject,
              (Subject{Operation::convert, q16_16, Arithmetic::saturating, ieee_single}));
}

TEST(Symbol, OtherNamesAreRejected) {
    for (const char* symbol :
         {"", "main", "multiply", "multiply_", "multiply_q16_16", "cube_q16_16_x",
          "multiply_q16_16_", "multiply_double_libc", "convert_q8_8_default"}) {
        EXPECT_THROW(parse_symbol(symbol), std::invalid_argument) << symbol;
    }
    EXPECT_THROW(parse_operation("cube"), std::invalid_argument);
}

}  // namespace
}  // namespace reference
