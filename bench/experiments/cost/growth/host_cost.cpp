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

template <class World>
void take(unsigned steps, World& world) {
    for (; steps > 0; --steps) world.step(engine::BinaryStep<exponent_of_step>());
    if (world.error() != engine::Error::none)
        throw std::runtime_error(fmt::format("box of {} discs: {}", world.particles().size(),
                                             engine::describe(world.error())));
}

template <class Search>
std::function<void(unsigned)> in_the_engine(unsigned n) {
    const auto world = std::make_shared<DiscWorld<Search>>();
    build<Search>(*world, n);
    return [world](unsigned steps) { take(steps, *world); };
}

// The mean over the timed steps.
template <class Search>
double pairs_in_the_engine(unsigned n) {
    const auto world = std::make_unique<DiscWorld<Counted<Search>>>();
    build<Counted<Search>>(*world, n);
    take(warm_steps, *world);
    const auto before = world->pair_memory().pairs;
    take(timed_steps(n), *world);
    return static_cast<double>(world->pair_memory().pairs - before) / timed_steps(n);
}

std::function<void(unsigned)> in_box2d(unsigned n) {
    const std::shared_ptr<b2World> world = box2d_discs(n);
    return [world](unsigned steps) {
        for (; steps > 0; --steps) step(*world);
    };
}

struct Kind {
    const char* what;
    unsigned most;
    std::function<void(unsigned)> (*start)(unsigned n);
    double (*pairs)(unsigned n);
};
constexpr Kind kinds[] = {
    // With more, every pair takes too long.
    {"brute_force", 4096, in_the_engine<engine::BruteForce>,
     pairs_in_the_engine<engine::BruteForce>},
    {"sort_and_sweep", max_discs, in_the_engine<engine::CachedSortAndSweep>,
     pairs_in_the_engine<engine::CachedSortAndSweep>},
    {"box2d", max_discs, in_box2d, nullptr},
};

}  // namespace

std::vector<Cost> costs_on_host(unsigned most, unsigned rounds) {
    std::vector<Cost> costs;
    std::vector<Timed> worlds;
    for (const Kind& kind : kinds)
        for (const unsigned n :
             {16u, 36u, 64u, 144u, 256u, 576u, 1024u, 2304u, 4096u, 9216u, 16384u}) {
            if (n > std::min(most, kind.most)) break;
            worlds.push_back({[&kind, n] { return kind.start(n); }, timed_steps(n)});
            costs.push_back({.broad_phase = kind.what,
                             .particles = n,
                             .per_step = 0,
                             .pairs = kind.pairs ? kind.pairs(n) : 0});
        }
    records::Progress progress("growth on the host", rounds * worlds.size());
    const auto times = time_steps(worlds, rounds, [&] { progress.advance(); });
    for (std::size_t i = 0; i < costs.size(); ++i) {
        costs[i].per_step = times[i].per_step;
        costs[i].runs = times[i].runs;
        costs[i].rejected = times[i].rejected;
    }
    return costs;
}

}  // namespace growth
