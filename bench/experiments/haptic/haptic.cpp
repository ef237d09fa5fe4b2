// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/haptic.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "bench/lab/parallel.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "firmware/src/firmware/hardware/readings.hpp"

namespace haptic {
namespace {

using simulator::Chip;

constexpr double millisecond = 1e-3;
constexpr Cycle cycles_of_tick = Chip::frequency / firmware::ticks_per_second;

template <class Named>
std::vector<Named> selected(const std::vector<Named>& all, const std::vector<std::string>& names,
                            std::string Named::*name, const char* option) {
    if (names.empty()) return all;
    std::vector<std::string> known;
    for (const Named& each : all) known.push_back(each.*name);
    fixbench::check_names(option, names, known);
    std::vector<Named> chosen;
    for (const std::string& wanted : names) {
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const Named& each) { return each.*name == wanted; });
        chosen.push_back(*found);
    }
    return chosen;
}

using records::column;

// A row of haptic.csv.
struct Row {
    std::string scenario, arithmetic;
    double seconds, loop_rate, step_mean_ms, step_max_ms;
    std::optional<std::uint64_t> late_steps;  // if the device has steps of constant length
    std::optional<double> worst_lateness_ms;
    double cpu_percent, render_percent, frames_per_s;
    double servo_min_us, servo_max_us;
    std::optional<double> fall, swing_deg;
    unsigned stack_bytes;
    std::uint64_t bytes_sent;
    std::string verdict, reason, elf_sha256;

    static constexpr auto columns = std::tuple(
        column("scenario", &Row::scenario), column("arithmetic", &Row::arithmetic),
        column("seconds", &Row::seconds), column("loop_rate_hz", &Row::loop_rate),
        column("step_mean_ms", &Row::step_mean_ms), column("step_max_ms", &Row::step_max_ms),
        column("late_steps", &Row::late_steps),
        column("worst_lateness_ms", &Row::worst_lateness_ms),
        column("cpu_percent", &Row::cpu_percent), column("render_percent", &Row::render_percent),
        column("frames_per_s", &Row::frames_per_s), column("servo_min_us", &Row::servo_min_us),
        column("servo_max_us", &Row::servo_max_us), column("fall_s", &Row::fall),
        column("swing_deg", &Row::swing_deg), column("stack_bytes", &Row::stack_bytes),
        column("bytes_sent", &Row::bytes_sent), column("verdict", &Row::verdict),
        column("reason", &Row::reason), column("elf_sha256", &Row::elf_sha256));
};

// An hour for the device itself, four minutes for the others; and less for recordings, since an
// hour of them would fill a disk.
double longest(const Options& options, const Firmware& program) {
    if (options.longest) return *options.longest;
    return program.flashed && options.record.empty() ? 3600 : 240;
}

// Removes the requirements that lie beyond the end.
Scenario shortened(Scenario scenario, double longest) {
    if (scenario.duration <= longest) return scenario;
    scenario.duration = longest;
    // Half a minute after it was pushed, the lever rests.
    if (scenario.envelope.rest && scenario.envelope.rest->from > longest)
        scenario.envelope.rest->from = longest - 1;
    return scenario;
}

}  // namespace

std::vector<Firmware> firmwares(const std::filesystem::path& folder) {
    const auto period = [](int rate) {
        return (firmware::ticks_per_second >> rate) * cycles_of_tick;
    };
    TimingLimits limits{period(10)};
    // Published: more than 500 steps a second in float.
    TimingLimits in_float{period(9)};
    in_float.loop_rate = 500;
    in_float.cpu_share = 1;
    in_float.lateness = 2e-3;
    return {{"q16_16", folder / "lever.elf", limits, true},
            {"published", folder / "lever_published.elf", {}, false},
            {"float", folder / "lever_float.elf", in_float, false}};
}

Run run(const Firmware& firmware, const Scenario& scenario, const Parameters& parameters,
        const std::filesystem::path& record) {
    const simulator::Elf elf(firmware.elf);
    DeviceLoop loop(elf, scenario.adapted(parameters), scenario.script);
    loop.wrap_clock_at(scenario.duration / 2);
    Judge judge(scenario, firmware.limits);
    std::optional<Recording> recording;
    if (!record.empty()) recording.emplace(loop);
    for (double now = millisecond; now < scenario.duration; now += millisecond) {
        loop.run_until(now);
        judge.watch({loop.time(), loop.plant().servo_angle(), loop.plant().lever_angle(),
                     loop.screen_is_right()});
        if (recording) recording->watch(loop);
    }
    if (recording) recording->save(record, scenario.name + "." + firmware.arithmetic);
    const unsigned stack = Chip::ram_end - 1u - loop.chip().lowest_stack_pointer();
    return {scenario.name, firmware.arithmetic,
            loop.time(),   judge.judge(loop.timing(), loop.time(), loop.arm_length()),
            loop.timing(), stack,
            elf.sha256()};
}

std::uint64_t run_scenarios(const Options& options) {
    const std::vector<Scenario> scenes =
        selected(scenarios(), options.scenarios, &Scenario::name, "--scenario");
    const std::vector<Firmware> programs = selected(
        firmwares(options.firmware), options.arithmetics, &Firmware::arithmetic, "--arithmetic");
    struct Job {
        Firmware program;
        Scenario scenario;
    };
    std::vector<Job> jobs;
    for (const Firmware& program : programs)
        for (const Scenario& scenario : scenes)
            jobs.push_back({program, shortened(scenario, longest(options, program))});
    // The longest first, so that none is left for a single thread at the end.
    std::vector<std::size_t> order(jobs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return jobs[a].scenario.duration > jobs[b].scenario.duration;
    });
    std::vector<Row> rows(jobs.size());
    std::atomic<std::uint64_t> failed = 0;
    records::Progress progress("haptic", jobs.size());
    operations::in_parallel(options.threads, jobs.size(), [&](std::size_t k) {
        const auto& [program, scenario] = jobs[order[k]];
        const Run r = run(program, scenario, published_parameters(), options.record);
        const Judgement& j = r.judgement;
        const bool timed = program.limits.has_value();
        const bool held = j.violations.empty();
        if (!held && program.flashed) ++failed;
        rows[order[k]] = {r.scenario,
                          r.arithmetic,
                          r.duration,
                          j.loop_rate,
                          j.step_mean * 1e3,
                          j.step_most * 1e3,
                          timed ? std::optional(j.late_steps) : std::nullopt,
                          j.worst_lateness * 1e3,
                          j.cpu_share * 100,
                          j.rendering_share * 100,
                          j.frames_per_second,
                          r.timing.shortest_pulse * 1e6,
                          r.timing.longest_pulse * 1e6,
                          j.fall,
                          j.swing / degrees(1),
                          r.stack_bytes,
                          r.timing.bytes_sent,
                          held ? "held" : "failed",
                          fmt::format("{}", fmt::join(j.violations, "; ")),
                          r.elf_sha256};
        progress.advance();
    });
    records::table_of(rows).save(options.output / "haptic.csv");
    return failed;
}

}  // namespace haptic
