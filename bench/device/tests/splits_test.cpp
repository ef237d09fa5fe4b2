// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of every split of 16, 24 and 32 bits, and of some of 64, on the simulated chip,
// compared bit for bit with the portable code: the split is their parameter, and only some splits
// are in programs of the bench. Includes operands whose rounding is decided narrowly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/atan.hpp>
#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/dot.hpp>
#include <fixedpoint/portable/exp.hpp>
#include <fixedpoint/portable/length.hpp>
#include <fixedpoint/portable/log.hpp>
#include <fixedpoint/portable/multiply_add.hpp>
#include <fixedpoint/portable/multiply_saturating.hpp>
#include <fixedpoint/portable/normalise.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>
#include <fixedpoint/portable/sin.hpp>
#include <fixedpoint/portable/sqrt.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/device/tests/program_folder.hpp"
#include "fixedpoint/tests/exact.hpp"
#include "this_build.hpp"

namespace {

namespace portable = fixedpoint::portable;
using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Signature;
using Vector = std::array<int32_t, 3>;

constexpr int pairs = 10000;

class Operands {
  public:
    int32_t next() { return static_cast<int32_t>(numbers_[random_() % numbers_.size()]); }
    Vector vector() { return {next(), next(), next()}; }

  private:
    std::vector<std::int64_t> numbers_ = exact::raws(32);
    std::mt19937_64 random_{32};
};

// A program of one operation, and its subject of each split.
class Program {
  public:
    explicit Program(const std::string& operation, int bits = 32, const char* arithmetic = "")
        : operation_(operation),
          bits_(bits),
          chip_(simulator::Elf(fmt::format("{}/splits_{}_{}{}.elf", program_folder(), bits,
                                           operation, arithmetic))) {
        chip_.run_until_function("main");
        for (std::uint16_t& address : vectors_) address = chip_.allocate(3 * sizeof(int64_t));
    }
    DeviceFunction subject(int fraction_bits, const Signature& signature) {
        return {chip_,
                fmt::format("{}_q{}_{}_default", operation_, bits_ - fraction_bits, fraction_bits),
                signature};
    }
    template <class Element>
    std::uint16_t put(int index, const std::array<Element, 3>& v) {
        chip_.write(vectors_[index], {reinterpret_cast<const std::uint8_t*>(v.data()), sizeof v});
        return vectors_[index];
    }
    template <class Element = int32_t>
    std::array<Element, 3> get(int index) const {
        std::array<Element, 3> v;
        chip_.read(vectors_[index], {reinterpret_cast<std::uint8_t*>(v.data()), sizeof v});
        return v;
    }

  private:
    std::string operation_;
    int bits_;
    Chip chip_;
    std::array<std::uint16_t, 2> vectors_;
};

// check(F) for every split but Q16.16.
template <class Check, int... F>
void for_each_split(Check check, std::integer_sequence<int, F...>) {
    (..., (F == 16 ? void() : check(std::integral_constant<int, F>())));
}
template <class Check>
void for_each_split(Check check) {
    for_each_split(check, std::make_integer_sequence<int, 33>());
}

// The quotients and roots of random numbers are far from where rounding is decided. These are the
// operands on either side: of the divisor b and the root r, those for which a 2^F / b is about q +
// 1/2, and a 2^F about (r + 1/2)^2.
TEST(Splits, DivideBesideHalves) {
    Program program("divide");
    const auto check_split = [&](int F, int32_t (*portable_divide)(int32_t, int32_t)) {
        DeviceFunction divide = program.subject(F, {4, {4, 4}});
        std::mt19937_64 random(1);
        for (int i = 0; i < pairs; ++i) {
            const int64_t b = static_cast<int64_t>(random() >> 33 >> random() % 31);
            const int64_t q = static_cast<int64_t>(random() >> 33 >> random() % 31);
            const int64_t half = static_cast<int64_t>((__int128(2 * q + 1) * b / 2) >> F);
            for (int64_t a = half; a <= half + 1; ++a) {
                if (a > fixedpoint::RawLimits<int32_t>::max) continue;
                for (const int32_t sign : {1, -1}) {
                    const int32_t n = static_cast<int32_t>(a) * sign, d = static_cast<int32_t>(b);
                    ASSERT_EQ(divide(n, d).as<int32_t>(), portable_divide(n, d))
                        << F << " fraction bits: " << n << " " << d;
                }
            }
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::divide<int32_t, F>); });
}
TEST(Splits, SqrtBesideHalves) {
    Program program("sqrt");
    const auto check_split = [&](int F, int32_t (*portable_sqrt)(int32_t)) {
        DeviceFunction sqrt = program.subject(F, {4, {4}});
        std::mt19937_64 random(2);
        for (int i = 0; i < pairs; ++i) {
            const uint64_t r = random() >> 33 >> random() % 31, half = (r * r + r) >> F;
            for (uint64_t a = half; a <= half + 1; ++a) {
                if (a > static_cast<uint64_t>(fixedpoint::RawLimits<int32_t>::max)) continue;
                const auto n = static_cast<int32_t>(a);
                ASSERT_EQ(sqrt(n).as<int32_t>(), portable_sqrt(n)) << F << " fraction bits: " << a;
            }
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::sqrt<int32_t, F>); });
}

// r^2 + r, the largest sum of squares below (r + 1/2)^2, belongs to (m^2, m, 0), and r^2 + r + 1,
// the next, to (m^2 - 1, m, 0).
TEST(LengthQ32_32, RoundsBesideHalves) {
    Chip chip(simulator::Elf(build_folder() / "bench/device/q32_32.elf"));
    chip.run_until_function("main");
    const std::uint16_t address = chip.allocate(3 * sizeof(int64_t));
    DeviceFunction length(chip, "length3_q32_32_default", {8, {2}});
    std::mt19937_64 random(3);
    for (int i = 0; i < pairs; ++i) {
        const int64_t m = static_cast<int64_t>(2 + (random() % 3037000000u >> random() % 31));
        for (const int64_t below : {0, 1}) {
            const int64_t v[3] = {m * m - below, below ? -m : m, 0};
            chip.write(address, {reinterpret_cast<const std::uint8_t*>(v), sizeof v});
            ASSERT_EQ(length(address).as<int64_t>(), m * m) << m << " " << below;
        }
    }
}

// Of 16 bits, every split but Q8.8, with all operands. Functions of one operand ignore the second.
using ShortFunction = int16_t (*)(int16_t a, int16_t b);
void expect_short_pairs(DeviceFunction function, int operands, int F, ShortFunction expected) {
    const std::vector<int16_t> edges = {0, 1, -1, 2, 255, 256, -256, 32767, -32767, -32768};
    std::mt19937 random(16);
    const auto next = [&] {
        return random() % 4 == 0
                   ? edges[random() % edges.size()]
                   : static_cast<int16_t>(static_cast<int16_t>(random()) >> random() % 16);
    };
    for (int i = 0; i < pairs; ++i) {
        const int16_t a = next(), b = next();
        const std::uint64_t values[] = {static_cast<uint16_t>(a), static_cast<uint16_t>(b)};
        ASSERT_EQ(function.call(std::span(values, operands)).as<int16_t>(), expected(a, b))
            << F << " fraction bits: " << a << " " << b;
    }
}
template <class Check>
void for_each_short_split(Check check) {
    [&]<int... F>(std::integer_sequence<int, F...>) {
        (..., (F == 8 ? void() : check(std::integral_constant<int, F>())));
    }
    (std::make_integer_sequence<int, 17>());
}

TEST(ShortSplits, Multiply) {
    Program program("multiply", 16);
    for_each_short_split([&](auto F) {
        expect_short_pairs(program.subject(F, {2, {2, 2}}), 2, F, portable::multiply<int16_t, F>);
    });
}
TEST(ShortSplits, Divide) {
    Program program("divide", 16);
    for_each_short_split([&](auto F) {
        expect_short_pairs(program.subject(F, {2, {2, 2}}), 2, F, portable::divide<int16_t, F>);
    });
}
TEST(ShortSplits, Sqrt) {
    Program program("sqrt", 16);
    for_each_short_split([&](auto F) {
        expect_short_pairs(program.subject(F, {2, {2}}), 1, F, [](int16_t a, int16_t) {
            return portable::sqrt<int16_t, decltype(F)::value>(a);
        });
    });
}

// Of 24 bits, every split, compared with exact arithmetic: the portable code has no other kernels.
using Numbers = std::array<fixedpoint::Int24, 3>;
template <class Expected>
void expect_of_24_bits(const char* operation, const Signature& signature, Expected expected,
                       const char* arithmetic = "") {
    Program program(operation, 24, arithmetic);
    const bool in_memory = signature.operands[0] == simulator::pointer_size;
    std::vector<std::int64_t> numbers = exact::raws(24);
    std::mt19937_64 random(24);
    for (int F = 0; F < 24; ++F) {
        DeviceFunction function = program.subject(F, signature);
        for (int i = 0; i < pairs / 2; ++i) {
            int64_t v[6];
            for (int64_t& n : v)
                n = numbers[random() % numbers.size()] >> (i & 1 ? random() % 24 : 0);
            const Numbers a = {v[0], v[1], v[2]}, b = {v[3], v[4], v[5]};
            std::uint64_t values[3];
            for (int k = 0; k < 3; ++k)
                values[k] = in_memory ? (k == 0 ? program.put(0, a) : program.put(1, b))
                                      : static_cast<std::uint64_t>(v[k]);
            const auto result = static_cast<fixedpoint::Int24>(
                function.call({values, signature.operands.size()}).result);
            ASSERT_EQ(result, expected(v, exact::Format{24, F}))
                << F << " fraction bits: " << testing::PrintToString(v);
        }
    }
}
TEST(SplitsOf24Bits, Multiply) {
    expect_of_24_bits("multiply", {3, {3, 3}}, [](const int64_t* v, exact::Format format) {
        return exact::multiply_add(v[0], v[1], 0, format).wrapped;
    });
}
TEST(SplitsOf24Bits, MultiplyAdd) {
    expect_of_24_bits("multiply_add", {3, {3, 3, 3}}, [](const int64_t* v, exact::Format format) {
        return exact::multiply_add(v[0], v[1], v[2], format).wrapped;
    });
}
TEST(SplitsOf24Bits, MultiplySaturating) {
    expect_of_24_bits(
        "multiply", {3, {3, 3}},
        [](const int64_t* v, exact::Format format) {
            return exact::multiply_add(v[0], v[1], 0, format).saturated;
        },
        "_saturating");
}
TEST(SplitsOf24Bits, Dot2) {
    expect_of_24_bits("dot2", {3, {2, 2}}, [](const int64_t* v, exact::Format format) {
        return exact::dot(v, v + 3, 2, format).wrapped;
    });
}
TEST(SplitsOf24Bits, Dot3) {
    expect_of_24_bits("dot3", {3, {2, 2}}, [](const int64_t* v, exact::Format format) {
        return exact::dot(v, v + 3, 3, format).wrapped;
    });
}

TEST(Splits, Multiply) {
    Program program("multiply");
    const auto check_split = [&](int F, int32_t (*portable_multiply)(int32_t, int32_t)) {
        DeviceFunction multiply = program.subject(F, {4, {4, 4}});
        Operands operands;
        for (int i = 0; i < pairs; ++i) {
            const int32_t a = operands.next(), b = operands.next();
            ASSERT_EQ(multiply(a, b).as<int32_t>(), portable_multiply(a, b))
                << F << " fraction bits: " << a << " " << b;
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::multiply<int32_t, F>); });
}

// Of all lengths, since a product of boundary numbers mostly saturates.
TEST(Splits, MultiplySaturating) {
    Program program("multiply", 32, "_saturating");
    const auto check_split = [&](int F, int32_t (*portable_multiply_saturating)(int32_t, int32_t)) {
        DeviceFunction multiply = program.subject(F, {4, {4, 4}});
        Operands operands;
        for (int i = 0; i < pairs; ++i) {
            const int32_t a = operands.next(), b = operands.next() >> (i % 32);
            ASSERT_EQ(multiply(a, b).as<int32_t>(), portable_multiply_saturating(a, b))
                << F << " fraction bits: " << a << " " << b;
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::multiply_saturating<int32_t, F>); });
}

TEST(Splits, MultiplyAdd) {
    Program program("multiply_add");
    const auto check_split = [&](int F,
                                 int32_t (*portable_multiply_add)(int32_t, int32_t, int32_t)) {
        DeviceFunction multiply_add = program.subject(F, {4, {4, 4, 4}});
        Operands operands;
        for (int i = 0; i < pairs; ++i) {
            const auto [a, b, c] = operands.vector();
            ASSERT_EQ(multiply_add(a, b, c).as<int32_t>(), portable_multiply_add(a, b, c))
                << F << " fraction bits: " << a << " " << b << " " << c;
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::multiply_add<int32_t, F>); });
}

TEST(Splits, Divide) {
    Program program("divide");
    const auto check_split = [&](int F, int32_t (*portable_divide)(int32_t, int32_t)) {
        DeviceFunction divide = program.subject(F, {4, {4, 4}});
        Operands operands;
        for (int i = 0; i < pairs; ++i) {
            const int32_t a = operands.next(), b = operands.next();
            ASSERT_EQ(divide(a, b).as<int32_t>(), portable_divide(a, b))
                << F << " fraction bits: " << a << " " << b;
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::divide<int32_t, F>); });
}

TEST(Splits, Sqrt) {
    Program program("sqrt");
    const auto check_split = [&](int F, int32_t (*portable_sqrt)(int32_t)) {
        DeviceFunction sqrt = program.subject(F, {4, {4}});
        Operands operands;
        for (int i = 0; i < pairs; ++i) {
            const int32_t a = operands.next();
            ASSERT_EQ(sqrt(a).as<int32_t>(), portable_sqrt(a)) << F << " fraction bits: " << a;
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::sqrt<int32_t, F>); });
}

template <class Expected>
void expect_dots(Program& program, int fraction_bits, Expected expected) {
    DeviceFunction dot = program.subject(fraction_bits, {4, {2, 2}});
    Operands operands;
    for (int i = 0; i < pairs; ++i) {
        const Vector a = operands.vector(), b = operands.vector();
        ASSERT_EQ(dot(program.put(0, a), program.put(1, b)).template as<int32_t>(),
                  expected(a.data(), b.data()))
            << fraction_bits << " fraction bits: " << testing::PrintToString(a) << " "
            << testing::PrintToString(b);
    }
}

TEST(Splits, Dot2) {
    Program program("dot2");
    for_each_split([&](auto F) { expect_dots(program, F, portable::dot2<int32_t, F>); });
}
TEST(Splits, Dot3) {
    Program program("dot3");
    for_each_split([&](auto F) { expect_dots(program, F, portable::dot3<int32_t, F>); });
}

TEST(Splits, Length3) {
    Program program("length3");
    const auto check_split = [&](int F, int32_t (*portable_length3)(const int32_t*)) {
        DeviceFunction length = program.subject(F, {4, {2}});
        Operands operands;
        for (int i = 0; i < pairs / 8; ++i) {
            const Vector v = operands.vector();
            ASSERT_EQ(length(program.put(0, v)).as<int32_t>(), portable_length3(v.data()))
                << F << " fraction bits: " << testing::PrintToString(v);
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::length3<int32_t, F>); });
}

// A function of one number. `limits` are the ends of the intervals of its tables.
template <class Expected>
void expect_function(Program& program, int fraction_bits, Expected expected,
                     const std::vector<int32_t>& limits) {
    DeviceFunction function = program.subject(fraction_bits, {4, {4}});
    const auto check = [&](int32_t a) {
        ASSERT_EQ(function(a).template as<int32_t>(), expected(a))
            << fraction_bits << " fraction bits: " << a;
    };
    for (const int32_t limit : limits) {
        for (int32_t offset = -1; offset <= 1; ++offset) check(limit + offset);
    }
    Operands operands;
    std::mt19937 random(7);
    for (int i = 0; i < pairs / 4; ++i) {
        check(operands.next());
        check(static_cast<int32_t>(random()));
    }
}

// Angles at multiples of 1/512 of a quarter turn.
std::vector<int32_t> limits_of_angles(int fraction_bits) {
    std::vector<int32_t> limits;
    for (int i = -1500; i <= 1500; ++i) {
        const double angle = std::ldexp(i * M_PI_4 / 256, fraction_bits);
        if (std::abs(angle) < 0x7ffffff0p0) limits.push_back(static_cast<int32_t>(angle));
    }
    return limits;
}

// Operands of one size, a shorter one among them, and vectors along an axis, whose reciprocal root
// is the largest. In place.
TEST(Splits, Normalise3) {
    Program program("normalise3");
    const auto check_split = [&](int F, void (*portable_normalise3)(const int32_t*, int32_t*)) {
        DeviceFunction normalise = program.subject(F, {0, {2, 2}});
        Operands operands;
        std::mt19937_64 random(3);
        for (int i = 0; i < pairs / 4; ++i) {
            Vector v = operands.vector();
            if (i % 2 != 0) {
                const int shift = static_cast<int>(random() % 31);
                for (int32_t& a : v) a = static_cast<int32_t>(random()) >> shift;
                v[random() % 3] >>= random() % 32;
            }
            if (i % 16 == 0) v = {0, i % 32 == 0 ? 1 << (random() % 31) : v[1], 0};
            Vector expected;
            portable_normalise3(v.data(), expected.data());
            const std::uint16_t address = program.put(0, v);
            normalise(address, address);
            ASSERT_EQ(program.get(0), expected)
                << F << " fraction bits: " << testing::PrintToString(v);
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::normalise3<int32_t, F>); });
}

TEST(Splits, Sin) {
    Program program("sin");
    for_each_split([&](auto F) {
        expect_function(program, F, portable::sin<int32_t, F>, limits_of_angles(F));
    });
}
TEST(Splits, Cos) {
    Program program("cos");
    for_each_split([&](auto F) {
        expect_function(program, F, portable::cos<int32_t, F>, limits_of_angles(F));
    });
}
TEST(Splits, Sincos) {
    Program program("sincos");
    const auto check_split = [&](int F, void (*portable_sincos)(int32_t, int32_t*)) {
        DeviceFunction sincos = program.subject(F, {0, {4, 2}});
        Operands operands;
        for (int i = 0; i < pairs / 10; ++i) {
            const int32_t a = operands.next();
            int32_t expected[2];
            portable_sincos(a, expected);
            const std::uint16_t address = program.put(0, Vector{});
            sincos(a, address);
            const Vector pair = program.get(0);
            ASSERT_EQ(pair[0], expected[0]) << F << " fraction bits: " << a;
            ASSERT_EQ(pair[1], expected[1]) << F << " fraction bits: " << a;
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::sincos<int32_t, F>); });
}

// The numbers at which the upper nine bits change.
std::vector<int32_t> limits_of_mantissas() {
    std::vector<int32_t> limits;
    for (int exponent = 0; exponent < 31; ++exponent) {
        for (int64_t leading = 256; leading < 512;
             leading += exponent < 8 ? 1 << (8 - exponent) : 1)
            limits.push_back(static_cast<int32_t>((leading << exponent) >> 8));
    }
    return limits;
}

TEST(Splits, Log) {
    Program program("log");
    for_each_split([&](auto F) {
        expect_function(program, F, portable::log<int32_t, F>, limits_of_mantissas());
    });
}

// Where the number of factors of 2 that are split off changes or nearly does, everything that
// saturates, and operands over the rest.
std::vector<int32_t> limits_of_exponents(int fraction_bits) {
    std::vector<int32_t> limits;
    const auto add = [&](double x) {
        const double a = std::ldexp(x, fraction_bits);
        if (std::abs(a) < 0x7ffffff0p0) limits.push_back(static_cast<int32_t>(a));
    };
    for (int k = -36; k <= 34; ++k) {
        for (int i = -20; i <= 20; ++i) add((k + i / 256.0) * M_LN2);
    }
    std::mt19937 random(9);
    std::uniform_real_distribution<double> representable(-(fraction_bits + 3) * M_LN2,
                                                         (32 - fraction_bits) * M_LN2);
    for (int i = 0; i < pairs / 2; ++i) add(representable(random));
    return limits;
}

TEST(Splits, Exp) {
    Program program("exp");
    for_each_split([&](auto F) {
        expect_function(program, F, portable::exp<int32_t, F>, limits_of_exponents(F));
    });
}

TEST(Splits, ReciprocalSqrt) {
    Program program("reciprocal_sqrt");
    for_each_split([&](auto F) {
        expect_function(program, F, portable::reciprocal_sqrt<int32_t, F>, limits_of_mantissas());
    });
}

TEST(Splits, Atan) {
    Program program("atan");
    for_each_split([&](auto F) {
        expect_function(program, F, portable::atan<int32_t, F>, limits_of_mantissas());
    });
}
// Ratios on both sides of every 1/256, of longer coordinates of every length, in every octant.
TEST(Splits, Atan2) {
    Program program("atan2");
    const auto check_split = [&](int F, int32_t (*portable_atan2)(int32_t, int32_t)) {
        DeviceFunction atan2 = program.subject(F, {4, {4, 4}});
        const auto check = [&](int32_t y, int32_t x) {
            ASSERT_EQ(atan2(y, x).as<int32_t>(), portable_atan2(y, x))
                << F << " fraction bits: " << y << " " << x;
        };
        Operands operands;
        std::mt19937 random(11);
        for (int i = 0; i < pairs / 4; ++i) {
            check(operands.next(), operands.next());
            const auto longer = static_cast<int32_t>(random() >> 1 >> random() % 31);
            const auto shorter = static_cast<int32_t>(int64_t(longer) * (random() % 257) / 256 +
                                                      static_cast<int32_t>(random() % 3) - 1);
            const int32_t a = i & 1 ? -longer : longer, b = i & 2 ? -shorter : shorter;
            check(i & 4 ? a : b, i & 4 ? b : a);
        }
    };
    for_each_split([&](auto F) { check_split(F, portable::atan2<int32_t, F>); });
}

// The splits of 64 bits in splits.cpp.
template <class Check>
void for_each_long_split(Check check) {
    [&]<int... F>(std::integer_sequence<int, F...>) {
        (..., check(std::integral_constant<int, F>()));
    }
    (std::integer_sequence<int, 0, 1, 7, 8, 16, 24, 29, 31, 33, 40, 48, 56, 62, 63>());
}

// Random numbers of every length, and those of the boundary table.
class LongOperands {
  public:
    int64_t next() {
        if (random_() % 3 == 0) return numbers_[random_() % numbers_.size()];
        return static_cast<int64_t>(random_()) >> random_() % 64;
    }
    uint64_t magnitude() { return random_() >> 1 >> random_() % 63; }
    std::array<int64_t, 3> vector() { return {next(), next(), next()}; }

  private:
    std::vector<std::int64_t> numbers_ = exact::raws(64);
    std::mt19937_64 random_{64};
};

TEST(LongSplits, Multiply) {
    Program program("multiply", 64);
    const auto check_split = [&](int F, int64_t (*portable_multiply)(int64_t, int64_t)) {
        DeviceFunction multiply = program.subject(F, {8, {8, 8}});
        LongOperands operands;
        for (int i = 0; i < pairs; ++i) {
            const int64_t a = operands.next(), b = operands.next();
            ASSERT_EQ(multiply(a, b).as<int64_t>(), portable_multiply(a, b))
                << F << " fraction bits: " << a << " " << b;
        }
    };
    for_each_long_split([&](auto F) { check_split(F, portable::multiply<int64_t, F>); });
}

// Random operands, and those whose quotient is about q + 1/2.
TEST(LongSplits, Divide) {
    Program program("divide", 64);
    const auto check_split = [&](int F, int64_t (*portable_divide)(int64_t, int64_t)) {
        DeviceFunction divide = program.subject(F, {8, {8, 8}});
        const auto check = [&](int64_t a, int64_t b) {
            ASSERT_EQ(divide(a, b).as<int64_t>(), portable_divide(a, b))
                << F << " fraction bits: " << a << " " << b;
        };
        LongOperands operands;
        for (int i = 0; i < pairs; ++i) {
            check(operands.next(), operands.next());
            const auto b = static_cast<int64_t>(operands.magnitude());
            const __int128 twice = __int128(2 * (operands.magnitude() >> 1) + 1) * b;
            const __int128 half = (twice >> 1) >> F;
            if (half >= fixedpoint::RawLimits<int64_t>::max) continue;
            const auto a = static_cast<int64_t>(half);
            check(a, i % 2 == 0 ? b : -b);
            check(-a - 1, i % 2 == 0 ? b : -b);
        }
    };
    for_each_long_split([&](auto F) { check_split(F, portable::divide<int64_t, F>); });
}

// Random operands, and those whose root is about r + 1/2.
TEST(LongSplits, Sqrt) {
    Program program("sqrt", 64);
    const auto check_split = [&](int F, int64_t (*portable_sqrt)(int64_t)) {
        DeviceFunction sqrt = program.subject(F, {8, {8}});
        const auto check = [&](int64_t a) {
            ASSERT_EQ(sqrt(a).as<int64_t>(), portable_sqrt(a)) << F << " fraction bits: " << a;
        };
        LongOperands operands;
        for (int i = 0; i < pairs; ++i) {
            check(operands.next());
            const unsigned __int128 r = operands.magnitude(), half = (r * r + r) >> F;
            if (half >= static_cast<uint64_t>(fixedpoint::RawLimits<int64_t>::max)) continue;
            check(static_cast<int64_t>(half));
            check(static_cast<int64_t>(half) + 1);
        }
    };
    for_each_long_split([&](auto F) { check_split(F, portable::sqrt<int64_t, F>); });
}

template <class Expected>
void expect_long_vectors(const char* operation, const Signature& signature, Expected expected) {
    Program program(operation, 64);
    for_each_long_split([&](auto F) {
        DeviceFunction function = program.subject(F, signature);
        LongOperands operands;
        for (int i = 0; i < pairs / 4; ++i) {
            const auto a = operands.vector(), b = operands.vector();
            const std::uint64_t addresses[] = {program.put(0, a), program.put(1, b)};
            ASSERT_EQ(function.call({addresses, signature.operands.size()}).template as<int64_t>(),
                      expected(F, a.data(), b.data()))
                << F << " fraction bits: " << testing::PrintToString(a) << " "
                << testing::PrintToString(b);
        }
    });
}
TEST(LongSplits, Dot2) {
    expect_long_vectors("dot2", {8, {2, 2}}, [](auto F, const int64_t* a, const int64_t* b) {
        return portable::dot2<int64_t, F>(a, b);
    });
}
TEST(LongSplits, Dot3) {
    expect_long_vectors("dot3", {8, {2, 2}}, [](auto F, const int64_t* a, const int64_t* b) {
        return portable::dot3<int64_t, F>(a, b);
    });
}
TEST(LongSplits, Length3) {
    expect_long_vectors("length3", {8, {2}}, [](auto F, const int64_t* v, const int64_t*) {
        return portable::length3<int64_t, F>(v);
    });
}

// Of every length, over the range of powers, and where the number of factors of 2 changes.
TEST(LongSplits, Exp) {
    Program program("exp", 64);
    const auto check_split = [&](int F, int64_t (*portable_exp)(int64_t)) {
        DeviceFunction exp = program.subject(F, {8, {8}});
        const auto check = [&](double x) {
            const auto a = static_cast<int64_t>(std::ldexp(x, F));
            for (int64_t n = a - 1; n <= a + 1; ++n) {
                ASSERT_EQ(exp(n).as<int64_t>(), portable_exp(n)) << F << " fraction bits: " << n;
            }
        };
        const double limit = std::ldexp(0.999, 63 - F);
        const double least = std::max(-(F + 3) * M_LN2, -limit);
        const double largest = std::min((64 - F) * M_LN2, limit);
        std::mt19937 random(13);
        std::uniform_real_distribution<double> representable(least, largest);
        for (int i = 0; i < pairs / 4; ++i) check(representable(random));
        for (const double whole : {-65.0, -64.0, -46.0, 46.0, 63.0, 64.0}) {
            if (std::abs(whole) < limit) check(whole);
        }
        for (int k = -66; k <= 66; ++k) {
            for (int i = -8; i <= 8; ++i) {
                const double x = (k + i / 128.0) * M_LN2;
                if (std::abs(x) < limit) check(x);
            }
        }
        LongOperands operands;
        for (int i = 0; i < pairs / 4; ++i) {
            const int64_t a = operands.next();
            ASSERT_EQ(exp(a).as<int64_t>(), portable_exp(a)) << F << " fraction bits: " << a;
        }
    };
    for_each_long_split([&](auto F) { check_split(F, portable::exp<int64_t, F>); });
}

// All but the finest ones, whose sines, angles and logarithms are portable code.
template <class Check>
void for_each_split_with_functions(Check check) {
    for_each_long_split([&](auto F) {
        if constexpr (F <= 56) check(F);
    });
}

// The coarse splits use the sine of Q32.32, for angles that it holds and for larger ones.
TEST(LongSplits, SinAndCos) {
    Program sines("sin", 64), cosines("cos", 64), pairs_of_both("sincos", 64);
    const auto check_split = [&](int F, int64_t (*portable_sin)(int64_t),
                                 int64_t (*portable_cos)(int64_t)) {
        DeviceFunction sin = sines.subject(F, {8, {8}}), cos = cosines.subject(F, {8, {8}});
        DeviceFunction sincos = pairs_of_both.subject(F, {0, {8, 2}});
        LongOperands operands;
        for (int i = 0; i < pairs / 4; ++i) {
            const int64_t a = operands.next();
            const int64_t expected[] = {portable_sin(a), portable_cos(a)};
            ASSERT_EQ(sin(a).as<int64_t>(), expected[0]) << F << " fraction bits: " << a;
            ASSERT_EQ(cos(a).as<int64_t>(), expected[1]) << F << " fraction bits: " << a;
            sincos(a, pairs_of_both.put(0, std::array<int64_t, 3>{}));
            const auto both = pairs_of_both.get<int64_t>(0);
            ASSERT_EQ(both[0], expected[0]) << F << " fraction bits: " << a;
            ASSERT_EQ(both[1], expected[1]) << F << " fraction bits: " << a;
        }
    };
    for_each_split_with_functions([&](auto F) {
        check_split(F, fixedpoint::kernel::sin<int64_t, F>, fixedpoint::kernel::cos<int64_t, F>);
    });
}

// Of every length, and next to the axes and the diagonals.
TEST(LongSplits, Angles) {
    Program vectors("atan2", 64), tangents("atan", 64);
    const auto check_split = [&](int F, int64_t (*portable_atan2)(int64_t, int64_t),
                                 int64_t (*portable_atan)(int64_t)) {
        DeviceFunction atan2 = vectors.subject(F, {8, {8, 8}}),
                       atan = tangents.subject(F, {8, {8}});
        LongOperands operands;
        for (int i = 0; i < pairs / 4; ++i) {
            const int64_t y = operands.next();
            const int64_t x = i % 4 != 0 ? operands.next() : i % 8 == 0 ? y : ~y;
            ASSERT_EQ(atan2(y, x).as<int64_t>(), portable_atan2(y, x))
                << F << " fraction bits: " << y << " " << x;
            ASSERT_EQ(atan(y).as<int64_t>(), portable_atan(y)) << F << " fraction bits: " << y;
        }
    };
    for_each_split_with_functions([&](auto F) {
        check_split(F, fixedpoint::kernel::atan2<int64_t, F>, fixedpoint::kernel::atan<int64_t, F>);
    });
}

// Of every length, and next to 1, where the logarithm is small.
TEST(LongSplits, Log) {
    Program program("log", 64);
    const auto check_split = [&](int F, int64_t (*portable_log)(int64_t)) {
        DeviceFunction log = program.subject(F, {8, {8}});
        LongOperands operands;
        for (int i = 0; i < pairs / 4; ++i) {
            const int64_t n = operands.next();
            const int64_t a = i % 4 != 0 ? n : (int64_t(1) << F) + (n >> (63 - F));
            ASSERT_EQ(log(a).as<int64_t>(), portable_log(a)) << F << " fraction bits: " << a;
        }
    };
    for_each_split_with_functions(
        [&](auto F) { check_split(F, fixedpoint::kernel::log<int64_t, F>); });
}

TEST(LongSplits, ReciprocalSqrt) {
    Program program("reciprocal_sqrt", 64);
    const auto check_split = [&](int F, int64_t (*portable_reciprocal_sqrt)(int64_t)) {
        DeviceFunction reciprocal_sqrt = program.subject(F, {8, {8}});
        LongOperands operands;
        for (int i = 0; i < pairs / 8; ++i) {
            const int64_t a = operands.next();
            ASSERT_EQ(reciprocal_sqrt(a).as<int64_t>(), portable_reciprocal_sqrt(a))
                << F << " fraction bits: " << a;
        }
    };
    for_each_long_split(
        [&](auto F) { check_split(F, fixedpoint::kernel::reciprocal_sqrt<int64_t, F>); });
}

}  // namespace
