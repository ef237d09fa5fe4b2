// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of vectors, matrices, quaternions, polynomials and filters on the simulated chip,
// compared with exact arithmetic, for any operands and for those that the kernels treat specially
// (components of unit vectors, with fraction 0).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/device/tests/program_folder.hpp"
#include "fixedpoint/tests/exact.hpp"

namespace {

using simulator::Chip;
using simulator::DeviceFunction;
using Vector = std::array<int32_t, 3>;

constexpr int rounds = 10000;
constexpr exact::Format q16_16{32, 16};

int32_t product(int32_t a, int32_t b) {
    return static_cast<int32_t>(exact::multiply_add(a, b, 0, q16_16).wrapped);
}
int32_t sum(int32_t a, int32_t b) {
    return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}
int32_t difference(int32_t a, int32_t b) {
    return static_cast<int32_t>(static_cast<uint32_t>(a) - static_cast<uint32_t>(b));
}

// b such that sum + a b, with an odd a, is `wanted` modulo 2^24, and is less than 1 of Q8.24 or,
// with `negative`, is -1 or more but negative.
int32_t completing(int64_t sum, int32_t a, int64_t wanted, bool negative) {
    auto inverse = static_cast<std::uint32_t>(a);  // by Newton's method
    for (int i = 0; i < 4; ++i) inverse *= 2 - static_cast<std::uint32_t>(a) * inverse;
    const auto b = static_cast<int32_t>((static_cast<std::uint32_t>(wanted - sum) * inverse) &
                                        ((1u << 24) - 1));
    return negative ? b - (1 << 24) : b;
}

// A remainder modulo 2^24: a half, and up to 2^16 more or, every other time, up to 2^19 more or
// less.
int64_t nearly_half(std::uint32_t random) {
    const auto bits = static_cast<int64_t>(random >> 1);
    return (1 << 23) + (random % 2 == 0 ? bits & 0xffff : (bits & 0xfffff) - 0x80000);
}

class VectorKernels : public testing::Test {
  protected:
    explicit VectorKernels(const std::string& program)
        : chip_(simulator::Elf(program_folder() + "/" + program + ".elf")) {
        chip_.run_until_function("main");
        for (std::uint16_t& address : addresses_) address = chip_.allocate(sizeof(Vector));
    }
    // Any number, or 0, +-1 and numbers between, a few ulp off.
    int32_t number(int fraction = 16) {
        if (random_() % 2 == 0) return static_cast<int32_t>(any_[random_() % any_.size()]);
        const auto one = static_cast<int64_t>(1) << fraction;
        return static_cast<int32_t>(
            one * (static_cast<int64_t>(random_() % 3) - 1) +
            (random_() % 2 == 0 ? static_cast<int64_t>(random_() % 3) - 1
                                : static_cast<int64_t>(random_() % static_cast<uint64_t>(one))));
    }
    // A whole number from 0 to 255, or one ulp off.
    int32_t whole(int i) {
        return ((i & 255) << 16) + static_cast<int32_t>(random_() % 4 == 0) -
               static_cast<int32_t>(random_() % 4 == 0);
    }
    Vector vector() { return {number(), number(), number()}; }
    std::uint16_t put(int index, const Vector& v) {
        chip_.write(addresses_[index], {reinterpret_cast<const std::uint8_t*>(v.data()), sizeof v});
        return addresses_[index];
    }
    template <class T>
    void write(std::uint16_t address, const T& object) {
        chip_.write(address, {reinterpret_cast<const std::uint8_t*>(&object), sizeof object});
    }
    template <class T>
    T read(std::uint16_t address) const {
        T object;
        chip_.read(address, {reinterpret_cast<std::uint8_t*>(&object), sizeof object});
        return object;
    }
    Vector get(int index) const {
        Vector v;
        chip_.read(addresses_[index], {reinterpret_cast<std::uint8_t*>(v.data()), sizeof v});
        return v;
    }

    Chip chip_;

  private:
    std::array<std::uint16_t, 3> addresses_{};
    std::vector<std::int64_t> any_ = exact::raws(32);
    std::mt19937_64 random_{16};
};
class VectorSteps : public VectorKernels {
  protected:
    VectorSteps() : VectorKernels("vector_steps") {}
};
class VectorTransform : public VectorKernels {
  protected:
    VectorTransform() : VectorKernels("vector_transform") {}
};
class VectorCross : public VectorKernels {
  protected:
    VectorCross() : VectorKernels("vector_cross") {}
};
class VectorPolynomials : public VectorKernels {
  protected:
    VectorPolynomials() : VectorKernels("vector_polynomials") {}
};
class VectorInverses : public VectorKernels {
  protected:
    VectorInverses() : VectorKernels("vector_inverses") {}
};
class VectorFilters : public VectorKernels {
  protected:
    VectorFilters() : VectorKernels("vector_filters") {}
};
class VectorComplexProduct : public VectorKernels {
  protected:
    VectorComplexProduct() : VectorKernels("vector_complex_product") {}
};
class VectorMatrixProduct2 : public VectorKernels {
  protected:
    VectorMatrixProduct2() : VectorKernels("vector_matrix_product_2") {}
};
class VectorCofactors : public VectorKernels {
  protected:
    VectorCofactors() : VectorKernels("vector_cofactors") {}
};

TEST_F(VectorSteps, ProjectIsTheDotProductAndDotDifferenceThatOfTheDifferenceRoundedOnce) {
    for (const int n : {2, 3}) {
        const std::string size = n == 2 ? "2_q16_16" : "3_q16_16";
        DeviceFunction square(chip_, "fixedpoint_square" + size, {4, {2}});
        DeviceFunction project(chip_, "fixedpoint_project" + size, {4, {2, 2}});
        DeviceFunction dot_difference(chip_, "fixedpoint_dot_difference" + size, {4, {2, 2, 2}});
        for (int i = 0; i < rounds; ++i) {
            const Vector a = vector(), u = vector(), v = vector();
            const int64_t wide_a[3] = {a[0], a[1], a[2]}, wide_u[3] = {u[0], u[1], u[2]};
            const int64_t d[3] = {difference(u[0], v[0]), difference(u[1], v[1]),
                                  difference(u[2], v[2])};
            const std::uint16_t at_a = put(0, a), at_u = put(1, u), at_v = put(2, v);
            ASSERT_EQ(project(at_a, at_u).as<int32_t>(),
                      exact::dot(wide_a, wide_u, n, q16_16).wrapped)
                << n << " " << i;
            ASSERT_EQ(square(at_a).as<int32_t>(), exact::dot(wide_a, wide_a, n, q16_16).wrapped)
                << n << " " << i;
            ASSERT_EQ(dot_difference(at_a, at_u, at_v).as<int32_t>(),
                      exact::dot(wide_a, d, n, q16_16).wrapped)
                << n << " " << i;
        }
    }
}

// |a| < 1/4 and 0 <= b < 2: the ends of both, and their neighbours, with each other and at random.
TEST_F(VectorSteps, ShortProductsAreRounded) {
    DeviceFunction multiply(chip_, "fixedpoint_multiply_short_q16_16", {4, {4, 4}});
    std::vector<int32_t> a, b;
    for (const int32_t end : {0, 0x100, 0x2000, 0x3fff})
        for (int32_t x = end - 2; x <= end + 2 && x < 0x4000; ++x) a.insert(a.end(), {x, -x});
    for (const int32_t end : {0, 0x100, 0x8000, 0x10000, 0x1ffff})
        for (int32_t x = std::max(end - 2, 0); x <= end + 2 && x < 0x20000; ++x) b.push_back(x);
    std::mt19937 random(17);
    for (int i = 0; i < 200; ++i) {
        a.push_back(static_cast<int32_t>(random() % 0x7fff) - 0x3fff);
        b.push_back(static_cast<int32_t>(random() % 0x20000));
    }
    for (const int32_t x : a)
        for (const int32_t y : b)
            ASSERT_EQ(multiply(x, y).as<int32_t>(), product(x, y)) << x << " " << y;
}

TEST_F(VectorSteps, ScaleDownRoundsHalfUpByEveryShift) {
    for (int shift = 0; shift < 32; ++shift) {
        DeviceFunction scale_down(chip_, "scale_down_" + std::to_string(shift), {4, {4}});
        for (int i = 0; i < 1000; ++i) {
            const int32_t a = number();
            const std::int64_t half = (std::int64_t(1) << shift) / 2;
            ASSERT_EQ(scale_down(a).as<int32_t>(), (a + half) >> shift) << a << " " << shift;
        }
    }
}

TEST_F(VectorSteps, AddScaledAddsTheRoundedProducts) {
    for (const int n : {2, 3}) {
        DeviceFunction add_scaled(
            chip_, n == 2 ? "fixedpoint_add_scaled2_q16_16" : "fixedpoint_add_scaled3_q16_16",
            {0, {2, 2, 4}});
        for (int i = 0; i < rounds; ++i) {
            const Vector v = vector();
            Vector expected = vector();
            const int32_t factor = i % 4 == 0 ? whole(i / 4) : number();
            add_scaled(put(0, expected), put(1, v), factor);
            for (int k = 0; k < n; ++k) expected[k] = sum(expected[k], product(v[k], factor));
            ASSERT_EQ(get(0), expected) << n << " " << factor << " " << v[0] << " " << v[1];
            ASSERT_EQ(get(1), v);
        }
    }
}

TEST_F(VectorSteps, ExchangeAddsTheRoundedProductsToOneAndTakesThemFromTheOther) {
    for (const int n : {2, 3}) {
        DeviceFunction exchange(
            chip_, n == 2 ? "fixedpoint_exchange2_q16_16" : "fixedpoint_exchange3_q16_16",
            {0, {2, 2, 2, 4}});
        for (int i = 0; i < rounds; ++i) {
            const Vector v = vector();
            Vector a = vector(), b = vector();
            const int32_t factor = number();
            exchange(put(0, a), put(1, b), put(2, v), factor);
            for (int k = 0; k < n; ++k) {
                a[k] = sum(a[k], product(v[k], factor));
                b[k] = difference(b[k], product(v[k], factor));
            }
            ASSERT_EQ(get(0), a) << n << " " << factor << " " << v[0] << " " << v[1];
            ASSERT_EQ(get(1), b) << n << " " << factor << " " << v[0] << " " << v[1];
            ASSERT_EQ(get(2), v);
        }
    }
}

TEST_F(VectorTransform, MatricesTimesVectorsAndMatricesAreRoundedSums) {
    const std::uint16_t at_result = chip_.allocate(64), at_v = chip_.allocate(64),
                        at_m = chip_.allocate(64);
    for (int fraction = 0; fraction <= 32; ++fraction) {
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        for (const bool of_matrices : {false, true}) {
            DeviceFunction multiply(
                chip_,
                (of_matrices ? "fixedpoint_matrix_product_q" : "fixedpoint_transform_q") + split,
                {0, {2, 2, 2, 1}});
            for (int i = 0; i < 60; ++i) {
                const int n = 2 + i % 3;
                std::array<int32_t, 16> v{}, m{}, result{};
                for (int32_t& x : v) x = number(fraction);
                for (int32_t& x : m) x = number(fraction);
                chip_.write(at_v, {reinterpret_cast<const std::uint8_t*>(v.data()), sizeof v});
                chip_.write(at_m, {reinterpret_cast<const std::uint8_t*>(m.data()), sizeof m});
                multiply(at_result, at_v, at_m, n);
                chip_.read(at_result,
                           {reinterpret_cast<std::uint8_t*>(result.data()), sizeof result});
                for (int k = 0; k < (of_matrices ? n * n : n); ++k) {
                    int64_t a[4] = {}, b[4] = {};
                    for (int j = 0; j < n; ++j) {
                        a[j] = v[of_matrices ? k / n * n + j : j];
                        b[j] = m[of_matrices ? j * n + k % n : k * n + j];
                    }
                    ASSERT_EQ(result[k], exact::dot(a, b, n, format).wrapped)
                        << split << " " << of_matrices << " " << n << " " << k;
                }
            }
        }
    }
}

TEST_F(VectorMatrixProduct2, IsMadeOfRoundedSums) {
    using Matrix = std::array<std::array<int32_t, 2>, 2>;
    const std::uint16_t at_result = chip_.allocate(20), at_a = chip_.allocate(16),
                        at_b = chip_.allocate(16);
    for (int fraction = 0; fraction <= 32; ++fraction) {
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction multiply(chip_, "fixedpoint_matrix_product_2_q" + split, {0, {2, 2, 2}});
        for (int i = 0; i < (fraction == 16 || fraction == 24 ? rounds / 10 : 100); ++i) {
            Matrix a, b;
            for (Matrix* m : {&a, &b})
                for (auto& row : *m)
                    for (int32_t& x : row) x = number(fraction);
            write(at_a, a);
            write(at_b, b);
            const int32_t behind = number();
            write(static_cast<std::uint16_t>(at_result + 16), behind);
            multiply(at_result, at_a, at_b);
            ASSERT_EQ(read<int32_t>(static_cast<std::uint16_t>(at_result + 16)), behind);
            const auto result = read<Matrix>(at_result);
            for (int k = 0; k < 4; ++k) {
                const int64_t row[2] = {a[k / 2][0], a[k / 2][1]},
                              column[2] = {b[0][k % 2], b[1][k % 2]};
                ASSERT_EQ(result[k / 2][k % 2], exact::dot(row, column, 2, format).wrapped)
                    << split << " " << k;
            }
        }
    }
}

TEST_F(VectorMatrixProduct2, IsExactWhereItIsNearlyHalfWay) {
    using Matrix = std::array<std::array<int32_t, 2>, 2>;
    const std::uint16_t at_result = chip_.allocate(16), at_a = chip_.allocate(16),
                        at_b = chip_.allocate(16);
    DeviceFunction multiply(chip_, "fixedpoint_matrix_product_2_q8_24", {0, {2, 2, 2}});
    std::mt19937 random(20);
    const auto small = [&] { return static_cast<int32_t>(random() % (1u << 25)) - (1 << 24); };
    for (int i = 0; i < rounds; ++i) {
        const bool large = i % 8 >= 4;  // what is left out
        const int column = i % 2;       // of the elements that are nearly half way
        Matrix a, b;
        for (auto& row : b)
            for (int32_t& x : row) x = large ? (small() & ~0xffff) | 0x1ff : small() | 1;
        for (auto& row : a) {
            row[0] = large ? (small() & ~0xffff) | 0x1ff : small();
            const int64_t wanted = nearly_half(random());
            row[1] = completing(int64_t{row[0]} * b[0][column], b[1][column], wanted, i % 4 >= 2);
        }
        write(at_a, a);
        write(at_b, b);
        multiply(at_result, at_a, at_b);
        const auto result = read<Matrix>(at_result);
        for (int k = 0; k < 4; ++k) {
            const int64_t row[2] = {a[k / 2][0], a[k / 2][1]},
                          b_column[2] = {b[0][k % 2], b[1][k % 2]};
            ASSERT_EQ(result[k / 2][k % 2],
                      exact::dot(row, b_column, 2, exact::Format{32, 24}).wrapped)
                << i << " " << k;
        }
    }
}

// The products that make up a component: of the quaternions' parts a_p and b_q, with a sign.
struct Product {
    int sign, p, q;
};
using Components = std::vector<std::vector<Product>>;
const Components of_quaternions = {{{1, 0, 0}, {-1, 1, 1}, {-1, 2, 2}, {-1, 3, 3}},
                                   {{1, 0, 1}, {1, 1, 0}, {1, 2, 3}, {-1, 3, 2}},
                                   {{1, 0, 2}, {-1, 1, 3}, {1, 2, 0}, {1, 3, 1}},
                                   {{1, 0, 3}, {1, 1, 2}, {-1, 2, 1}, {1, 3, 0}}};

TEST_F(VectorCross, CrossAndQuaternionProductsAreRoundedSums) {
    const std::uint16_t at_result = chip_.allocate(16), at_a = chip_.allocate(16),
                        at_b = chip_.allocate(16);
    struct Kernel {
        const char* name;
        bool a_is_vector, b_is_vector;
        int factor;
    };
    for (const Kernel kernel : {Kernel{"cross", true, true, 1},
                                {"twice_cross", true, true, 2},
                                {"quaternion_times_vector", false, true, 1},
                                {"quaternion_product", false, false, 1}}) {
        for (int fraction = 0; fraction <= 32; ++fraction) {
            const exact::Format format{32, fraction};
            const std::string split =
                std::to_string(32 - fraction) + "_" + std::to_string(fraction);
            DeviceFunction multiply(chip_, "fixedpoint_" + (kernel.name + ("_q" + split)),
                                    {0, {2, 2, 2}});
            for (int i = 0; i < 60; ++i) {
                std::array<int32_t, 4> a{}, b{}, result{};
                for (int32_t& x : a) x = number(fraction);
                for (int32_t& x : b) x = number(fraction);
                if (kernel.a_is_vector) a[0] = 0;
                if (kernel.b_is_vector) b[0] = 0;
                chip_.write(at_a, {reinterpret_cast<const std::uint8_t*>(a.data()), sizeof a});
                chip_.write(at_b, {reinterpret_cast<const std::uint8_t*>(b.data()), sizeof b});
                multiply(at_result + (kernel.b_is_vector ? 4 : 0),
                         at_a + (kernel.a_is_vector ? 4 : 0), at_b + (kernel.b_is_vector ? 4 : 0));
                chip_.read(at_result,
                           {reinterpret_cast<std::uint8_t*>(result.data()), sizeof result});
                for (int part = kernel.b_is_vector ? 1 : 0; part < 4; ++part) {
                    int64_t p[4] = {}, q[4] = {};
                    for (int j = 0; j < 4; ++j) {
                        const Product& product = of_quaternions[part][j];
                        p[j] = kernel.factor * product.sign * static_cast<int64_t>(a[product.p]);
                        q[j] = b[product.q];
                    }
                    ASSERT_EQ(result[part], exact::dot(p, q, 4, format).wrapped)
                        << kernel.name << " " << split << " " << part;
                }
            }
        }
    }
}

TEST_F(VectorPolynomials, RoundOnceAStep) {
    const int32_t c[5] = {102921, INT32_MIN, -42218, INT32_MAX, 4833};  // as on the chip
    std::uint16_t at_c = 0;
    for (const simulator::Symbol& table : chip_.elf().flash_objects())
        if (table.name == "coefficients") at_c = static_cast<std::uint16_t>(table.address);
    for (int fraction = 0; fraction <= 32; ++fraction) {
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction polynomial(chip_, "fixedpoint_polynomial_q" + split, {4, {4, 2, 2}});
        for (int i = 0; i < (fraction == 16 || fraction == 24 ? rounds : 500); ++i) {
            const int32_t x = number(fraction);
            const int n = 1 + i % 5;
            int32_t expected = c[n - 1];
            for (int k = n - 2; k >= 0; --k)
                expected =
                    static_cast<int32_t>(exact::multiply_add(expected, x, c[k], format).wrapped);
            ASSERT_EQ(polynomial(x, at_c, n).as<int32_t>(), expected)
                << split << " " << x << " " << n;
        }
    }
}

// Bytes that the kernel of Q8.24 leaves out decide. They are largest in products of numbers that
// end with 0x01ff.
TEST_F(VectorComplexProduct, IsExactWhereItIsNearlyHalfWay) {
    using Complex = std::array<int32_t, 2>;
    const std::uint16_t at_result = chip_.allocate(8), at_a = chip_.allocate(8),
                        at_b = chip_.allocate(8);
    DeviceFunction multiply(chip_, "fixedpoint_complex_product_q8_24", {0, {2, 2, 2}});
    std::mt19937 random(19);
    const auto small = [&] { return static_cast<int32_t>(random() % (1u << 25)) - (1 << 24); };
    for (int i = 0; i < 2 * rounds; ++i) {
        const int unit = i % 4 < 2 ? 0 : 1;  // 0: the real part is nearly half way
        Complex a = {small(), small() | 1}, b = {small(), small()};
        if (i % 16 >= 8) {
            a[0] = (a[0] & ~0xffff) | 0x1ff;
            a[1] = (a[1] & ~0xffff) | (unit == 0 && i % 32 >= 16 ? 1 : 0x1ff);
            b[unit] = (b[unit] & ~0xffff) | 0x1ff;
        }
        const int64_t wanted = nearly_half(random());
        b[1 - unit] =
            completing(int64_t{a[0]} * b[unit], unit == 0 ? -a[1] : a[1], wanted, i % 2 == 1);
        write(at_a, a);
        write(at_b, b);
        multiply(at_result, at_a, at_b);
        const auto result = read<Complex>(at_result);
        const int64_t wide_a[2] = {a[0], a[1]}, b_conjugate[2] = {b[0], -int64_t{b[1]}},
                      b_swapped[2] = {b[1], b[0]};
        const exact::Format format{32, 24};
        ASSERT_EQ(result[0], exact::dot(wide_a, b_conjugate, 2, format).wrapped) << i;
        ASSERT_EQ(result[1], exact::dot(wide_a, b_swapped, 2, format).wrapped) << i;
    }
}

TEST_F(VectorComplexProduct, IsTheRoundedDifferenceAndSum) {
    using Complex = std::array<int32_t, 2>;
    const std::uint16_t at_result = chip_.allocate(8), at_a = chip_.allocate(8),
                        at_b = chip_.allocate(8);
    for (int fraction = 0; fraction <= 32; ++fraction) {
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction multiply(chip_, "fixedpoint_complex_product_q" + split, {0, {2, 2, 2}});
        for (int i = 0; i < (fraction == 16 || fraction == 24 ? rounds / 10 : 100); ++i) {
            const Complex a = {number(fraction), number(fraction)},
                          b = {number(fraction), number(fraction)};
            write(at_a, a);
            write(at_b, b);
            multiply(at_result, at_a, at_b);
            const auto result = read<Complex>(at_result);
            const int64_t wide_a[2] = {a[0], a[1]}, b_conjugate[2] = {b[0], -int64_t{b[1]}},
                          b_swapped[2] = {b[1], b[0]};
            ASSERT_EQ(result[0], exact::dot(wide_a, b_conjugate, 2, format).wrapped) << split;
            ASSERT_EQ(result[1], exact::dot(wide_a, b_swapped, 2, format).wrapped) << split;
        }
    }
}

TEST_F(VectorPolynomials, AmplifiedNumbersAreRoundedOnce) {
    using Numbers = std::array<int32_t, 4>;
    const std::uint16_t at = chip_.allocate(20);
    for (int fraction = 0; fraction <= 32; ++fraction) {
        if (fraction == 16) continue;
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction amplify(chip_, "fixedpoint_amplify4_q" + split, {0, {2, 4}});
        for (int i = 0; i < (fraction == 24 ? rounds / 10 : 100); ++i) {
            Numbers a;
            for (int32_t& x : a) x = number(fraction);
            const int32_t b = number(fraction), behind = number();
            write(at, a);
            write(static_cast<std::uint16_t>(at + 16), behind);
            amplify(at, b);
            ASSERT_EQ(read<int32_t>(static_cast<std::uint16_t>(at + 16)), behind);
            const auto result = read<Numbers>(at);
            for (int k = 0; k < 4; ++k)
                ASSERT_EQ(result[k], exact::multiply_add(a[k], b, a[k], format).wrapped)
                    << split << " " << a[k] << " " << b;
        }
    }
}

TEST_F(VectorInverses, AreTheQuotientsOfCofactorsAndDeterminant) {
    using Matrix = std::array<int32_t, 4>;
    const std::uint16_t at_a = chip_.allocate(16), at_inverse = chip_.allocate(16);
    int singular = 0;
    for (int fraction = 0; fraction <= 32; ++fraction) {
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction invert(chip_, "fixedpoint_invert2_q" + split, {1, {2, 2}});
        for (int i = 0; i < (fraction == 16 || fraction == 24 ? rounds : 300); ++i) {
            const Matrix a = {number(fraction), number(fraction), number(fraction),
                              number(fraction)},
                         before = {1, 2, 3, 4};
            const int64_t row[2] = {a[0], a[1]}, column[2] = {a[3], difference(0, a[2])};
            const int64_t d = exact::dot(row, column, 2, format).wrapped;
            Matrix expected = before;
            if (d != 0) {
                const auto over = [&](int64_t cofactor) {
                    return static_cast<int32_t>(exact::divide(cofactor, d, format).saturated);
                };
                expected = {over(a[3]), over(difference(0, a[1])), over(column[1]), over(a[0])};
            }
            singular += d == 0;
            write(at_a, a);
            write(at_inverse, before);
            ASSERT_EQ(invert(at_a, at_inverse).as<std::uint8_t>(), d != 0) << split;
            ASSERT_EQ(read<Matrix>(at_inverse), expected) << split << " " << d;
            ASSERT_EQ(read<Matrix>(at_a), a);
            if (fraction != 16) continue;
            ASSERT_EQ(invert(at_a, at_a).as<std::uint8_t>(), d != 0);
            ASSERT_EQ(read<Matrix>(at_a), d != 0 ? expected : a);
        }
    }
    EXPECT_GT(singular, 0);
}

// Divisors of every length, so that the reciprocal is one of five bytes, too small or too large;
// quotients that are ties or an ulp beside one; and what saturates.
TEST_F(VectorInverses, TransposedQuotientsAreRounded) {
    using Numbers = std::array<int32_t, 9>;
    const std::uint16_t at_a = chip_.allocate(36), at_q = chip_.allocate(40);
    std::mt19937_64 random(18);
    for (int fraction = 0; fraction <= 32; ++fraction) {
        if (fraction == 16) continue;
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction divide(chip_, "fixedpoint_transposed_quotients_q" + split,
                              {0, {2, 2, 4, 1}});
        for (int i = 0; i < (fraction == 24 ? rounds / 2 : 500); ++i) {
            const int n = 2 + i % 2;
            const auto length = random() % 32;
            int32_t d =
                i % 4 == 0 ? number(fraction) : static_cast<int32_t>(random() >> 32) >> length;
            if (d == 0) d = 1;
            Numbers a;
            for (int32_t& x : a) {
                // Near half an odd number of ulps, where the product fits.
                const __int128 half =
                    static_cast<__int128>(d) * (2 * static_cast<int64_t>(random() % 100000) + 1);
                const int shift = fraction + 1;
                const auto near = static_cast<int64_t>(half >> shift);
                if (i % 2 == 0 && near == static_cast<int32_t>(near))
                    x = static_cast<int32_t>(near) + static_cast<int32_t>(random() % 2);
                else
                    x = number(fraction);
            }
            write(at_a, a);
            const int32_t behind = number();
            const auto end = static_cast<std::uint16_t>(at_q + 4 * n * n);
            write(end, behind);
            divide(at_q, at_a, d, n);
            ASSERT_EQ(read<int32_t>(end), behind);
            const auto q = read<Numbers>(at_q);
            for (int k = 0; k < n * n; ++k) {
                const int32_t x = a[k % n * n + k / n];
                ASSERT_EQ(q[k], exact::divide(x, d, format).saturated)
                    << split << " " << x << " " << d;
            }
        }
    }
}

TEST_F(VectorCofactors, AreRoundedCrossProductsOfRows) {
    using Matrix = std::array<std::array<int32_t, 3>, 3>;
    // At any address, since the address of a component may carry.
    const std::uint16_t space = chip_.allocate(36 + 255), at_result = chip_.allocate(36);
    unsigned place = 0;
    for (int fraction = 0; fraction <= 32; ++fraction) {
        const exact::Format format{32, fraction};
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction cofactors(chip_, "fixedpoint_cofactors_q" + split, {0, {2, 2}});
        for (int i = 0; i < (fraction == 16 || fraction == 24 ? rounds / 10 : 60); ++i) {
            Matrix m;
            for (auto& row : m)
                for (int32_t& x : row) x = number(fraction);
            const auto at_m = static_cast<std::uint16_t>(space + place++ % 256);
            write(at_m, m);
            cofactors(at_m, at_result);
            const auto result = read<Matrix>(at_result);
            for (int r = 0; r < 3; ++r) {
                for (int c = 0; c < 3; ++c) {
                    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3,
                              c2 = (c + 2) % 3;
                    const int64_t p[2] = {m[r1][c1], -int64_t{m[r1][c2]}},
                                  q[2] = {m[r2][c2], m[r2][c1]};
                    ASSERT_EQ(result[r][c], exact::dot(p, q, 2, format).wrapped)
                        << split << " " << r << " " << c;
                }
            }
            ASSERT_EQ(read<Matrix>(at_m), m);
        }
    }
}

// The number of F bits that is congruent to a.
int64_t low_bits(__int128 a, int fraction) {
    return static_cast<int64_t>(a & ((int64_t{1} << fraction) - 1));
}

// The error is stored together with the half that rounds, in the highest bits of `Low`.
template <int fraction, class Low>
struct __attribute__((packed)) OnePole {
    int32_t coefficient;
    Low error;
    int32_t output;

    int32_t last() const { return output; }
    template <class Number>
    void begin(Number number) {
        coefficient = number();
        output = number();
        error = static_cast<Low>(low_bits(number(), fraction) << (8 * sizeof(Low) - fraction));
    }
    void take(int32_t input) {
        constexpr int unused = 8 * sizeof(Low) - fraction;
        const int64_t distance = std::clamp<int64_t>(int64_t{input} - output, INT32_MIN, INT32_MAX);
        const __int128 sum = (static_cast<__int128>(output) << fraction) + (error >> unused) +
                             static_cast<__int128>(coefficient) * distance;
        error = static_cast<Low>(low_bits(sum, fraction) << unused);
        output = static_cast<int32_t>(sum >> fraction);
    }
};
template <int fraction, class Error>
struct __attribute__((packed)) Biquad {
    int32_t coefficient[5], x1, x2, y1, y2;
    int8_t weight[2];
    Error error[2];

    int32_t last() const { return y1; }
    template <class Number>
    void begin(Number number) {
        for (int i = 0; i < 5; ++i) coefficient[i] = number();
        x1 = number(), x2 = number(), y1 = number(), y2 = number();
        for (int i = 0; i < 2; ++i) {
            weight[i] =
                static_cast<int8_t>(static_cast<uint32_t>(number()) % (i == 0 ? 5 : 3) - 2 + i);
            error[i] =
                static_cast<Error>(low_bits(number(), fraction) - (int64_t{1} << (fraction - 1)));
        }
    }
    void take(int32_t input) {
        constexpr int64_t half = int64_t{1} << (fraction - 1);
        __int128 sum = int64_t{weight[0]} * error[0] + int64_t{weight[1]} * error[1];
        const int32_t signal[5] = {input, x1, x2, y1, y2};
        for (int i = 0; i < 5; ++i) sum += static_cast<__int128>(coefficient[i]) * signal[i];
        error[1] = error[0];
        error[0] = static_cast<Error>(low_bits(sum + half, fraction) - half);
        x2 = x1, x1 = input, y2 = y1, y1 = static_cast<int32_t>((sum + half) >> fraction);
    }
};

// The kernel of Q8.24 expects the weights nearest to the coefficients of y1 and y2, and keeps each
// output and its error as their exact sum plus half an ulp.
struct __attribute__((packed)) BiquadOfSums {
    static constexpr int64_t half = int64_t{1} << 23;
    int32_t b0, halves, b1, x1, b2, x2, c2;
    std::array<std::uint8_t, 7> sum2;
    int32_t c1;
    std::array<std::uint8_t, 7> sum1;
    int8_t weight2, weight1;

    static int64_t sum(const std::array<std::uint8_t, 7>& bytes) {
        std::uint64_t sum = 0;
        std::memcpy(&sum, bytes.data(), 7);
        return static_cast<int64_t>(sum << 8) >> 8;
    }
    static std::array<std::uint8_t, 7> bytes(int64_t sum) {
        std::array<std::uint8_t, 7> bytes{};
        std::memcpy(bytes.data(), &sum, 7);
        return bytes;
    }
    static int8_t nearest(int32_t c, int64_t limit) {
        return static_cast<int8_t>(std::clamp<int64_t>((int64_t{c} + half) >> 24, -limit, limit));
    }
    int32_t last() const { return static_cast<int32_t>(sum(sum1) >> 24); }
    template <class Number>
    void begin(Number number) {
        b0 = number(), b1 = number(), b2 = number(), c1 = number(), c2 = number();
        weight1 = nearest(c1, 2), weight2 = nearest(c2, 1);
        halves = (1 - weight1 - weight2) * 128;
        x1 = number(), x2 = number();
        for (auto* sum : {&sum1, &sum2})
            *sum = bytes(int64_t{number()} * 2 * half + low_bits(number(), 24));
    }
    void take(int32_t input) {
        const int64_t y1 = sum(sum1) >> 24, y2 = sum(sum2) >> 24;
        const __int128 exact = static_cast<__int128>(b0) * input + static_cast<__int128>(b1) * x1 +
                               static_cast<__int128>(b2) * x2 + static_cast<__int128>(c1) * y1 +
                               static_cast<__int128>(c2) * y2 +
                               weight1 * (low_bits(sum(sum1), 24) - half) +
                               weight2 * (low_bits(sum(sum2), 24) - half);
        sum2 = sum1, sum1 = bytes(static_cast<int64_t>(exact + half));
        x2 = x1, x1 = input;
    }
};

TEST_F(VectorFilters, KeepWhatTheirSumsLose) {
    const std::uint16_t at = chip_.allocate(64);
    const auto follow = [&](auto filter, const std::string& kernel, int fraction) {
        using Filter = decltype(filter);
        DeviceFunction step(chip_, kernel, {4, {4, 2}});
        for (int i = 0; i < rounds; ++i) {
            if (i % 8 == 0) filter.begin([&] { return number(fraction); });
            write(at, filter);
            const int32_t input = number(fraction);
            const auto output = step(input, at).as<int32_t>();
            filter.take(input);
            const auto after = read<Filter>(at);
            ASSERT_EQ(output, filter.last()) << kernel << " " << i;
            ASSERT_EQ(std::memcmp(&after, &filter, sizeof filter), 0) << kernel << " " << i;
        }
    };
    follow(OnePole<16, std::uint16_t>{}, "fixedpoint_one_pole_q16_16", 16);
    follow(OnePole<24, std::uint32_t>{}, "fixedpoint_one_pole_q8_24", 24);
    follow(Biquad<16, std::int16_t>{}, "fixedpoint_biquad_q16_16", 16);
    follow(BiquadOfSums{}, "fixedpoint_biquad_q8_24", 24);
}

// Each product and each sum is saturated; the error that is carried has a half added.
template <class Low>
struct __attribute__((packed)) Controller {
    int32_t gain[3], low, high, integral, measurement;
    Low error;
    std::uint8_t started;

    static int64_t saturated(__int128 x) {
        return static_cast<int64_t>(std::clamp<__int128>(x, INT32_MIN, INT32_MAX));
    }
    int32_t take(int32_t setpoint, int32_t measured, int fraction) {
        const int unused = static_cast<int>(8 * sizeof(Low)) - fraction;
        const __int128 half = (__int128{1} << fraction) / 2;
        const auto rounded = [&](__int128 product) {
            return saturated((product + half) >> fraction);
        };
        const int64_t off = saturated(int64_t{setpoint} - measured),
                      change = started ? saturated(int64_t{measured} - measurement) : 0;
        const __int128 product = static_cast<__int128>(gain[1]) * off;
        const int64_t behind = low_bits(product, fraction), sum = (error >> unused) + behind;
        const int64_t carry = fraction == 0 ? 0 : (sum >> fraction) - (behind >> (fraction - 1));
        const int64_t total = saturated(saturated(rounded(product) + integral) + carry);
        const int64_t wanted =
            saturated(saturated(rounded(static_cast<__int128>(gain[0]) * off) -
                                rounded(static_cast<__int128>(gain[2]) * change)) +
                      total);
        measurement = measured;
        started = 1;
        if ((wanted > high && total > integral) ||
            (wanted <= high && wanted < low && total < integral))
            return wanted > high ? high : low;
        integral = static_cast<int32_t>(total);
        if (fraction != 0) error = static_cast<Low>(low_bits(sum, fraction) << unused);
        return wanted > high ? high : static_cast<int32_t>(std::max<int64_t>(wanted, low));
    }
};

TEST_F(VectorFilters, ControllersSaturateAndDoNotWindUp) {
    const std::uint16_t at = chip_.allocate(64);
    const auto follow = [&](auto controller, int fraction) {
        const std::string split = std::to_string(32 - fraction) + "_" + std::to_string(fraction);
        DeviceFunction update(chip_, "fixedpoint_pid_q" + split, {4, {4, 4, 2}});
        const int steps = fraction == 16 || fraction == 24 ? 10 * rounds : rounds / 10;
        const int unused = static_cast<int>(8 * sizeof controller.error) - fraction;
        int limited = 0;
        for (int i = 0; i < steps; ++i) {
            if (i % 8 == 0) {
                for (int g = 0; g < 3; ++g) controller.gain[g] = number(fraction);
                const int32_t a = number(fraction), b = number(fraction);
                controller.low = std::min(a, b), controller.high = std::max(a, b);
                controller.integral = number(fraction), controller.measurement = number(fraction);
                controller.error = static_cast<decltype(controller.error)>(
                    low_bits(number(fraction), fraction) << unused);
                controller.started = i % 16 != 0;
            }
            write(at, controller);
            const int32_t setpoint = number(fraction), measured = number(fraction);
            const auto output = update(setpoint, measured, at).template as<int32_t>();
            ASSERT_EQ(output, controller.take(setpoint, measured, fraction)) << split << " " << i;
            const auto after = read<decltype(controller)>(at);
            ASSERT_EQ(std::memcmp(&after, &controller, sizeof after), 0) << split << " " << i;
            limited += output == controller.low || output == controller.high;
        }
        EXPECT_GT(limited, steps / 10) << split;
        EXPECT_LT(limited, steps * (steps > rounds ? 18 : 19) / 20) << split;
    };
    for (int fraction = 0; fraction <= 32; ++fraction) {
        if (fraction <= 8)
            follow(Controller<std::uint8_t>{}, fraction);
        else if (fraction <= 16)
            follow(Controller<std::uint16_t>{}, fraction);
        else
            follow(Controller<std::uint32_t>{}, fraction);
    }
}

}  // namespace
