// SPDX-License-Identifier: GPL-3.0-or-later
// Random worlds, and those of the ablations, are the same on the host and on the simulated chip:
// the hash of the state after each step, and the error that ends them.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <engine/hash.hpp>
#include <engine/vector.hpp>
#include <fixedpoint/conversion.hpp>
#include <optional>
#include <string_view>

#include "bench/experiments/stability/cases.hpp"
#include "bench/experiments/stability/chip_world.hpp"
#include "bench/experiments/stability/methods.hpp"
#include "bench/experiments/stability/subject.hpp"
#include "this_build.hpp"

namespace stability {
namespace {

std::filesystem::path program(const std::string& name) {
    return build_folder() / "bench/experiments/stability" / (name + ".elf");
}

template <int dimensions>
std::uint32_t hash_of(const State& state) {
    const auto exact = [](Point p) {
        engine::Vector<fixedpoint::Q16_16, dimensions> v;
        const double components[] = {p.x, p.y, p.z};
        for (unsigned char i = 0; i < dimensions; ++i)
            v[i] = fixedpoint::from_float<fixedpoint::Q16_16>(components[i]);
        return v;
    };
    std::uint32_t hash = 2166136261u;
    for (const BodyState& body : state) {
        hash = engine::hash_into(hash, exact(body.position));
        hash = engine::hash_into(hash, exact(body.velocity));
    }
    return hash;
}

// How many steps the host made, after each of which the chip's state was the same. The first that
// differs is in `differs_at`.
struct Comparison {
    unsigned steps = 0;
    std::optional<unsigned> differs_at;
    std::string error;
};
Comparison compare(const Subject& on_host, const std::filesystem::path& on_chip,
                   const Description& description) {
    Comparison result;
    ChipWorld chip(on_chip, description);
    const auto hash = on_host.integrator == ThreeDimensions::name ? hash_of<3> : hash_of<2>;
    const Outcome host = on_host.run(description, [&](const State& state, unsigned step) {
        if (step > 0) chip.step();
        result.steps = step;
        if (hash(state) != chip.hash()) result.differs_at = step;
        return !result.differs_at;
    });
    result.error = host.error;
    // The host does not show a step that an error ends.
    if (!host.error.empty() && host.steps > result.steps) chip.step();
    const std::string chip_error =
        chip.error() == engine::Error::none ? "" : engine::describe(chip.error());
    if (!result.differs_at && chip_error != host.error) result.differs_at = host.steps;
    return result;
}

double random_number(int most, double unit) { return unit * *rc::gen::inRange(-most, most + 1); }
Point random_point(int most, double unit, bool in_space) {
    const double x = random_number(most, unit), y = random_number(most, unit);
    return {x, y, in_space ? random_number(most, unit) : 0};
}

// A method with its program on the chip.
struct Kind {
    const char *integrator, *program, *arithmetic = "nearest";

    bool in_space() const { return integrator == std::string_view(ThreeDimensions::name); }
    bool only_rods() const { return integrator == std::string_view(scenes::Direct::name); }
    // Whether nothing wraps, so that worlds may leave the range.
    bool saturates() const { return arithmetic == std::string_view("saturating"); }
};

// Four bodies within a few metres, which overlap, pull and hold each other. Where nothing wraps, up
// to the ends of the range and fast.
Description random_world(const Kind& kind) {
    Description made;
    const double wide = kind.saturates() ? std::exp2(*rc::gen::inRange(0, 13)) : 1;
    const auto point = [&](int most, double unit) {
        return random_point(most, unit, kind.in_space());
    };
    const int n = *rc::gen::inRange(1, 5);
    for (int i = 0; i < n; ++i) {
        made.bodies.push_back({.position = point(300, 0x1p-7 * wide),
                               .velocity = point(2000, 0x1p-8 * wide),
                               .inverse_mass = *rc::gen::inRange(0, 40) / 8.0,
                               .force = point(50, 0.3)});
        if (kind.only_rods()) continue;
        made.bodies.back().radius = *rc::gen::inRange(0, 100) / 128.0;
        made.bodies.back().damping = 1 - *rc::gen::inRange(0, 4) / 1024.0;
    }
    made.gravity = point(100, 0.1);
    made.dt = TimeStep::binary(8);
    made.steps = 64;
    const auto body = [n] { return *rc::gen::inRange(0, n); };
    const auto ends = [&] {
        Link link{.a = body(), .anchor = point(300, 0x1p-7 * wide)};
        link.length = wide * *rc::gen::inRange(1, 500) / 128.0;
        if (n > 1 && *rc::gen::arbitrary<bool>()) link.b = (link.a + *rc::gen::inRange(1, n)) % n;
        return link;
    };
    // There is room for two of each kind.
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) made.rods.push_back(ends());
    if (kind.only_rods()) return made;
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        made.springs.push_back(
            {ends(), *rc::gen::inRange(0, 4000) / 16.0, *rc::gen::inRange(0, 40) / 16.0});
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        made.ropes.push_back({ends(), *rc::gen::inRange(0, 9) / 8.0});
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        made.drags.push_back(
            {body(), *rc::gen::inRange(0, 20) / 16.0, *rc::gen::inRange(0, 20) / 64.0});
    const std::array<Point, 4> in_the_plane = {{{0, 1}, {0.6, 0.8}, {-0.8, 0.6}, {1, 0}}};
    const std::array<Point, 4> in_space = {{{0, 0, 1}, {0.6, 0, 0.8}, {0.48, -0.6, 0.64}, {1, 0}}};
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        made.planes.push_back(
            {(kind.in_space() ? in_space : in_the_plane)[*rc::gen::inRange<std::size_t>(0, 4)],
             random_number(100, 0x1p-6), *rc::gen::inRange(0, 9) / 8.0});
    made.restitution = *rc::gen::inRange(0, 9) / 8.0;
    made.restitution_threshold = *rc::gen::inRange(0, 3) / 4.0;
    return made;
}

class RandomWorlds : public testing::TestWithParam<Kind> {};

TEST_P(RandomWorlds, MoveOnTheChipAsOnTheHost) {
    const Kind kind = GetParam();
    const Subject& on_host = subject("q16_16", kind.arithmetic, kind.integrator);
    const auto on_chip = program(std::string("random_") + kind.program);
    unsigned long steps = 0;
    EXPECT_TRUE(rc::check([&] {
        const Description made = random_world(kind);
        const Comparison result = compare(on_host, on_chip, made);
        steps += result.steps;
        RC_ASSERT(!result.differs_at);
    }));
    EXPECT_GT(steps, 1000u);
}
INSTANTIATE_TEST_SUITE_P(
    Methods, RandomWorlds,
    testing::Values(
        Kind{"explicit_euler", "Published"}, Kind{"semi_implicit_euler", "SemiImplicit"},
        Kind{"semi_implicit_euler", "Saturating", "saturating"}, Kind{"velocity_verlet", "Verlet"},
        Kind{"implicit_springs", "Implicit"}, Kind{"direct_springs", "DirectSprings"},
        Kind{"gauss_seidel_springs", "GaussSeidelSprings"},
        Kind{"implicit_midpoint", "ImplicitMidpoint"},
        Kind{"semi_implicit_compensated", "CompensatedIntegration"},
        Kind{"warm_started", "WarmStarted"}, Kind{"continuous_contacts", "ContinuousContacts"},
        Kind{"direct_rods", "Direct"}, Kind{"sort_and_sweep", "SortedPairs"},
        Kind{"cached_sort_and_sweep", "CachedSortedPairs"},
        Kind{"three_dimensions", "ThreeDimensions"}),
    [](const auto& info) { return info.param.program; });

// A chip with another world differs: the comparison can fail.
TEST(Comparison, DetectsAnotherMethodAndAnotherNumber) {
    Description made;
    made.bodies = {{.position = {3, 0}}};
    made.springs = {{{.length = 2}, 50, 0}};
    made.dt = TimeStep::binary(8);
    made.steps = 64;
    const Subject& ours = subject("q16_16", "nearest", "semi_implicit_euler");
    EXPECT_FALSE(compare(ours, program("random_SemiImplicit"), made).differs_at);
    EXPECT_EQ(compare(ours, program("random_Published"), made).differs_at, 1u);
    ChipWorld chip(program("random_SemiImplicit"), made);
    made.bodies[0].position.x += 0x1p-16;
    EXPECT_NE(ChipWorld(program("random_SemiImplicit"), made).hash(), chip.hash());
    made.dt = TimeStep::binary(9);
    EXPECT_THROW(ChipWorld(program("random_SemiImplicit"), made), std::runtime_error);
}

// The programs whose cycles are in ablations.csv are those of the methods whose limits it contains.
class AblationPrograms : public testing::TestWithParam<std::array<const char*, 3>> {};

TEST_P(AblationPrograms, MoveAsTheirMethodsOnTheHost) {
    const auto [name, integrator, arithmetic] = GetParam();
    for (const Case& one : all_cases()) {
        if (one.name != name) continue;
        Description made = one.at(one.endurance ? 400 : one.from).description;
        made.steps = std::min(made.steps, 400u);
        const std::string method = arithmetic == std::string("nearest") ? integrator : arithmetic;
        const Comparison result = compare(subject("q16_16", arithmetic, integrator),
                                          program("ablation_" + one.name + "_" + method), made);
        EXPECT_FALSE(result.differs_at) << "after step " << *result.differs_at;
        EXPECT_EQ(result.steps, made.steps) << result.error;
        return;
    }
    FAIL() << "no case " << name;
}
constexpr const char* nearest = "nearest";
constexpr const char* ours = "semi_implicit_euler";
INSTANTIATE_TEST_SUITE_P(
    Ablations, AblationPrograms,
    testing::Values(std::array{"spring_stiffness", "positions_first", nearest},
                    std::array{"spring_stiffness", ours, nearest},
                    std::array{"spring_coarse_step", "implicit_springs", nearest},
                    std::array{"spring_chain_of_4_heavy_end", "implicit_springs", nearest},
                    std::array{"spring_chain_of_4_heavy_end", "direct_springs", nearest},
                    std::array{"spring_chain_of_16_heavy_end", "direct_springs", nearest},
                    std::array{"spring_chain_of_4_heavy_end", "gauss_seidel_springs", nearest},
                    std::array{"spring_chain_of_4_heavy_end", "implicit_midpoint", nearest},
                    std::array{"spring_critically_damped", "implicit_midpoint", nearest},
                    std::array{"rod_chain_of_8_heavy_end", "rods_as_opposed_contacts", nearest},
                    std::array{"rod_chain_of_8_heavy_end", "rods_along_tangents", nearest},
                    std::array{"stack_of_10", "worst_contact_first", nearest},
                    std::array{"stack_of_10", ours, nearest},
                    std::array{"stack_of_20", "warm_started", nearest},
                    std::array{"rod_chain_of_8_heavy_end", "warm_started", nearest},
                    std::array{"rod_chain_of_16_heavy_end", "warm_started", nearest},
                    std::array{"rod_chain_of_4_heavy_end", "direct_rods", nearest},
                    std::array{"rod_chain_of_8_heavy_end", "direct_rods", nearest},
                    std::array{"rod_chain_of_16_heavy_end", "direct_rods", nearest},
                    std::array{"rod_chain_of_8_heavy_end_fine_steps", "one_iteration", nearest},
                    std::array{"rod_chain_of_8_heavy_end_fine_steps", ours, nearest},
                    std::array{"thin_wall", "continuous_contacts", nearest},
                    std::array{"thin_target", "continuous_contacts", nearest},
                    std::array{"bounces_under_gravity", "bounces_when_found", nearest},
                    std::array{"bounces_under_gravity", ours, nearest},
                    std::array{"resting_light_mass", "velocities_by_impulses", nearest},
                    std::array{"drag_quadratic", ours, "saturating"},
                    std::array{"slow", "semi_implicit_compensated", nearest}),
    [](const auto& info) {
        return std::string(info.param[0]) + "_" + info.param[1] + "_" + info.param[2];
    });

}  // namespace
}  // namespace stability
