// SPDX-License-Identifier: GPL-3.0-or-later
// The terminal of the user: pictures out, keys in. While this object exists the terminal is in
// another mode, and it is restored afterwards, however the program ends. One at a time.
#pragma once

#include <optional>

#include "bench/live/picture.hpp"
#include "bench/live/session.hpp"

namespace live {

class Terminal {
  public:
    // Throws std::runtime_error if input or output is not a terminal, or the window is too small.
    Terminal();
    ~Terminal();
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    void show(const Picture& picture);

    // Waits for a key, for at most that many seconds.
    std::optional<Key> key(double seconds);

    // The signal that asks the program to end, or 0 if there was none.
    static int signal();
};

}  // namespace live
