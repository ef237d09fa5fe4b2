// SPDX-License-Identifier: GPL-3.0-or-later
// The recording scalar: arithmetics that return what Nearest and Published return, and report to
// the thread's recorder what overflowed, what was divided by zero and which results vanished, with
// the quantity being computed and the step.
#pragma once

#include <cmath>
#include <engine/observe.hpp>
#include <engine/overlap.hpp>
#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <limits>
#include <optional>
#include <string>

namespace stability {

struct Occurrence {
    fixedpoint::Event event;
    fixedpoint::Operation operation;
    const char* quantity;
    unsigned step;
};
// "overflow multiply spring_force"
std::string to_text(const Occurrence& occurrence);

// The magnitudes of a quantity: the largest, and the smallest that is not zero.
struct Magnitudes {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;

    void include(double x) {
        x = std::abs(x);
        if (x > largest) largest = x;
        if (x > 0 && x < smallest) smallest = x;
    }
};

class Recorder {
  public:
    unsigned step = 0;
    Magnitudes position, velocity, force;  // of all particles, after each step: m, m/s, N
    Magnitudes result;  // of every operation that can wrap, exact: only AnyFormat notes it

    void enter(const char* quantity) { quantity_ = quantity; }
    void notify(fixedpoint::Event event, fixedpoint::Operation operation) {
        if (event == fixedpoint::Event::underflow) {
            if (!first_underflow_) first_underflow_ = {event, operation, quantity_, step};
            if (step != last_underflow_step_) ++steps_with_underflow_;
            last_underflow_step_ = step;
        } else if (event == fixedpoint::Event::overflow &&
                   (operation == fixedpoint::Operation::divide ||
                    operation == fixedpoint::Operation::length)) {
            ++saturations_;
        } else if (!first_failure_) {
            first_failure_ = {event, operation, quantity_, step};
        }
    }

    // In an arithmetic that saturates everything.
    void saturate(fixedpoint::Operation operation) {
        ++saturations_;
        if (!first_saturation_)
            first_saturation_ = {fixedpoint::Event::overflow, operation, quantity_, step};
    }

    // The first wrap, division by zero or domain error. Quotients and lengths beyond the range
    // saturate, as documented, and are only counted.
    const std::optional<Occurrence>& first_failure() const { return first_failure_; }
    const std::optional<Occurrence>& first_saturation() const { return first_saturation_; }
    const std::optional<Occurrence>& first_underflow() const { return first_underflow_; }
    unsigned steps_with_underflow() const { return steps_with_underflow_; }
    unsigned saturations() const { return saturations_; }

  private:
    const char* quantity_ = "description";
    std::optional<Occurrence> first_failure_, first_saturation_, first_underflow_;
    unsigned steps_with_underflow_ = 0, last_underflow_step_ = 0, saturations_ = 0;
};

// The recorder of this thread's run, or null.
Recorder*& active_recorder();
// Makes a recorder active while this object lives.
class Recorded {
  public:
    explicit Recorded(Recorder& recorder) { active_recorder() = &recorder; }
    ~Recorded() { active_recorder() = nullptr; }
    Recorded(const Recorded&) = delete;
    Recorded& operator=(const Recorded&) = delete;
};

const char* name_of(engine::Quantity quantity);

struct Hook {
    static void notify(fixedpoint::Event event, fixedpoint::Operation operation) {
        if (Recorder* recorder = active_recorder()) recorder->notify(event, operation);
    }
};

struct Recording : fixedpoint::Checked<Hook> {
    static void enter(engine::Quantity quantity) {
        if (Recorder* recorder = active_recorder()) recorder->enter(name_of(quantity));
    }
};

// The saturating arithmetic, each product and sum separately.
struct SaturationHook {
    static void notify(fixedpoint::Event event, fixedpoint::Operation operation) {
        Recorder* const recorder = active_recorder();
        if (recorder == nullptr) return;
        if (event == fixedpoint::Event::overflow) {
            recorder->saturate(operation);
        } else {
            recorder->notify(event, operation);
        }
    }
};
struct RecordingSaturating : fixedpoint::Checked<SaturationHook> {
    using Watched = fixedpoint::Checked<SaturationHook>;
    using Saturating = fixedpoint::Saturating;
    static void enter(engine::Quantity quantity) { Recording::enter(quantity); }

    template <class Raw, int F>
    static Raw add(Raw a, Raw b) {
        Watched::add<Raw, F>(a, b);
        return Saturating::add<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw subtract(Raw a, Raw b) {
        Watched::subtract<Raw, F>(a, b);
        return Saturating::subtract<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw negate(Raw a) {
        Watched::negate<Raw, F>(a);
        return Saturating::negate<Raw, F>(a);
    }
    template <class Raw, int F>
    static Raw multiply(Raw a, Raw b) {
        Watched::multiply<Raw, F>(a, b);
        return Saturating::multiply<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw multiply_add(Raw a, Raw b, Raw c) {
        return add<Raw, F>(multiply<Raw, F>(a, b), c);
    }
    template <class Raw, int F>
    static Raw dot2(const Raw* a, const Raw* b) {
        return multiply_add<Raw, F>(a[1], b[1], multiply<Raw, F>(a[0], b[0]));
    }
    template <class Raw, int F>
    static Raw dot3(const Raw* a, const Raw* b) {
        return multiply_add<Raw, F>(a[2], b[2], dot2<Raw, F>(a, b));
    }
    template <class Raw, int F>
    static Raw shift_left(Raw a, unsigned char count) {
        Watched::shift_left<Raw, F>(a, count);
        return Saturating::shift_left<Raw, F>(a, count);
    }
};

}  // namespace stability

template <>
struct engine::LastReach<fixedpoint::Fixed<16, 16, stability::RecordingSaturating>, true>
    : engine::LastReach<engine::SaturatingFixed<16, 16>, true> {};

namespace stability {

// Overlapping spheres are so close that nothing leaves the range, and the engine measures them in
// its default arithmetic.
using RecordingSaturatingQ16_16 = fixedpoint::Fixed<16, 16, RecordingSaturating>;
template <int N>
RecordingSaturatingQ16_16 overlap(const engine::Vector<RecordingSaturatingQ16_16, N>& first,
                                  const engine::Vector<RecordingSaturatingQ16_16, N>& second,
                                  RecordingSaturatingQ16_16 reach,
                                  engine::LastReach<RecordingSaturatingQ16_16, true>& last,
                                  engine::Vector<RecordingSaturatingQ16_16, N>& direction) {
    using Plain = engine::SaturatingFixed<16, 16>;
    engine::LastReach<Plain, true>& of_plain = last;
    auto unit = engine::in_arithmetic_of<Plain>(direction);
    const Plain depth = engine::overlap(engine::in_arithmetic_of<Plain>(first),
                                        engine::in_arithmetic_of<Plain>(second),
                                        Plain::from_raw(reach.raw()), of_plain, unit);
    direction = engine::in_arithmetic_of<RecordingSaturatingQ16_16>(unit);
    return RecordingSaturatingQ16_16::from_raw(depth.raw());
}

// The published results. An exact result beyond the range differs from the returned one by more
// than the truncation.
struct RecordingPublished : fixedpoint::Published {
    static void enter(engine::Quantity quantity) { Recording::enter(quantity); }

    template <class Raw, int F>
    static Raw add(Raw a, Raw b) {
        return Recording::add<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw subtract(Raw a, Raw b) {
        return Recording::subtract<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw negate(Raw a) {
        return Recording::negate<Raw, F>(a);
    }
    template <class Raw, int F>
    static Raw multiply(Raw a, Raw b) {
        Recording::multiply<Raw, F>(a, b);
        return Published::multiply<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw divide(Raw a, Raw b) {
        Recording::divide<Raw, F>(a, b);
        return Published::divide<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw sqrt(Raw a) {
        Recording::sqrt<Raw, F>(a);
        return Published::sqrt<Raw, F>(a);
    }
};

}  // namespace stability
