// SPDX-License-Identifier: GPL-3.0-or-later
// Every operation of the reference's table is a function of fixedpoint_c.h in every format, and
// returns what the reference defines. The other functions of C are compared with exact values.
#include <fixedpoint/c_functions.h>
#include <fixedpoint_c.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "fixedpoint/tests/exact.hpp"
#include "reference/judge.hpp"

namespace {

using reference::NumberFormat;
using reference::Operation;

struct Function {
    const char* name;
    reference::Subject subject;
    void (*call)(const std::int64_t* operands, std::int64_t* results);
};

template <class Raw>
struct Vector {
    Raw raw[3];
    explicit Vector(const std::int64_t* v, int n = 3) {
        for (int i = 0; i < n; ++i) raw[i] = static_cast<Raw>(v[i]);
    }
};

#define CALL_unary(f, q) *r = f(static_cast<q>(v[0]))
#define CALL_binary(f, q) *r = f(static_cast<q>(v[0]), static_cast<q>(v[1]))
#define CALL_ternary(f, q) *r = f(static_cast<q>(v[0]), static_cast<q>(v[1]), static_cast<q>(v[2]))
#define CALL_shift(f, q) *r = f(static_cast<q>(v[0]), static_cast<std::uint8_t>(v[1]))
#define CALL_pair(f, q)          \
    q both[2];                   \
    f(static_cast<q>(*v), both); \
    r[0] = both[0], r[1] = both[1]
#define CALL_binary_pair(f, q)                           \
    q both[2];                                           \
    f(static_cast<q>(v[0]), static_cast<q>(v[1]), both); \
    r[0] = both[0], r[1] = both[1]
#define CALL_dot(f, q, n) *r = f(Vector<q>(v, n).raw, Vector<q>(v + n, n).raw)
#define CALL_length(f, q, n) *r = f(Vector<q>(v, n).raw)
#define CALL_direction(f, q)   \
    q unit[3];                 \
    f(Vector<q>(v).raw, unit); \
    r[0] = unit[0], r[1] = unit[1], r[2] = unit[2]

// The number of components is half the number of operands for dot, and all of them for length.
#define CALLED_unary(f, q, operands) CALL_unary(f, q)
#define CALLED_binary(f, q, operands) CALL_binary(f, q)
#define CALLED_ternary(f, q, operands) CALL_ternary(f, q)
#define CALLED_shift(f, q, operands) CALL_shift(f, q)
#define CALLED_pair(f, q, operands) CALL_pair(f, q)
#define CALLED_binary_pair(f, q, operands) CALL_binary_pair(f, q)
#define CALLED_dot(f, q, operands) CALL_dot(f, q, operands / 2)
#define CALLED_length(f, q, operands) CALL_length(f, q, operands)
#define CALLED_direction(f, q, operands) CALL_direction(f, q)
#define FUNCTION(name, signature, operands, results, kind, bound, domain, q, integer, fraction) \
    FUNCTION_##signature(name, signature, operands, q, integer, fraction)
#define PLAIN(name, signature, operands, q, integer, fraction)     \
    {#q "_" #name,                                                 \
     {Operation::name, reference::fixed_format(integer, fraction), \
      reference::Arithmetic::nearest},                             \
     [](const std::int64_t* v, std::int64_t* r) { CALLED_##signature(q##_##name, q, operands); }},
#define FUNCTION_unary PLAIN
#define FUNCTION_binary PLAIN
#define FUNCTION_ternary PLAIN
#define FUNCTION_shift PLAIN
#define FUNCTION_pair PLAIN
#define FUNCTION_binary_pair PLAIN
#define FUNCTION_dot PLAIN
#define FUNCTION_length PLAIN
#define FUNCTION_direction PLAIN
// Conversions from each of the other formats, and from and to the built-in types.
#define FUNCTION_conversion(name, signature, operands, q, integer, fraction)

#define CONVERSION(function, To, to, From, from)                                             \
    {#function,                                                                              \
     {Operation::convert, to,                                                                \
      (to).is_float() ? reference::Arithmetic::ieee : reference::Arithmetic::nearest, from}, \
     [](const std::int64_t* v, std::int64_t* r) { *r = to_raw<To>(function(of_raw<From>(*v))); }},

template <class T>
T of_raw(std::int64_t raw) {
    if constexpr (std::is_same_v<T, float>) return reference::float_of_raw(raw);
    return static_cast<T>(raw);
}
template <class T>
std::int64_t to_raw(T number) {
    if constexpr (std::is_same_v<T, float>) return reference::raw_of_float(number);
    return static_cast<std::int64_t>(number);
}

#define FORMAT(q, Q, integer, fraction) \
    constexpr NumberFormat format_##q = reference::fixed_format(integer, fraction);
FIXEDPOINT_C_FORMATS(FORMAT)
constexpr NumberFormat format_int32 = {reference::FormatKind::integer, 32, 0},
                       format_float = reference::ieee_single;
#define FROM(from, to) CONVERSION(to##_from_##from, to, format_##to, from, format_##from)
#define BUILT_IN(q)                                                       \
    CONVERSION(q##_from_int32, q, format_##q, std::int32_t, format_int32) \
    CONVERSION(q##_to_int32, std::int32_t, format_int32, q, format_##q)   \
    CONVERSION(q##_from_float, q, format_##q, float, format_float)        \
    CONVERSION(q##_to_float, float, format_float, q, format_##q)
#define FUNCTIONS(q, Q, integer, fraction) \
    OPERATIONS(FUNCTION, q, integer, fraction) BUILT_IN(q) FIXEDPOINT_C_BESIDE_##q(FROM, q)

const std::vector<Function> functions = {FIXEDPOINT_C_FORMATS(FUNCTIONS)};

// Boundary and random raws of the operand's format.
std::vector<std::int64_t> raws(const NumberFormat& format) {
    std::vector<std::int64_t> all = exact::raws(format.width, 200);
    std::mt19937_64 random(1);
    if (all.size() > 1500) {
        std::shuffle(all.begin(), all.end(), random);
        all.resize(1500);
    }
    for (const std::int64_t raw :
         {std::int64_t(0), std::int64_t(1), std::int64_t(-1), format.min(), format.max()})
        all.push_back(raw);
    return all;
}

TEST(C, EveryOperationReturnsWhatTheReferenceDefines) {
    std::mt19937_64 random(2);
    for (const Function& function : functions) {
        const auto& shape = reference::shape(function.subject.operation);
        const auto all = raws(function.subject.operand_format);
        int judged = 0;
        for (const std::int64_t first : all) {
            std::int64_t operands[reference::max_operands] = {first},
                         results[reference::max_results] = {};
            // Every other call has operands with the magnitude of its first one, and boundary
            // operands.
            for (std::size_t i = 1; i < shape.operands; ++i)
                operands[i] =
                    all[random() % 4 == 0 ? all.size() - 1 - random() % 5 : random() % all.size()];
            if (reference::is_shift(shape.operation)) operands[1] = random() % 80;
            // Every other exponent is a small one.
            if (shape.operation == Operation::power)
                operands[1] = random() % 2 ? static_cast<std::int32_t>(operands[1])
                                           : static_cast<std::int64_t>(random() % 33) - 16;
            function.call(operands, results);
            const auto judgement = reference::judge(function.subject, {operands, shape.operands},
                                                    {results, shape.results});
            if (judgement.excluded) continue;
            ++judged;
            ASSERT_TRUE(judgement.as_defined) << function.name << " of " << operands[0] << ", "
                                              << operands[1] << " returns " << results[0];
        }
        EXPECT_GT(judged, 200) << function.name;
    }
}

template <class Raw>
struct Text {
    const char* format;
    int fraction;
    std::size_t capacity;
    fixedpoint_text_status (*parse)(const char*, Raw*);
    std::size_t (*print)(Raw, char*, std::size_t);
    std::size_t (*print_decimals)(Raw, std::uint8_t, char*, std::size_t);
    double (*to_double)(Raw);
    Raw (*from_double)(double);
    Raw third;  // Q_RATIO(-1, 3), a constant expression
};

template <class Raw>
void check_text(const Text<Raw>& c) {
    SCOPED_TRACE(c.format);
    const double unit = std::ldexp(1.0, c.fraction);
    const std::vector<std::int64_t> all = exact::raws(8 * sizeof(Raw), 50);
    for (std::size_t i = 0; i<all.size(); i += all.size()> 3000 ? 37 : 1) {
        const Raw raw = static_cast<Raw>(all[i]);
        char text[100] = "?";
        const std::size_t length = c.print(raw, text, c.capacity);
        ASSERT_EQ(length, std::string(text).size()) << raw;
        ASSERT_GT(length, 0u);
        // Only values that a double represents exactly can be compared.
        if (sizeof(Raw) < 8) {
            ASSERT_EQ(std::floor(std::strtod(text, nullptr) * unit + 0.5), raw) << text;
            ASSERT_EQ(c.to_double(raw), raw / unit);
            ASSERT_EQ(c.from_double(raw / unit), raw);
        }
        Raw read = 0;
        ASSERT_EQ(c.parse(text, &read), FIXEDPOINT_TEXT_OK) << text;
        ASSERT_EQ(read, raw) << text;
        char small[100] = "??";
        ASSERT_EQ(c.print(raw, small, length), 0u) << "there is no room for the zero";
        ASSERT_EQ(small[0], '\0');
        ASSERT_EQ(c.print(raw, small, length + 1), length);
    }
    char text[100] = "?";
    EXPECT_EQ(c.print(0, text, 0), 0u);
    EXPECT_EQ(text[0], '?') << "nothing may be written into no bytes";
    const Raw one_and_a_half = static_cast<Raw>(3 * (std::int64_t(1) << (c.fraction - 1)));
    EXPECT_EQ(c.print_decimals(one_and_a_half, 0, text, sizeof text), 1u);
    EXPECT_STREQ(text, "2");
    EXPECT_EQ(c.print_decimals(static_cast<Raw>(-one_and_a_half), 3, text, sizeof text), 6u);
    EXPECT_STREQ(text, "-1.500");
    EXPECT_EQ(c.print_decimals(one_and_a_half, 255, text, sizeof text), 2u + c.fraction);

    constexpr Raw max = std::numeric_limits<Raw>::max(), min = std::numeric_limits<Raw>::min();
    const struct {
        const char* text;
        fixedpoint_text_status status;
        Raw number;
    } cases[] = {{"1.5", FIXEDPOINT_TEXT_OK, one_and_a_half},
                 {"15e-1", FIXEDPOINT_TEXT_OK, one_and_a_half},
                 {"", FIXEDPOINT_TEXT_EMPTY, 0},
                 {"1.5x", FIXEDPOINT_TEXT_MALFORMED, 0},
                 {"-", FIXEDPOINT_TEXT_MALFORMED, 0},
                 {"1e30", FIXEDPOINT_TEXT_OUT_OF_RANGE, max},
                 {"-1e30", FIXEDPOINT_TEXT_OUT_OF_RANGE, min}};
    for (const auto& expected : cases) {
        Raw number = 77;
        EXPECT_EQ(c.parse(expected.text, &number), expected.status) << expected.text;
        EXPECT_EQ(number, expected.number) << expected.text;
    }
    EXPECT_EQ(c.third, static_cast<Raw>(std::floor(-unit / 3 + 0.5)));
    EXPECT_EQ(c.from_double(std::nan("")), 0);
    EXPECT_EQ(c.from_double(1e300), max);
    EXPECT_EQ(c.from_double(-INFINITY), min);
}

#define TEXT(q, Q, integer, fraction)                                                         \
    check_text<q>({#q, fraction, Q##_TEXT_CAPACITY, q##_parse, q##_print, q##_print_decimals, \
                   q##_to_double, q##_from_double, Q##_RATIO(-1, 3)});                        \
    static_assert(Q##_ONE == Q##_RATIO(7, 7));                                                \
    static_assert(Q##_MIN == std::numeric_limits<q>::min());                                  \
    static_assert(Q##_MAX == std::numeric_limits<q>::max());

TEST(C, TextIsExact){FIXEDPOINT_C_FORMATS(TEXT)}

TEST(C, ConstantsAreRoundedHalfUp) {
    static_assert(Q16_16_RATIO(38, 100) == 24904);  // 24903.68
    static_assert(Q4_4_RATIO(1, 32) == 1 && Q4_4_RATIO(-1, 32) == 0);
    static_assert(Q4_4_RATIO(-3, 32) == -1 && Q4_4_RATIO(3, 32) == 2);
    static_assert(Q32_32_RATIO(-(1 << 29), 1) == -(1ll << 61));
}

}  // namespace
