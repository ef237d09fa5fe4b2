// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/stopwatch.hpp"

#include <sched.h>

#include <algorithm>
#include <chrono>

namespace growth {
namespace {

// Keeps the thread on the processor that it runs on.
class Pinned {
  public:
    Pinned() {
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<unsigned>(std::max(sched_getcpu(), 0)), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~Pinned() { sched_setaffinity(0, sizeof before_, &before_); }
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;

  private:
    cpu_set_t before_;
};

double nanoseconds_of_a_run(const Start& world) {
    using Clock = std::chrono::steady_clock;
    const auto advance = world();
    advance(warm_steps);
    const auto begin = Clock::now();
    advance(timed_steps);
    return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

Time of_runs(std::vector<double> runs) {
    std::sort(runs.begin(), runs.end());
    const auto loaded = std::upper_bound(runs.begin(), runs.end(), 1.05 * runs.front());
    const auto kept = static_cast<std::size_t>(loaded - runs.begin());
    return {runs[kept / 2] / timed_steps, runs.size(), runs.size() - kept};
}

}  // namespace

std::vector<Time> time_steps(const std::vector<Start>& worlds,
                             const std::function<void()>& progress) {
    constexpr double least_time = 3e7;  // ns per world and round
    const Pinned pinned;
    std::vector<std::vector<double>> runs(worlds.size());
    for (unsigned round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            for (double spent = 0; spent < least_time; spent += runs[i].back())
                runs[i].push_back(nanoseconds_of_a_run(worlds[i]));
            progress();
        }
    std::vector<Time> times;
    for (auto& of_world : runs) times.push_back(of_runs(std::move(of_world)));
    return times;
}

}  // namespace growth
