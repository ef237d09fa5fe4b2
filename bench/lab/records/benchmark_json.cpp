// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/records/benchmark_json.hpp"

namespace records {

nlohmann::json benchmark_document(const std::vector<SimulatedBenchmark>& benchmarks,
                                  const nlohmann::json& context) {
    constexpr double nanoseconds_per_cycle = 62.5;
    nlohmann::json document;
    document["context"] = {{"executable", "simulated ATmega328P"},
                           {"num_cpus", 1},
                           {"mhz_per_cpu", 16},
                           {"cpu_scaling_enabled", false},
                           {"caches", nlohmann::json::array()},
                           {"library_build_type", "release"}};
    if (!context.is_null()) document["context"].update(context);
    document["benchmarks"] = nlohmann::json::array();
    int family = 0;
    for (const SimulatedBenchmark& benchmark : benchmarks) {
        nlohmann::json entry = {{"name", benchmark.name},
                                {"family_index", family++},
                                {"per_family_instance_index", 0},
                                {"run_name", benchmark.name},
                                {"run_type", "iteration"},
                                {"repetitions", 1},
                                {"repetition_index", 0},
                                {"threads", 1},
                                {"iterations", benchmark.iterations},
                                {"real_time", benchmark.cycles_mean * nanoseconds_per_cycle},
                                {"cpu_time", benchmark.cycles_mean * nanoseconds_per_cycle},
                                {"time_unit", "ns"},
                                {"cycles", benchmark.cycles_mean}};
        if (!benchmark.counters.is_null()) entry.update(benchmark.counters);
        document["benchmarks"].push_back(std::move(entry));
    }
    return document;
}

}  // namespace records
