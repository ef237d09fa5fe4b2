// SPDX-License-Identifier: MIT
/// \file
/// When to step the physics and when to render. Times are a board's ticks, modulo 2^32: due() must
/// be called at least every 17 minutes. Plain logic, without a clock of its own:
///
///     while (const uint32_t length = steps.due(Board::ticks())) {
///         step(seconds<Scalar>(length));
///         steps.done(Board::ticks());
///     }
///     if (frames.due(Board::ticks())) draw();
///
/// The two policies for steps differ only in their type.
#pragma once

#include <firmware/hardware/readings.hpp>
#include <fixedpoint/conversion.hpp>

namespace firmware {

/// `now` less `then` in ticks; negative if `now` is earlier. The two must be less than 2^31 ticks
/// apart.
constexpr int32_t elapsed(uint32_t then, uint32_t now) { return static_cast<int32_t>(now - then); }

/// A time in ticks as seconds of the physics, rounded to nearest.
template <class Scalar>
constexpr Scalar seconds(uint32_t ticks) {
    return fixedpoint::from_decimal<Scalar>(static_cast<int32_t>(ticks / ticks_per_microsecond), 6);
}
/// \cond internal
template <>
constexpr float seconds<float>(uint32_t ticks) {
    return static_cast<float>(ticks) / ticks_per_second;
}
/// \endcond

/// Steps of one length, each due at its time. Up to max_behind late steps are made up for. Steps
/// later than that are given up, so that a long wait is not followed by a burst of steps. Nothing
/// of this is silent: late steps (by a whole step or more), steps given up and the worst delay are
/// counted.
template <uint16_t step_length = ticks_per_millisecond, uint8_t max_behind = 10>
class FixedSteps {
    static_assert(step_length > 0, "step_length must be above 0.");
    static_assert(max_behind > 0, "max_behind must be above 0, or no late step is made up for.");

  public:
    /// The first step is due one step after `now`.
    explicit FixedSteps(uint32_t now) : next_(now + step_length) {}

    /// The length in ticks of the step that is due, or 0 if none is.
    uint16_t due(uint32_t now) {
        const int32_t behind = elapsed(next_, now);
        if (behind < 0) return 0;
        if (static_cast<uint32_t>(behind) > worst_delay_) {
            worst_delay_ = static_cast<uint32_t>(behind);
        }
        if (behind >= step_length) ++late_;
        if (behind > int32_t{max_behind} * step_length) give_up(behind);
        next_ += step_length;
        return step_length;
    }
    /// Reports that the step has been computed. Steps of constant length ignore it.
    void done(uint32_t) {}

    /// The number of steps that began late by a whole step or more.
    uint32_t late() const { return late_; }
    /// The number of steps given up because they were too late.
    uint32_t given_up() const { return given_up_; }
    uint32_t worst_delay() const { return worst_delay_; }  ///< in ticks

  private:
    void give_up(int32_t behind) {
        const uint32_t steps = static_cast<uint32_t>(behind) / step_length - max_behind;
        given_up_ += steps;
        next_ += steps * step_length;
    }

    uint32_t next_;
    uint32_t late_ = 0, given_up_ = 0, worst_delay_ = 0;
};

/// The published policy: the physics waits until it is 10 ms behind the clock, then catches up
/// until it is ahead. Each step is as long as the previous one took to compute, plus 5 ms.
class PublishedSteps {
  public:
    /// The physics starts at `now`.
    explicit PublishedSteps(uint32_t now) : physics_(now) {}

    /// The length in ticks of the step that is due, or 0 if none is.
    uint32_t due(uint32_t now) {
        const int32_t behind = elapsed(physics_, now);
        if (behind <= 0) catching_up_ = false;
        if (behind >= wait_until_behind) catching_up_ = true;
        if (!catching_up_) return 0;
        const uint32_t length = duration_ + 5 * ticks_per_millisecond;
        begun_ = now;
        physics_ += length;
        return length;
    }
    /// Reports that the step has been computed at `now`. This determines the length of the next
    /// one.
    void done(uint32_t now) { duration_ = now - begun_; }

  private:
    static constexpr int32_t wait_until_behind = 10 * ticks_per_millisecond;

    uint32_t physics_;  // the time that the physics has reached
    uint32_t begun_ = 0, duration_ = 0;
    bool catching_up_ = false;
};

/// Frames of one length, 20 a second by default. A frame that is late by a whole frame or more is
/// skipped.
template <uint32_t frame_length = 50ul * ticks_per_millisecond>
class Frames {
  public:
    /// The first frame is due immediately.
    explicit Frames(uint32_t now) : next_(now) {}

    /// Whether to draw a frame now. True once per frame.
    bool due(uint32_t now) {
        const int32_t behind = elapsed(next_, now);
        if (behind < 0) return false;
        next_ =
            behind < static_cast<int32_t>(frame_length) ? next_ + frame_length : now + frame_length;
        return true;
    }

  private:
    uint32_t next_;
};

}  // namespace firmware
