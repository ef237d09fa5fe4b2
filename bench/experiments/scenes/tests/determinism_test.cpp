// SPDX-License-Identifier: GPL-3.0-or-later
// The hash of the whole state after every step is the same on the host and on the chip, for every
// scene and every fixed-point format, and the last hash is pinned. After an intended change of the
// engine: pin_scene_hashes bench/experiments/scenes/tests/pinned_hashes.csv
#include <gtest/gtest.h>

#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/host/describe.hpp"
#include "bench/experiments/scenes/tests/pinned_hashes.hpp"
#include "this_build.hpp"

namespace scene_bench {
namespace {

struct Subject {
    const Scene* scene;
    std::string scalar;
};

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    for (const Scene& scene : all_scenes())
        for (const char* scalar : pinned_scalars) all.push_back({&scene, scalar});
    return all;
}

const std::filesystem::path pinned_hashes =
    source_folder() / "bench/experiments/scenes/tests/pinned_hashes.csv";

class Determinism : public testing::TestWithParam<Subject> {};

TEST_P(Determinism, HostChipAndPinnedHashesAreEqual) {
    const auto& [scene, scalar] = GetParam();
    const scene_bench::Run on_host =
        scene->find(scalar, pinned_method)->run(pinned_exponent, Hashes::of_each_step);
    const ChipRun on_chip =
        run_on_chip(program_path(scene_programs(), scene->name, scalar, pinned_method, "hash"),
                    *scene, scalar, pinned_exponent, Hashes::of_each_step);
    ASSERT_EQ(on_host.hashes.size(), scene->duration << pinned_exponent) << on_host.failure;
    ASSERT_EQ(on_chip.hashes.size(), on_host.hashes.size()) << on_chip.failure;
    for (std::size_t step = 0; step < on_host.hashes.size(); ++step)
        ASSERT_EQ(on_chip.hashes[step], on_host.hashes[step]) << "after step " << step + 1;

    const records::Table pinned = records::Table::load(pinned_hashes);
    std::string last;
    for (const auto& row : pinned.rows())
        if (row.at(0) == scene->name && row.at(1) == scalar) last = row.at(2);
    EXPECT_EQ(fmt::format("{:08x}", on_host.hashes.back()), last)
        << "not what pinned_hashes.csv says";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism, testing::ValuesIn(subjects()), [](const auto& info) {
    return info.param.scene->name + "_" + info.param.scalar;
});

TEST(PinnedHashes, AreThoseOfAllScenesAndNoMore) {
    EXPECT_EQ(records::Table::load(pinned_hashes).rows().size(),
              all_scenes().size() * pinned_scalars.size());
}

// An engine that is off by one ulp once per step.
struct OffByAnUlp : scenes::SemiImplicit {
    struct Integrator : engine::SemiImplicitEuler {
        template <class World, class TimeStep>
        static void step(World& world, TimeStep dt) {
            engine::SemiImplicitEuler::step(world, dt);
            world.particles()[0].velocity[0] += World::Scalar::ulp();
        }
    };
};

TEST(PinnedHashes, ChangeWithTheEngine) {
    const auto last = [](auto method) {
        return run_on_host<scenes::Pendulum, scalars::q16_16, decltype(method)>(
                   pinned_exponent, Hashes::of_each_step)
            .hashes;
    };
    const auto right = last(scenes::SemiImplicit()), wrong = last(OffByAnUlp());
    EXPECT_NE(right.front(), wrong.front());
    EXPECT_NE(right.back(), wrong.back());
}

}  // namespace
}  // namespace scene_bench
