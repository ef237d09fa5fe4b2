// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks on many threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "bench/lab/pool.hpp"

namespace operations {

// Calls task(0) .. task(count - 1) on so many threads, in order of starting; where processes share
// the cores, on as many of them as there are cores to have. The first exception ends the run and is
// thrown here.
template <class Task>
void in_parallel(unsigned threads, std::size_t count, Task&& task) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failing;
    struct Held {
        lab::Pool* pool;
        ~Held() {
            if (pool) pool->give_back();
        }
    };
    {
        std::vector<std::jthread> workers;
        for (unsigned i = 0; i < threads; ++i) {
            workers.emplace_back([&, i] {
                // The first works on the core that the process has.
                lab::Pool* const pool = i == 0 ? nullptr : lab::Pool::shared();
                try {
                    while (!pool || pool->take([&] { return next >= count; })) {
                        const Held held{pool};
                        const std::size_t k = next++;
                        if (k >= count) break;
                        task(k);
                    }
                } catch (...) {
                    next = count;
                    const std::lock_guard lock(failing);
                    if (!failure) failure = std::current_exception();
                }
            });
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace operations
