// SPDX-License-Identifier: MIT
// DirectRods, compared with what Newton's third law and the rods require, solved by GSL; with
// closed forms and conserved quantities where masses are far apart; and with rods that do not form
// a chain.
#include <gsl/gsl_linalg.h>

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "runs.hpp"

using namespace engine;
using namespace scenes;

namespace {

constexpr unsigned most = 17;

struct Rods : Uses {
    static constexpr unsigned particles = most, anchored_rods = 2, rods = most;
    static constexpr bool gravity = true;
    using Solver = DirectRods;
};
template <class Scalar, class OfUses = Rods>
using WorldOfRods = World<Scalar, OfUses>;

// A rod between two particles, or from one to a fixed point.
struct Link {
    int a, b;  // b < 0: to the anchor
};
using Plain = std::array<double, 2>;
double dot(Plain a, Plain b) { return a[0] * b[0] + a[1] * b[1]; }

using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
using Column = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;

// Velocities v' along unit vectors u_r for which u_r . (v'_a - v'_b) = target_r, when impulses
// along the u_r act between the ends: the matrix of all rows, by LU decomposition.
std::vector<Plain> velocities_by_gsl(const std::vector<Link>& links, std::vector<Plain> v,
                                     const std::vector<Plain>& unit,
                                     const std::vector<double>& inverse_mass,
                                     const std::vector<double>& target) {
    const std::size_t n = links.size();
    if (n == 0) return v;
    const auto sign = [&](std::size_t r, int p) {
        return (links[r].a == p ? 1 : 0) - (links[r].b == p ? 1 : 0);
    };
    Matrix matrix(gsl_matrix_alloc(n, n), gsl_matrix_free);
    Column missing(gsl_vector_alloc(n), gsl_vector_free),
        impulse(gsl_vector_alloc(n), gsl_vector_free);
    for (std::size_t r = 0; r < n; ++r) {
        double velocity = 0;
        for (std::size_t p = 0; p < v.size(); ++p) velocity += sign(r, int(p)) * dot(unit[r], v[p]);
        gsl_vector_set(missing.get(), r, target[r] - velocity);
        for (std::size_t c = 0; c < n; ++c) {
            double element = 0;
            for (std::size_t p = 0; p < v.size(); ++p)
                element += sign(r, int(p)) * sign(c, int(p)) * inverse_mass[p];
            gsl_matrix_set(matrix.get(), r, c, element * dot(unit[r], unit[c]));
        }
    }
    const std::unique_ptr<gsl_permutation, decltype(&gsl_permutation_free)> order(
        gsl_permutation_alloc(n), gsl_permutation_free);
    int signum;
    gsl_linalg_LU_decomp(matrix.get(), order.get(), &signum);
    gsl_linalg_LU_solve(matrix.get(), order.get(), missing.get(), impulse.get());
    for (std::size_t r = 0; r < n; ++r)
        for (std::size_t p = 0; p < v.size(); ++p)
            for (int i = 0; i < 2; ++i)
                v[p][i] += sign(r, int(p)) * inverse_mass[p] * unit[r][i] *
                           gsl_vector_get(impulse.get(), r);
    return v;
}

// Bodies of 1 kg below each other on rods of 0.5 m, the last with another mass, pushed sideways.
template <class Scalar>
void hang(WorldOfRods<Scalar>& world, unsigned links, Scalar last_inverse_mass) {
    using namespace engine::literals;
    world.gravity = {0_d, -9.81_d};
    typename WorldOfRods<Scalar>::Body body;
    body.inverse_mass = 1_d;
    typename WorldOfRods<Scalar>::Handle last;
    for (unsigned i = 0; i < links; ++i) {
        body.position[1] -= Scalar(0.5_d);
        if (i + 1 == links) {
            body.inverse_mass = last_inverse_mass;
            body.velocity[0] = 0.5_d;
        }
        const auto next = world.add_particle(body);
        if (i == 0) {
            world.add_anchored_rod(next, {0_d, 0_d}, 0.5_d);
        } else {
            world.add_rod(next, last, 0.5_d);
        }
        last = next;
    }
}

template <class Scalar>
double stretch(const WorldOfRods<Scalar>& world) {
    double largest = 0;
    const auto look = [&](const auto& rod) {
        const auto d = rod.ends.difference(world);
        const double distance = std::hypot(runs::to_double(d[0]), runs::to_double(d[1]));
        largest = std::max(largest, std::abs(distance / runs::to_double(rod.length) - 1));
    };
    world.rods().for_each(look);
    world.anchored_rods().for_each(look);
    return largest;
}

// The energy in J; the potential energy is 0 where the chain hangs.
template <class Scalar>
double energy(const WorldOfRods<Scalar>& world) {
    double sum = 0;
    for (std::size_t i = 0; i < world.particles().size(); ++i) {
        const auto& p = world.particles()[i];
        const double vx = runs::to_double(p.velocity[0]), vy = runs::to_double(p.velocity[1]);
        sum += ((vx * vx + vy * vy) / 2 + 9.81 * (runs::to_double(p.position[1]) + 0.5 * (i + 1))) /
               runs::to_double(p.inverse_mass);
    }
    return sum;
}

template <class Scalar, int K>
void expect_held(unsigned links, Scalar last_inverse_mass, double by) {
    WorldOfRods<Scalar> world;
    hang(world, links, last_inverse_mass);
    const double start = energy(world);
    double largest = 0, max_energy = 0;
    for (int step = 0; step < 4 << K; ++step) {
        world.step(BinaryStep<K>());
        largest = std::max(largest, stretch(world));
        max_energy = std::max(max_energy, energy(world));
    }
    EXPECT_EQ(world.error(), Error::none);
    EXPECT_LT(largest, by) << links << " links";
    EXPECT_LT(max_energy, 1.1 * start) << links << " links";
}

}  // namespace

TEST(DirectRods, EqualsGslInRandomChains) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int round = 0; round < 500; ++round) {
        WorldOfRods<double> world;
        const int n = 2 + int(random() % (most - 1));
        std::vector<Plain> position(n), velocity(n);
        std::vector<double> inverse_mass(n);
        for (int p = 0; p < n; ++p) {
            position[p] = {p + 0.8 * uniform(random), 2 * uniform(random)};
            velocity[p] = {3 * uniform(random), 3 * uniform(random)};
            // Anything from 1 g to 1 t, and sometimes an immovable particle.
            inverse_mass[p] = random() % 8 == 0 ? 0 : std::pow(1000, uniform(random));
            WorldOfRods<double>::Body body;
            body.position = {position[p][0], position[p][1]};
            body.velocity = {velocity[p][0], velocity[p][1]};
            body.inverse_mass = inverse_mass[p];
            if (inverse_mass[p] == 0) velocity[p] = {0, 0}, body.velocity = {0.0, 0.0};
            world.add_particle(body);
        }
        // From a particle in the middle to both ends, with the rods' ends swapped at random.
        const int middle = int(random() % n);
        std::vector<Link> links;
        if (random() % 2 == 0 && inverse_mass[middle] > 0 && (middle == 0 || middle == n - 1))
            links.push_back({middle, -1});
        for (int p = middle; p + 1 < n; ++p) links.push_back({p, p + 1});
        for (int p = middle; p > 0; --p) links.push_back({p, p - 1});
        std::vector<Plain> unit;
        std::vector<double> target;
        std::vector<Link> between;
        for (Link& link : links) {
            if (link.b >= 0 && random() % 2 == 0) std::swap(link.a, link.b);
            const Plain anchor = {0.25, 3};
            const Plain from = link.b < 0 ? anchor : position[link.b];
            const Plain of_b = link.b < 0 ? Plain{0, 0} : velocity[link.b];
            const Plain d = {position[link.a][0] - from[0], position[link.a][1] - from[1]};
            const Plain w = {velocity[link.a][0] - of_b[0], velocity[link.a][1] - of_b[1]};
            const double distance = std::hypot(d[0], d[1]);
            if (link.b < 0) {
                world.add_anchored_rod(std::uint8_t(link.a), {anchor[0], anchor[1]}, distance);
            } else {
                world.add_rod(std::uint8_t(link.a), std::uint8_t(link.b), distance);
            }
            // Two immovable ends have no effect, and GSL no row for them.
            if (inverse_mass[link.a] == 0 && (link.b < 0 || inverse_mass[link.b] == 0)) continue;
            between.push_back(link);
            unit.push_back({d[0] / distance, d[1] / distance});
            target.push_back(-dot(w, w) / 256 / (2 * distance));
        }
        world.step(BinaryStep<8>());
        ASSERT_EQ(world.error(), Error::none);
        const auto expected = velocities_by_gsl(between, velocity, unit, inverse_mass, target);
        for (int p = 0; p < n; ++p)
            for (int i = 0; i < 2; ++i)
                ASSERT_NEAR(world.particles()[p].velocity[i], expected[p][i], 1e-8)
                    << "round " << round << ", particle " << p << " of " << n;
    }
}

TEST(DirectRods, MakesVerletOfSecondOrder) {
    EXPECT_NEAR((runs::error<DoublePendulum, Direct, double, 10>() /
                 runs::error<DoublePendulum, Direct, double, 11>()),
                4, 0.6);
    EXPECT_NEAR((runs::error<ChainOfRods, Direct, double, 10>() /
                 runs::error<ChainOfRods, Direct, double, 11>()),
                4, 0.6);
}

// A light particle of mass m under the tension R m g swings across two rods of length L with at
// most omega^2 = 4 R g / L, which a step resolves up to omega h = 2: at 2^-8 s up to R = 3340.
TEST(DirectRods, HoldsAThousandTimesTheMass) {
    using namespace engine::literals;
    for (unsigned links : {2u, 4u, 8u, 16u}) {
        expect_held<Fixed<16, 16>, 8>(links, 0.001_d, 0.01);
        expect_held<Fixed<32, 32>, 8>(links, 0.001_d, 0.01);
        expect_held<float, 8>(links, 0.001_d, 0.01);
    }
}

// At 2^-11 s up to R = 213,000.
TEST(DirectRods, HoldsAHundredThousandTimesTheMassInSmallSteps) {
    using namespace engine::literals;
    for (unsigned links : {2u, 4u, 8u, 16u}) {
        expect_held<Fixed<32, 32>, 11>(links, 0.00001_d, 0.01);
        expect_held<float, 11>(links, 0.00001_d, 0.01);
    }
}

// Impulses are equal and opposite, except for the rounding of the share and of each end's change:
// at most 2 ulp for each of 7 rods in each step.
template <class Scalar>
void expect_momentum(double within) {
    using namespace engine::literals;
    WorldOfRods<Scalar> world;
    typename WorldOfRods<Scalar>::Body body;
    body.inverse_mass = 1_d;
    body.velocity = {0_d, 1_d};
    auto last = world.add_particle(body);
    body.velocity = {0_d, 0_d};
    for (int i = 1; i < 8; ++i) {
        body.position[0] += Scalar(0.5_d);
        const auto next = world.add_particle(body);
        world.add_rod(next, last, 0.5_d);
        last = next;
    }
    for (int step = 0; step < 1024; ++step) world.step(BinaryStep<8>());
    double x = 0, y = 0;
    const auto& as_it_is = world;
    for (const auto& particle : as_it_is.particles()) {
        x += runs::to_double(particle.velocity[0]);
        y += runs::to_double(particle.velocity[1]);
    }
    EXPECT_NEAR(x, 0, within);
    EXPECT_NEAR(y, 1, within);
}
TEST(DirectRods, KeepsTheMomentumOfAFreeChain) {
    expect_momentum<double>(1e-11);
    expect_momentum<Fixed<32, 32>>(std::ldexp(2.0 * 7 * 1024, -32));
    expect_momentum<Fixed<16, 16>>(std::ldexp(2.0 * 7 * 1024, -16));
}

TEST(DirectRods, ReportsRodsThatDoNotFormAChain) {
    using namespace engine::literals;
    WorldOfRods<double> world;
    WorldOfRods<double>::Body body;
    body.inverse_mass = 1_d;
    const auto a = world.add_particle(body);
    body.position = {1_d, 0_d};
    const auto b = world.add_particle(body);
    body.position = {0_d, 1_d};
    const auto c = world.add_particle(body);
    world.add_rod(a, b, 1_d);
    world.add_rod(c, a, 1_d);
    world.step(BinaryStep<8>());
    EXPECT_EQ(world.error(), Error::none);
    world.add_rod(b, c, std::sqrt(2.0));
    world.step(BinaryStep<8>());
    EXPECT_EQ(world.error(), Error::no_chain);
}
