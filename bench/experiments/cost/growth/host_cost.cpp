// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/experiments/cost/growth/box2d_discs.hpp"
#include "bench/experiments/cost/growth/cost.hpp"
#include "bench/experiments/cost/growth/discs.hpp"
#include "bench/experiments/cost/growth/stopwatch.hpp"
#include "bench/lab/records/progress.hpp"

namespace growth {
namespace {

template <unsigned N, class Search>
std::function<void(unsigned)> in_the_engine() {
    const auto world = std::make_shared<DiscWorld<N, Search>>();
    build<N, Search>(*world);
    return [world](unsigned steps) {
        for (; steps > 0; --steps) world->step(engine::BinaryStep<exponent_of_step>());
        if (world->error() != engine::Error::none)
            throw std::runtime_error(
                fmt::format("box of {} discs: {}", N, engine::describe(world->error())));
    };
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
};

// Every pair is too many to wait for beyond 4,096 discs.
template <unsigned... N>
void add(std::vector<Timed>& list, unsigned most, std::integer_sequence<unsigned, N...>) {
    const auto add_all = [&](const char* what, unsigned limit, auto start_of) {
        ((N <= limit ? list.push_back({what, N, start_of(std::integral_constant<unsigned, N>())})
                     : void()),
         ...);
    };
    add_all("brute_force", std::min(most, 4096u), [](auto n) -> Start {
        if constexpr (n <= 4096)
            return in_the_engine<n, engine::BruteForce>;
        else
            return {};
    });
    add_all("sort_and_sweep", most,
            [](auto n) -> Start { return in_the_engine<n, engine::SortAndSweep>; });
    add_all("box2d", most, [](auto n) -> Start { return [n] { return in_box2d(n); }; });
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
                         .runs = times[i].runs,
                         .rejected = times[i].rejected});
    return costs;
}

}  // namespace growth
