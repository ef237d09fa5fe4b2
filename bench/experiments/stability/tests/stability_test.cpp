// SPDX-License-Identifier: GPL-3.0-or-later
// The battery, compared with theory and with what the engine promises for random scenes.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <scenes/all.hpp>
#include <set>

#include "bench/experiments/stability/measures.hpp"
#include "bench/experiments/stability/prediction.hpp"
#include "bench/experiments/stability/scene_description.hpp"
#include "bench/experiments/stability/search.hpp"
#include "bench/experiments/stability/tests/three_bytes.hpp"
#include "bench/experiments/stability/world_of.hpp"

namespace stability {
namespace {

const Effort fine{1, 14, 20000};

Finding find(const std::string& name, const std::string& scalar, const std::string& integrator,
             const std::string& arithmetic = "nearest") {
    return find_limit(case_named(name), subject(scalar, arithmetic, integrator), fine);
}

TEST(Recording, SaturatingReturnsWhatSaturatingReturnsAndReportsWhatSaturated) {
    using S = fixedpoint::Saturating;
    using R = RecordingSaturating;
    EXPECT_TRUE(rc::check([](const std::array<std::int16_t, 3>& a,
                             const std::array<std::int16_t, 3>& b) {
        const auto [x, y, z] = a;
        RC_ASSERT((R::add<std::int16_t, 8>(x, y)) == (S::add<std::int16_t, 8>(x, y)));
        RC_ASSERT((R::subtract<std::int16_t, 8>(x, y)) == (S::subtract<std::int16_t, 8>(x, y)));
        RC_ASSERT((R::negate<std::int16_t, 8>(x)) == (S::negate<std::int16_t, 8>(x)));
        RC_ASSERT((R::multiply<std::int16_t, 8>(x, y)) == (S::multiply<std::int16_t, 8>(x, y)));
        RC_ASSERT((R::divide<std::int16_t, 8>(x, y)) == (S::divide<std::int16_t, 8>(x, y)));
        RC_ASSERT((R::multiply_add<std::int16_t, 8>(x, y, z)) ==
                  (S::multiply_add<std::int16_t, 8>(x, y, z)));
        RC_ASSERT((R::dot2<std::int16_t, 8>(a.data(), b.data())) ==
                  (S::dot2<std::int16_t, 8>(a.data(), b.data())));
        RC_ASSERT((R::dot3<std::int16_t, 8>(a.data(), b.data())) ==
                  (S::dot3<std::int16_t, 8>(a.data(), b.data())));
        RC_ASSERT((R::shift_left<std::int16_t, 8>(x, 3)) == (S::shift_left<std::int16_t, 8>(x, 3)));
    }));
    Recorder recorder;
    const Recorded recorded(recorder);
    const std::int16_t most[2] = {32767, 32767};
    EXPECT_EQ((R::dot2<std::int16_t, 8>(most, most)), 32767);
    ASSERT_TRUE(recorder.first_saturation());
    EXPECT_EQ(recorder.first_saturation()->operation, fixedpoint::Operation::multiply);
    EXPECT_FALSE(recorder.first_failure());
}

TEST(Recorder, NamesEveryOperation) {
    using fixedpoint::Event, fixedpoint::Operation;
    EXPECT_EQ(to_text({Event::overflow, Operation::lerp, "position", 0}), "overflow lerp position");
    EXPECT_EQ(to_text({Event::underflow, Operation::power, "rod", 0}), "underflow power rod");
}

TEST(Battery, NamesAreUniqueAndRangesPositive) {
    std::set<std::string> names;
    for (const Case& one : all_cases()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_TRUE(one.from > 0 && one.to > 0 && one.from != one.to) << one.name;
    }
    EXPECT_GE(names.size(), 60u);
    EXPECT_GE(subjects().size(), 20u);
}

// The column `holds` of stability.csv: what a measure compares with, in words.
TEST(Battery, EveryCaseSaysWhatHolds) {
    for (const Case& one : all_cases())
        for (const double end : {one.from, one.to}) {
            const Experiment experiment = one.at(end);
            EXPECT_GT(experiment.measure.holds().size(), 10u) << one.name;
            EXPECT_GT(experiment.description.steps, 0u) << one.name;
            EXPECT_GT(experiment.description.dt.value(), 0) << one.name;
        }
    Description made;
    made.bodies = {{}};
    made.rods = {{.length = 2}};
    const Measure both = from_step(7, all_of({rods_hold(made, 0.05), stays_within(made, 0.25)}));
    EXPECT_EQ(both.holds(),
              "from step 7: rods within 5 % of their length; all within 0.25 m of "
              "the start");
    // At the tolerance that it states, each is 1.
    const State state = {{{2.1, 0}, {}}};
    EXPECT_NEAR(rods_hold(made, 0.05)(state, 7), 1, 1e-12);
    EXPECT_NEAR(stays_within(made, 2.1)(state, 7), 1, 1e-12);
    EXPECT_EQ(both(state, 6), 0);
    EXPECT_NEAR(both(state, 7), 2.1 / 0.25, 1e-12);
    EXPECT_EQ(has_velocity(0, {3, -4}, 2.5).holds(),
              "velocity of body 0 within 2.5 m/s of (3 -4) m/s");
    EXPECT_NEAR(has_velocity(0, {3, -4}, 2.5)(state, 1), 2, 1e-12);
}

class OmegaTimesStep : public testing::TestWithParam<std::pair<const char*, const char*>> {};

// Undamped: symplectic steps are stable up to omega dt = 2. (E. Hairer, C. Lubich, G. Wanner,
// Geometric Numerical Integration, 2006, I.1.)
TEST_P(OmegaTimesStep, EndsAtTwo) {
    const auto [scalar, integrator] = GetParam();
    const bool floating = std::string(scalar) == "float";
    const Finding found =
        find("spring_coarse_step", scalar, integrator, floating ? "ieee" : "nearest");
    EXPECT_NEAR(found.limit, 2, 0.02);
    EXPECT_TRUE(found.verdict == Verdict::drifts || found.verdict == Verdict::diverges);
}
INSTANTIATE_TEST_SUITE_P(Symplectic, OmegaTimesStep,
                         testing::Values(std::pair{"q16_16", "semi_implicit_euler"},
                                         std::pair{"q16_16", "velocity_verlet"},
                                         std::pair{"q32_32", "semi_implicit_euler"},
                                         std::pair{"q32_32", "velocity_verlet"},
                                         std::pair{"float", "semi_implicit_euler"},
                                         std::pair{"float", "velocity_verlet"}));

// The amplitude that the oscillation of one body of 1 kg on a spring reaches in that many steps.
double amplitude_after(const Subject& subject, double omega_dt, unsigned steps) {
    const double omega = omega_dt * 16;
    Description made;
    made.bodies = {{.position = {32.25, 0}}};
    made.springs = {{{.length = 32}, omega * omega, 0}};
    made.dt = TimeStep::binary(4);
    made.steps = steps;
    double amplitude = 0;
    attempt(subject, {made, [&](const State& state, unsigned) {
                          const double x = state[0].position.x - 32;
                          const double v = state[0].velocity.x / omega;
                          amplitude = std::hypot(x, v);
                          return 0.0;
                      }});
    return amplitude;
}

// Explicit Euler multiplies the amplitude by sqrt(1 + (omega dt)^2) per step, for every omega dt.
TEST(ExplicitEuler, GrowsForEveryStep) {
    const Subject& explicit_euler = subject("q32_32", "nearest", "explicit_euler");
    for (const double omega_dt : {0.01, 0.1, 0.5, 1.0}) {
        const unsigned steps = std::min(2000u, unsigned(4 / (omega_dt * omega_dt)));
        const double growth = std::pow(1 + omega_dt * omega_dt, steps / 2.0);
        EXPECT_NEAR(amplitude_after(explicit_euler, omega_dt, steps) / 0.25, growth, 0.01 * growth)
            << omega_dt;
        EXPECT_GT(growth, 1.05);
    }
}

TEST(ImplicitSprings, AreStableFarBeyondTheExplicitLimit) {
    EXPECT_EQ(find_limit(case_named("spring_coarse_step"),
                         subject("float", "ieee", "implicit_springs"), fine)
                  .verdict,
              Verdict::stable);
    EXPECT_DOUBLE_EQ(find("spring_coarse_step", "q32_32", "implicit_springs").limit, 1e4);
    // In Q16.16, up to the stiffness that the format holds.
    const Finding found = find("spring_coarse_step", "q16_16", "implicit_springs");
    EXPECT_EQ(found.first_event, "overflow convert stiffness");
    EXPECT_NEAR(found.limit, std::sqrt(32768.0) / 4, 0.5);
    EXPECT_EQ(find("spring_light_and_stiff", "q16_16", "implicit_springs").first_event,
              "overflow convert inverse_mass");
    EXPECT_EQ(find("spring_light_and_damped", "q16_16", "implicit_springs").first_event,
              "overflow convert inverse_mass");
}

TEST(Recorder, NamesOperationQuantityAndStep) {
    const Finding found = find("spring_extension", "q16_16", "semi_implicit_euler");
    EXPECT_EQ(found.verdict, Verdict::overflows);
    EXPECT_EQ(found.first_event, "overflow multiply spring_force");
    EXPECT_EQ(found.step, 1u);
    EXPECT_NEAR(found.limit, 32768.0 / 40, 2);  // stiffness times extension
}

TEST(Engine, DefaultOutlivesThePublishedByAHundredfoldStiffness) {
    const double published =
        find("spring_coarse_step", "q16_16", "explicit_euler", "published").limit;
    const double ours = find("spring_coarse_step", "q16_16", "semi_implicit_euler").limit;
    EXPECT_GT(ours * ours, 100 * published * published);
}

TEST(Engine, ResidualsMoveWhatRoundingStops) {
    const double rounded = find("slow", "q16_16", "semi_implicit_euler").limit;
    const double carried = find("slow", "q16_16", "semi_implicit_compensated").limit;
    EXPECT_LT(carried, rounded / 100);
}

// At the cost of ten iterations or less (ablations.csv), a chain bears 1,000 times its links' mass
// in Q16.16, and 100,000 times in Q32.32 and float in steps that resolve the vibration of a link
// under that weight. What is compared is exact: the lengths of the rods, and the energy, which may
// not grow by a tenth of that of the push sideways. Iterations that begin from nothing in the first
// step let the chain stretch within the tolerance of the case; the direct solution does not.
TEST(LoadedChains, BearAThousandAndAHundredThousandTimesTheirMass) {
    const struct {
        const char* integrator;
        double stretch;
    } methods[] = {{"warm_started", 0.1}, {"direct_rods", 0.002}};
    const struct {
        const char *scalar, *arithmetic, *steps;
        double ratio;
    } goals[] = {{"q16_16", "nearest", "", 1e3},
                 {"q32_32", "nearest", "", 1e3},
                 {"float", "ieee", "", 1e3},
                 {"q32_32", "nearest", "_fine_steps", 1e5},
                 {"float", "ieee", "_fine_steps", 1e5}};
    for (const auto& goal : goals)
        for (const unsigned links : {4u, 8u, 16u})
            for (const auto& method : methods) {
                const Case& one =
                    case_named("rod_chain_of_" + std::to_string(links) + "_heavy_end" + goal.steps);
                const Description made = one.at(goal.ratio).description;
                const double push = goal.ratio * 0.5 * 0.5 / 2;  // J
                const Trial trial =
                    attempt(subject(goal.scalar, goal.arithmetic, method.integrator),
                            {made, all_of({rods_hold(made, method.stretch),
                                           energy_does_not_grow(made, 0.1, push)})});
                EXPECT_TRUE(trial.held)
                    << goal.scalar << ' ' << one.name << ' ' << method.integrator << ", step "
                    << trial.failed_step << ", " << trial.worst;
                EXPECT_EQ(trial.outcome.steps, made.steps);
            }
}

// Ten iterations that begin anew in each step do not; and no step bears more than the theory of its
// vibration allows: alternate links between the anchor and a weight that hardly moves oscillate
// with omega^2 = 2 (1 + cos(pi / n)) R g / L, and a step is stable up to omega h = 2.
TEST(LoadedChains, EndWhereTheStepNoLongerResolvesTheVibrationOfALink) {
    constexpr double pi = 3.14159265358979323846, g = 9.81, length = 0.5;
    for (const unsigned links : {4u, 8u, 16u})
        for (const int exponent : {8, 11}) {
            const double dt = std::ldexp(1, -exponent);
            const double bound = 2 * length / (g * dt * dt * (1 + std::cos(pi / links)));
            const std::string name = "rod_chain_of_" + std::to_string(links) + "_heavy_end" +
                                     (exponent == 8 ? "" : "_fine_steps");
            const double direct = find(name, "q32_32", "direct_rods").limit;
            const double warm = find(name, "q32_32", "warm_started").limit;
            const double cold = find(name, "q32_32", "semi_implicit_euler").limit;
            EXPECT_GT(direct, 0.9 * bound) << name;
            EXPECT_LT(direct, 1.2 * bound) << name;
            EXPECT_GT(warm, 0.5 * bound) << name;
            EXPECT_LT(warm, 1.2 * bound) << name;
            EXPECT_LT(cold, 0.02 * bound) << name;
        }
}

// Stiff springs that are solved together end there, too. Solved one after the other they give way
// long before, and ten iterations reach most of the way.
TEST(LoadedChains, OfSpringsEndWhereTheStepNoLongerResolvesTheVibrationOfALink) {
    constexpr double pi = 3.14159265358979323846, g = 9.81, length = 0.5, dt = 1.0 / 256;
    for (const unsigned links : {4u, 16u}) {
        const double bound = 2 * length / (g * dt * dt * (1 + std::cos(pi / links)));
        const std::string name = "spring_chain_of_" + std::to_string(links) + "_heavy_end";
        for (const char* method : {"direct_springs", "implicit_midpoint"}) {
            const double together = find(name, "q32_32", method).limit;
            EXPECT_GT(together, 0.9 * bound) << name << ' ' << method;
            EXPECT_LT(together, 1.2 * bound) << name << ' ' << method;
        }
        EXPECT_GT(find(name, "q32_32", "gauss_seidel_springs").limit, 0.5 * bound) << name;
        EXPECT_LT(find(name, "q32_32", "implicit_springs").limit, 0.12 * bound) << name;
    }
}

// Its world has nothing else, and says so instead of leaving it out.
TEST(LoadedChains, DirectRodsRefuseADescriptionWithMoreThanRods) {
    Description made;
    made.bodies = {{.position = {3, 0}}};
    made.springs = {{{.length = 2}, 50, 0}};
    EXPECT_THROW(attempt(subject("q16_16", "nearest", "direct_rods"),
                         {made, [](const State&, unsigned) { return 0.0; }}),
                 std::logic_error);
}

// Pools filled to their capacity, and beyond it by one, in every subject.
TEST(Engine, ReportsFullPools) {
    const Measure anything = [](const State&, unsigned) { return 0.0; };
    Description bodies;
    for (int i = 0; i < 20; ++i) bodies.bodies.push_back({.position = {4.0 * i, 0}});
    bodies.dt = TimeStep::binary(8);
    bodies.steps = 1;
    // The capacity of each kind, and what adds element number i.
    const struct {
        const char* kind;
        int capacity;
        std::function<void(Description&, int)> add;
    } pools[] = {
        {"particles", 0, [](Description& d, int) { d.bodies.push_back({}); }},
        {"springs", 17,
         [](Description& d, int i) {
             d.springs.push_back({{.a = i % 17, .b = i % 17 + 1, .length = 4}, 1, 0});
         }},
        {"anchored springs", 2,
         [](Description& d, int i) {
             d.springs.push_back({{.a = i}, 0.01, 0});
         }},
        {"drags", 2,
         [](Description& d, int i) {
             d.drags.push_back({i, 0.1, 0});
         }},
        {"rods", 16,
         [](Description& d, int i) { d.rods.push_back({.a = i, .b = i + 1, .length = 4}); }},
        {"anchored rods", 6,
         [](Description& d, int i) {
             d.rods.push_back({.a = i, .anchor = {4.0 * i, 1}, .length = 1});
         }},
        {"ropes", 16,
         [](Description& d, int i) {
             d.ropes.push_back({{.a = i, .b = i + 1, .length = 5}, 0});
         }},
        {"anchored ropes", 2,
         [](Description& d, int i) {
             d.ropes.push_back({{.a = i, .length = 100}, 0});
         }},
        {"planes", 4,
         [](Description& d, int) {
             d.planes.push_back({{0, 1}, -100, 0});
         }},
    };
    for (const auto& [kind, capacity, add] : pools) {
        Description full = bodies;
        for (int i = 0; i < capacity; ++i) add(full, i);
        Description more = full;
        add(more, capacity);
        for (const Subject& one : subjects()) {
            EXPECT_EQ(attempt(one, {full, anything}).outcome.error, "") << kind;
            const Trial refused = attempt(one, {more, anything});
            EXPECT_FALSE(refused.held) << kind;
            EXPECT_EQ(refused.outcome.error,
                      "a pool is full: raise the capacity that the scene states")
                << kind;
        }
    }
    // Contacts are found in a step.
    for (int i = 0; i < 20; ++i) {
        bodies.bodies[std::size_t(i)].position = {0.01 * i, 0};
        bodies.bodies[std::size_t(i)].radius = 1;
    }
    for (const Subject& one : subjects()) {
        const Trial full = attempt(one, {bodies, anything});
        EXPECT_FALSE(full.held);
        EXPECT_EQ(full.outcome.error, "more contacts in a step than the scene states");
    }
}

// An ablation changes one thing: what it does not touch moves as before.
TEST(Ablations, LeaveEverythingElseAsItIs) {
    const auto ends_at = [](const Description& made, const char* method,
                            const char* arithmetic = "nearest") {
        State last;
        attempt(subject("q16_16", arithmetic, method), {made, [&](const State& state, unsigned) {
                                                            last = state;
                                                            return 0.0;
                                                        }});
        std::vector<double> numbers;
        for (const BodyState& body : last)
            for (const double x :
                 {body.position.x, body.position.y, body.velocity.x, body.velocity.y})
                numbers.push_back(x);
        return numbers;
    };
    Description springs;
    springs.bodies = {{.position = {3, 0.25}, .velocity = {0, 1}}};
    springs.springs = {{{.length = 2}, 50, 0.5}};
    springs.gravity = {0, -9.81};
    springs.dt = TimeStep::binary(8);
    springs.steps = 300;
    Description bounces = springs, rods = springs;
    bounces.springs.clear();
    bounces.restitution = 0.5;
    bounces.planes = {{{0, 1}, 0, 0.5}};
    rods.springs.clear();
    rods.rods = {{.length = 3}};
    Description still = rods;  // where chord and tangent are one
    still.bodies[0] = {.position = {0, -3}};

    const char* ours = "semi_implicit_euler";
    const auto on_springs = ends_at(springs, ours), bouncing = ends_at(bounces, ours),
               on_rods = ends_at(rods, ours);
    for (const char* solver :
         {"worst_contact_first", "rods_as_opposed_contacts", "rods_along_tangents",
          "bounces_when_found", "velocities_by_impulses"})
        EXPECT_EQ(ends_at(springs, solver), on_springs) << solver;
    for (const char* of_rods : {"rods_as_opposed_contacts", "rods_along_tangents"}) {
        EXPECT_EQ(ends_at(bounces, of_rods), bouncing) << of_rods;
        EXPECT_NE(ends_at(rods, of_rods), on_rods) << of_rods;
    }
    EXPECT_EQ(ends_at(still, "rods_along_tangents"), ends_at(still, ours));
    EXPECT_EQ(ends_at(rods, "bounces_when_found"), on_rods);
    EXPECT_NE(ends_at(bounces, "bounces_when_found"), bouncing);
    EXPECT_EQ(ends_at(rods, "implicit_springs"), on_rods);
    EXPECT_NE(ends_at(springs, "implicit_springs"), on_springs);
    EXPECT_NE(ends_at(springs, "positions_first"), on_springs);
}

// The world that has everything moves like the one that has only what its scene states.
TEST(Everything, MovesAsTheSceneItself) {
    unsigned compared = 0;
    scenes::for_each_scene([&](auto scene) {
        using Scene = decltype(scene);
        using Uses = typename Scene::template Uses<scenes::SemiImplicit>;
        if constexpr (Uses::dimensions == 2) {
            engine::World<fixedpoint::Q16_16, Uses> world;
            scenes::build<Scene>(world);
            Description made = describe_scene(Scene::name, 8);
            made.steps = 400;
            // A scene may sum positions in its own scalar.
            for (std::size_t i = 0; i < made.bodies.size(); ++i) {
                const auto& position = world.particles()[i].position;
                made.bodies[i].position = {to_double(position[0]), to_double(position[1])};
            }
            unsigned differing = 0;
            attempt(subject("q16_16", "nearest", "semi_implicit_euler"),
                    {made, [&](const State& state, unsigned step) {
                         if (step > 0) world.step(engine::BinaryStep<8>());
                         for (std::size_t i = 0; i < state.size(); ++i) {
                             const auto& position = world.particles()[i].position;
                             if (to_double(position[0]) != state[i].position.x ||
                                 to_double(position[1]) != state[i].position.y)
                                 ++differing;
                         }
                         return 0.0;
                     }});
            EXPECT_EQ(differing, 0u) << Scene::name;
            ++compared;
        }
    });
    EXPECT_GE(compared, 10u);
}

// AnyFormat computes as Fixed does.
template <class Number>
void expect_the_same(std::int64_t a_raw, std::int64_t b_raw, std::int64_t c_raw) {
    using Raw = typename Number::Raw;
    AnyFormat::split() = {Number::integer_bits, Number::fraction_bits};
    const Number a = Number::from_raw(static_cast<Raw>(a_raw));
    const Number b = Number::from_raw(static_cast<Raw>(b_raw));
    const Number c = Number::from_raw(static_cast<Raw>(c_raw));
    const auto any = [](Number x) { return AnyFormat::from_raw(x.raw()); };
    RC_ASSERT((any(a) + any(b)).raw() == (a + b).raw());
    RC_ASSERT((any(a) - any(b)).raw() == (a - b).raw());
    RC_ASSERT((-any(a)).raw() == (-a).raw());
    RC_ASSERT((any(a) * any(b)).raw() == (a * b).raw());
    RC_ASSERT((any(a) / any(b)).raw() == (a / b).raw());
    RC_ASSERT(engine::multiply_add(any(a), any(b), any(c)).raw() ==
              engine::multiply_add(a, b, c).raw());
    RC_ASSERT(saturating_sum(any(a), any(b)).raw() == engine::saturating_sum(a, b).raw());
    RC_ASSERT(saturating_product(any(a), any(b)).raw() == engine::saturating_product(a, b).raw());
    RC_ASSERT(scaled_down(any(a), 5).raw() == fixedpoint::scale_down<5>(a).raw());
    const Number first[] = {a, b}, second[] = {c, a};
    const AnyFormat any_first[] = {any(a), any(b)}, any_second[] = {any(c), any(a)};
    RC_ASSERT(dot<2>(any_first, any_second).raw() == engine::dot<2>(first, second).raw());
    const auto apart = length<2>(any_first).raw() - engine::length<2>(first).raw();
    RC_ASSERT(apart >= -1 && apart <= 1);
}
TEST(AnyFormat, ComputesAsFixedDoes) {
    EXPECT_TRUE(rc::check([](std::int64_t a, std::int64_t b, std::int64_t c, unsigned char shift) {
        // Of all magnitudes.
        a >>= shift % 64;
        b >>= shift / 5 % 64;
        c >>= shift / 7 % 64;
        expect_the_same<fixedpoint::Q8_8>(a, b, c);
        expect_the_same<fixedpoint::Q8_16>(a, b, c);
        expect_the_same<fixedpoint::Q12_12>(a, b, c);
        expect_the_same<fixedpoint::Fixed<3, 21>>(a, b, c);
        expect_the_same<fixedpoint::Q16_16>(a, b, c);
        expect_the_same<fixedpoint::Fixed<8, 24>>(a, b, c);
        expect_the_same<fixedpoint::Q32_32>(a, b, c);
    }));
}

// Of the cases that compute no roots, at both ends and between them: the same motion, bit for bit,
// up to where a result wraps, and the same verdict on whether one does.
TEST(AnyFormat, MovesAsFixedDoes) {
    unsigned compared = 0, wrapped = 0, wrapped_in_three_bytes = 0;
    const std::vector<Subject> of_three_bytes = subjects_of_three_bytes();
    for (const Case& one : all_cases()) {
        std::vector<const Subject*> in_fixed = subjects_of(one);
        for (const Subject& subject : of_three_bytes) in_fixed.push_back(&subject);
        for (const Subject* each : in_fixed) {
            const Subject& fixed = *each;
            const auto split = split_of(fixed);
            if (!split) continue;
            const Description first = one.at(one.from).description;
            if (one.endurance || !first.springs.empty() || !first.drags.empty()) continue;
            const bool touches = one.group == "contacts" || one.group == "edges";
            if (touches && fixed.scalar != "q16_16") continue;
            for (const double part : {0.0, 0.3, 0.6, 0.9, 1.0}) {
                Description made = one.at(one.from * std::pow(one.to / one.from, part)).description;
                made.steps = std::min(made.steps, 200u);
                std::vector<State> states;
                const Outcome outcome = fixed.run(made, [&](const State& state, unsigned) {
                    states.push_back(state);
                    return true;
                });
                bool same = true;
                std::vector<Subject> any_format = subjects_of_any_format(*split);
                for (Subject& more : more_subjects_of_any_format(*split))
                    any_format.push_back(std::move(more));
                const auto any = std::find_if(
                    any_format.begin(), any_format.end(),
                    [&](const Subject& any) { return any.integrator == fixed.integrator; });
                if (any == any_format.end() && !one.more_methods.empty()) break;  // as direct_rods
                ASSERT_NE(any, any_format.end());
                const auto& failure = outcome.record.first_failure();
                const Outcome again = any->run(made, [&](const State& state, unsigned step) {
                    if (failure && step >= failure->step) return true;
                    for (std::size_t i = 0; i < state.size(); ++i) {
                        const BodyState &a = state[i], &b = states.at(step)[i];
                        same = same && a.position.x == b.position.x &&
                               a.position.y == b.position.y && a.velocity.x == b.velocity.x &&
                               a.velocity.y == b.velocity.y;
                    }
                    return true;
                });
                const std::string where = one.name + " " + fixed.scalar + " " + fixed.integrator +
                                          " " + std::to_string(part);
                EXPECT_TRUE(same) << where;
                EXPECT_EQ(again.unfit, outcome.unfit) << where;
                EXPECT_EQ(again.error, outcome.error) << where;
                EXPECT_EQ(again.record.first_failure().has_value(), failure.has_value()) << where;
                ++compared;
                wrapped += failure.has_value();
                wrapped_in_three_bytes += failure && split->width() == 24;
            }
        }
    }
    EXPECT_GT(compared, 1000u);
    EXPECT_GT(wrapped, 50u);
    EXPECT_GT(wrapped_in_three_bytes, 10u);
}

// At any speed that the format holds, and in any format: where the contacts of the end of a step
// let it through at 26 m/s, in Q8.8 at 39 m/s.
TEST(ContinuousContacts, LetNothingThrough) {
    for (const char* name : {"thin_wall", "thin_target"}) {
        const Case& one = case_named(name);
        unsigned formats = 0;
        for (const Subject* subject : subjects_of(one)) {
            if (subject->integrator != "continuous_contacts") continue;
            ++formats;
            Finding found = find_limit(one, *subject, {4, 8, 20000, 1, true});
            const std::string where = one.name + " " + subject->scalar;
            EXPECT_GT(found.limit, 50) << where;
            // What ends it is the format, in the description or in a result, or the search.
            EXPECT_TRUE(found.verdict == Verdict::stable || found.verdict == Verdict::overflows)
                << where << ": " << cause_of(found);
            const auto with_end_contacts = find_limit(
                one,
                stability::subject(subject->scalar, subject->arithmetic, "semi_implicit_euler"),
                {4, 8, 20000});
            EXPECT_LT(with_end_contacts.limit, 40) << where;
        }
        EXPECT_EQ(formats, 5u);
    }
}

// A heavy ball on two light ones, and a blow against a chain: iterations that begin where the last
// step ended bear more than those that begin anew.
TEST(Heaps, BearMoreWarmStarted) {
    for (const char* scalar : {"q16_16", "q32_32"})
        EXPECT_GT(find("wedge_heavy_top", scalar, "warm_started").limit,
                  5 * find("wedge_heavy_top", scalar, "semi_implicit_euler").limit)
            << scalar;
}

// The blow reaches the chain at every speed: without it nothing would move sideways.
TEST(Impact, ReachesTheChainAtEverySpeed) {
    for (const double speed : {0.5, 10.0, 300.0, 20000.0}) {
        double sideways = 0;
        attempt(subject("q32_32", "nearest", "semi_implicit_euler"),
                {case_named("impact_on_chain_of_8").at(speed).description,
                 [&](const State& state, unsigned) {
                     sideways = std::max(sideways, std::abs(state[7].velocity.x));
                     return 0.0;
                 }});
        EXPECT_GT(sideways, 0.1 * speed) << speed;
    }
}

// A row of the battery that wraps is announced: fixbench advise finds a result beyond the format.
// And it does not cry wolf: what holds, up to the limit, has bits left.
TEST(Prediction, AnnouncesEveryWrapAndNothingThatHolds) {
    unsigned wraps = 0, holds = 0;
    for (const Case& of : all_cases())
        for (const Subject* one : subjects_of(of)) {
            const auto split = split_of(*one);
            if (!split || one->integrator == "explicit_euler") continue;
            const Finding found = find_limit(of, *one, {1, 3, 2000});
            const bool wrapped = found.verdict == Verdict::overflows &&
                                 found.first_event.rfind("overflow convert", 0) != 0;
            const std::string where = of.name + " " + one->scalar + " " + one->integrator;
            // The solvers of chains alone have no instance in AnyFormat.
            if (std::set<std::string>{"direct_rods", "direct_springs", "gauss_seidel_springs",
                                      "implicit_midpoint"}
                    .count(one->integrator) > 0) {
                EXPECT_FALSE(wrapped) << where << " wraps unannounced";
                continue;
            }
            const auto bits = [&](double parameter) {
                const auto prediction =
                    predict(of.at(parameter).description, *split, one->integrator);
                EXPECT_TRUE(prediction) << where;
                return prediction ? prediction->result : 0;
            };
            if (wrapped) {
                EXPECT_LT(bits(found.beyond), 0) << where << ": " << cause_of(found);
                ++wraps;
            }
            if (std::isnan(found.limit) || found.limit == 0) continue;
            EXPECT_GE(bits(found.limit), 0) << where << " holds at " << found.limit;
            ++holds;
        }
    EXPECT_GT(wraps, 100u);
    EXPECT_GT(holds, 1000u);
}

TEST(Prediction, IsTheDistanceOfTheLargestResultFromTheEnd) {
    EXPECT_DOUBLE_EQ(bits_to_overflow(8, 128), 4);
    EXPECT_DOUBLE_EQ(bits_to_overflow(256, 128), -1);
    EXPECT_DOUBLE_EQ(bits_to_overflow(0, 128), 7);
    // 40 N/m times 100 m is the largest number of this scene: Q16.16 leaves 2^15 / 4000.
    Description made;
    made.bodies = {{.position = {101, 0}}};
    made.springs = {{{.length = 1}, 40, 0}};
    made.dt = TimeStep::binary(10);
    made.steps = 1;
    const auto left = predict(made, {16, 16}, "semi_implicit_euler");
    ASSERT_TRUE(left);
    EXPECT_NEAR(left->result, std::log2(32768.0 / 4000), 1e-6);
    EXPECT_NEAR(left->position, std::log2(32768.0 / 101), 1e-3);
    // The force of Q8.24 would wrap; a mass below an ulp is another scene.
    EXPECT_LT(predict(made, {8, 24}, "semi_implicit_euler")->result, 0);
    made.bodies[0].inverse_mass = 1e-9;
    EXPECT_FALSE(predict(made, {16, 16}, "semi_implicit_euler"));
    EXPECT_EQ(split_of(subject("q8_24", "nearest", "velocity_verlet"))->fraction_bits, 24);
    EXPECT_EQ(split_of(subject("q32_32", "nearest", "velocity_verlet"))->integer_bits, 32);
    EXPECT_FALSE(split_of(subject("float", "ieee", "velocity_verlet")));
    EXPECT_FALSE(split_of(subject("q16_16", "saturating", "velocity_verlet")));
}

// Random worlds within what a format holds with room to spare.
Description random_springs() {
    Description made;
    const int n = *rc::gen::inRange(2, 6);
    for (int i = 0; i < n; ++i)
        made.bodies.push_back(
            {.position = {4.0 * i, 0.25 * *rc::gen::inRange(-4, 5)},
             .velocity = {0.25 * *rc::gen::inRange(-4, 5), 0.25 * *rc::gen::inRange(-4, 5)},
             .inverse_mass = 0.25 * *rc::gen::inRange(1, 9)});
    for (int i = 1; i < n; ++i) {
        Spring spring{{.a = i, .b = i - 1, .length = 4}, double(*rc::gen::inRange(1, 50)), 0};
        made.springs.push_back(spring);
    }
    made.dt = TimeStep::binary(8);
    made.steps = 200;
    return made;
}

TEST(RandomSprings, KeepTheirMomentumToTheRounding) {
    EXPECT_TRUE(rc::check([] {
        const Description made = random_springs();
        // A step rounds each velocity by about an ulp per spring, and each product with inverse
        // mass.
        const double ulp = std::ldexp(1.0, -16);
        Point before;
        for (const Body& body : made.bodies)
            before = before + body.velocity * (1 / body.inverse_mass);
        double worst = 0;
        attempt(subject("q16_16", "nearest", "semi_implicit_euler"),
                {made, [&](const State& state, unsigned step) {
                     Point now;
                     double bound = ulp;
                     for (std::size_t i = 0; i < state.size(); ++i) {
                         const double mass = 1 / made.bodies[i].inverse_mass;
                         now = now + state[i].velocity * mass;
                         // Each velocity changes by a rounded product, of rounded forces.
                         bound += mass * ulp * step;
                     }
                     worst = std::max(worst, length(now - before) / bound);
                     return 0.0;
                 }});
        RC_ASSERT(worst <= 1.0);
    }));
}

TEST(RandomSprings, SolvedImplicitlyNeverGainEnergy) {
    EXPECT_TRUE(rc::check([] {
        Description made = random_springs();
        for (Spring& spring : made.springs) spring.stiffness *= *rc::gen::inRange(1, 400);
        State start;
        for (const Body& body : made.bodies) start.push_back({body.position, body.velocity});
        const double scale = energy(made, start) + 0.01;
        const Trial trial = attempt(subject("q16_16", "nearest", "implicit_springs"),
                                    {made, energy_does_not_grow(made, 0.02, scale)});
        RC_ASSERT(trial.held);
    }));
}

TEST(RandomStacks, DoNotOverlapAtRest) {
    EXPECT_TRUE(rc::check([] {
        Description made;
        made.gravity = {0, -9.81};
        made.planes = {{{0, 1}, 0, 0}};
        made.restitution_threshold = 0.25;
        made.restitution = 0.25 * *rc::gen::inRange(0, 3);
        made.planes[0].restitution = made.restitution;
        made.dt = TimeStep::binary(8);
        made.steps = 1500;
        const int n = *rc::gen::inRange(1, 5);
        for (int i = 0; i < n; ++i)
            made.bodies.push_back({.position = {0, 0.25 + 0.53 * i},
                                   .inverse_mass = 0.5 * *rc::gen::inRange(1, 5),
                                   .radius = 0.25});
        for (const char* method : {"semi_implicit_euler", "velocity_verlet"}) {
            const Trial trial = attempt(subject("q16_16", "nearest", method),
                                        {made, from_step(1250, no_overlap(made, 0.05))});
            RC_ASSERT(trial.held);
        }
    }));
}

}  // namespace
}  // namespace stability
