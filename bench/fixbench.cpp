// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench, the command line of the bench: each sub-command measures one thing and writes its
// files.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>

#include "bench/experiments/calibration/command.hpp"
#include "bench/lab/catalogue/catalogue.hpp"
#include "bench/lab/command.hpp"
#include "bench/experiments/haptic/command.hpp"
#include "bench/experiments/haptic/region/command.hpp"
#include "bench/experiments/cost/features/command.hpp"
#include "bench/experiments/cost/growth/command.hpp"
#include "bench/live/command.hpp"
#include "bench/experiments/exhaustive/exhaustive.hpp"
#include "bench/experiments/operations/measure_accuracy.hpp"
#include "bench/experiments/operations/measure_cycles.hpp"
#include "bench/experiments/operations/verify_kernels.hpp"
#include "bench/experiments/profile/command.hpp"
#include "bench/experiments/scenes/command.hpp"
#include "bench/experiments/stability/command.hpp"
#include "bench/experiments/table_3_2/table_3_2.hpp"
#include "reference/published.hpp"

namespace {

void add_selection(CLI::App& command, operations::Selection& selection, bool operands) {
    command
        .add_option("--operation", selection.operations,
                    "only these operations, e.g. multiply,divide,sqrt,atan2")
        ->delimiter(',');
    command.add_option("--format", selection.formats, "only these formats, e.g. q16_16,q8_8,float")
        ->delimiter(',');
    command
        .add_option("--implementation", selection.implementations,
                    "only these implementations, e.g. default,published,libc")
        ->delimiter(',');
    if (!operands) return;
    command
        .add_option("--operands", selection.operands,
                    "only these operand classes: small, physics, full, uniform, published, boundary, all")
        ->delimiter(',');
}

int held(std::uint64_t violations) {
    if (violations == 0) return EXIT_SUCCESS;
    fmt::print(stderr, "fixbench: {} results are not what their definition says\n", violations);
    return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Measures fixed-point arithmetic on a simulated ATmega328P: cycles, error, flash and "
        "stack.\n"
        "bench/run_all.sh runs all of it; each sub-command runs alone too.");
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    std::string output = "results/data";
    unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    fixbench::Action action;

    const auto add_command = [&](const char* name, const std::string& description) {
        CLI::App* command = app.add_subcommand(name, description);
        command->add_option("--output", output, "folder that the data files are written to")
            ->capture_default_str();
        command->add_option("--threads", threads, "threads to run on")
            ->capture_default_str()
            ->check(CLI::Range(1, 1024));
        return command;
    };

    std::vector<std::filesystem::path> programs;
    for (const std::string& name : catalogue::programs()) {
        programs.push_back(fmt::format(FIXBENCH_DEVICE_FOLDER "/{}.elf", name));
    }
    operations::CycleOptions cycles;
    cycles.programs = programs;
    CLI::App* command = add_command(
        "cycles",
        "Cycles, stack, flash and error of each subject on classes of operands.\n"
        "Writes operations.csv and operations.json (Google Benchmark's schema).\n\n"
        "A subject is an extern \"C\" function <operation>_<format>_<implementation> of a device\n"
        "program, by default q4_4.elf, q8_8.elf, q16_16.elf, q8_24.elf, q32_32.elf and\n"
        "rivals.elf in\n"
        "  " FIXBENCH_DEVICE_FOLDER
        "\n"
        "(avr-nm lists them), for avr-gcc's calling convention: any other tool can call it too.\n"
        "Cycles include call (4) and ret (4), not the loading of operands.\n\n"
        "Operand classes: small |x| < 1; physics 0.01..20; full, log-uniform over the range;\n"
        "uniform, every raw alike; "
        "published, those of the rebuilt harness; boundary, an annotated table; all, every input\n"
        "where there are at most 65536.\n\n"
        "Example: fixbench cycles --operation divide --format q16_16,float --operands physics");
    add_selection(*command, cycles.selection, true);
    command->add_option("--program", cycles.programs, "device programs, e.g. one of your own")
        ->check(CLI::ExistingFile);
    command->add_option("--samples", cycles.samples, "operands of each random class")
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40));
    command->callback([&] {
        action = [&] {
            cycles.output = output;
            cycles.threads = threads;
            return held(operations::measure_cycles(cycles));
        };
    });

    operations::AccuracyOptions accuracy;
    command = add_command(
        "accuracy",
        "Error of the portable code, which the device's results equal bit for bit, over whole "
        "input\n"
        "spaces where they are finite enough (bound `exact`), else over boundary tables, random\n"
        "operands and a search for the worst case (bound `lower bound`).\n"
        "Writes accuracy.csv, error_histograms.csv and error_along_input.csv.\n\n"
        "Example: fixbench accuracy --operation sqrt --format q16_16");
    add_selection(*command, accuracy.selection, false);
    command->add_flag(
        "--quick", accuracy.quick,
        "sample the input spaces of more than 2^24 points instead of exhausting them");
    command->callback([&] {
        action = [&] {
            accuracy.output = output;
            accuracy.threads = threads;
            return held(operations::measure_accuracy(accuracy));
        };
    });

    operations::VerifyOptions verify;
    verify.programs = programs;
    command = add_command("verify",
                          "The device's machine code against the host, bit for bit: boundary "
                          "tables, random operands,\n"
                          "all inputs where there are at most 65536; the calling convention, stray "
                          "writes, and which\n"
                          "instructions were executed. Writes kernels.csv.\n\n"
                          "Example: fixbench verify --operation divide --samples 10000000");
    add_selection(*command, verify.selection, false);
    command->add_option("--program", verify.programs, "device programs")->check(CLI::ExistingFile);
    command->add_option("--samples", verify.samples, "random operands of each subject")
        ->capture_default_str();
    command->callback([&] {
        action = [&] {
            verify.output = output;
            verify.threads = threads;
            const std::uint64_t differing = operations::verify_kernels(verify);
            if (differing != 0) fmt::print(stderr, "fixbench: {} subjects differ\n", differing);
            return differing == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
        };
    });

    table_3_2::Options table;
    table.programs_csv = FIXBENCH_TABLE_3_2_PROGRAMS;
    table.division_elf = FIXBENCH_TABLE_3_2_DIVISION_ELF;
    table.published = reference::published_folder();
    bool table_quick = false;
    command =
        add_command("table",
                    "The published timing table, measured again cell by cell with a verdict,\n"
                    "the cost of its division by operand, and Table 3.1, computed.\n"
                    "Writes table_3_1.csv, table_3_2.csv, division_cycles.csv and, with the\n"
                    "search over hypotheses, table_3_2_hypotheses.csv.");
    command->add_flag("--quick", table_quick, "without the search over hypotheses");
    command->callback([&] {
        action = [&] {
            table.data = output;
            table.search = !table_quick;
            table_3_2::measure_table_3_2(table);
            return EXIT_SUCCESS;
        };
    });

    machine_code::Options exhaustive;
    exhaustive.program = FIXBENCH_DEVICE_FOLDER "/q16_16.elf";
    std::string shard = "1/1";
    command = add_command(
        "exhaustive",
        "Kernels as machine code, translated instruction by instruction and run over all inputs\n"
        "where there are at most 2^32 (bound `exact`), else over a long search (`lower bound`).\n"
        "About a minute a function. Rows go into exhaustive.csv; those of other functions stay.\n"
        "With --shard i/n a part of the work goes into files that `fixbench merge` joins:\n\n"
        "  parallel fixbench exhaustive --shard {}/16 ::: $(seq 16); fixbench merge FILES\n\n"
        "Example: fixbench exhaustive --symbol sqrt_q16_16_default,sin_q16_16_default");
    command->add_option("--program", exhaustive.program, "device program")
        ->check(CLI::ExistingFile)
        ->capture_default_str();
    command
        ->add_option("--symbol", exhaustive.symbols,
                     "only these functions; else all that can be judged")
        ->delimiter(',');
    command
        ->add_option("--search-operands", exhaustive.search_operands,
                     "operands of a search, for functions of more than 32 bits of operands")
        ->capture_default_str();
    command->add_option("--shard", shard, "i/n: the i-th of n parts of the work")
        ->capture_default_str();
    command->callback([&] {
        action = [&] {
            exhaustive.output = output;
            exhaustive.threads = threads;
            exhaustive.shard = machine_code::parse_shard(shard);
            return held(machine_code::run_exhaustive(exhaustive));
        };
    });

    std::vector<std::filesystem::path> shards;
    command = add_command("merge",
                          "Joins the files of all shards of `exhaustive` into exhaustive.csv.\n"
                          "Writes what a run without shards would have written.");
    command->add_option("files", shards, "the files exhaustive.<symbol>.<i>-of-<n>.json")
        ->required()
        ->check(CLI::ExistingFile);
    command->callback(
        [&] { action = [&] { return held(machine_code::merge_exhaustive(shards, output)); }; });

    profile::add_profile_command(app, action);
    features::add_features_command(app, action);
    growth::add_growth_command(app, action);

    std::string results = "results";
    command = app.add_subcommand("report", "Figures and pages out of the data files.");
    command
        ->add_option("--results", results,
                     "folder that holds data/ and gets figures/ and README.md")
        ->capture_default_str();
    command->callback([&] {
        action = [&] {
            execl(FIXBENCH_PYTHON, FIXBENCH_PYTHON, FIXBENCH_REPORT, "--results", results.c_str(),
                  nullptr);
            throw std::runtime_error(fmt::format("cannot run {}", FIXBENCH_PYTHON));
            return EXIT_FAILURE;
        };
    });

    calibration::add_calibrate_command(app, action);
    haptic::add_haptic_command(app, action);
    live::add_lever_command(app, action);
    haptic::region::add_region_command(app, action);
    scene_bench::add_scenes_command(app, action);
    stability::add_stability_command(app, action);
    scene_bench::add_workload_command(app, action);

    CLI11_PARSE(app, argc, argv);
    try {
        return action();
    } catch (const std::exception& error) {
        fmt::print(stderr, "fixbench: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
