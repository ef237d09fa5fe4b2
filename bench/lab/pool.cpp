// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/pool.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace lab {

Pool* Pool::shared() {
    static const std::unique_ptr<Pool> pool = [] {
        int ends[2];
        const char* const text = std::getenv(variable);
        if (text == nullptr || std::sscanf(text, "%d,%d", &ends[0], &ends[1]) != 2 ||
            fcntl(ends[0], F_GETFD) < 0 || fcntl(ends[1], F_GETFD) < 0)
            return std::unique_ptr<Pool>();
        return std::unique_ptr<Pool>(new Pool(ends[0], ends[1]));
    }();
    return pool.get();
}

Pool::Pool(unsigned cores) : owned_(true) {
    int ends[2];
    if (pipe2(ends, O_NONBLOCK) != 0) throw std::runtime_error("no pipe for the pool of cores");
    read_ = ends[0];
    write_ = ends[1];
    refill(cores);
}

Pool::~Pool() {
    if (!owned_) return;
    close(read_);
    close(write_);
}

bool Pool::try_take() {
    char token;
    return read(read_, &token, 1) == 1;
}

bool Pool::take(const std::function<bool()>& over) {
    while (!over()) {
        if (try_take()) return true;
        pollfd waiting{read_, POLLIN, 0};
        poll(&waiting, 1, 50);
    }
    return false;
}

void Pool::give_back() {
    const char token = '+';
    // A byte always fits: there are never more than at the start.
    [[maybe_unused]] const auto written = write(write_, &token, 1);
}

void Pool::refill(unsigned cores) {
    while (try_take()) {
    }
    for (unsigned i = 0; i < cores; ++i) give_back();
}

}  // namespace lab
