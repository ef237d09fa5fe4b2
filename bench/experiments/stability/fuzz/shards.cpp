// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: joins the files of the parts of an exhaustive run.
#include "bench/experiments/exhaustive/exhaustive.hpp"
#include "bench/experiments/stability/fuzz/refusal.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = fuzz::file("shard.json", {reinterpret_cast<const char*>(data), size});
    fuzz::takes([&] { machine_code::merge_exhaustive({path}, fuzz::folder()); });
    return 0;
}
