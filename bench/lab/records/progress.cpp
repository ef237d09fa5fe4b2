// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/records/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "bench/lab/pool.hpp"

namespace records {

std::string Progress::duration(double seconds) {
    const long total = std::lround(seconds);
    return fmt::format("{}:{:02}", total / 60, total % 60);
}

std::string Progress::time_left(double elapsed, double share) {
    return share < 0.01 ? "?" : duration(elapsed / share - elapsed);
}

Progress::Progress(std::string task, std::uint64_t total)
    : task_(std::move(task)),
      total_(total == 0 ? 1 : total),
      silent_(lab::Pool::shared() != nullptr),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      next_print_ms_(terminal_ ? 200 : 10000) {}

Progress::~Progress() { print(done_, true); }

void Progress::advance(std::uint64_t steps) {
    const std::uint64_t done = done_ += steps;
    const std::int64_t now = std::chrono::duration_cast<std::chrono::milliseconds>(
                                 std::chrono::steady_clock::now() - start_)
                                 .count();
    std::int64_t due = next_print_ms_;
    // The thread that advances the due time prints.
    if (now >= due &&
        next_print_ms_.compare_exchange_strong(due, now + (terminal_ ? 200 : 10000))) {
        print(done, false);
    }
}

void Progress::print(std::uint64_t done, bool last) {
    if (silent_) return;
    const std::lock_guard lock(printing_);
    const double elapsed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    const char* const begin = terminal_ ? "\r\033[K" : "";
    const char* const end = terminal_ && !last ? "" : "\n";
    if (last) {
        fmt::print(stderr, "{}{}: {}{}", begin, task_, duration(elapsed), end);
    } else {
        constexpr int width = 30;
        const int filled = static_cast<int>(share * width);
        fmt::print(stderr, "{}{} [{:#<{}}{:.<{}}] {:3.0f}% {} left{}", begin, task_, "", filled, "",
                   width - filled, 100 * share, time_left(elapsed, share), end);
    }
    std::fflush(stderr);
}

}  // namespace records
