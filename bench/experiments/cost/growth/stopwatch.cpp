// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/stopwatch.hpp"

#include <sched.h>
#include <time.h>

#include <algorithm>
#include <utility>

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

double processor_time() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

double nanoseconds_of_a_run(const Timed& world) {
    const auto advance = world.start();
    advance(warm_steps);
    const double begin = processor_time();
    advance(world.steps);
    return processor_time() - begin;
}

Time of_runs(std::vector<double> runs, unsigned steps) {
    std::sort(runs.begin(), runs.end());
    const auto loaded = std::upper_bound(runs.begin(), runs.end(), 1.05 * runs.front());
    const auto kept = static_cast<std::size_t>(loaded - runs.begin());
    return {runs[kept / 2] / steps, runs.size(), runs.size() - kept};
}

}  // namespace

std::vector<Time> time_steps(const std::vector<Timed>& worlds, unsigned rounds,
                             const std::function<void()>& progress) {
    const Pinned pinned;
    std::vector<std::vector<double>> runs(worlds.size());
    for (unsigned round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            runs[i].push_back(nanoseconds_of_a_run(worlds[i]));
            progress();
        }
    std::vector<Time> times;
    for (std::size_t i = 0; i < worlds.size(); ++i)
        times.push_back(of_runs(std::move(runs[i]), worlds[i].steps));
    return times;
}

}  // namespace growth
