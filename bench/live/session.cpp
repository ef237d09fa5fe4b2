// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/session.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace live {
namespace {

using haptic::degrees;
using haptic::Fault;
using haptic::seconds_of;

constexpr double watched = 1;  // s, over which rates are shown

// The effect of a key: a hand that holds moves by this much, one that does not gives a push.
constexpr double hand_moves = degrees(3), hand_takes = 0.06;  // rad, s
constexpr double push_force = 2.5, push_lasts = 0.15;         // N, s
constexpr double hand_closes = 0.05;                          // s
constexpr double dial_turns = 0.05;
constexpr double min_hand = degrees(-5), max_hand = degrees(65);

constexpr double forever = std::numeric_limits<double>::infinity();

}  // namespace

Session::Session(haptic::Firmware firmware, haptic::Scenario scenario)
    : firmware_(std::move(firmware)), scenario_(std::move(scenario)), elf_(firmware_.elf) {
    reset();
}

void Session::reset() {
    if (loop_) before_ += loop_->time();
    loop_ = std::make_unique<haptic::DeviceLoop>(
        elf_, scenario_.adapted(haptic::published_parameters()), scenario_.script);
    marks_.clear();
    on_time_ = std::numeric_limits<std::int64_t>::max();
}

void Session::run_until(double seconds) {
    const std::size_t steps = loop_->timing().step_begins.size();
    loop_->run_until(seconds - before_);
    marks_.push_back(mark(steps));
    while (marks_.size() > 2 && marks_[1].time <= marks_.back().time - watched) marks_.pop_front();
}

Session::Mark Session::mark(std::size_t steps_before) {
    const haptic::Timing& timing = loop_->timing();
    std::int64_t latest = std::numeric_limits<std::int64_t>::min();
    if (firmware_.limits) {
        for (std::size_t k = steps_before; k < timing.step_begins.size(); ++k) {
            const auto offset = static_cast<std::int64_t>(timing.step_begins[k]) -
                                static_cast<std::int64_t>(k * firmware_.limits->step_period);
            latest = std::max(latest, offset);
            on_time_ = std::min(on_time_, offset);
        }
    }
    constexpr double lines_of_a_frame = 2 * haptic::DeviceLoop::rows;
    const double frames = timing.lines_sent != 0
                              ? static_cast<double>(timing.lines_sent) / lines_of_a_frame
                              : static_cast<double>(timing.frame_begins.size());
    return {loop_->time(), timing.step_begins.size(), timing.asleep, timing.rendering,
            frames,        timing.bytes_sent,         latest};
}

void Session::press(Key key) {
    switch (key) {
        case Key::push_up:
            return push(1);
        case Key::push_down:
            return push(-1);
        case Key::grip:
            return grip();
        case Key::dial_up:
            return turn(dial_turns);
        case Key::dial_down:
            return turn(-dial_turns);
        case Key::unplug:
            return unplug_next();
        case Key::stall:
            return toggle_stall();
        case Key::full_frame:
            return loop_->send(' ');
        case Key::reset:
            return reset();
        case Key::quit:
            return;
    }
}

void Session::push(double direction) {
    haptic::Script& script = loop_->plant().script();
    const double now = loop_->time();
    if (script.hand_grip.at(now) > 0) {
        const double angle = script.hand_angle.at(now);
        // From where the last key wanted it, so that none is lost.
        const double wanted = script.hand_angle.at(now + hand_takes) + direction * hand_moves;
        script.hand_angle.from(angle).ramp(now, now + hand_takes,
                                           std::clamp(wanted, min_hand, max_hand));
    } else {
        script.hand_force.from(direction * push_force).step(now + push_lasts, 0);
    }
}

void Session::grip() {
    haptic::Script& script = loop_->plant().script();
    const double now = loop_->time(), held = script.hand_grip.at(now);
    if (held > 0) {
        script.hand_grip.from(0);
    } else {
        script.hand_angle.from(loop_->plant().lever_angle());
        script.hand_grip.from(0).ramp(now, now + hand_closes, 1);
    }
}

void Session::turn(double by) {
    haptic::Signal& dial = loop_->plant().script().dial;
    dial.from(std::clamp(dial.at(loop_->time()) + by, 0.0, 1.0));
}

void Session::toggle_stall() {
    const bool stalled = fault(Fault::Kind::stalled).has_value();
    auto& faults = loop_->plant().script().faults;
    std::erase_if(faults, [](const Fault& f) { return f.kind == Fault::Kind::stalled; });
    if (!stalled) faults.push_back({Fault::Kind::stalled, 0, loop_->time(), forever});
}

// The first sensor, the second, none.
void Session::unplug_next() {
    const auto now = fault(Fault::Kind::unplugged);
    auto& faults = loop_->plant().script().faults;
    std::erase_if(faults, [](const Fault& f) { return f.kind == Fault::Kind::unplugged; });
    const int next = now ? now->sensor + 1 : 0;
    if (next < 2) faults.push_back({Fault::Kind::unplugged, next, loop_->time(), forever});
}

std::optional<Fault> Session::fault(Fault::Kind kind) const {
    for (const Fault& f : loop_->plant().script().faults)
        if (f.kind == kind && loop_->time() >= f.begin && loop_->time() < f.end) return f;
    return {};
}

Status Session::status() const {
    haptic::Plant& plant = loop_->plant();
    const haptic::Script& script = plant.script();
    Status s{};
    s.time = time();
    s.lever = plant.lever_angle();
    s.servo = plant.servo_angle();
    s.hand_force = plant.hand_force();
    const auto unplugged = fault(Fault::Kind::unplugged);
    const auto shorted = fault(Fault::Kind::shorted);
    for (const int sensor : {0, 1}) {
        s.reading[sensor] = plant.sensor_reading(sensor);
        if (unplugged && unplugged->sensor == sensor) s.reading[sensor] = 0;
        if (shorted && shorted->sensor == sensor) s.reading[sensor] = 1023;
    }
    s.pulse = loop_->pulse();
    s.dial = script.dial.at(loop_->time());
    if (!loop_->timing().step_begins.empty()) s.arm = loop_->arm_length();
    s.held = script.hand_grip.at(loop_->time()) > 0;
    s.stalled = fault(Fault::Kind::stalled).has_value();
    if (unplugged) s.unplugged = unplugged->sensor;
    s.screen = loop_->screen();

    if (marks_.size() < 2) return s;
    const Mark &begin = marks_.front(), &end = marks_.back();
    const double seconds = end.time - begin.time;
    if (end.steps < begin.steps + 2) return s;
    const auto& steps = loop_->timing().step_begins;
    s.loop_rate = static_cast<double>(end.steps - begin.steps - 1) /
                  seconds_of(steps[end.steps - 1] - steps[begin.steps]);
    s.cpu_share = 1 - seconds_of(end.asleep - begin.asleep) / seconds;
    s.rendering_share = seconds_of(end.rendering - begin.rendering) / seconds;
    s.frames_per_second = (end.frames - begin.frames) / seconds;
    s.bytes_per_second = static_cast<double>(end.bytes - begin.bytes) / seconds;
    if (firmware_.limits) {
        std::int64_t latest = on_time_;
        for (auto m = std::next(marks_.begin()); m != marks_.end(); ++m)
            latest = std::max(latest, m->latest);
        s.lateness = seconds_of(static_cast<haptic::Cycle>(latest - on_time_));
    }
    return s;
}

}  // namespace live
