// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>

#include "bench/experiments/cost/growth/box.hpp"
#include "bench/experiments/cost/growth/cost.hpp"
#include "bench/lab/records/progress.hpp"

namespace growth {
namespace {

constexpr unsigned largest = 4096;

// The median of the steps' times: what else the machine does plays no part.
template <unsigned N, class Search>
double nanoseconds_per_step() {
    using Clock = std::chrono::steady_clock;
    const auto world = std::make_unique<World<N, Search>>();
    build<N, Search>(*world);
    const auto end = Clock::now() + std::chrono::milliseconds(200);
    std::vector<double> times;
    while (times.size() < 9 || Clock::now() < end) {
        // As many steps at once as make the clock's own cost small.
        constexpr unsigned at_once = N < 64 ? 64 / N * 4 : 1;
        const auto start = Clock::now();
        for (unsigned i = 0; i < at_once; ++i) world->step(engine::BinaryStep<8>());
        times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() /
                        at_once);
    }
    if (world->error() != engine::Error::none)
        throw std::runtime_error(
            fmt::format("box of {} particles: {}", N, engine::describe(world->error())));
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    return times[times.size() / 2];
}

template <unsigned N, class Search>
void measure(const char* search, unsigned most, std::vector<Cost>& costs,
             records::Progress& progress) {
    if (N > most) return;
    costs.push_back({search, N, nanoseconds_per_step<N, Search>()});
    progress.advance();
    if constexpr (N < largest) measure<2 * N, Search>(search, most, costs, progress);
}

}  // namespace

std::vector<Cost> costs_on_host(unsigned most) {
    std::vector<Cost> costs;
    unsigned sizes = 0;
    for (unsigned n = 2; n <= std::min(most, largest); n *= 2) ++sizes;
    records::Progress progress("growth on the host", 2 * sizes);
    measure<2, engine::BruteForce>("brute_force", most, costs, progress);
    measure<2, engine::SortAndSweep>("sort_and_sweep", most, costs, progress);
    return costs;
}

}  // namespace growth
