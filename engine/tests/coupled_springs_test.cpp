// SPDX-License-Identifier: MIT
// DirectSprings, GaussSeidelSprings and ImplicitMidpoint, compared with the implicit step of all
// particles, solved by GSL; with the closed forms of a chain's frequencies and of its sag under
// weights that are far apart; and with springs that do not form a chain.
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <array>
#include <complex>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "runs.hpp"

using namespace engine;
using namespace engine::literals;

namespace {

constexpr unsigned most = 17;

template <class ChosenIntegrator>
struct Springs : Uses {
    static constexpr unsigned particles = most, anchored_springs = 2, springs = most;
    static constexpr bool gravity = true;
    using Integrator = ChosenIntegrator;
};
template <class Scalar, class Integrator = DirectSprings>
using WorldOfSprings = World<Scalar, Springs<Integrator>>;

using Plain = std::array<double, 2>;

// A spring between two particles, or from one to a fixed point.
struct Link {
    int a, b;  // b < 0: to the anchor
    double stiffness, damping, rest_length;
    Plain unit{};
    double extension = 0;
};

using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
using Column = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;

// Velocities v' with v'_p = v_p + h g - (h / m_p) sum of +- unit (k (extension + h w') + c w') over
// the springs at p, where w' = unit . (v'_a - v'_b): the matrix of all components, by LU
// decomposition.
std::vector<Plain> velocities_by_gsl(const std::vector<Link>& links, const std::vector<Plain>& v,
                                     const std::vector<double>& inverse_mass, Plain gravity,
                                     double h) {
    const std::size_t n = 2 * v.size();
    Matrix matrix(gsl_matrix_alloc(n, n), gsl_matrix_free);
    Column right(gsl_vector_alloc(n), gsl_vector_free), after(gsl_vector_alloc(n), gsl_vector_free);
    gsl_matrix_set_identity(matrix.get());
    for (std::size_t p = 0; p < v.size(); ++p)
        for (std::size_t i = 0; i < 2; ++i)
            gsl_vector_set(right.get(), 2 * p + i,
                           v[p][i] + (inverse_mass[p] > 0 ? h * gravity[i] : 0));
    for (const Link& link : links) {
        const double slope = h * (h * link.stiffness + link.damping);
        for (const int p : {link.a, link.b}) {
            if (p < 0) continue;
            const double of_p = (p == link.a ? 1 : -1) * inverse_mass[std::size_t(p)];
            for (std::size_t i = 0; i < 2; ++i) {
                const std::size_t row = 2 * std::size_t(p) + i;
                *gsl_vector_ptr(right.get(), row) -=
                    of_p * link.unit[i] * h * link.stiffness * link.extension;
                for (const int q : {link.a, link.b}) {
                    if (q < 0) continue;
                    for (std::size_t j = 0; j < 2; ++j)
                        *gsl_matrix_ptr(matrix.get(), row, 2 * std::size_t(q) + j) +=
                            of_p * link.unit[i] * slope * (q == link.a ? 1 : -1) * link.unit[j];
                }
            }
        }
    }
    const std::unique_ptr<gsl_permutation, decltype(&gsl_permutation_free)> order(
        gsl_permutation_alloc(n), gsl_permutation_free);
    int signum;
    gsl_linalg_LU_decomp(matrix.get(), order.get(), &signum);
    gsl_linalg_LU_solve(matrix.get(), order.get(), right.get(), after.get());
    std::vector<Plain> result(v.size());
    for (std::size_t p = 0; p < v.size(); ++p)
        result[p] = {gsl_vector_get(after.get(), 2 * p), gsl_vector_get(after.get(), 2 * p + 1)};
    return result;
}

// Bodies of 1 kg below each other on springs of 0.5 m, the last with another mass, at rest where
// gravity and the springs are in balance.
template <class Scalar, class Integrator>
void hang(WorldOfSprings<Scalar, Integrator>& world, unsigned links, double stiffness,
          double last_mass) {
    const auto number = [](double x) { return runs::Rounded<Scalar>::of(x); };
    world.gravity = {number(0), number(-9.81)};
    last_mass = 1 / runs::to_double(number(1 / last_mass));  // that of the rounded inverse
    typename WorldOfSprings<Scalar, Integrator>::Handle last;
    double y = 0;
    for (unsigned i = 0; i < links; ++i) {
        y -= 0.5 + 9.81 * (links - 1 - i + last_mass) / stiffness;
        typename WorldOfSprings<Scalar, Integrator>::Body body;
        body.position = {number(0), number(y)};
        body.inverse_mass = number(i + 1 == links ? 1 / last_mass : 1);
        const auto next = world.add_particle(body);
        if (i == 0) {
            world.add_anchored_spring(next, {number(0), number(0)}, number(stiffness), number(0),
                                      number(0.5));
        } else {
            world.add_spring(next, last, number(stiffness), number(0), number(0.5));
        }
        last = next;
    }
}

// The largest distance of a body from where it began, in 4 s of steps of 1/256 s.
template <class Scalar, class Integrator>
double drift(unsigned links, double stiffness, double last_mass) {
    WorldOfSprings<Scalar, Integrator> world;
    hang(world, links, stiffness, last_mass);
    const auto start = runs::state_of(world);
    double largest = 0;
    for (int step = 0; step < 1024; ++step) {
        world.step(BinaryStep<8>());
        const auto now = runs::state_of(std::as_const(world));
        for (unsigned i = 0; i < links; ++i)
            largest = std::max(largest, std::abs(now[i].position[1] - start[i].position[1]));
    }
    EXPECT_EQ(world.error(), Error::none);
    return largest;
}

// Random particles and the springs that `draw(random, n)` puts between them. All velocities after a
// step are those of GSL.
template <class Integrator, class Draw>
void expect_gsl(double mass_range, Draw draw) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int round = 0; round < 500; ++round) {
        WorldOfSprings<double, Integrator> world;
        const Plain gravity = {uniform(random), 10 * uniform(random)};
        world.gravity = {gravity[0], gravity[1]};
        const std::size_t n = 2 + random() % (most - 1);
        std::vector<Plain> position(n), velocity(n);
        std::vector<double> inverse_mass(n);
        for (std::size_t p = 0; p < n; ++p) {
            position[p] = {double(p) + 0.8 * uniform(random), 2 * uniform(random)};
            // Sometimes an immovable particle.
            inverse_mass[p] = random() % 8 == 0 ? 0 : std::pow(mass_range, uniform(random));
            if (inverse_mass[p] > 0) velocity[p] = {3 * uniform(random), 3 * uniform(random)};
            typename WorldOfSprings<double, Integrator>::Body body;
            body.position = {position[p][0], position[p][1]};
            body.velocity = {velocity[p][0], velocity[p][1]};
            body.inverse_mass = inverse_mass[p];
            world.add_particle(body);
        }
        std::vector<Link> links = draw(random, int(n));
        for (Link& it : links) {
            if (it.b >= 0 && random() % 2 == 0) std::swap(it.a, it.b);
            const Plain anchor = {0.25, 3};
            const Plain from = it.b < 0 ? anchor : position[std::size_t(it.b)];
            const Plain d = {position[std::size_t(it.a)][0] - from[0],
                             position[std::size_t(it.a)][1] - from[1]};
            const double distance = std::hypot(d[0], d[1]);
            it.unit = {d[0] / distance, d[1] / distance};
            it.extension = distance - it.rest_length;
            if (it.b < 0) {
                world.add_anchored_spring(std::uint8_t(it.a), {anchor[0], anchor[1]}, it.stiffness,
                                          it.damping, it.rest_length);
            } else {
                world.add_spring(std::uint8_t(it.a), std::uint8_t(it.b), it.stiffness, it.damping,
                                 it.rest_length);
            }
        }
        world.step(BinaryStep<8>());
        ASSERT_EQ(world.error(), Error::none);
        const auto expected = velocities_by_gsl(links, velocity, inverse_mass, gravity, 1.0 / 256);
        for (std::size_t p = 0; p < n; ++p)
            for (unsigned char i = 0; i < 2; ++i)
                ASSERT_NEAR(std::as_const(world).particles()[std::uint8_t(p)].velocity[i],
                            expected[p][i], 1e-8 * (1 + std::abs(expected[p][i])))
                    << "round " << round << ", particle " << p << " of " << n;
    }
}

// From slack to stiffer by `range` than 10 kN/m.
Link random_link(std::mt19937_64& random, int a, int b, double range) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double stiffness = random() % 8 == 0 ? 0 : 1e4 * std::pow(range, uniform(random));
    const double damping = random() % 2 == 0 ? 0 : std::pow(range, uniform(random));
    return {a, b, stiffness, damping, 1 + uniform(random)};
}

}  // namespace

// Masses from 1 g to 1 t, and springs that are stiffer than the step by up to 10^4.
TEST(DirectSprings, EqualsGslInRandomChains) {
    expect_gsl<DirectSprings>(1000, [](std::mt19937_64& random, int n) {
        // From a particle in the middle to both ends.
        const int middle = int(random() % unsigned(n));
        std::vector<Link> links;
        if (random() % 2 == 0 && (middle == 0 || middle == n - 1))
            links.push_back(random_link(random, middle, -1, 1e4));
        for (int p = middle; p + 1 < n; ++p) links.push_back(random_link(random, p, p + 1, 1e4));
        for (int p = middle; p > 0; --p) links.push_back(random_link(random, p, p - 1, 1e4));
        return links;
    });
}

TEST(GaussSeidelSprings, EqualsGslInRandomNets) {
    expect_gsl<GaussSeidelSprings<255>>(3, [](std::mt19937_64& random, int n) {
        std::vector<Link> links = {random_link(random, int(random() % unsigned(n)), -1, 10)};
        for (unsigned count = 0; count < most; ++count) {
            const int a = int(random() % unsigned(n));
            const int b = (a + 1 + int(random() % unsigned(n - 1))) % n;
            links.push_back(random_link(random, a, b, 10));
        }
        return links;
    });
}

// One iteration solves springs one after the other.
TEST(GaussSeidelSprings, AreImplicitSpringsInOneIteration) {
    WorldOfSprings<double, GaussSeidelSprings<1>> one;
    WorldOfSprings<double, ImplicitSprings> other;
    hang(one, 8, 20000, 30);
    hang(other, 8, 20000, 30);
    for (int step = 0; step < 256; ++step) {
        one.step(BinaryStep<8>());
        other.step(BinaryStep<8>());
    }
    const auto a = runs::state_of(std::as_const(one)), b = runs::state_of(std::as_const(other));
    for (std::size_t p = 0; p < a.size(); ++p) {
        EXPECT_NEAR(a[p].position[1], b[p].position[1], 1e-9);
        EXPECT_NEAR(a[p].velocity[1], b[p].velocity[1], 1e-9);
    }
}

// A uniform chain of n springs has the frequencies omega_j = 2 sqrt(k / m) sin((2 j - 1) pi / (4 n
// + 2)). A step is linear along the chain, so that steps from unit vectors are its matrix. Returns
// the eigenvalues above the real axis, by rising angle, next to the frequencies times the step.
template <class Integrator>
std::vector<std::pair<std::complex<double>, double>> modes(double k) {
    constexpr unsigned n = 6;
    constexpr double h = 1.0 / 256;
    std::vector<double> matrix(4 * n * n);
    for (unsigned column = 0; column < 2 * n; ++column) {
        WorldOfSprings<double, Integrator> world;
        typename WorldOfSprings<double, Integrator>::Handle last;
        const double unit = 0x1p-10;  // keeps the springs' directions
        for (unsigned i = 0; i < n; ++i) {
            typename WorldOfSprings<double, Integrator>::Body body;
            body.inverse_mass = 1;
            body.position = {i + 1 + (column == i ? unit : 0), 0.0};
            body.velocity = {column == n + i ? unit : 0, 0.0};
            const auto next = world.add_particle(body);
            if (i == 0) {
                world.add_anchored_spring(next, {0.0, 0.0}, k, 0, 1);
            } else {
                world.add_spring(next, last, k, 0, 1);
            }
            last = next;
        }
        world.step(BinaryStep<8>());
        for (unsigned i = 0; i < n; ++i) {
            const auto& body = std::as_const(world).particles()[std::uint8_t(i)];
            matrix[2 * n * i + column] = (body.position[0] - (i + 1)) / unit;
            matrix[2 * n * (n + i) + column] = body.velocity[0] / unit;
        }
    }
    const std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> space(
        gsl_eigen_nonsymm_alloc(2 * n), gsl_eigen_nonsymm_free);
    const std::unique_ptr<gsl_vector_complex, decltype(&gsl_vector_complex_free)> values(
        gsl_vector_complex_alloc(2 * n), gsl_vector_complex_free);
    gsl_matrix_view view = gsl_matrix_view_array(matrix.data(), 2 * n, 2 * n);
    gsl_eigen_nonsymm(&view.matrix, values.get(), space.get());
    std::vector<std::complex<double>> above;
    for (unsigned i = 0; i < 2 * n; ++i) {
        const gsl_complex value = gsl_vector_complex_get(values.get(), i);
        if (GSL_IMAG(value) > 0) above.emplace_back(GSL_REAL(value), GSL_IMAG(value));
    }
    EXPECT_EQ(above.size(), n);
    std::sort(above.begin(), above.end(), [](auto a, auto b) { return std::arg(a) < std::arg(b); });
    std::vector<std::pair<std::complex<double>, double>> found;
    for (unsigned j = 0; j < above.size(); ++j)
        found.emplace_back(
            above[j],
            2 * std::sqrt(k) * std::sin((2 * j + 1) * std::numbers::pi / (4 * n + 2)) * h);
    return found;
}

// By 1 / (1 - i omega h), from a resolved mode to one of omega h = 10.
TEST(DirectSprings, DampsEachModeAsImplicitEuler) {
    for (const auto& [value, product] : modes<DirectSprings>(1.6e6)) {
        EXPECT_NEAR(std::abs(value), 1 / std::hypot(1, product), 1e-8);
        EXPECT_NEAR(std::arg(value), std::atan(product), 1e-8);
    }
}
// By (1 + i omega h / 2) / (1 - i omega h / 2): no mode loses energy.
TEST(ImplicitMidpoint, KeepsTheEnergyOfEachMode) {
    for (const auto& [value, product] : modes<ImplicitMidpoint>(1.6e6)) {
        EXPECT_NEAR(std::abs(value), 1, 1e-8);
        EXPECT_NEAR(std::arg(value), 2 * std::atan(product / 2), 1e-8);
    }
}

// A chain in balance stays where it is. Solved one after the other, its springs give way. In Q16.16
// the heavy end's share of a change is 66 ulp: half an ulp of it is as much of the extension.
TEST(DirectSprings, HoldsAThousandTimesTheMassWhereItHangs) {
    for (const unsigned links : {2u, 4u, 8u, 16u}) {
        EXPECT_LT((drift<double, DirectSprings>(links, 30000, 1000)), 1e-9);
        EXPECT_LT((drift<Fixed<32, 32>, DirectSprings>(links, 30000, 1000)), 1e-5);
        EXPECT_LT((drift<Fixed<16, 16>, DirectSprings>(links, 30000, 1000)),
                  0.5 / 66 * links * 9810 / 30000);
        EXPECT_LT((drift<float, DirectSprings>(links, 30000, 1000)), 1e-3);
        EXPECT_LT((drift<double, ImplicitMidpoint>(links, 30000, 1000)), 1e-9);
        EXPECT_LT((drift<double, GaussSeidelSprings<20>>(links, 30000, 1000)), 1e-3);
        EXPECT_GT((drift<double, ImplicitSprings>(links, 30000, 1000)), 0.1);
    }
}

// Impulses are equal and opposite, except for the rounding of the share and of each end's change:
// at most 2 ulp for each of 7 springs in each step.
template <class Scalar, class Integrator>
void expect_momentum(double within) {
    WorldOfSprings<Scalar, Integrator> world;
    typename WorldOfSprings<Scalar, Integrator>::Body body;
    body.inverse_mass = 1_d;
    body.velocity = {0_d, 1_d};
    auto last = world.add_particle(body);
    body.velocity = {0_d, 0_d};
    for (int i = 1; i < 8; ++i) {
        body.position[0] += Scalar(0.5_d);
        const auto next = world.add_particle(body);
        world.add_spring(next, last, 20000_d, 2_d, 0.5_d);
        last = next;
    }
    for (int step = 0; step < 1024; ++step) world.step(BinaryStep<8>());
    double x = 0, y = 0;
    for (const auto& particle : std::as_const(world).particles()) {
        x += runs::to_double(particle.velocity[0]);
        y += runs::to_double(particle.velocity[1]);
    }
    EXPECT_NEAR(x, 0, within);
    EXPECT_NEAR(y, 1, within);
}
TEST(DirectSprings, KeepsTheMomentumOfAFreeChain) {
    expect_momentum<double, DirectSprings>(1e-11);
    expect_momentum<Fixed<32, 32>, DirectSprings>(std::ldexp(2.0 * 7 * 1024, -32));
    expect_momentum<Fixed<16, 16>, DirectSprings>(std::ldexp(2.0 * 7 * 1024, -16));
}
TEST(ImplicitMidpoint, KeepsTheMomentumOfAFreeChain) {
    expect_momentum<double, ImplicitMidpoint>(1e-11);
    expect_momentum<Fixed<16, 16>, ImplicitMidpoint>(std::ldexp(2.0 * 7 * 1024, -16));
}
// Bodies of equal mass receive the same product.
TEST(GaussSeidelSprings, KeepTheMomentumOfAFreeChainToTheLastBit) {
    expect_momentum<Fixed<16, 16>, GaussSeidelSprings<10>>(0);
}

// A spring alone moves as with ImplicitSprings, up to rounding: the velocity is multiplied by 1 - 1
// / d, which is within an ulp, and not divided by d.
TEST(DirectSprings, SolvesASpringAloneAsImplicitSprings) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto after = [](auto world, double x, double y, double u, double k, double c) {
        using Scalar = typename decltype(world)::Scalar;
        const auto number = [](double of) { return runs::Rounded<Scalar>::of(of); };
        typename decltype(world)::Body body;
        body.position = {number(x), number(y)};
        body.velocity = {number(u), number(-u / 2)};
        body.inverse_mass = 1_d;
        world.add_anchored_spring(world.add_particle(body), {0_d, 0_d}, number(k), number(c), 1_d);
        world.step(BinaryStep<8>());
        const auto& velocity = std::as_const(world).particles()[0].velocity;
        return Plain{runs::to_double(velocity[0]), runs::to_double(velocity[1])};
    };
    for (int round = 0; round < 1000; ++round) {
        const double x = 2 + uniform(random), y = uniform(random), u = 10 * uniform(random),
                     k = std::pow(10, 2 + 2 * uniform(random)),
                     c = round % 2 == 0 ? 0 : std::pow(10, 2 * uniform(random));
        const auto expect_near = [&](auto one, auto other, double within) {
            const Plain direct = after(one, x, y, u, k, c), alone = after(other, x, y, u, k, c);
            EXPECT_NEAR(direct[0], alone[0], within);
            EXPECT_NEAR(direct[1], alone[1], within);
        };
        expect_near(WorldOfSprings<double>(), WorldOfSprings<double, ImplicitSprings>(), 1e-11);
        expect_near(WorldOfSprings<Fixed<16, 16>>(),
                    WorldOfSprings<Fixed<16, 16>, ImplicitSprings>(),
                    (3 + 1.12 * std::abs(u)) * 0x1p-16);
    }
}

TEST(DirectSprings, ReportsSpringsThatDoNotFormAChain) {
    WorldOfSprings<double> world;
    WorldOfSprings<double>::Body body;
    body.inverse_mass = 1_d;
    const auto a = world.add_particle(body);
    body.position = {1_d, 0_d};
    const auto b = world.add_particle(body);
    body.position = {0_d, 1_d};
    const auto c = world.add_particle(body);
    world.add_spring(a, b, 10_d, 0_d, 1_d);
    world.add_spring(c, a, 10_d, 0_d, 1_d);
    world.step(BinaryStep<8>());
    EXPECT_EQ(world.error(), Error::none);
    world.add_spring(b, c, 10_d, 0_d, 1_d);
    world.step(BinaryStep<8>());
    EXPECT_EQ(world.error(), Error::no_chain);
}
