// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/operations/host_throughput.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/fixed.hpp>
#include <iostream>
#include <iterator>
#include <random>
#include <string>

#include "bench/lab/catalogue/invoke.h"
#include "bench/lab/catalogue/subjects.h"
#include "reference/operation.hpp"

namespace {

using fixedpoint::Nearest;
using fixedpoint::Published;
using reference::Operation;

// Log-uniform operands of 0.01 to 20 with both signs, clipped to the format.
template <class Raw, int F>
std::array<Raw, 1024> physics_operands(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> exponent(std::log(0.01), std::log(20.0));
    std::array<Raw, 1024> operands;
    for (Raw& operand : operands) {
        const double magnitude = std::exp(exponent(random)) * std::exp2(F);
        const double limit = static_cast<double>(fixedpoint::RawLimits<Raw>::max);
        operand = static_cast<Raw>(magnitude < limit ? magnitude : limit);
        if (random() & 1) operand = static_cast<Raw>(-operand);
    }
    return operands;
}

template <class Policy, class Raw, int F, Operation operation>
void measure(const std::string& suffix) {
    const reference::OperationShape& shape = reference::shape(operation);
    benchmark::RegisterBenchmark(
        (std::string(shape.name) + suffix).c_str(), [](benchmark::State& state) {
            const auto a = physics_operands<Raw, F>(1), b = physics_operands<Raw, F>(2);
            std::size_t i = 0;
            for (auto _ : state) {
                if constexpr (reference::shape(operation).operands == 1)
                    benchmark::DoNotOptimize(catalogue::invoke<operation, Policy, Raw, F>(a[i]));
                else
                    benchmark::DoNotOptimize(
                        catalogue::invoke<operation, Policy, Raw, F>(a[i], b[i]));
                i = (i + 1) % a.size();
            }
        });
}

template <class Policy, class Raw, int F, Operation... operations>
void measure_all(const std::string& suffix) {
    (measure<Policy, Raw, F, operations>(suffix), ...);
}

template <class Policy>
void measure_formats(const std::string& implementation) {
    using enum Operation;
#define MEASURE_FORMAT(format, Raw, F, ...)                                                \
    measure_all<Policy, Raw, F, add, multiply, divide, Operation::sqrt, Operation::atan2>( \
        "_" #format "_" + implementation);
    SQUARE_FORMATS(MEASURE_FORMAT)
}

void measure_float() {
    const auto named = [](const std::string& operation) { return operation + "_float_host"; };
    const auto measure = [&](const char* operation, float (*function)(float, float)) {
        benchmark::RegisterBenchmark(named(operation).c_str(), [function](benchmark::State& state) {
            const auto a = physics_operands<std::int32_t, 16>(1),
                       b = physics_operands<std::int32_t, 16>(2);
            std::array<float, 1024> x, y;
            for (std::size_t i = 0; i < x.size(); ++i) {
                x[i] = std::ldexp(static_cast<float>(a[i]), -16);
                y[i] = std::ldexp(static_cast<float>(b[i]), -16);
            }
            std::size_t i = 0;
            for (auto _ : state) {
                benchmark::DoNotOptimize(function(x[i], y[i]));
                i = (i + 1) % x.size();
            }
        });
    };
    measure("add", [](float a, float b) { return a + b; });
    measure("multiply", [](float a, float b) { return a * b; });
    measure("divide", [](float a, float b) { return a / b; });
    measure("sqrt", [](float a, float) { return std::sqrt(a); });
    measure("atan2", [](float a, float b) { return std::atan2(a, b); });
}

}  // namespace

void operations::measure_throughput(const std::filesystem::path& file, double seconds) {
    measure_formats<Nearest>("default");
    measure_formats<Published>("published");
    measure_float();
    // The library's table goes to stderr, like everything that is not the result.
    std::filesystem::path partial = file;
    partial += ".partial";
    std::string arguments[] = {"fixbench", fmt::format("--benchmark_min_time={}", seconds),
                               "--benchmark_out=" + partial.string(),
                               "--benchmark_out_format=json"};
    char* pointers[std::size(arguments)];
    for (std::size_t i = 0; i < std::size(arguments); ++i) pointers[i] = arguments[i].data();
    int count = std::size(arguments);
    benchmark::Initialize(&count, pointers);
    benchmark::ConsoleReporter console;
    console.SetOutputStream(&std::cerr);
    console.SetErrorStream(&std::cerr);
    benchmark::RunSpecifiedBenchmarks(&console);
    benchmark::Shutdown();
    std::filesystem::rename(partial, file);
}
