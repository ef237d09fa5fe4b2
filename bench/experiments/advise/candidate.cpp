// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/advise/candidate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/advise/driver.hpp"

namespace advise {
namespace {

namespace fs = std::filesystem;
constexpr simulator::Cycle chip_cycles = 50'000'000;  // per format: half a second of simulation

void note_errors(Candidate& candidate, const std::vector<double>& exact) {
    double most = 0, squares = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double error = std::abs(candidate.format.value(candidate.outputs[i]) - exact[i]);
        if (!(error <= most)) most = error;
        squares += error * error;
    }
    candidate.advice.max_error = most;
    candidate.advice.rms_error = std::sqrt(squares / static_cast<double>(exact.size()));
}

// Compiles the program in the formats, with these additional compiler options. Throws Failure if
// that fails.
void compile_formats(const Options& options, const std::vector<Format>& formats,
                     const fs::path& runner, std::vector<std::string> further = {}) {
    std::string list = "-DFORMATS=";
    for (const Format& format : formats)
        list += fmt::format("X({}, {}) ", format.integer_bits, format.fraction_bits);
    further.push_back(list);
    compile_for_host(options.program, "formats.cpp", further, runner);
}

}  // namespace

std::vector<Format> candidates(int integer_bits) {
    std::vector<Format> formats;
    const auto add = [&](int bits, int width) {
        if (bits < integer_bits || bits > width) return;
        if (std::none_of(formats.begin(), formats.end(), [&](const Format& each) {
                return each.width() == width && each.integer_bits == bits;
            }))
            formats.push_back({bits, width - bits});
    };
    for (const int width : {8, 16, 24, 32, 64}) {
        add(integer_bits, width);
        add(integer_bits + 1, width);
        if (width == 24 || width == 32) add(8, width);
        add(width / 2, width);
    }
    return formats;
}

std::vector<Candidate> run_on_host(const Options& options, const fs::path& scratch,
                                   const fs::path& rows, std::vector<Format> formats,
                                   const Recorded& recorded) {
    const fs::path runner = scratch / "formats";
    std::vector<Candidate> refused;
    try {
        compile_formats(options, formats, runner);
    } catch (const Failure&) {
        std::erase_if(formats, [&](const Format& format) {
            try {
                compile_formats(options, {format}, runner, {"-fsyntax-only"});
                return false;
            } catch (const Failure& failure) {
                Candidate& added = refused.emplace_back();
                added.format = format;
                added.advice.format = format.name();
                added.advice.max_error = added.advice.rms_error = std::nan("");
                added.advice.failure = failure.what();
                return true;
            }
        });
        compile_formats(options, formats, runner);
    }
    std::vector<Candidate> list;
    for (const Words& words : lines_of(options.program, {runner, rows})) {
        if (words[0] == "format") {
            Candidate& added = list.emplace_back();
            added.format = {std::stoi(words[1]), std::stoi(words[2])};
            added.advice.format = added.format.name();
            if (added.format.is_float()) added.operations = recorded.operations;
        } else if (words[0] == "output") {
            list.back().outputs.push_back(std::stoll(words[1]));
        } else if (words[0] == "operation") {
            note_operation(list.back().operations, words, recorded.outputs.size());
        } else if (!list.back().format.is_float()) {
            list.back().advice.overflows = std::stoull(words[1]);
            list.back().advice.underflows = std::stoull(words[2]);
            list.back().advice.bits_left = list.back().format.integer_bits - recorded.integer_bits;
        }
    }
    for (Candidate& each : list) {
        note_errors(each, recorded.outputs);
        each.advice.meets =
            each.advice.max_error <= options.error && each.advice.overflows.value_or(0) == 0;
    }
    list.insert(list.end(), refused.begin(), refused.end());
    return list;
}

void measure_on_chip(const Options& options, const Data& data, const fs::path& scratch,
                     const std::vector<double>& exact, Candidate& candidate) {
    const Format& format = candidate.format;
    Advice& advice = candidate.advice;
    const fs::path file = scratch / (format.name() + ".elf");
    std::vector<std::string> definitions;
    std::string parameters, arguments;
    for (std::size_t i = 0; i < data.names.size(); ++i) {
        parameters += fmt::format("{}Raw x{}", i ? ", " : "", i);
        arguments += fmt::format("{}number(x{})", i ? ", " : "", i);
    }
    definitions.push_back("-DPARAMETERS=" + parameters);
    definitions.push_back("-DARGUMENTS=" + arguments);
    if (!format.is_float()) {
        definitions.push_back(fmt::format("-DINTEGER_BITS={}", format.integer_bits));
        definitions.push_back(fmt::format("-DFRACTION_BITS={}", format.fraction_bits));
    }
    try {
        compile_for_chip(options.program, definitions, file);
        const simulator::Elf elf(file);
        advice.flash_bytes = elf.flash_bytes();
        advice.ram_bytes = elf.ram_bytes();
        simulator::Cycle sum = 0;
        std::uint32_t most = 0;
        std::uint16_t stack = 0;
        std::size_t row_of_all = 0;
        for (const auto& run : data.runs) {
            simulator::Chip chip(elf);
            chip.run_until_function("main");
            simulator::DeviceFunction step(
                chip, "advise_step",
                {format.bytes(), std::vector<int>(data.names.size(), format.bytes())});
            for (std::size_t i = 0; i < run.size() && sum < chip_cycles; ++i) {
                std::vector<std::uint64_t> patterns;
                for (const double x : run[i])
                    patterns.push_back(static_cast<std::uint64_t>(format.pattern(x)));
                const simulator::Outcome outcome = step.call(patterns);
                const int spare = 64 - 8 * format.bytes();
                const std::int64_t pattern =
                    static_cast<std::int64_t>(outcome.result << spare) >> spare;
                std::int64_t& expected = candidate.outputs[row_of_all + i];
                if (format.is_float()) {
                    expected = pattern;
                } else if (pattern != expected) {
                    throw Failure(
                        fmt::format("in row {} the chip returns the pattern {} and the host {}",
                                    row_of_all + i + 1, pattern, expected));
                }
                sum += outcome.cycles;
                most = std::max(most, outcome.cycles);
                stack = std::max(stack, outcome.stack_bytes);
                ++advice.chip_steps;
            }
            row_of_all += run.size();
        }
        advice.cycles_mean = static_cast<double>(sum) / static_cast<double>(advice.chip_steps);
        advice.cycles_max = most;
        advice.stack_bytes = stack;
        note_errors(candidate, exact);
        advice.meets &= advice.max_error <= options.error;
    } catch (const std::exception& failure) {
        advice.meets = false;
        advice.failure = failure.what();
    }
}

}  // namespace advise
