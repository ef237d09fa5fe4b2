// SPDX-License-Identifier: GPL-3.0-or-later
// Results in Google Benchmark's JSON schema, so that its compare.py can read figures of the
// simulated chip and of the host alike.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace records {

// One benchmark on the simulated chip, where one cycle at 16 MHz is 62.5 ns.
struct SimulatedBenchmark {
    std::string name;
    std::uint64_t iterations;
    double cycles_mean;
    nlohmann::json counters;  // further numbers by name, added to the entry
};

// The document of a simulated run. `context` is added to the schema's context object. It contains
// no date, so that equal measurements give equal files.
nlohmann::json benchmark_document(const std::vector<SimulatedBenchmark>& benchmarks,
                                  const nlohmann::json& context);

}  // namespace records
