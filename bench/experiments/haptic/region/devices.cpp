// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/region/devices.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fixedpoint/arithmetic/published.hpp>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "bench/experiments/haptic/host_loop.hpp"
#include "reference/published.hpp"

namespace haptic::region {
namespace {

using PublishedScalar = fixedpoint::Fixed<16, 16, fixedpoint::Published>;

template <class Base>
struct Undamped : Base {
    static constexpr bool selective_damping = false;
};
template <class Base>
struct Unled : Base {
    static constexpr typename Base::Scalar servo_delay() { return typename Base::Scalar(); }
};
template <class Base>
struct LateToBelieve : Base {
    static constexpr std::uint16_t pressed = 900;
};

// The published lever in steps of constant length.
template <int rate>
struct PublishedAt : firmware::PublishedLeverChoices<PublishedScalar> {
    static constexpr std::uint16_t step_length = firmware::ticks_per_second >> rate;
    using Steps = firmware::FixedSteps<step_length>;
};

template <class Choices>
Swing hold(const Parameters& parameters, double arm, Start start, double step_takes) {
    HostLoop<Choices> loop(parameters, Holding(arm, start).script, step_takes);
    return watch_held(loop);
}

template <class Choices>
std::optional<double> fall(const Parameters& parameters, double step_takes) {
    HostLoop<Choices> loop(parameters, scenario("release_and_fall").script, step_takes);
    return watch_fall(loop);
}

double number(float value) { return value; }
template <int I, int F, class A>
double number(fixedpoint::Fixed<I, F, A> value) {
    return fixedpoint::to_float<double>(value);
}

template <class Choices>
Device device(std::string arithmetic, int rate, std::string change = "") {
    Device d;
    d.arithmetic = std::move(arithmetic);
    d.change = std::move(change);
    d.damped = Choices::selective_damping;
    d.rate = rate;
    d.law.step = rate == 0 ? 0 : std::ldexp(1, -rate);
    d.law.servo_delay = number(Choices::servo_delay());
    d.law.damping = d.damped ? std::ldexp(1, -Choices::damping_exponent) : 0;
    d.law.position_first = std::is_same_v<typename Choices::Method, scenes::Published>;
    d.hold = hold<Choices>;
    d.fall = fall<Choices>;
    return d;
}

template <class Choices>
void add_both(std::vector<Device>& list, const std::string& arithmetic, int rate) {
    list.push_back(device<Choices>(arithmetic, rate));
    list.push_back(device<Undamped<Choices>>(arithmetic, rate));
}

template <int rate>
void add_rates_from(std::vector<Device>& list) {
    add_both<firmware::LeverChoices<firmware::LeverScalar, rate>>(list, "q16_16", rate);
    add_both<firmware::LeverChoices<float, rate>>(list, "float", rate);
    add_both<PublishedAt<rate>>(list, "published", rate);
    if constexpr (rate < fastest) add_rates_from<rate + 1>(list);
}

}  // namespace

double published_fall() {
    constexpr double published_arm = 0.20;  // m
    for (const reference::WorkloadFigure& figure : reference::load_workload())
        if (figure.quantity == "fall_time")
            return figure.value * std::sqrt(shortest_arm / published_arm);
    throw std::runtime_error("no fall_time among the published figures");
}

std::vector<Device> devices() {
    std::vector<Device> list;
    add_both<firmware::PublishedLeverChoices<PublishedScalar>>(list, "published", 0);
    add_rates_from<slowest>(list);
    return list;
}

std::vector<Device> changes() {
    using Flashed = firmware::LeverChoices<firmware::LeverScalar>;
    using Float = firmware::LeverChoices<float, 9>;
    using Published = firmware::PublishedLeverChoices<PublishedScalar>;
    constexpr int rate = 10;
    return {device<Flashed>("q16_16", rate, "as flashed"),
            device<LateToBelieve<Flashed>>("q16_16", rate, "a free sensor believed from 900 on"),
            device<Undamped<Flashed>>("q16_16", rate, "without damping"),
            device<Unled<Flashed>>("q16_16", rate, "without lead"),
            device<Undamped<Unled<Flashed>>>("q16_16", rate, "without lead and damping"),
            device<Float>("float", 9, "in float"),
            device<Undamped<Float>>("float", 9, "in float, without damping"),
            device<Published>("published", 0, "2016 design"),
            device<Undamped<Published>>("published", 0, "2016 design, without damping")};
}

}  // namespace haptic::region
