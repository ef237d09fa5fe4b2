// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/command.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <thread>

#include "bench/experiments/scenes/measure_scenes.hpp"
#include "bench/experiments/scenes/workload.hpp"

namespace scene_bench {
namespace {

// The device programs are too many to be part of every build.
void build_programs(const char* target, unsigned threads) {
    const std::string command = fmt::format("cmake --build '{}' --target {} --parallel {} >&2",
                                            BUILD_FOLDER, target, threads);
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error(fmt::format("cannot build the target {}", target));
}

void add_output(CLI::App& command, std::filesystem::path& output, unsigned& threads) {
    command.add_option("--output", output, "folder that the data files are written to")
        ->capture_default_str();
    command.add_option("--threads", threads, "threads to run on")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
}

unsigned all_threads() { return std::max(1u, std::thread::hardware_concurrency()); }

}  // namespace

void add_scenes_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<SceneOptions>();
    options->output = "results/data";
    options->programs = SCENE_PROGRAMS;
    options->threads = all_threads();
    CLI::App* const command = app.add_subcommand(
        "scenes",
        "Error of every scene of engine/src/scenes/ in every scalar, method and time step, "
        "against\n"
        "cycles on the simulated chip. Builds the device programs where they are out of date.\n"
        "Writes scenes.csv.\n\n"
        "error is against the truth; error_method that of the same method in 50 digits; and\n"
        "error_arithmetic is against the same method in 50 digits. Each is the largest distance "
        "of\n"
        "a particle at any quarter of a second, in metres. Rows without cycles ran on the host,\n"
        "which the chip equals bit for bit. A run that failed is a row with its reason.\n\n"
        "Example: fixbench scenes --scene pendulum --scalar q16_16,float");
    const auto add_names = [&](const char* name, std::vector<std::string>& names,
                               const char* what) {
        command->add_option(name, names, what)->delimiter(',');
    };
    add_names("--scene", options->scenes, "only these scenes, e.g. pendulum,lever");
    add_names("--scalar", options->scalars,
              "only these of q8_8, q8_24, q16_16, q16_16_published, q16_16_saturating, q32_32, "
              "float, double, "
              "fifty_digits");
    add_names("--method", options->methods,
              "only these of explicit_euler, semi_implicit_euler, velocity_verlet, "
              "implicit_springs");
    command->add_flag("--quick", options->quick, "only time steps of 2^-8 s and more");
    add_output(*command, options->output, options->threads);
    command->callback([&action, options] {
        action = [options] {
            build_programs("scene_programs", options->threads);
            measure_scenes(*options);
            return EXIT_SUCCESS;
        };
    });
}

void add_workload_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<WorkloadOptions>();
    options->output = "results/data";
    options->programs = WORKLOAD_PROGRAMS;
    options->threads = all_threads();
    CLI::App* const command = app.add_subcommand(
        "workload",
        "The published lever with the report's arithmetic, ours and float on one source: its "
        "step,\n"
        "what its parts cost inside the running engine, and how many steps a second that makes,\n"
        "beside the published figures. Writes workload.csv, workload_rounds.csv (cycles by rounds\n"
        "of contact resolution) and workload_trace.csv (one step, call by call).");
    add_output(*command, options->output, options->threads);
    command->callback([&action, options] {
        action = [options] {
            build_programs("workload_programs", options->threads);
            measure_workload(*options);
            return EXIT_SUCCESS;
        };
    });
}

}  // namespace scene_bench
