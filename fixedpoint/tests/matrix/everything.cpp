// SPDX-License-Identifier: MIT
// Everything that the library offers, in every format of the tables and in every arithmetic, so
// that a compiler reports any warning about a header here. Compiled, but not run.
#include <fixedpoint.h>
#include <fixedpoint/c_functions.h>

#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/correctly_rounded.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/rounded.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/blocks/biquad.hpp>
#include <fixedpoint/blocks/complex.hpp>
#include <fixedpoint/blocks/interpolation.hpp>
#include <fixedpoint/blocks/matrix.hpp>
#include <fixedpoint/blocks/moving_average.hpp>
#include <fixedpoint/blocks/one_pole.hpp>
#include <fixedpoint/blocks/pid.hpp>
#include <fixedpoint/blocks/polynomial.hpp>
#include <fixedpoint/blocks/quaternion.hpp>

#ifdef HOST_HEADERS
#include <fixedpoint/host/hash.hpp>
#include <fixedpoint/host/limits.hpp>
#include <fixedpoint/host/stream.hpp>
#include <fixedpoint/host/text.hpp>
#endif
#ifdef FORMAT_HEADER
#include <fixedpoint/host/format.hpp>
#endif

using namespace fixedpoint;
using namespace fixedpoint::literals;

// Literals are constants in every standard.
static_assert((0.38_q16_16).raw() == 24904, "0.38 2^16 = 24903.68");
static_assert((7.9375_q4_4).raw() == 127, "the largest number");
static_assert((1e-3_q8_8).raw() == 0, "an exponent");
static_assert((-0.38_q8_16).raw() == -24904 && (0.38_q12_12).raw() == 1556, "of 24 bits");
static_assert((3.14159265358979323846_q32_32).raw() == 13493037705, "pi 2^32 = 13493037704.52");
static_assert((1 - 0.5_q16_16 * 3).raw() == -32768 && 1_q16_16 < 2 && 2u > 1_q16_16, "integers");
static_assert(fixed<16, 16>(-0.38).raw() == -24904, "a checked constant");
static_assert(constants::pi<Q16_16>().raw() == 205887, "pi 2^16 = 205887.42");
#if __cplusplus >= 201402L
// So are results computed from them, from C++14 on.
static_assert((2.5_q16_16 * 0.5_q16_16).raw() == 81920, "a product");
static_assert((1_q16_16 / 3_q16_16).raw() == 21845, "a quotient");
static_assert(sqrt(2_q16_16).raw() == 92682, "a root");
#endif

namespace {

struct Hook {
    static void notify(Event, Operation) {}
};

struct Serial {
    size_t write(const char*, size_t length) { return length; }
    int peek() { return -1; }
    int read() { return -1; }
};

template <class Number>
void ring(Number& a, Number b) {
    a = a + b - a * b / (-b) % +a;
    a += b;
    a -= b;
    a *= b;
    a /= b;
    a %= b;
    a <<= 1;
    a >>= 1;
    a = a << 2 >> 3;
    if (a == b || a != b || a < b || a > b || a <= b || a >= b) a = Number::ulp();
    a = clamp(max(min(abs(a), b), b), Number::min(), Number::max());
    a = floor(ceil(round(trunc(a))));
    a = scale_down<3>(a) + sqrt(a);
}

template <class Number, class Int>
void beside_integer(Number& a, Int n) {
    a = (n - a) * n + n * (a + n) - (n + a - n) / n;
    a += n;
    a -= n;
    a *= n;
    a /= n;
    if (a == n || a != n || a < n || a > n || a <= n || a >= n) a = Number();
    if (n == a || n != a || n < a || n > a || n <= a || n >= a) a = Number();
}

template <class Number>
void beside_integers(Number& a) {
    beside_integer(a, static_cast<int8_t>(1));
    beside_integer(a, static_cast<uint8_t>(1));
    beside_integer(a, 1);
    beside_integer(a, 1u);
    beside_integer(a, 1L);
    beside_integer(a, 1ull);
}

template <int I, int F, class A>
void widening(Fixed<I, F, A>& a) {
    a = narrow<Fixed<I, F, A>>(widening_multiply(a, a)) +
        narrow<Fixed<I, F, A>>(widening_add(a, a));
    a += constants::ln2<Fixed<I, F, A>>() + fixed<I, F, A>(0.5) + fixed<I, F, A>(0);
}
template <class Number>
void angles(Number& a) {
    Turn<16> coarse = Turn<16>::from_turns(a);
    Turn<32> fine = Turn<32>::from_turns(a);
    coarse += -coarse * 2 - coarse + 3u * coarse;
    fine -= fine;
    if (coarse == Turn<16>() || fine != Turn<32>::from_raw(coarse.raw())) a = fine.turns<Number>();
    a += sin<Number>(coarse) + cos<Number>(fine) + sincos<Number>(fine).sine;
}

// The functions of C, which are all of C++ beside hypot and the operators.
#define CALL(name, shape, ...) CALL_##shape(name)
#define CALL_operator(name)
#define CALL_negation(name)
#define CALL_shift(name)
#define CALL_unary(name) a[0] += name(a[1]);
#define CALL_binary(name) a[0] += name(a[0], a[1]);
#define CALL_ternary(name) a[0] += name(a[0], a[1], a[2]);
#define CALL_power(name) a[0] += name(a[0], 3) + name(a[1], -2ll);
#define CALL_sign(name) a[0] = a[1] * name(a[0]);
#define CALL_integer(name) a[0] = a[1] * name(a[0].raw());
#define CALL_pair(name) a[0] += name(a[1]).sine + name(a[0]).cosine;
#define CALL_direct_pair CALL_pair
#define CALL_binary_pair(name) a[0] = name(a[0], a[1]).remainder;
#define CALL_dot(name) a[0] += name(a, a);
#define CALL_length(name) a[0] += name(a);
#define CALL_direction(name) name(a, a);
template <class Number>
void functions(Number* a) {
    FIXEDPOINT_C_FUNCTIONS(CALL, )
    a[0] += hypot(a[0], a[1]) + hypot(a[0], a[1], a[2]);
}

template <class Number>
void conversions(Number& a) {
    a = convert<Number>(convert<int16_t>(a));
    a = convert<Number>(convert<Q4_4>(a)) + convert<Number>(convert<Q32_32>(a));
    a += convert_checked<Number>(convert_checked<Q16_16>(a).number).number;
    a += from_float<Number>(to_float<float>(a));
    a += from_float_checked<Number>(to_float<double>(a)).number;
    a += from_decimal<Number>(38, 2) + from_decimal_checked<Number>(1, 2).number +
         Number::from_integer(1);
    Serial serial;
    if (print(serial, a) < print(serial, a, 3)) a = read<Number>(serial).number;
    char text[text_capacity<Number>()];
    a += parse<Number>(text, print(a, text, sizeof text) + print(a, 3, text, sizeof text)).number;
    a += parse_raw<Number>(text,
                           print_raw(a, text, sizeof text) + print(a, Layout(9), text, sizeof text))
             .number;
    const auto end = to_chars(to_chars(text, text + 4, a).ptr, text + 9, a, 2).ptr;
    if (from_chars(text, end, a).ec == TextError::invalid_argument) a = Number();
}

template <class Number, uint8_t N>
void matrices(Number (&v)[N]) {
    Matrix<Number, N> a = {};
    for (uint8_t i = 0; i < N; ++i) a.element[i][i] = v[i];
    Number image[N] = {};
    if (invert(a * adjugate(a), a)) multiply(a, v, image);
    v[0] = image[0] + determinant(a);
}

template <class Number, class Coefficient>
void blocks() {
    static const Table<Number, 3> values FIXEDPOINT_PROGRAM_MEMORY = {{}};
    static const Table<Coefficient, 3> coefficients FIXEDPOINT_PROGRAM_MEMORY = {{}};
    Number a[3] = {};
    Pid<Number> pid({a[0], a[0], a[0]}, a[0], a[0]);
    Biquad<Number> biquad({a[0], a[0], a[0], a[0], a[0]});
    OnePole<Number> one_pole(a[0], a[1]);
    MovingAverage<Number, 256> average(a[0]);
    a[0] = biquad.update(one_pole.update(average.update(pid.update(a[0], one_pole.output()))));
    a[0] = polynomial(interpolate<0>(values, a[0], a[1]), coefficients);
    a[0] = interpolate<-2>(values, a[0], interpolate<1>(values, a[0], a[1]));
    const Complex<Number> z = {{a[0], a[1]}}, product = z * conjugate(z) + z - z;
    a[0] = product.real() + product.imaginary() + squared_magnitude(z);
    Number plane[2] = {a[0], a[1]};
    matrices(plane);
    matrices(a);
    const Quaternion<Number> q = {{a[0], a[1], a[2], plane[0]}};
    rotate(renormalised(q * conjugate(q)), a, a);
}

template <class Number>
void without_sign(Number (&a)[3]) {
    ring(a[0], a[1]);
    beside_integers(a[0]);
    conversions(a[0]);
    a[0] = lerp(a[0], midpoint(a[0], a[1]), abs_diff(a[0], a[1]));
    a[0] = multiply_add(divmod(a[0], a[1]).remainder, divrem(a[0], a[1]).remainder, a[1]);
    a[0] += Number::from_raw(Number::max().raw() / 2);
}
template <int I, int F>
void every_unsigned_arithmetic() {
    UFixed<I, F> nearest[3];
    without_sign(nearest);
    nearest[0] += ufixed<I, F>(0.5);
    UFixed<I, F, Saturating> saturating[3];
    without_sign(saturating);
    UFixed<I, F, Checked<Hook>> checked[3];
    without_sign(checked);
}

template <int I, int F>
void every_arithmetic() {
    Fixed<I, F> nearest[3];
    ring(nearest[0], nearest[1]);
    beside_integers(nearest[0]);
    functions(nearest);
    angles(nearest[0]);
    conversions(nearest[0]);
    Fixed<I, F, Small> small[3];
    ring(small[0], small[1]);
    functions(small);
    Fixed<I, F, Saturating> saturating[3];
    ring(saturating[0], saturating[1]);
    beside_integers(saturating[0]);
    functions(saturating);
    angles(saturating[0]);
    conversions(saturating[0]);
    Fixed<I, F, HalfToEven> rounded[3];
    ring(rounded[0], rounded[1]);
    rounded[0] += atan2(rounded[0], rounded[1]);
    beside_integers(rounded[0]);
    conversions(rounded[0]);
    Fixed<I, F, Checked<Hook>> checked[3];
    ring(checked[0], checked[1]);
    beside_integers(checked[0]);
    functions(checked);
}

}  // namespace

void everything();
void everything() {
    every_arithmetic<4, 4>();
    every_arithmetic<8, 8>();
    every_arithmetic<8, 16>();
    every_arithmetic<16, 16>();
    every_unsigned_arithmetic<8, 8>();
    every_unsigned_arithmetic<16, 16>();
    blocks<Q8_8, Q16_16>();
    blocks<Fixed<16, 16, Saturating>, Fixed<8, 24, Saturating>>();
    blocks<float, float>();
#ifndef FEW_FORMATS
    every_arithmetic<12, 12>();
    every_arithmetic<32, 32>();
    every_arithmetic<8, 24>();
    every_arithmetic<1, 15>();
    every_unsigned_arithmetic<4, 4>();
    every_unsigned_arithmetic<0, 16>();
    every_unsigned_arithmetic<0, 32>();
    every_unsigned_arithmetic<32, 32>();
    Fixed<8, 16, CorrectlyRounded> of_24_bits[3];
    functions(of_24_bits);
    blocks<Q4_4, Q8_8>();
    blocks<Q16_16, Fixed<8, 24>>();
    blocks<Fixed<8, 24>, Fixed<8, 24>>();
    blocks<Q32_32, Q32_32>();
    blocks<Fixed<16, 16, Checked<Hook>>, Fixed<16, 16, Checked<Hook>>>();
    blocks<Fixed<8, 8, Small>, Fixed<16, 16, Small>>();
#endif
    Fixed<16, 16, CorrectlyRounded> correctly_rounded[3];
    functions(correctly_rounded);
    // Products of wider numbers do not compile.
    Q4_4 a;
    Fixed<1, 15, Saturating> b;
    Fixed<16, 16, Checked<Hook>> c;
    widening(a);
    widening(b);
    widening(c);
    U8_8 d = 0.5_u8_8;
    widening(d);
    Q12_12 e;
    widening(e);
    Fixed<16, 16, Published> published = Fixed<16, 16, Published>::from_integer(3);
    published = published * published / sqrt(published) + atan2(published, published);
}

int main() { everything(); }
