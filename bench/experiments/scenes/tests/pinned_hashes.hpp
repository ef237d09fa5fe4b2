// SPDX-License-Identifier: GPL-3.0-or-later
// The hash of each scene's last state in each fixed-point format, in steps of 2^-8 s: the same on
// every machine.
#pragma once

#include <fmt/format.h>

#include <array>

#include "bench/experiments/scenes/scalars.hpp"
#include "bench/experiments/scenes/scene.hpp"
#include "bench/lab/records/csv.hpp"

namespace scene_bench {

#define FORMAT_NAME(name, I, F) #name,
constexpr std::array pinned_scalars = {SCENE_FORMATS(FORMAT_NAME) "q16_16_saturating"};
#undef FORMAT_NAME
constexpr const char* pinned_method = "semi_implicit_euler";
constexpr int pinned_exponent = 8;

// As in pinned_hashes.csv, computed again by the host.
inline records::Table hash_scenes() {
    records::Table table({"scene", "scalar", "hash"});
    for (const Scene& scene : all_scenes())
        for (const char* scalar : pinned_scalars) {
            const Run run =
                scene.find(scalar, pinned_method)->run(pinned_exponent, Hashes::of_each_step);
            table.add({scene.name, scalar, fmt::format("{:08x}", run.hashes.back())});
        }
    return table;
}

}  // namespace scene_bench
