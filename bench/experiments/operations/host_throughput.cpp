// SPDX-License-Identifier: GPL-3.0-or-later
// What the portable code costs on the host, by Google Benchmark: host_throughput
// --benchmark_out=host.json. Names are those of the device subjects.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/fixed.hpp>
#include <random>
#include <string>

namespace {

using fixedpoint::Integer;
using fixedpoint::Nearest;
using fixedpoint::Published;

// Operands of 0.01 to 20 in both signs, log-uniform, clipped to the format.
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

template <class Raw, int F, class Function>
void measure_binary(const std::string& name, Function function) {
    benchmark::RegisterBenchmark(name.c_str(), [function](benchmark::State& state) {
        const auto a = physics_operands<Raw, F>(1), b = physics_operands<Raw, F>(2);
        std::size_t i = 0;
        for (auto _ : state) {
            benchmark::DoNotOptimize(function(a[i], b[i]));
            i = (i + 1) % a.size();
        }
    });
}

template <class Raw, int F, class Function>
void measure_unary(const std::string& name, Function function) {
    measure_binary<Raw, F>(name, [function](Raw a, Raw) { return function(a); });
}

template <class Policy, int I, int F>
void measure_format(const std::string& suffix) {
    using Raw = Integer<I + F>;
    const auto named = [&](const char* operation) { return operation + suffix; };
    measure_binary<Raw, F>(named("add"),
                           [](Raw a, Raw b) { return Policy::template add<Raw, F>(a, b); });
    measure_binary<Raw, F>(named("multiply"),
                           [](Raw a, Raw b) { return Policy::template multiply<Raw, F>(a, b); });
    measure_binary<Raw, F>(named("divide"),
                           [](Raw a, Raw b) { return Policy::template divide<Raw, F>(a, b); });
    measure_unary<Raw, F>(named("sqrt"), [](Raw a) { return Policy::template sqrt<Raw, F>(a); });
    measure_binary<Raw, F>(named("atan2"),
                           [](Raw a, Raw b) { return Policy::template atan2<Raw, F>(a, b); });
}

template <class Policy>
void measure_formats(const std::string& implementation) {
    measure_format<Policy, 4, 4>("_q4_4_" + implementation);
    measure_format<Policy, 8, 8>("_q8_8_" + implementation);
    measure_format<Policy, 16, 16>("_q16_16_" + implementation);
    measure_format<Policy, 32, 32>("_q32_32_" + implementation);
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

int main(int argc, char** argv) {
    measure_formats<Nearest>("default");
    measure_formats<Published>("published");
    measure_float();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
