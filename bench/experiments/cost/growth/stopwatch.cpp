// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/stopwatch.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <ctime>
#include <vector>

namespace growth {
namespace {

double now(clockid_t clock) {
    timespec time;
    clock_gettime(clock, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

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

double median(std::vector<double>& times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

}  // namespace

double nanoseconds_per_step(const char* what,
                            const std::function<std::function<void(unsigned)>()>& start) {
    constexpr std::size_t least_runs = 5;
    constexpr double least_time = 2e8, most_time = 3e9, interrupted = 1.02;
    const Pinned pinned;
    std::vector<double> undisturbed, all;
    for (double spent = 0; undisturbed.size() < least_runs
                               ? all.size() < least_runs || spent < most_time
                               : spent < least_time;) {
        const auto advance = start();
        advance(warm_steps);
        const double wall = now(CLOCK_MONOTONIC), processor = now(CLOCK_THREAD_CPUTIME_ID);
        advance(timed_steps);
        const double took = now(CLOCK_MONOTONIC) - wall;
        const bool alone = took <= interrupted * (now(CLOCK_THREAD_CPUTIME_ID) - processor) + 1e3;
        all.push_back(took / timed_steps);
        if (alone) undisturbed.push_back(took / timed_steps);
        spent += took;
    }
    if (undisturbed.size() >= least_runs) return median(undisturbed);
    fmt::print(stderr, "{}: {} of {} runs were interrupted: the machine is busy\n", what,
               all.size() - undisturbed.size(), all.size());
    return median(all);
}

}  // namespace growth
