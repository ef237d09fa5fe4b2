// SPDX-License-Identifier: GPL-3.0-or-later
// The terminal that somebody sits at: pictures out, keys in. While it exists the terminal is in
// another mode, and as it was before when it is gone, however that comes about. One at a time.
#pragma once

#include <optional>

#include "bench/live/picture.hpp"
#include "bench/live/session.hpp"

namespace live {

class Terminal {
  public:
    // Throws std::runtime_error where input or output is no terminal, or the window is too small.
    Terminal();
    ~Terminal();
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    void show(const Picture& picture);

    // Waits for a key for so many seconds at most.
    std::optional<Key> key(double seconds);

    // The signal that asks the program to end, once there was one.
    static int signal();
};

}  // namespace live
