// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench cycles, accuracy, verify and throughput.
#include <fmt/format.h>

#include <memory>

#include "bench/chip/simulator/elf.hpp"
#include "bench/experiments/operations/host_throughput.hpp"
#include "bench/experiments/operations/measure_accuracy.hpp"
#include "bench/experiments/operations/measure_cycles.hpp"
#include "bench/experiments/operations/measure_other_chips.hpp"
#include "bench/experiments/operations/verify_kernels.hpp"
#include "bench/lab/catalogue/catalogue.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "this_build.hpp"

namespace operations {
namespace {

using fixbench::Call;
using fixbench::Mode;

const std::filesystem::path device_folder = build_folder() / "bench/device";
const auto max_samples = CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40);

std::vector<std::filesystem::path> all_programs() {
    std::vector<std::filesystem::path> programs;
    for (const std::string& name : catalogue::programs())
        programs.push_back(device_folder / (name + ".elf"));
    return programs;
}

void add_filters(CLI::App& command, Selection& selection) {
    fixbench::add_selection(command, "--operation", selection.operations,
                            "only these operations, e.g. multiply,divide,sqrt,atan2");
    fixbench::add_selection(command, "--format", selection.formats,
                            "only these formats, e.g. q16_16,q8_8,float");
    fixbench::add_selection(command, "--implementation", selection.implementations,
                            "only these implementations, e.g. default,published,libc");
}

// The names that subjects can be selected by.
struct Known {
    std::vector<std::string> operations, formats, implementations;

    void add(const reference::Subject& subject, const std::string& implementation) {
        operations.emplace_back(reference::shape(subject.operation).name);
        formats.push_back(reference::format_name(subject.format));
        implementations.push_back(implementation);
    }
    void check(const Selection& selection) const {
        fixbench::check_names("--operation", selection.operations, operations);
        fixbench::check_names("--format", selection.formats, formats);
        fixbench::check_names("--implementation", selection.implementations, implementations);
    }
};

Known known_to_host() {
    Known known;
    for (const HostSubject& each : host_subjects()) known.add(each.subject, each.implementation);
    return known;
}

// The user's own programs, or those of the build, which are built if they are missing or out of
// date.
void settle_programs(std::vector<std::filesystem::path>& programs) {
    if (!programs.empty()) return;
    fixbench::build({"subjects"});
    programs = all_programs();
}

// FIXBENCH_OTHER_CHIPS is a list written by CMake, separated by commas.
std::vector<std::string> listed(std::string_view names) {
    std::vector<std::string> list;
    for (std::size_t end; !names.empty(); names.remove_prefix(std::min(end + 1, names.size()))) {
        end = std::min(names.find(','), names.size());
        list.emplace_back(names.substr(0, end));
    }
    return list;
}

// Builds the programs of the chips for each format that is asked for.
OtherChipOptions settle_other_chips(const std::vector<std::string>& chips, CycleOptions& cycles) {
    if (!cycles.programs.empty())
        throw std::invalid_argument("--mcu builds its programs, and takes no --program");
    fixbench::check_names("--mcu", chips, listed(FIXBENCH_OTHER_CHIPS));
    Known known = known_to_host();
    known.formats = catalogue::formats();
    known.check(cycles.selection);
    fixbench::check_names("--operands", cycles.selection.operands, other_chip_operands);
    if (cycles.selection.formats.empty()) cycles.selection.formats = known.formats;
    const std::filesystem::path programs = device_folder / "other_chips";
    std::vector<std::string> targets;
    for (const std::string& chip : chips)
        for (const std::string& format : cycles.selection.formats)
            targets.push_back(programs / chip / format / "programs.csv");
    fixbench::build(targets);
    OtherChipOptions options;
    options.chips = chips;
    options.programs = programs;
    options.selection = cycles.selection;
    return options;
}

int held(std::uint64_t violations) {
    if (violations == 0) return fixbench::held;
    fmt::print(stderr, "fixbench: {} results contradict their definition\n", violations);
    return fixbench::check_failed;
}

const fixbench::Registration cycles({
    .name = "cycles",
    .description =
        "Cycles, stack, flash and error of each subject on classes of operands.\n"
        "Files: operations.csv, flash.csv (of programs that use several operations) and\n"
        "operations.json (Google Benchmark's schema). Means are over the operands whose result\n"
        "is rounded: neither pinned by definition nor below half an ulp.\n\n"
        "A subject is an extern \"C\" function <operation>_<format>_<implementation> of a\n"
        "device program. The default programs are those of each format, such as q16_16.elf,\n"
        "q16_16_angles.elf, q16_16_powers.elf and q16_16_auxiliary.elf,\n"
        "correctly_rounded_*.elf, unsigned.elf, roundings.elf and rivals.elf, in\n"
        "  " +
        device_folder.string() +
        "\n"
        "(avr-nm lists their functions). They follow avr-gcc's calling convention, so any other\n"
        "tool can call them too. Cycles include call (4) and ret (4), but not the loading of\n"
        "operands.\n\n"
        "Operand classes: small, |x| < 1; physics, 0.01..20 (exp: up to 10); full, log-uniform\n"
        "over the range; uniform, every raw number equally likely; published, those of the\n"
        "rebuilt harness; boundary, an annotated table; all, every input if there are at most\n"
        "65536.\n\n"
        "Example: fixbench cycles --operation divide --format q16_16,float --operands physics\n"
        "         fixbench cycles --mcu atmega2560,attiny85 --format q16_16",
    .prints = {"operations.csv", "other_chips.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<CycleOptions>();
            const auto chips = std::make_shared<std::vector<std::string>>();
            add_filters(command, options->selection);
            fixbench::add_selection(command, "--mcu", *chips,
                                    "the library's functions on these chips; file: "
                                    "other_chips.csv");
            fixbench::add_selection(command, "--operands", options->selection.operands,
                                    "only these operand classes");
            command
                .add_option("--program", options->programs, "device programs, e.g. one of your own")
                ->check(CLI::ExistingFile);
            command.add_option("--samples", options->samples, "operands of each random class")
                ->capture_default_str()
                ->check(max_samples);
            return [options, chips](const Call& call) {
                if (!chips->empty()) {
                    OtherChipOptions others = settle_other_chips(*chips, *options);
                    others.output = call.output;
                    others.samples = options->samples;
                    others.threads = call.threads;
                    return held(measure_other_chips(others));
                }
                settle_programs(options->programs);
                Known known;
                for (const auto& program : options->programs) {
                    const simulator::Elf elf(program);
                    for (const std::string& symbol : subjects_of(elf)) {
                        const reference::NamedSubject named = reference::parse_symbol(symbol);
                        known.add(named.subject, named.implementation);
                    }
                }
                known.check(options->selection);
                std::vector<std::string> classes = {"boundary", "all"};
                for (const operands::OperandClass each : operands::operand_classes)
                    classes.emplace_back(operands::class_name(each));
                fixbench::check_names("--operands", options->selection.operands, classes);
                options->output = call.output;
                options->threads = call.threads;
                return held(measure_cycles(*options));
            };
        },
    .steps = {{.name = "cycles",
               .arguments = [](const Mode& mode) -> std::vector<std::string> {
                   std::vector<std::string> arguments = {"cycles", "--output", mode.data,
                                                         "--samples", mode.quick ? "300" : "20000"};
                   // Without the class `all`: 65536 inputs take longer than the rest.
                   if (mode.quick)
                       arguments.insert(
                           arguments.end(),
                           {"--operands", "boundary,small,physics,full,uniform,published"});
                   return arguments;
               },
               .writes = {"operations.csv", "flash.csv", "operations.json"},
               .targets = {"subjects"},
               .reads = {device_folder},
               .full_seconds = 450,
               .quick_seconds = 60}},
});

const fixbench::Registration accuracy({
    .name = "accuracy",
    .description =
        "Error of the portable code, which the device's results equal bit for bit: over the\n"
        "whole input space if it is small enough (operands `all`), otherwise over boundary\n"
        "tables, random operands and a search for the worst case.\n"
        "Files: accuracy.csv, error_histograms.csv and error_along_input.csv.\n\n"
        "Example: fixbench accuracy --operation sqrt --format q16_16",
    .prints = {"accuracy.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<AccuracyOptions>();
            add_filters(command, options->selection);
            CLI::Option* const quick = command.add_flag(
                "--quick", options->quick,
                "sample input spaces of more than 2^16 points instead of exhausting them");
            command
                .add_option("--keep", options->kept,
                            "folder of an earlier run, from which rows of 2^32 points are "
                            "taken if samples of the present code agree with them")
                ->check(CLI::ExistingDirectory)
                ->excludes(quick);
            return [options](const Call& call) {
                known_to_host().check(options->selection);
                options->output = call.output;
                options->threads = call.threads;
                return held(measure_accuracy(*options));
            };
        },
    .steps = {{.name = "accuracy",
               .arguments =
                   [](const Mode& mode) {
                       std::vector<std::string> arguments = {"accuracy", "--output", mode.data};
                       if (mode.quick)
                           arguments.push_back("--quick");
                       else if (!mode.exhaustive)
                           arguments.insert(arguments.end(), {"--keep", mode.committed});
                       return arguments;
                   },
               .writes = {"accuracy.csv", "error_histograms.csv", "error_along_input.csv"},
               .full_seconds = 200,
               .quick_seconds = 25}},
});

const fixbench::Registration verify({
    .name = "verify",
    .description =
        "Compares the device's machine code with the host, bit for bit: on boundary tables,\n"
        "random operands and, for fast functions with at most 65536 inputs, all inputs. Also\n"
        "checks the calling convention and stray writes, and records which instructions were\n"
        "executed.\n"
        "File: kernels.csv.\n\n"
        "Example: fixbench verify --operation divide --samples 10000000",
    .prints = {"kernels.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<VerifyOptions>();
            add_filters(command, options->selection);
            command.add_option("--program", options->programs, "device programs")
                ->check(CLI::ExistingFile);
            command.add_option("--samples", options->samples, "random operands of each subject")
                ->capture_default_str()
                ->check(max_samples);
            return [options](const Call& call) {
                settle_programs(options->programs);
                known_to_host().check(options->selection);
                options->output = call.output;
                options->threads = call.threads;
                const std::uint64_t differing = verify_kernels(*options);
                if (differing == 0) return fixbench::held;
                fmt::print(stderr, "fixbench: {} subjects differ from the host\n", differing);
                return fixbench::check_failed;
            };
        },
    .steps =
        {{.name = "verify",
          .arguments = [](const Mode& mode) -> std::vector<std::string> {
              return {"verify", "--samples", mode.quick ? "200" : "500000", "--output", mode.data};
          },
          .writes = {"kernels.csv"},
          .targets = {"subjects"},
          .reads = {device_folder},
          .full_seconds = 300,
          .quick_seconds = 30}},
});

const fixbench::Registration throughput({
    .name = "throughput",
    .description = "What the portable code costs on this machine, measured with Google Benchmark.\n"
                   "File: host_throughput.json. Names are those of the device subjects.",
    .prints = {"host_throughput.json"},
    .add =
        [](CLI::App& command) {
            const auto seconds = std::make_shared<double>(0.2);
            command.add_option("--seconds", *seconds, "seconds that each function runs")
                ->capture_default_str()
                ->check(CLI::Range(0.001, 60.0));
            return [seconds](const Call& call) {
                measure_throughput(call.output / "host_throughput.json", *seconds);
                return fixbench::held;
            };
        },
    .steps = {{.name = "throughput",
               .arguments = [](const Mode& mode) -> std::vector<std::string> {
                   return {"throughput", "--seconds", mode.quick ? "0.02" : "0.2", "--output",
                           mode.data};
               },
               .writes = {"host_throughput.json"},
               .full_seconds = 20,
               .quick_seconds = 5,
               .times_host = true}},
});

}  // namespace
}  // namespace operations
