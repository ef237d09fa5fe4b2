// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace operations {

// Calls task(0) .. task(count - 1) on so many threads, in order of starting. The first exception
// ends the run and is thrown here.
template <class Task>
void in_parallel(unsigned threads, std::size_t count, Task&& task) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failing;
    {
        std::vector<std::jthread> workers;
        for (unsigned i = 0; i < threads; ++i) {
            workers.emplace_back([&] {
                try {
                    for (std::size_t k = next++; k < count; k = next++) task(k);
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
