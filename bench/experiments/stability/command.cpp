// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/command.hpp"

#include <map>
#include <memory>
#include <string>
#include <thread>

#include "bench/experiments/stability/advise.hpp"
#include "bench/experiments/stability/measure_stability.hpp"

namespace stability {

void add_stability_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<Options>();
    options->output = "results/data";
    options->threads = std::max(1u, std::thread::hardware_concurrency());
    CLI::App* command = app.add_subcommand(
        "stability",
        "Stiff and extreme cases, each driven to where it breaks: the limit by bisection, and "
        "what\n"
        "went wrong first, for every scalar and method of the engine. Writes stability.csv\n"
        "and, where neither cases nor subjects are picked, envelope.csv, stability_map.csv, "
        "ablations.csv\n"
        "and suitability.csv (the least error of each width in each scene; not with --quick).\n\n"
        "Example: fixbench stability --case spring_stiffness --scalar q16_16");
    command->add_option("--output", options->output, "folder that the data files are written to")
        ->capture_default_str();
    command->add_option("--threads", options->threads, "threads to run on")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    command->add_flag("--quick", options->quick, "fewer bisections and shorter endurance");
    command->add_option("--case", options->cases, "only these cases")->delimiter(',');
    command->add_option("--scalar", options->scalars, "only these scalars, e.g. q16_16,float")
        ->delimiter(',');
    command
        ->add_option("--integrator", options->integrators,
                     "only these integrators, e.g. explicit_euler,velocity_verlet")
        ->delimiter(',');
    command->callback([options, &action] {
        action = [options] {
            measure_stability(*options);
            return EXIT_SUCCESS;
        };
    });

    const auto advice = std::make_shared<AdviceOptions>();
    const auto unit = std::make_shared<double>(1);
    advice->data = "results/data";
    advice->threads = options->threads;
    command = app.add_subcommand(
        "advise",
        "Number formats, splits, methods and steps that run a scene within an error, cheapest\n"
        "first, with cycles, flash and the bits that each quantity is away from overflow. All\n"
        "splits Q2.14 to Q12.4, Q4.28 to Q24.8 and Q12.52 to Q40.24 are tried, and float. Exits\n"
        "with 1 where nothing meets the error.\n\n"
        "Example: fixbench advise --scene pendulum --error 5 --unit mm");
    command->add_option("--scene", advice->scene, "a scene of engine/src/scenes/, e.g. pendulum")
        ->required();
    command->add_option("--error", advice->error, "the largest error of a position")
        ->required()
        ->check(CLI::PositiveNumber);
    command->add_option("--unit", *unit, "of the error: m, cm, mm or um")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, double>{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}));
    command->add_option("--data", advice->data, "folder of scenes.csv, for cycles and flash")
        ->capture_default_str();
    command->add_option("--lines", advice->most, "so many lines at most")->capture_default_str();
    command->callback([advice, unit, &action] {
        action = [advice, unit] {
            AdviceOptions asked = *advice;
            asked.error *= *unit;
            return advise(asked) ? EXIT_SUCCESS : EXIT_FAILURE;
        };
    });
}

}  // namespace stability
