// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/blocks/measure_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <type_traits>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/blocks/subjects.hpp"
#include "bench/lab/records/progress.hpp"
#include "this_build.hpp"

namespace blocks {
namespace {

using simulator::Chip;
using simulator::Elf;

const std::filesystem::path folder = build_folder() / "bench/experiments/blocks";

double value(float x) { return x; }
template <int I, int F>
double value(fixedpoint::Fixed<I, F> x) {
    return fixedpoint::to_float<double>(x);
}

// The device program of the block, whose `input` and `output` are accessed by address.
template <class Number>
class Device {
  public:
    Device(const std::string& name, unsigned outputs)
        : elf_(folder / (name + ".elf")), chip_(elf_), outputs_(outputs) {
        chip_.run_until_function("main");
        step_.emplace(chip_, "step", simulator::Signature{.result = 0, .operands = {}});
    }
    std::uint32_t flash_bytes() const { return elf_.flash_bytes(); }
    std::uint32_t step(const std::vector<Number>& in, std::vector<Number>& out) {
        for (std::size_t i = 0; i < in.size(); ++i) {
            std::uint8_t bytes[sizeof(Number)];
            std::memcpy(bytes, &in[i], sizeof bytes);
            chip_.write(address("input", i), bytes);
        }
        const auto cycles = (*step_)().cycles;
        for (std::size_t i = 0; i < outputs_; ++i) {
            std::uint8_t bytes[sizeof(Number)];
            chip_.read(address("output", i), bytes);
            std::memcpy(&out[i], bytes, sizeof bytes);
        }
        return cycles;
    }

  private:
    std::uint16_t address(const char* array, std::size_t i) const {
        return static_cast<std::uint16_t>(elf_.object(array).address + i * sizeof(Number));
    }

    Elf elf_;
    Chip chip_;
    std::size_t outputs_;
    std::optional<simulator::DeviceFunction> step_;
};

template <template <class> class Block, class Number>
Measurement measured(const std::string& block, const std::string& format, unsigned steps) {
    constexpr unsigned inputs = Block<Number>::inputs, outputs = Block<Number>::outputs;
    Device<Number> device("blocks_" + block + "_" + format, outputs);
    Block<Number> host;
    Block<double> exact;
    std::vector<Number> in(inputs), out(outputs), host_out(outputs);
    std::vector<double> exact_in(inputs), exact_out(outputs);
    Measurement m{block,
                  format,
                  0,
                  0,
                  device.flash_bytes() - Elf(folder / "blocks_empty.elf").flash_bytes(),
                  0,
                  0,
                  steps * outputs,
                  0};
    std::mt19937 random(1);  // the same inputs for every format
    for (unsigned k = 0; k < steps; ++k) {
        for (unsigned i = 0; i < inputs; ++i) {
            // A multiple of 2^-16, if the format holds that.
            constexpr int bits = std::is_same_v<Number, q8_8> ? 8 : 16;
            const long n = static_cast<long>(random() % 131073) - 65536;
            in[i] = Constant<Number, bits>::of((n >> (16 - bits)) * Block<Number>::scale +
                                               (Block<Number>::offset(i) * (1l << (bits - 8))));
            exact_in[i] = value(in[i]);
        }
        const std::uint32_t cycles = device.step(in, out);
        host.step(in.data(), host_out.data());
        exact.step(exact_in.data(), exact_out.data());
        m.cycles_mean += static_cast<double>(cycles) / steps;
        m.cycles_max = std::max(m.cycles_max, cycles);
        for (unsigned i = 0; i < outputs; ++i) {
            const double error = std::abs(value(out[i]) - exact_out[i]);
            m.max_error = std::max(m.max_error, error);
            m.rms_error += error * error / m.outputs;
            if (out[i] != host_out[i]) ++m.unlike_host;
        }
    }
    m.rms_error = std::sqrt(m.rms_error);
    return m;
}

using Run = Measurement (*)(unsigned steps);
const Run runs[] = {
#define PROGRAM(block, format) \
    [](unsigned steps) { return measured<block, format>(#block, #format, steps); },
#include "programs.inc"
#undef PROGRAM
};

}  // namespace

std::vector<Measurement> measure(unsigned steps) {
    std::vector<Measurement> all;
    records::Progress progress("blocks", std::size(runs));
    for (const Run run : runs) {
        all.push_back(run(steps));
        progress.advance();
    }
    return all;
}

}  // namespace blocks
