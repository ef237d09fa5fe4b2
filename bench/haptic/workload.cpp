// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/haptic/workload.hpp"

#include <engine.h>
#include <fmt/format.h>

#include <cmath>
#include <fixedpoint/arithmetic/published.hpp>
#include <limits>
#include <numeric>
#include <scenes/published_lever.hpp>
#include <stdexcept>

#include "bench/profile/stack_bound.hpp"
#include "reference/published.hpp"

namespace haptic {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double close_enough = 0.1;

// As in the published report: a particle of the scene.
using PublishedWorld = engine::World<fixedpoint::Fixed<16, 16, fixedpoint::Published>,
                                     scenes::PublishedLever::Uses<scenes::Published>>;
constexpr std::size_t object_size = sizeof(PublishedWorld::Particle);
static_assert(object_size % 4 == 0, "Numbers of 4 bytes alone: the chip's size is the host's.");

class Sheet {
  public:
    void compare(const std::string& quantity, const std::string& arithmetic, double measured,
                 const Run& run, const std::string& reason) {
        for (const reference::WorkloadFigure& figure : published_) {
            if (figure.quantity != quantity || figure.arithmetic != arithmetic) continue;
            const double ratio = measured / figure.value;
            add(quantity, arithmetic, figure.value, measured, figure.unit, ratio,
                std::abs(ratio - 1) <= close_enough ? "reproduced" : "explained", reason, run);
            return;
        }
        throw std::logic_error("no published figure: " + quantity);
    }
    void tell(const std::string& quantity, const Run& run, double measured, const std::string& unit,
              const std::string& reason = "") {
        add(quantity, run.arithmetic, none, measured, unit, none, "measured", reason, run);
    }
    const records::Table& table() const { return table_; }

  private:
    void add(const std::string& quantity, const std::string& arithmetic, double published,
             double measured, const std::string& unit, double ratio, const std::string& verdict,
             const std::string& reason, const Run& run) {
        using records::cell;
        table_.add({quantity, arithmetic, cell(published), cell(measured), unit, cell(ratio),
                    verdict, reason, run.elf_sha256});
    }

    std::vector<reference::WorkloadFigure> published_ = reference::load_workload();
    records::Table table_{{"quantity", "arithmetic", "published", "measured", "unit", "ratio",
                           "verdict", "reason", "elf_sha256"}};
};

double mean_frame(const Timing& timing) {
    return seconds_of(std::accumulate(timing.frame_lengths.begin(), timing.frame_lengths.end(),
                                      Cycle{0})) /
           static_cast<double>(timing.frame_lengths.size());
}

struct Interval {
    int pin;
    double begin, end;  // s
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

constexpr int step_pin = 2, render_pin = 3;
constexpr const char* pin_names[] = {"step",        "render",    "collision",
                                     "square_root", "operation", "servo"};

}  // namespace

void write_pins(const Options& options) {
    records::Table table({"device", "view", "pin", "begin_ms", "end_ms"});
    for (const auto& [device, elf] : {std::pair{"published", "lever_published_profiled.elf"},
                                      {"q16_16", "lever_profiled.elf"}}) {
        const Scenario scene = scenario("poke_while_held");
        DeviceLoop loop(simulator::Elf(options.firmware / elf), published_parameters(),
                        scene.script);
        loop.run_until(2);
        std::vector<PinEdge> edges;
        loop.record_edges(edges);
        loop.run_until(2.16);
        const std::vector<Interval> intervals = intervals_of(edges);
        const auto add = [&](const char* view, const Interval& interval, double origin) {
            table.add({device, view, pin_names[interval.pin - DeviceLoop::first_pin],
                       fmt::format("{:.4f}", (interval.begin - origin) * 1e3),
                       fmt::format("{:.4f}", (interval.end - origin) * 1e3)});
        };
        const Interval* longest = nullptr;
        for (const Interval& interval : intervals) {
            if (interval.begin < 2) continue;  // was high when the recording began
            const bool shown = interval.pin == step_pin || interval.pin == render_pin;
            if (shown) add("frames", interval, 2);
            if (interval.pin == step_pin && interval.end < 2.15 &&
                (!longest || interval.end - interval.begin > longest->end - longest->begin))
                longest = &interval;
        }
        if (!longest) throw std::runtime_error(fmt::format("{}: no step on its pin", elf));
        for (const Interval& interval : intervals)
            if (interval.begin >= longest->begin && interval.end <= longest->end)
                add("step", interval, longest->begin);
    }
    table.save(options.output / "haptic_pins.csv");
}

void write_workload(const Options& options) {
    Sheet sheet;
    const Scenario scene = scenario("poke_while_held");
    for (const Firmware& firmware : firmwares(options.firmware)) {
        const Run r = run(firmware, scene, published_parameters());
        const simulator::Elf elf(firmware.elf);
        const Judgement& j = r.judgement;
        if (firmware.arithmetic == "published") {
            sheet.compare("render_frame", "any", mean_frame(r.timing) * 1e3, r,
                          "400 cells, 20 line ends and 20 blank lines of two bytes each, sent by "
                          "interrupts while steps go on");
            sheet.compare("render_rate", "fixed_16_16", j.frames_per_second, r,
                          "the original waits for each byte, 20 ms a frame, and then catches up "
                          "with the physics; here bytes are sent by interrupts");
            sheet.compare("flash", "any", elf.flash_bytes() / 1024.0, r,
                          "the original's Arduino core, Serial and Servo are not in it");
            sheet.compare("static_ram", "any", elf.ram_bytes(), r,
                          "pools hold what the scene states and no more");
            sheet.compare("object_size", "fixed_16_16", object_size, r,
                          "position, velocity, force, displacement, inverse mass, radius, damping");
        } else if (firmware.arithmetic == "float") {
            sheet.compare("render_rate", "float", j.frames_per_second, r, "the rate asked for");
        }
        sheet.tell("loop_rate", r, j.loop_rate, "1/s");
        sheet.tell("loop_step", r, j.step_mean * 1e3, "ms",
                   "sensors, forces, engine, stops, servo; interrupts included");
        sheet.tell("loop_step_max", r, j.step_most * 1e3, "ms");
        sheet.tell("render_frame_sent", r, mean_frame(r.timing) * 1e3, "ms",
                   "from the first drawing to the last byte taken");
        sheet.tell("frames_per_second", r, j.frames_per_second, "1/s");
        sheet.tell("cpu_share", r, j.cpu_share * 100, "percent");
        sheet.tell("render_share", r, j.rendering_share * 100, "percent");
        sheet.tell("flash_bytes", r, elf.flash_bytes(), "bytes");
        sheet.tell("static_ram_bytes", r, elf.ram_bytes(), "bytes");
        sheet.tell("stack_measured", r, r.stack_bytes, "bytes", "deepest in this run");
        const profile::StackBound bound = profile::static_stack_bound(elf);
        sheet.tell("stack_bound", r, bound.bytes ? static_cast<double>(*bound.bytes) : none,
                   "bytes", bound.bytes ? "by the machine code" : bound.unbounded.front());
    }
    sheet.table().save(options.output / "workload_firmware.csv");
}

}  // namespace haptic
