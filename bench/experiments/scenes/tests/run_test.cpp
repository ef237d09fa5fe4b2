// SPDX-License-Identifier: GPL-3.0-or-later
// Runs on the chip and on the host, compared with a fall computed by hand; and runs that fail.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <thread>

#include "bench/experiments/scenes/any_program.hpp"
#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/host/describe.hpp"
#include "bench/experiments/scenes/tests/failing_scenes.hpp"

namespace scene_bench {
namespace {

const std::filesystem::path programs = scene_programs();

const Scene& scene_named(std::string_view name) {
    for (const Scene& scene : all_scenes())
        if (scene.name == name) return scene;
    throw std::runtime_error("no such scene");
}

std::int64_t rounded(std::int64_t a, int shift) {
    return (a + (std::int64_t(1) << (shift - 1))) >> shift;
}

// The free fall from (0, 20) at (3, 4) m/s in plain integers of 16 fraction bits: 9.81 is 642908.
void expect_free_fall(const Run& run, int exponent) {
    std::int64_t x = 0, y = 20 << 16;
    const std::int64_t horizontal = 3 << 16;
    std::int64_t vertical = 4 << 16;
    ASSERT_EQ(run.trajectory.size(), 9u);  // 2 s in quarters
    for (int quarter = 1; quarter <= 8; ++quarter) {
        for (int step = 0; step < (1 << exponent) / 4; ++step) {
            vertical += rounded(-642908, exponent);
            x += rounded(horizontal, exponent);
            y += rounded(vertical, exponent);
        }
        const ParticleState& point = run.trajectory[quarter].at(0);
        EXPECT_EQ(point.position[0], std::ldexp(static_cast<double>(x), -16)) << quarter;
        EXPECT_EQ(point.position[1], std::ldexp(static_cast<double>(y), -16)) << quarter;
        EXPECT_EQ(point.velocity[1], std::ldexp(static_cast<double>(vertical), -16)) << quarter;
    }
}

TEST(AnyProgram, OfASplitOfTheBuildIsTheBuilds) {
    const std::filesystem::path made = any_program("free_fall", "q16_16", "semi_implicit_euler", 8);
    const Scene& scene = scene_named("free_fall");
    const ChipRun found = run_on_chip(made, scene, "q16_16", 8, Hashes::no);
    const ChipRun built =
        run_on_chip(program_path(programs, "free_fall", "q16_16", "semi_implicit_euler", "8"),
                    scene, "q16_16", 8, Hashes::no);
    expect_free_fall(found, 8);
    EXPECT_EQ(found.cycles_mean, built.cycles_mean);
    EXPECT_EQ(found.cycles_max, built.cycles_max);
    EXPECT_EQ(found.flash_bytes, built.flash_bytes);
}

TEST(AnyProgram, IsMadeOnceAndInAnySplit) {
    const auto make = [] {
        return std::filesystem::last_write_time(
            any_program("free_fall", "q7_25", "velocity_verlet", 7));
    };
    const auto first = make();
    EXPECT_EQ(make(), first);
    const ChipRun run = run_on_chip(any_program("free_fall", "q7_25", "velocity_verlet", 7),
                                    scene_named("free_fall"), "q7_25", 7, Hashes::no);
    // From (0, 20) at (3, 4) m/s: after 1 s at (3, 24 - 9.81 / 2), which Verlet has exactly.
    EXPECT_NEAR(run.trajectory.at(4).at(0).position[0], 3, 1e-5);
    EXPECT_NEAR(run.trajectory.at(4).at(0).position[1], 24 - 9.81 / 2, 1e-5);
}

// Another process may run the program while this one makes it again.
TEST(AnyProgram, IsReplacedAsAWhole) {
    const auto make = [] { return any_program("free_fall", "q7_25", "velocity_verlet", 9); };
    const auto bytes = [](const std::filesystem::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    const std::filesystem::path program = make(), empty = program.parent_path() / "empty.elf";
    const std::string whole = bytes(program), whole_empty = bytes(empty);
    const auto long_ago = std::filesystem::last_write_time(program) - std::chrono::years(30);
    std::filesystem::last_write_time(program, long_ago);  // older than its sources
    std::atomic<bool> made = false;
    std::thread maker([&] {
        make();
        made = true;
    });
    int looks = 0, parts = 0;
    for (; !made; ++looks) parts += bytes(program) != whole || bytes(empty) != whole_empty;
    maker.join();
    EXPECT_GT(std::filesystem::last_write_time(program), long_ago);
    EXPECT_GT(looks, 10);
    EXPECT_EQ(parts, 0);
}

// Of 24 bits: by hand, and a rod and springs like those in the 32 bits with the same last bit.
TEST(AnyProgram, OfThreeBytesMovesAsByHandAndAsThoseOfFour) {
    const auto run = [](const char* scene, const char* scalar) {
        return run_on_chip(any_program(scene, scalar, "semi_implicit_euler", 8), scene_named(scene),
                           scalar, 8, Hashes::no);
    };
    expect_free_fall(run("free_fall", "q8_16"), 8);
    for (const char* scene : {"pendulum", "spring_and_mass", "lever"}) {
        const ChipRun narrow = run(scene, "q8_16"), wide = run(scene, "q16_16");
        EXPECT_EQ(narrow.failure, "") << scene;
        EXPECT_LT(narrow.ram_bytes, wide.ram_bytes) << scene;
        ASSERT_EQ(narrow.trajectory.size(), wide.trajectory.size()) << scene;
        for (std::size_t i = 0; i < wide.trajectory.size(); ++i)
            for (const int axis : {0, 1}) {
                const ParticleState &a = narrow.trajectory[i].at(0), &b = wide.trajectory[i].at(0);
                EXPECT_EQ(a.position[axis], b.position[axis]) << scene << " " << i;
                EXPECT_EQ(a.velocity[axis], b.velocity[axis]) << scene << " " << i;
            }
    }
}

// Nothing is lost in compensated integration: each sum of products with the step is the floor of
// the exact one.
TEST(AnyProgram, WithCompensatedIntegrationMovesAsByHand) {
    for (const char* scalar : {"q8_16", "q16_16"}) {
        const ChipRun run =
            run_on_chip(any_program("free_fall", scalar, "semi_implicit_compensated", 8),
                        scene_named("free_fall"), scalar, 8, Hashes::no);
        ASSERT_EQ(run.trajectory.size(), 9u) << scalar;
        std::int64_t sum = 0;  // of the velocities
        for (int step = 1; step <= 2 << 8; ++step) {
            const std::int64_t vertical = (4 << 16) + ((-642908 * std::int64_t(step)) >> 8);
            sum += vertical;
            if (step % 64 != 0) continue;
            const ParticleState& point = run.trajectory[step / 64].at(0);
            EXPECT_EQ(point.velocity[1], std::ldexp(static_cast<double>(vertical), -16)) << step;
            EXPECT_EQ(point.position[1],
                      std::ldexp(static_cast<double>((20 << 16) + (sum >> 8)), -16))
                << step;
        }
    }
}

TEST(AnyProgram, ReportsAFormatThatCannotHoldTheScene) {
    EXPECT_THROW(any_program("free_fall", "q2_14", "velocity_verlet", 7), std::runtime_error);
}

TEST(FreeFall, ByHandOnTheHost) {
    const HostSubject* const subject =
        scene_named("free_fall").find("q16_16", "semi_implicit_euler");
    ASSERT_NE(subject, nullptr);
    for (const int exponent : {5, 6, 8, 10, 12})
        expect_free_fall(subject->run(exponent, Hashes::no), exponent);
}

TEST(FreeFall, ByHandOnTheChip) {
    for (const int exponent : {6, 8, 10}) {
        const ChipRun run =
            run_on_chip(program_path(programs, "free_fall", "q16_16", "semi_implicit_euler",
                                     std::to_string(exponent)),
                        scene_named("free_fall"), "q16_16", exponent, Hashes::no);
        expect_free_fall(run, exponent);
        EXPECT_EQ(run.steps, 2u << exponent);
        // At least four additions of four bytes, and far less than a product.
        EXPECT_GT(run.cycles_mean, 100);
        EXPECT_LT(run.cycles_mean, 1000);
        EXPECT_GE(run.cycles_max, run.cycles_mean);
        EXPECT_GE(run.ram_bytes, 28u);  // position, velocity, inverse mass, gravity
        EXPECT_LT(run.ram_bytes, 48u);
        EXPECT_GT(run.flash_bytes, 100u);
        EXPECT_LT(run.flash_bytes, 1000u);  // no product, no quotient, no table
        EXPECT_GE(run.stack_bytes, 2);
    }
}

// With compensated integration the sum of all products with the step is rounded down once, whatever
// their number: velocity Verlet adds half a step's gravity twice a step, and moves in between.
TEST(FreeFall, CompensatedByHand) {
    const HostSubject* const subject =
        scene_named("free_fall").find("q16_16_compensated", "velocity_verlet");
    ASSERT_NE(subject, nullptr);
    for (const int exponent : {6, 8, 10}) {
        const scene_bench::Run run = subject->run(exponent, Hashes::no);
        ASSERT_EQ(run.trajectory.size(), 9u);
        std::int64_t velocities = 0;  // their sum
        for (std::int64_t step = 1; step <= 2 << exponent; ++step) {
            velocities += (4 << 16) + ((-642908 * (2 * step - 1)) >> (exponent + 1));
            if (step % ((1 << exponent) / 4) != 0) continue;
            const ParticleState& point =
                run.trajectory[static_cast<std::size_t>(step / ((1 << exponent) / 4))].at(0);
            EXPECT_EQ(point.position[1],
                      std::ldexp(static_cast<double>((20 << 16) + (velocities >> exponent)), -16));
            EXPECT_EQ(
                point.velocity[1],
                std::ldexp(static_cast<double>((4 << 16) + ((-642908 * step) >> exponent)), -16));
        }
        // 4 - 2 g / 2 + 20 m, of which the conversion of g takes at most 2^-16.
        EXPECT_NEAR(run.trajectory[8].at(0).position[1], 20 + 2 * 4 - 9.81 * 2, 0x1p-15);
    }
}

Scene overfull_scene() {
    Scene scene = scene_named("free_fall");
    scene.name = scenes::Overfull::name;
    scene.duration = scenes::Overfull::duration;
    scene.particles = 2;
    return scene;
}

TEST(FailingRun, OneContactTooManyEndsIt) {
    const ChipRun on_chip =
        run_on_chip(program_path(programs, "overfull", "q16_16", "semi_implicit_euler", "8"),
                    overfull_scene(), "q16_16", 8, Hashes::no);
    EXPECT_EQ(on_chip.failure, "more contacts in a step than the scene states");
    EXPECT_LT(on_chip.steps, 256u);
    const scene_bench::Run on_host =
        run_on_host<scenes::Overfull, scalars::q16_16, scenes::SemiImplicit>(8, Hashes::no);
    EXPECT_EQ(on_host.failure, on_chip.failure);
}

TEST(FailingRun, ANumberThatIsNotFiniteEndsIt) {
    Scene scene = scene_named("free_fall");
    scene.duration = scenes::Exploding::duration;
    const ChipRun run =
        run_on_chip(program_path(programs, "exploding", "float", "semi_implicit_euler", "8"), scene,
                    "float", 8, Hashes::no);
    EXPECT_EQ(run.failure, "a number is not finite");
    EXPECT_LT(run.steps, 4u << 8);
}

TEST(Layout, OfNames) {
    EXPECT_EQ(layout_of("q16_16_published").fraction_bits, 16);
    EXPECT_EQ(layout_of("q8_24").range(), 128);
    EXPECT_EQ(layout_of("q32_32").bytes, 8);
    EXPECT_TRUE(std::isinf(layout_of("float").range()));
    EXPECT_THROW(layout_of("double"), std::runtime_error);
    EXPECT_THROW(layout_of("q16"), std::runtime_error);
    const std::uint8_t minus_one_and_a_half[] = {0x80, 0xfe};
    EXPECT_EQ(layout_of("q8_8").value(minus_one_and_a_half), -1.5);
}

}  // namespace
}  // namespace scene_bench
