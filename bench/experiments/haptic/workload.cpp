// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/workload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "bench/chip/profile/stack_bound.hpp"
#include "bench/lab/verdict_row.hpp"
#include "reference/published.hpp"

namespace haptic {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// The program that was measured.
struct Source {
    std::string arithmetic, elf_sha256;
};

// A row of workload_firmware.csv.
struct FirmwareRow : lab::VerdictRow {
    std::string elf_sha256;
    static constexpr auto columns = std::tuple_cat(
        VerdictRow::columns, std::tuple(records::column("elf_sha256", &FirmwareRow::elf_sha256)));
};

struct Sheet {
    std::vector<FirmwareRow> rows;

    void compare(const std::string& quantity, const std::string& arithmetic, double measured,
                 const Source& source, const std::string& reason,
                 const char* otherwise = "cause named") {
        rows.push_back(
            {lab::compared(quantity, arithmetic, measured, reason, otherwise), source.elf_sha256});
    }
    void tell(const std::string& quantity, const Source& source, double measured,
              const std::string& unit, const std::string& reason = "") {
        rows.push_back(
            {lab::told(quantity, source.arithmetic, measured, unit, reason), source.elf_sha256});
    }
};

double mean_frame(const Timing& timing) {
    return seconds_of(std::accumulate(timing.frame_lengths.begin(), timing.frame_lengths.end(),
                                      Cycle{0})) /
           static_cast<double>(timing.frame_lengths.size());
}

// A time during which a pin was high.
struct Interval {
    int pin;
    double begin, end;  // s
    double length() const { return end - begin; }
};

std::vector<Interval> intervals_of(const std::vector<PinEdge>& edges) {
    std::vector<Interval> intervals;
    double begin[DeviceLoop::last_pin + 1] = {};
    for (const PinEdge& edge : edges) {
        if (edge.level)
            begin[edge.pin] = seconds_of(edge.at);
        else
            intervals.push_back({edge.pin, begin[edge.pin], seconds_of(edge.at)});
    }
    return intervals;
}

enum Pin : int { step_pin = 2, render_pin, collision_pin, square_root_pin, operation_pin };
constexpr const char* pin_names[] = {"step",        "render",    "collision",
                                     "square_root", "operation", "servo"};

// A run of a profiled program through the scenario: the activity of its pins.
struct Profiled {
    std::string device;
    Source source;
    std::vector<Interval> intervals;  // by their ends
};
Profiled profiled(const Options& options, const std::string& device, const Scenario& scene) {
    const simulator::Elf elf(options.firmware / fmt::format("{}.elf", device));
    DeviceLoop loop(elf, published_parameters(), scene.script);
    std::vector<PinEdge> edges;
    loop.record_edges(edges);
    loop.run_until(scene.duration);
    const bool ours = device == "lever_profiled";
    return {ours ? "q16_16" : "published",
            {ours ? "q16_16" : "fixed_16_16", elf.sha256()},
            intervals_of(edges)};
}

// Each step with the intervals of the other pins within it.
template <class Function>
void for_each_step(const std::vector<Interval>& intervals, Function function) {
    std::vector<Interval> parts;
    for (const Interval& interval : intervals) {
        if (interval.pin != step_pin) {
            parts.push_back(interval);
            continue;
        }
        std::erase_if(parts, [&](const Interval& part) { return part.begin < interval.begin; });
        function(interval, std::exchange(parts, {}));
    }
}

// A row of haptic_pins.csv.
struct PinRow {
    std::string device, view, pin;
    double begin_ms, end_ms;

    static constexpr auto columns =
        std::tuple(records::column("device", &PinRow::device),
                   records::column("view", &PinRow::view), records::column("pin", &PinRow::pin),
                   records::column("begin_ms", &PinRow::begin_ms, "{:.4f}"),
                   records::column("end_ms", &PinRow::end_ms, "{:.4f}"));
};

// Three frames, and the longest step during them.
void save_pins(const std::vector<Profiled>& devices, const std::filesystem::path& folder) {
    std::vector<PinRow> rows;
    for (const Profiled& of : devices) {
        const auto add = [&](const char* view, const Interval& interval, double origin) {
            rows.push_back({of.device, view, pin_names[interval.pin - DeviceLoop::first_pin],
                            (interval.begin - origin) * 1e3, (interval.end - origin) * 1e3});
        };
        for (const Interval& interval : of.intervals)
            if (interval.begin >= pins_from && interval.end <= pins_to &&
                (interval.pin == step_pin || interval.pin == render_pin))
                add("frames", interval, pins_from);
        Interval longest{};
        std::vector<Interval> within;
        for_each_step(of.intervals, [&](const Interval& step, std::vector<Interval> parts) {
            if (step.begin < pins_from || step.end > pins_to) return;
            if (step.length() <= longest.length()) return;
            longest = step;
            within = std::move(parts);
        });
        if (!longest.pin)
            throw std::runtime_error(fmt::format("{}: no step on its pin", of.device));
        add("step", longest, longest.begin);
        for (const Interval& part : within)
            if (part.pin <= operation_pin) add("step", part, longest.begin);
    }
    records::table_of(rows).save(folder / "haptic_pins.csv");
}

// What the pins show of all steps. The contacts' pin rises twice: while they are found and while
// they are resolved.
void tell_pins(Sheet& sheet, const Profiled& of) {
    double step_time = 0, found = 0, resolved = 0, square_roots = 0, operations = 0;  // s
    double steps = 0, max_resolved = 0;
    for_each_step(of.intervals, [&](const Interval& step, const std::vector<Interval>& parts) {
        ++steps;
        step_time += step.length();
        bool looked = false;
        for (const Interval& part : parts) {
            if (part.pin == square_root_pin) square_roots += part.length();
            if (part.pin == operation_pin) operations += part.length();
            if (part.pin != collision_pin) continue;
            (looked ? resolved : found) += part.length();
            if (looked) max_resolved = std::max(max_resolved, part.length());
            looked = true;
        }
    });
    const double mean_step = step_time / steps * 1e3, mean_resolved = resolved / steps * 1e3;
    const auto percent = [&](double time) { return 100 * time / step_time; };
    if (of.device == "published") {
        sheet.compare(
            "physics_step", "fixed_16_16", mean_step, of.source,
            "pin D2 of the running device: sensors, their curve, angle, stops, servo and "
            "interrupts are in it beside the engine's step, and the other pins' own time; "
            "workload.csv has the engine alone",
            "explained");
        sheet.compare(
            "contact_resolution", "fixed_16_16", mean_resolved, of.source,
            fmt::format("pin D4 of the running device, up to {:.1f} ms; with finding them "
                        "{:.0f}% of the step",
                        max_resolved * 1e3, percent(found + resolved)));
        sheet.compare("square_roots_share", "fixed_16_16", percent(square_roots), of.source,
                      "pin D5 of the running device: one root for each rod and step; where the "
                      "original takes more is not known",
                      "not reproducible");
    } else {
        sheet.tell("physics_step", of.source, mean_step, "ms", "pin D2, all pins in use");
        sheet.tell("contact_resolution", of.source, mean_resolved, "ms", "pin D4");
        sheet.tell("square_roots_share", of.source, percent(square_roots), "percent",
                   "pin D5: lengths");
    }
    sheet.tell("contact_finding_share", of.source, percent(found), "percent", "pin D4");
    sheet.tell("contact_resolution_share", of.source, percent(resolved), "percent", "pin D4");
    sheet.tell("operations_share", of.source, percent(operations), "percent",
               "pin D6: products, quotients and sums of products, in contacts too");
}

void tell_device(Sheet& sheet, const Firmware& firmware, const Scenario& scene) {
    const Run r = run(firmware, scene, published_parameters());
    const Source source{r.arithmetic, r.elf_sha256};
    const simulator::Elf elf(firmware.elf);
    const Judgement& j = r.judgement;
    if (firmware.arithmetic == "published") {
        sheet.compare("render_frame", "any", mean_frame(r.timing) * 1e3, source,
                      "400 cells, 20 line ends and 20 blank lines of two bytes each, sent by "
                      "interrupts while steps go on");
        sheet.compare("render_rate", "fixed_16_16", j.frames_per_second, source,
                      "the original waits for each byte, 20 ms a frame, and then catches up "
                      "with the physics; here bytes are sent by interrupts");
        sheet.compare("flash", "any", elf.flash_bytes() / 1024.0, source,
                      "the original's Arduino core, Serial and Servo are not in it");
        sheet.compare("static_ram", "any", elf.ram_bytes(), source,
                      "pools hold what the scene states and no more");
    } else if (firmware.arithmetic == "float") {
        sheet.compare("render_rate", "float", j.frames_per_second, source, "the rate asked for");
    }
    sheet.tell("loop_rate", source, j.loop_rate, "1/s");
    sheet.tell("loop_step", source, j.step_mean * 1e3, "ms",
               "sensors, forces, engine, stops, servo; interrupts included");
    sheet.tell("loop_step_max", source, j.step_most * 1e3, "ms");
    if (firmware.limits) sheet.tell("worst_lateness", source, j.worst_lateness * 1e3, "ms");
    sheet.tell("render_frame_sent", source, mean_frame(r.timing) * 1e3, "ms",
               "from the first drawing to the last byte taken");
    sheet.tell("frames_per_second", source, j.frames_per_second, "1/s");
    sheet.tell("cpu_share", source, j.cpu_share * 100, "percent");
    sheet.tell("render_share", source, j.rendering_share * 100, "percent");
    sheet.tell("flash_bytes", source, elf.flash_bytes(), "bytes");
    sheet.tell("static_ram_bytes", source, elf.ram_bytes(), "bytes");
    sheet.tell("stack_measured", source, r.stack_bytes, "bytes", "deepest in this run");
    const profile::StackBound bound = profile::static_stack_bound(elf);
    sheet.tell("stack_bound", source, bound.bytes ? static_cast<double>(*bound.bytes) : none,
               "bytes", bound.bytes ? "by the machine code" : bound.unbounded.front());
}

// The published arm was 20 cm long, the scenario's is 23 cm: times scale as the square roots.
void tell_fall(Sheet& sheet, const Firmware& published) {
    constexpr double published_arm = 0.20, arm = 0.23;  // m
    const Run r = run(published, scenario("release_and_fall"), published_parameters());
    sheet.compare("fall_time", "fixed_16_16", r.judgement.fall * std::sqrt(published_arm / arm),
                  {r.arithmetic, r.elf_sha256},
                  fmt::format("{:.3f} s at 23 cm, with the selective damping, which brakes a fall; "
                              "without it plants within the data sheets' ranges fall in the "
                              "published time (identification.csv)",
                              r.judgement.fall),
                  "explained");
}

}  // namespace

void write_workload(const Options& options) {
    const Scenario scene = scenario("poke_while_held");
    std::vector<Firmware> devices = firmwares(options.firmware);
    const Firmware rebuilt = *std::ranges::find(devices, "published", &Firmware::arithmetic);
    Firmware sketch = devices.front();
    sketch.arithmetic = "q16_16_arduino";
    sketch.elf = options.firmware / "lever_arduino.elf";
    devices.insert(devices.begin() + 1, sketch);

    Sheet sheet;
    tell_fall(sheet, rebuilt);
    for (const Firmware& device : devices) tell_device(sheet, device, scene);
    const std::vector<Profiled> watched = {profiled(options, "lever_published_profiled", scene),
                                           profiled(options, "lever_profiled", scene)};
    for (const Profiled& device : watched) tell_pins(sheet, device);
    save_pins(watched, options.output);
    records::table_of(sheet.rows).save(options.output / "workload_firmware.csv");
}

}  // namespace haptic
