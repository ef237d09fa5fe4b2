// SPDX-License-Identifier: GPL-3.0-or-later
// A progress bar with the time left, on stderr.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace records {

// Counts the steps of a task towards a total. On a terminal it redraws one line, elsewhere it
// prints a line every ten seconds. A process that shares the cores with others prints nothing,
// since its parent shows the progress of all. advance() may be called from several threads.
class Progress {
  public:
    Progress(std::string task, std::uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(std::uint64_t steps = 1);

    // Minutes and seconds: 62:07.
    static std::string duration(double seconds);
    // The duration that is left after `elapsed` seconds, in which a share in 0..1 was done. "?" as
    // long as that is below a hundredth: the first steps may include preparations, and would
    // announce days.
    static std::string time_left(double elapsed, double share);

  private:
    void print(std::uint64_t done, bool last);

    const std::string task_;
    const std::uint64_t total_;
    const bool silent_, terminal_;
    const std::chrono::steady_clock::time_point start_;
    std::atomic<std::uint64_t> done_{0};
    std::atomic<std::int64_t> next_print_ms_;
    std::mutex printing_;
};

}  // namespace records
