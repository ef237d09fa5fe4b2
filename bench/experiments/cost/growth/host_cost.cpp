// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/experiments/cost/growth/box2d_discs.hpp"
#include "bench/experiments/cost/growth/cost.hpp"
#include "bench/experiments/cost/growth/counted.hpp"
#include "bench/experiments/cost/growth/discs.hpp"
#include "bench/experiments/cost/growth/stopwatch.hpp"
#include "bench/lab/records/progress.hpp"

namespace growth {
namespace {

template <unsigned N, class World>
void take(unsigned steps, World& world) {
    for (; steps > 0; --steps) world.step(engine::BinaryStep<exponent_of_step>());
    if (world.error() != engine::Error::none)
        throw std::runtime_error(
            fmt::format("box of {} discs: {}", N, engine::describe(world.error())));
}

template <unsigned N, class Search>
std::function<void(unsigned)> in_the_engine() {
    const auto world = std::make_shared<DiscWorld<N, Search>>();
    build<N, Search>(*world);
    return [world](unsigned steps) { take<N>(steps, *world); };
}

// The mean over the timed steps.
template <unsigned N, class Search>
double pairs_in_the_engine() {
    const auto world = std::make_unique<DiscWorld<N, Counted<Search>>>();
    build<N, Counted<Search>>(*world);
    const auto pairs_of = [&](unsigned steps) {
        const auto before = world->pair_memory().pairs;
        take<N>(steps, *world);
        return world->pair_memory().pairs - before;
    };
    pairs_of(warm_steps);
    return static_cast<double>(pairs_of(timed_steps)) / timed_steps;
}

std::function<void(unsigned)> in_box2d(unsigned n) {
    const std::shared_ptr<b2World> world = box2d_discs(n);
    return [world](unsigned steps) {
        for (; steps > 0; --steps) step(*world);
    };
}

struct Timed {
    const char* what;
    unsigned particles;
    Start start;
    double (*pairs)() = nullptr;
};

// Testing every pair takes too long beyond 4,096 discs.
template <unsigned... N>
void add(std::vector<Timed>& list, unsigned most, std::integer_sequence<unsigned, N...>) {
    const auto add_all = [&](unsigned limit, auto timed) {
        ((N <= limit ? list.push_back(timed(std::integral_constant<unsigned, N>())) : void()), ...);
    };
    add_all(std::min(most, 4096u), [](auto n) -> Timed {
        if constexpr (n <= 4096)
            return {"brute_force", n, in_the_engine<n, engine::BruteForce>,
                    pairs_in_the_engine<n, engine::BruteForce>};
        else
            return {};
    });
    add_all(most, [](auto n) -> Timed {
        return {"sort_and_sweep", n, in_the_engine<n, engine::SortAndSweep>,
                pairs_in_the_engine<n, engine::SortAndSweep>};
    });
    add_all(most, [](auto n) -> Timed { return {"box2d", n, [n] { return in_box2d(n); }}; });
}

}  // namespace

std::vector<Cost> costs_on_host(unsigned most) {
    std::vector<Timed> list;
    add(list, most,
        std::integer_sequence<unsigned, 16, 36, 64, 144, 256, 576, 1024, 2304, 4096, 9216,
                              16384>());
    std::vector<Start> starts;
    for (const Timed& timed : list) starts.push_back(timed.start);
    records::Progress progress("growth on the host", rounds * list.size());
    const auto times = time_steps(starts, [&] { progress.advance(); });
    std::vector<Cost> costs;
    for (std::size_t i = 0; i < list.size(); ++i)
        costs.push_back({.broad_phase = list[i].what,
                         .particles = list[i].particles,
                         .per_step = times[i].per_step,
                         .pairs = list[i].pairs ? list[i].pairs() : 0,
                         .runs = times[i].runs,
                         .rejected = times[i].rejected});
    return costs;
}

}  // namespace growth
