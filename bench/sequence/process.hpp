// SPDX-License-Identifier: GPL-3.0-or-later
// A program that runs next to this one, with its output in a log.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/lab/pool.hpp"

namespace sequence {

class Process {
  public:
    // Starts it in the folder. `pool` is the pool of cores that it shares; without one it does not
    // know of others. It ends when this process does. Throws std::runtime_error if it cannot start.
    Process(const std::vector<std::string>& command, const std::filesystem::path& folder,
            const std::filesystem::path& log, const lab::Pool* pool);

    // The exit status once it has ended; 128 and more for a signal.
    std::optional<int> ended();
    // Seconds of all cores so far.
    double cpu_seconds() const;
    // Stops it and everything that it started.
    void stop();

  private:
    pid_t pid_;
    double total_ = 0;
    std::optional<int> status_;
};

}  // namespace sequence
