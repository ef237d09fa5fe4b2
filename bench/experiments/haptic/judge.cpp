// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace haptic {
namespace {

constexpr double degree = degrees(1);

double in_degrees(double angle) { return angle / degree; }
bool within(double value, Span span) { return value >= span.least && value <= span.most; }

}  // namespace

void Judge::watch(const Glance& glance) {
    const double now = glance.time, servo = glance.servo_angle;
    const Envelope& envelope = scenario_.envelope;

    const bool held = scenario_.script.hand_grip.at(now) > 0;
    if (held_before_ && !held && !let_go_) let_go_ = now;
    held_before_ = held;
    const double lowered = Travel().lowered;
    if (let_go_ && !fallen_ && servo - lowered < degree) fallen_ = now;
    if (envelope.quiet && now >= envelope.quiet->from) {
        least_ = std::min(least_, glance.lever_angle);
        most_ = std::max(most_, glance.lever_angle);
    }
    if (envelope.rest && now >= envelope.rest->from &&
        std::abs(servo - envelope.rest->angle) > degree)
        rested_ = false;
    if (!glance.screen_is_right) screen_right_ = false;
}

void Judge::violate(bool violated, std::string what) {
    if (violated) judgement_.violations.push_back(std::move(what));
}

void Judge::judge_timing(const Timing& timing, double end) {
    Judgement& j = judgement_;
    if (timing.step_begins.size() < 2) {
        violate(true, "no steps");
        return;
    }
    const Cycle first = timing.step_begins.front(), last = timing.step_begins.back();
    const double watched = end - seconds_of(first);
    const auto steps = static_cast<double>(timing.step_begins.size());
    j.loop_rate = (steps - 1) / seconds_of(last - first);
    j.step_mean = seconds_of(std::accumulate(timing.step_lengths.begin(), timing.step_lengths.end(),
                                             Cycle{0})) /
                  static_cast<double>(timing.step_lengths.size());
    j.step_most =
        seconds_of(*std::max_element(timing.step_lengths.begin(), timing.step_lengths.end()));
    j.cpu_share = 1 - seconds_of(timing.asleep) / watched;
    j.rendering_share = seconds_of(timing.rendering) / watched;
    constexpr double lines_of_a_frame = 2 * DeviceLoop::rows;
    j.frames_per_second =
        (timing.lines_sent != 0 ? static_cast<double>(timing.lines_sent) / lines_of_a_frame
                                : static_cast<double>(timing.frame_begins.size())) /
        watched;
    if (!limits_) return;

    // For step k: its start less k periods, relative to the earliest of these.
    std::vector<std::int64_t> offsets;
    for (std::size_t k = 0; k < timing.step_begins.size(); ++k)
        offsets.push_back(static_cast<std::int64_t>(timing.step_begins[k]) -
                          static_cast<std::int64_t>(k * limits_->step_period));
    const std::int64_t on_time = *std::min_element(offsets.begin(), offsets.end());
    const auto lateness = [&](std::int64_t offset) {
        return seconds_of(static_cast<Cycle>(offset - on_time));
    };
    j.worst_lateness = lateness(*std::max_element(offsets.begin(), offsets.end()));
    j.late_steps = static_cast<std::uint64_t>(
        std::count_if(offsets.begin(), offsets.end(),
                      [&](std::int64_t offset) { return lateness(offset) > limits_->lateness; }));
    violate(j.late_steps != 0,
            fmt::format("{} steps late by more than {} ms, the worst by {:.3f} ms", j.late_steps,
                        limits_->lateness * 1e3, j.worst_lateness * 1e3));
    violate(j.loop_rate < limits_->loop_rate, fmt::format("{:.1f} steps a second", j.loop_rate));
    violate(j.cpu_share > limits_->cpu_share, fmt::format("{:.1f}% of the CPU", j.cpu_share * 100));
    violate(j.rendering_share > limits_->rendering_share,
            fmt::format("{:.1f}% of the CPU for rendering", j.rendering_share * 100));
    violate(j.frames_per_second < limits_->frames_per_second,
            fmt::format("{:.2f} frames a second", j.frames_per_second));
}

Judgement Judge::judge(const Timing& timing, double end, double arm_length) {
    const Envelope& envelope = scenario_.envelope;
    judge_timing(timing, end);

    const double half_step = 0.29 / 2 / 90 * 1e-3;
    violate(timing.shortest_pulse < 1e-3 - half_step || timing.longest_pulse > 1.667e-3 + half_step,
            fmt::format("pulses from {:.1f} to {:.1f} us", timing.shortest_pulse * 1e6,
                        timing.longest_pulse * 1e6));
    violate(timing.longest_period > 0.0201,
            fmt::format("{:.2f} ms from one pulse to the next", timing.longest_period * 1e3));
    violate(!screen_right_, "the terminal showed something else than the device believed");

    if (fallen_ && let_go_) judgement_.fall = *fallen_ - *let_go_;
    if (envelope.fall)
        violate(!(fallen_ && within(judgement_.fall, *envelope.fall)),
                fallen_ ? fmt::format("fell in {:.3f} s", judgement_.fall) : "did not fall");
    if (envelope.quiet) {
        judgement_.swing = most_ - least_;
        violate(judgement_.swing > envelope.quiet->max_swing,
                fmt::format("swung by {:.2f} degrees", in_degrees(judgement_.swing)));
    }
    if (envelope.arm) {
        const double share = (arm_length - 0.23) / 0.25;
        violate(!within(share, envelope.arm->dial),
                fmt::format("the arm stands for {:.3f} of the dial", share));
    }
    violate(!rested_, "did not rest where it should");
    return judgement_;
}

}  // namespace haptic
