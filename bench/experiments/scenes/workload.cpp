// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/workload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/scenes/call_trace.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/verdict_row.hpp"
#include "reference/published.hpp"

namespace scene_bench {
namespace {

using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Elf;

constexpr unsigned steps_run = 400;  // 2 s of 5 ms
constexpr unsigned max_rounds = 10;
constexpr simulator::Cycle longest_step = 10'000'000;
constexpr std::array flags = {"Os", "O2", "O3"};
// A round takes more cycles than this; other differences between programs with different limits are
// smaller.
constexpr std::uint32_t min_round = 200;
constexpr const char* rounds_flag = "O2";

struct Arithmetic {
    std::string program;   // in the programs' names
    std::string recorded;  // in the data
};
const std::vector<Arithmetic> arithmetics = {
    {"published", "fixed_16_16"}, {"nearest", "q16_16"}, {"float", "float"}};

enum Part : std::size_t {
    find_contacts,
    resolve_contacts,
    square_root,
    multiply,
    divide,
    add,
    part_count
};
const std::vector<Lane> lanes = {
    {"find contacts", {"_ZN7Watched19collect_constraints"}},
    {"resolve contacts", {"_ZN7Watched17solve_constraints"}},
    {"square root", {"published_sqrt", "fixedpoint_length", "fixedpoint_sqrt_q", "sqrt"}},
    {"multiply", {"published_multiply", "fixedpoint_multiply", "fixedpoint_dot", "__mulsf3"}},
    {"divide", {"published_divide", "fixedpoint_divide", "__divsf3"}},
    {"add", {"__addsf3", "__subsf3"}}};

struct Cost {
    std::uint64_t calls = 0, cycles = 0, min = std::numeric_limits<std::uint64_t>::max(), max = 0;
    void add(std::uint64_t sample) {
        ++calls;
        cycles += sample;
        min = std::min(min, sample);
        max = std::max(max, sample);
    }
    double mean() const { return static_cast<double>(cycles) / static_cast<double>(calls); }
};

// The steps of a program, taken apart.
struct Steps {
    Cost step;
    std::array<Cost, part_count> parts;
    double share(Part part) const {
        return static_cast<double>(parts[part].cycles) / static_cast<double>(step.cycles);
    }
    std::vector<Call> trace;  // of the longest step, in cycles from its start
    unsigned particle_bytes = 0, world_bytes = 0, flash_bytes = 0;
};

Steps take_apart(const std::filesystem::path& program) {
    Chip chip{Elf(program)};
    CallTrace trace(chip, lanes);
    Steps result;
    chip.run_until_function("main");
    const auto tell = [&](const char* name) {
        DeviceFunction function(chip, name, {.result = 2, .operands = {}});
        return function().as<std::uint16_t>();
    };
    result.particle_bytes = tell("particle_bytes");
    result.world_bytes = tell("world_bytes");
    result.flash_bytes = chip.elf().flash_bytes();
    for (unsigned i = 0; i < steps_run; ++i) {
        chip.run_until_function("step");
        const simulator::Cycle begin = chip.cycle() - 4;  // its call
        std::vector<Call> calls = trace.run_function();
        const simulator::Cycle cycles = chip.cycle() - begin;
        result.step.add(cycles);
        for (Call& call : calls) {
            result.parts[call.lane].add(call.end - call.begin);
            call.begin -= begin;
            call.end -= begin;
        }
        if (cycles == result.step.max) {
            result.trace = std::move(calls);
        }
    }
    return result;
}

// The cost of a step by the number of rounds of contact resolution that it makes, including the
// last round, which finds nothing to resolve. Each step of the run is made by eleven programs with
// different limits of rounds, 0 to 10, from the same state. The number of rounds is the first limit
// beyond which the cycles stay the same.
struct Rounds {
    std::array<Cost, max_rounds + 1> cost;         // by rounds, over the steps that make as many
    std::array<unsigned, max_rounds + 1> steps{};  // the number of steps that make as many
};

Rounds count_rounds(const std::filesystem::path& folder, const std::string& arithmetic) {
    std::vector<std::unique_ptr<Chip>> chips;
    std::vector<DeviceFunction> step;
    for (unsigned rounds = 0; rounds <= max_rounds; ++rounds) {
        chips.push_back(
            std::make_unique<Chip>(Elf(folder / fmt::format("published_lever.{}.{}.{}.elf",
                                                            arithmetic, rounds_flag, rounds))));
        chips.back()->run_until_function("step");
        step.emplace_back(*chips.back(), "step", simulator::Signature{.result = 0, .operands = {}});
        step.back().set_budget(longest_step);
    }
    const auto world = [&](unsigned rounds) {
        const simulator::Symbol& symbol = chips[rounds]->elf().object("world");
        return std::span(chips[rounds]->data() + (symbol.address & 0xffff), symbol.size);
    };
    Rounds result;
    for (unsigned i = 0; i < steps_run; ++i) {
        const std::vector<std::uint8_t> before(world(max_rounds).begin(), world(max_rounds).end());
        std::array<std::uint32_t, max_rounds + 1> cycles;
        for (unsigned rounds = 0; rounds <= max_rounds; ++rounds) {
            if (world(rounds).size() != before.size())
                throw std::runtime_error(
                    "the workload's programs differ in the size of their world");
            std::copy(before.begin(), before.end(), world(rounds).begin());
            cycles[rounds] = step[rounds]().cycles;
        }
        unsigned gone = max_rounds;
        while (gone > 0 && cycles[gone] < cycles[gone - 1] + min_round) --gone;
        ++result.steps[gone];
        for (unsigned rounds = 0; rounds <= gone; ++rounds) result.cost[rounds].add(cycles[rounds]);
    }
    return result;
}

double microseconds(double cycles) { return cycles * 1e6 / Chip::frequency; }
double milliseconds(double cycles) { return cycles * 1e3 / Chip::frequency; }
double per_second(double cycles) { return Chip::frequency / cycles; }

constexpr const char* explained = "explained";
constexpr const char* not_reproducible = "not reproducible";

// The rows of workload.csv.
struct Sheet {
    std::vector<lab::VerdictRow> rows;

    void compare(const std::string& quantity, const std::string& arithmetic, double measured,
                 const std::string& reason, const char* otherwise = not_reproducible) {
        rows.push_back(lab::compared(quantity, arithmetic, measured, reason, otherwise));
    }
    void tell(const std::string& quantity, const std::string& arithmetic, double measured,
              const std::string& unit, const std::string& reason) {
        rows.push_back(lab::told(quantity, arithmetic, measured, unit, reason));
    }
};

using Runs = std::map<std::string, Steps>;

const Steps& run_of(const Runs& runs, const char* scene, const std::string& arithmetic,
                    const char* flag) {
    return runs.at(fmt::format("{}.{}.{}", scene, arithmetic, flag));
}

// The flag with the shortest mean step.
const char* best_flag(const Runs& runs, const char* scene, const std::string& arithmetic) {
    return *std::min_element(flags.begin(), flags.end(), [&](const char* a, const char* b) {
        return run_of(runs, scene, arithmetic, a).step.mean() <
               run_of(runs, scene, arithmetic, b).step.mean();
    });
}

std::string span(const Cost& cost) {
    return fmt::format("{:.0f} to {:.0f} us, as the operands are", microseconds(cost.min),
                       microseconds(cost.max));
}

// The published program's figures, with the flag that its compiler was given.
void compare_published(Sheet& sheet, const Runs& runs, const Rounds& rounds) {
    const char* const flag = "Os";
    const Steps& steps = run_of(runs, "published_lever", "published", flag);
    const Steps& floats = run_of(runs, "published_lever", "float", flag);
    const char* const who = "fixed_16_16";
    std::string distribution;
    for (unsigned n = 0; n <= max_rounds; ++n)
        if (rounds.steps[n] > 0)
            distribution +=
                fmt::format("; {} of {} steps go through {} rounds at {:.2f} ms", rounds.steps[n],
                            steps_run, n, milliseconds(rounds.cost[n].mean()));
    const double mean = steps.step.mean();
    sheet.compare("physics_step", who, milliseconds(mean),
                  fmt::format("mean of {} steps of 5 ms, -Os{} (-O2)", steps_run, distribution));
    sheet.compare("physics_step_upper", who, milliseconds(mean),
                  fmt::format("an estimate of the mean; the longest step takes {:.1f} ms",
                              milliseconds(steps.step.max)));
    sheet.compare("physics_steps_per_second", "float", per_second(floats.step.mean()),
                  "the published figure is a lower bound, over 500, and holds; -Os", "reproduced");
    const Cost& resolve = steps.parts[resolve_contacts];
    sheet.compare(
        "contact_resolution", who, milliseconds(resolve.mean()),
        fmt::format("{:.0f}% of the step; finding the contacts takes another {:.0f}%",
                    100 * steps.share(resolve_contacts), 100 * steps.share(find_contacts)));
    const Cost& root = steps.parts[square_root];
    sheet.compare(
        "square_roots_share", who, 100 * steps.share(square_root),
        fmt::format("{:.2f} roots a step of {:.0f} us each; nearly 20% of 4.4 ms would be {:.1f}: "
                    "where the original takes more roots is not known",
                    static_cast<double>(root.calls) / steps_run, microseconds(root.mean()),
                    0.2 * 4400 / microseconds(root.mean())));
    sheet.compare("multiply", who, microseconds(steps.parts[multiply].mean()),
                  "mean inside the running engine; " + span(steps.parts[multiply]) +
                      "; what the pin's own pulse adds in the original is not known");
    const Cost& division = steps.parts[divide];
    sheet.compare("divide", who, microseconds(division.mean()),
                  "mean inside the running engine; " + span(division) +
                      ": the quotient's bytes decide (division_cycles.csv)",
                  explained);
    sheet.compare(
        "divide_predicted", who, microseconds(division.mean()),
        "a prediction for a full 64-bit division, which skips the quotient's leading zero "
        "bytes; " +
            span(division));
    sheet.compare(
        "object_size", who, steps.particle_bytes,
        "52 bytes are four vectors and a number: position, velocity, acceleration, force, "
        "inverse mass; ours has no acceleration, and holds displacement, radius and "
        "damping, which the original counts among its 16 bytes of attributes",
        explained);
}

// Each arithmetic on the same source: with the same flags and with the best.
void compare_arithmetics(Sheet& sheet, const Runs& runs, const char* scene) {
    for (const Arithmetic& arithmetic : arithmetics) {
        const std::string& program = arithmetic.program;
        const char* const best = best_flag(runs, scene, program);
        for (const char* flag : flags) {
            const Steps& steps = run_of(runs, scene, program, flag);
            const std::string which =
                std::string("-") + flag + (flag == best ? ", its best flag" : "");
            const auto tell = [&](const char* quantity, double value, const char* unit) {
                sheet.tell(std::string(scene) + "_" + quantity, arithmetic.recorded, value, unit,
                           which);
            };
            tell("step", steps.step.mean(), "cycles");
            tell("step_max", static_cast<double>(steps.step.max), "cycles");
            tell("flash", steps.flash_bytes, "bytes");
            if (flag != best) continue;
            tell("steps_per_second", per_second(steps.step.mean()), "1/s");
            tell("contact_finding_share", 100 * steps.share(find_contacts), "percent");
            tell("contact_resolution_share", 100 * steps.share(resolve_contacts), "percent");
            tell("square_roots_share", 100 * steps.share(square_root), "percent");
            tell("multiply", steps.parts[multiply].mean(), "cycles");
            tell("divide", steps.parts[divide].mean(), "cycles");
            tell("object_size", steps.particle_bytes, "bytes");
            tell("world_size", steps.world_bytes, "bytes");
        }
    }
    const auto best_steps = [&](const char* arithmetic) {
        return run_of(runs, scene, arithmetic, best_flag(runs, scene, arithmetic)).step.mean();
    };
    sheet.tell(std::string(scene) + "_step_to_float", "q16_16",
               best_steps("nearest") / best_steps("float"), "ratio", "each at its best flag");
    sheet.tell(std::string(scene) + "_step_to_published", "q16_16",
               best_steps("nearest") / best_steps("published"), "ratio", "each at its best flag");
}

using records::column;

// A row of workload_rounds.csv.
struct RoundsRow {
    std::string arithmetic;
    unsigned rounds;
    double cycles;
    std::uint64_t steps;

    static constexpr auto columns = std::tuple(
        column("arithmetic", &RoundsRow::arithmetic), column("rounds", &RoundsRow::rounds),
        column("cycles", &RoundsRow::cycles), column("steps", &RoundsRow::steps));
};

void save_rounds(const std::map<std::string, Rounds>& rounds, const std::filesystem::path& folder) {
    std::vector<RoundsRow> rows;
    for (const Arithmetic& arithmetic : arithmetics) {
        const Rounds& of = rounds.at(arithmetic.program);
        for (unsigned n = 0; n <= max_rounds; ++n)
            if (of.cost[n].calls > 0)
                rows.push_back({arithmetic.recorded, n, of.cost[n].mean(), of.steps[n]});
    }
    records::table_of(rows).save(folder / "workload_rounds.csv");
}

// A row of workload_trace.csv.
struct TraceRow {
    std::string arithmetic, lane;
    double begin_us, end_us;

    static constexpr auto columns =
        std::tuple(column("arithmetic", &TraceRow::arithmetic), column("lane", &TraceRow::lane),
                   column("begin_us", &TraceRow::begin_us, "{:.4f}"),
                   column("end_us", &TraceRow::end_us, "{:.4f}"));
};

void save_trace(const Runs& runs, const std::filesystem::path& folder) {
    std::vector<TraceRow> rows;
    for (const Arithmetic& arithmetic : arithmetics) {
        const Steps& steps = run_of(runs, "published_lever", arithmetic.program, rounds_flag);
        const auto add = [&](const std::string& lane, double begin, double end) {
            rows.push_back({arithmetic.recorded, lane, microseconds(begin), microseconds(end)});
        };
        add("step", 0, static_cast<double>(steps.step.max));
        for (const Call& call : steps.trace)
            add(lanes[call.lane].name, static_cast<double>(call.begin),
                static_cast<double>(call.end));
    }
    records::table_of(rows).save(folder / "workload_trace.csv");
}

}  // namespace

void measure_workload(const WorkloadOptions& options) {
    Runs runs;
    std::map<std::string, Rounds> rounds;
    for (const Arithmetic& arithmetic : arithmetics) {
        rounds[arithmetic.program];
        for (const char* scene : {"published_lever", "lever"})
            for (const char* flag : flags)
                runs[fmt::format("{}.{}.{}", scene, arithmetic.program, flag)];
    }
    std::vector<std::function<void()>> jobs;
    for (auto& entry : runs)
        jobs.push_back(
            [&] { entry.second = take_apart(options.programs / (entry.first + ".elf")); });
    for (auto& entry : rounds)
        jobs.push_back([&] { entry.second = count_rounds(options.programs, entry.first); });
    records::Progress progress("workload", jobs.size());
    operations::in_parallel(options.threads, jobs.size(), [&](std::size_t i) {
        jobs[i]();
        progress.advance();
    });

    Sheet sheet;
    compare_published(sheet, runs, rounds.at("published"));
    for (const char* scene : {"published_lever", "lever"}) compare_arithmetics(sheet, runs, scene);
    records::table_of(sheet.rows).save(options.output / "workload.csv");
    save_rounds(rounds, options.output);
    save_trace(runs, options.output);
}

}  // namespace scene_bench
