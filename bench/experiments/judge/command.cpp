// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench judge, operands and corpus: for anybody's arithmetic.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>

#include "bench/experiments/judge/corpus.hpp"
#include "bench/experiments/judge/pipe.hpp"
#include "bench/experiments/judge/program.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/names.hpp"

namespace judge {
namespace {

using fixbench::Call;

const fixbench::Registration judge({
    .name = "judge",
    .description =
        "Judges anybody's function against what it is said to compute: cycles and stack on the\n"
        "simulated chip by class of operands, error, worst operands, calling convention and\n"
        "stray writes. With --pipe it judges results that any program has computed, as lines of\n"
        "operands and results. File: judge.csv.\n\n"
        "--as says what is computed. Either <operation>:<format>, followed by :published or\n"
        ":saturating for another arithmetic than the default; or a formula over raw numbers,\n"
        "<type>(<type>,...)=<formula> of the operands a, b, c ..., with the types int8..int64,\n"
        "uint8..uint32 and the fixed-point formats, which stand for their values. The error is\n"
        "in units in the last place (ulp) of the result.\n\n"
        "A line of --pipe is one call: operands and results as decimal raw numbers, separated\n"
        "by blanks; `#` begins a comment.\n\n"
        "Exit status 1 if a result is wrong: if an operation contradicts its definition, or if\n"
        "a formula is off by more than half an ulp. With --bound, both are wrong beyond that\n"
        "bound.\n\n"
        "Example: fixbench judge program.elf --function my_sqrt --as sqrt:q16_16 --bound 1\n"
        "         fixbench judge program.elf --function mul --as 'int32(int32,int32)=a*b/2^16'\n"
        "         fixbench operands --as sqrt:q8_8 --class all | ./mine |\n"
        "             fixbench judge --pipe --as sqrt:q8_8",
    .prints = {"judge.csv"},
    .add =
        [](CLI::App& command) {
            struct Asked {
                ProgramOptions options;
                bool pipe = false;
            };
            const auto asked = std::make_shared<Asked>();
            CLI::Option* const program =
                command.add_option("program", asked->options.program, "an ELF file for the chip")
                    ->check(CLI::ExistingFile);
            CLI::Option* const function =
                command.add_option("--function", asked->options.function,
                                   "its function, which follows avr-gcc's calling convention");
            program->needs(function);
            command.add_option("--as", asked->options.claim, "what it is said to compute")
                ->required();
            command
                .add_option("--bound", asked->options.bound_ulp,
                            "largest error in ulp that still counts as right")
                ->check(CLI::Range(0.0, 1e18));
            CLI::Option* const samples =
                command
                    .add_option("--samples", asked->options.samples,
                                "operands of each random class and of the boundary table")
                    ->capture_default_str()
                    ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40));
            command.add_flag("--pipe", asked->pipe, "judge lines from the standard input")
                ->excludes(program)
                ->excludes(function)
                ->excludes(samples);
            return [asked](const Call& call) {
                ProgramOptions& options = asked->options;
                if (!asked->pipe && (options.program.empty() || options.function.empty()))
                    throw std::invalid_argument(
                        "judge needs a program and --function, or --pipe and lines on the standard "
                        "input");
                options.output = call.output;
                options.threads = call.threads;
                std::uint64_t wrong;
                if (asked->pipe) {
                    const auto claim = parse_claim(options.claim, options.bound_ulp);
                    const Piped piped = judge_lines(*claim, stdin);
                    Figures row = figures_of(*claim, piped.errors);
                    row.claim = options.claim;
                    row.samples = piped.calls;
                    row.regular = piped.errors.count() - piped.errors.underflowed();
                    wrong = row.violations;
                    records::table_of(std::vector{row}).save(call.output / "judge.csv");
                } else {
                    wrong = judge_program(options);
                }
                return wrong == 0 ? fixbench::held : fixbench::check_failed;
            };
        },
});

const fixbench::Registration operands({
    .name = "operands",
    .description =
        "Prints operands as text, one call a line, for any program to compute with: decimal raw\n"
        "numbers, separated by blanks. `#` begins a comment, which explains boundary operands.\n\n"
        "Classes: small, |x| < 1; physics, 0.01..20; full, log-uniform over the range; uniform;\n"
        "published; boundary, an annotated table; all, every input of at most 32 bits.\n\n"
        "Example: fixbench operands --operation divide --format q8_24 --class boundary",
    .add =
        [](CLI::App& command) {
            struct Asked {
                std::string operation, format, claim, operand_class = "boundary";
                std::uint64_t samples = 20000, seed = 1;
            };
            const auto asked = std::make_shared<Asked>();
            CLI::Option* const operation =
                command.add_option("--operation", asked->operation, "e.g. divide");
            CLI::Option* const format =
                command.add_option("--format", asked->format, "e.g. q8_24")->needs(operation);
            operation->needs(format);
            command
                .add_option("--as", asked->claim,
                            "operation and format, or a formula, as for judge")
                ->excludes(operation)
                ->excludes(format);
            command.add_option("--class", asked->operand_class, "which operands")
                ->capture_default_str();
            command.add_option("--samples", asked->samples, "number of operands of a random class")
                ->capture_default_str()
                ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40));
            command.add_option("--seed", asked->seed, "seed of a random class")
                ->capture_default_str();
            return [asked](const Call&) {
                if (asked->claim.empty()) {
                    if (asked->operation.empty())
                        throw std::invalid_argument(
                            "operands needs --operation and --format, or --as");
                    asked->claim = asked->operation + ":" + asked->format;
                }
                std::vector<std::string> classes = {"boundary", "all"};
                for (const operands::OperandClass each : operands::operand_classes)
                    classes.emplace_back(operands::class_name(each));
                fixbench::check_names("--class", {asked->operand_class}, classes);
                write_operands(*parse_claim(asked->claim), asked->operand_class, asked->samples,
                               asked->seed, stdout);
                return fixbench::held;
            };
        },
});

const fixbench::Registration corpus({
    .name = "corpus",
    .description =
        "Writes the boundary table and the worst measured operands of each operation and\n"
        "format, as files <operation>_<format>.txt for the tests of others. `fixbench report`\n"
        "writes them to results/corpus/.\n\n"
        "Example: fixbench corpus --data results/data --output build/corpus",
    .add =
        [](CLI::App& command) {
            struct Asked {
                std::filesystem::path data, output;
            };
            const auto asked = std::make_shared<Asked>();
            command.add_option("--data", asked->data, "folder of the measured tables")
                ->required()
                ->check(CLI::ExistingDirectory);
            command.add_option("--output", asked->output, "folder for the corpora")->required();
            return [asked](const Call&) {
                write_corpora(asked->data, asked->output);
                return fixbench::held;
            };
        },
});

}  // namespace
}  // namespace judge
