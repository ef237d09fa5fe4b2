// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench advise.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "bench/experiments/advise/advise.hpp"
#include "bench/experiments/scenes/any_program.hpp"
#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/stability/advise.hpp"
#include "bench/lab/program/experiment.hpp"
#include "this_build.hpp"

namespace advise {
namespace {

// The cost of a scene in a format that need not be in any data file.
stability::Cost on_chip(const std::string& scene, const std::string& scalar,
                        const std::string& method, int exponent) {
    const auto& scenes = scene_bench::all_scenes();
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const auto& each) { return each.name == scene; });
    const scene_bench::ChipRun run =
        scene_bench::run_on_chip(scene_bench::any_program(scene, scalar, method, exponent), *found,
                                 scalar, exponent, scene_bench::Hashes::no);
    if (!run.failure.empty()) throw std::runtime_error(run.failure);
    return {run.cycles_mean, static_cast<double>(run.flash_bytes)};
}

const fixbench::Registration command({
    .name = "advise",
    .description =
        "Lists the number formats that run a program or a scene within an error, cheapest\n"
        "first, with cycles, flash and the bits left before overflow. Exits with 1 if nothing\n"
        "meets the error.\n\n"
        "--program FILE: your code, `template <class Number> class Program` with a member\n"
        "function `Number step(Number...)`. It runs on your data: CSV files with a column for\n"
        "each input. Each file is a run, which begins with a new Program. The program is\n"
        "recorded in double, then run in each format that fits what was recorded, on the host\n"
        "and on the simulated chip, which have to agree. The error is the largest difference\n"
        "from double. Files: advice.csv, ranges.csv (the values of every line and of every\n"
        "variable that fixedpoint::watch names; printed with --ranges).\n\n"
        "--scene NAME: a scene of the engine against its true motion, in all splits Q2.14 to\n"
        "Q12.4, Q3.21 to Q16.8, Q4.28 to Q24.8 and Q12.52 to Q40.24, and float, with every\n"
        "method and step. A program whose cycles are not in the data is built and run on the\n"
        "simulated chip, and stays in the build folder.\n\n"
        "Example: fixbench advise --program my_filter.cpp --inputs my_data.csv --error 0.001\n"
        "         fixbench advise --scene pendulum --error 5 --unit mm",
    .prints = {"advice.csv", "ranges.csv"},
    .add =
        [](CLI::App& command) {
            struct Asked {
                Options program;
                stability::AdviceOptions scene;
                double error = 0, unit = 1;
            };
            const auto asked = std::make_shared<Asked>();
            asked->scene.data = source_folder() / "results/data";
            CLI::Option* const program =
                command.add_option("--program", asked->program.program, "your C++ file")
                    ->check(CLI::ExistingFile);
            CLI::Option* const inputs =
                command.add_option("--inputs", asked->program.data, "CSV files of its inputs")
                    ->check(CLI::ExistingFile)
                    ->needs(program);
            program->needs(inputs);
            CLI::Option* const ranges = command
                                            .add_flag("--ranges", asked->program.ranges_only,
                                                      "list only the ranges of variables and lines")
                                            ->needs(program);
            CLI::Option* const scene =
                command
                    .add_option("--scene", asked->scene.scene,
                                "a scene of engine/src/scenes/, e.g. pendulum")
                    ->excludes(program);
            for (const char* files : {"--output", "--json", "--csv"})
                scene->excludes(command.get_option(files));
            CLI::Option* const error =
                command
                    .add_option("--error", asked->error,
                                "largest error of a result, or of a position")
                    ->check([](const std::string& text) {
                        double error = 0;
                        return CLI::detail::lexical_cast(text, error) && std::isfinite(error) &&
                                       error > 0
                                   ? std::string()
                                   : "must be a number above 0, not " + text;
                    });
            error->excludes(ranges);
            command
                .add_option("--unit", asked->unit, "unit of a position's error: m, cm, mm or um")
                ->transform(CLI::CheckedTransformer(std::map<std::string, double>{
                    {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}))
                ->needs(scene);
            command
                .add_option("--data", asked->scene.data,
                            "folder with scenes.csv and operations.csv, for cycles and flash")
                ->capture_default_str();
            command.add_option("--lines", asked->scene.most, "at most this many lines for a scene")
                ->capture_default_str()
                ->check(CLI::Range(1, 10000))
                ->needs(scene);
            return [asked](const fixbench::Call& call) {
                const bool scene = !asked->scene.scene.empty();
                if (!scene && asked->program.program.empty())
                    throw std::invalid_argument(
                        "advise needs --program and --inputs, or --scene; and --error");
                if (asked->error == 0 && !asked->program.ranges_only)
                    throw std::invalid_argument("advise needs --error, the largest error allowed");
                bool found;
                if (scene) {
                    asked->scene.error = asked->error * asked->unit;
                    asked->scene.threads = call.threads;
                    asked->scene.measure = on_chip;
                    found = stability::advise(asked->scene);
                } else {
                    asked->program.error = asked->error;
                    asked->program.measured = asked->scene.data / "operations.csv";
                    asked->program.output = call.output;
                    asked->program.threads = call.threads;
                    found = advise_program(asked->program);
                }
                return found ? fixbench::held : fixbench::check_failed;
            };
        },
});

}  // namespace
}  // namespace advise
