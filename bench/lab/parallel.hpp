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

// Calls task(0) .. task(count - 1) on that many threads, starting them in order. Where processes
// share the cores, it uses only as many threads as there are free cores. The first exception ends
// the run and is rethrown here.
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
                // The first thread works on the core that belongs to the process.
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
