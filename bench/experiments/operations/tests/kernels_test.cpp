// SPDX-License-Identifier: GPL-3.0-or-later
// The machine code of every subject against the host: as `fixbench verify` runs it, in the simulated
// chip; and the library's assembly, translated to host code, over operands so dense that no path and
// no carry can be missed.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/experiments/operations/verify_kernels.hpp"
#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/subjects/calling.hpp"
#include "bench/lab/subjects/host_subject.hpp"

namespace operations {
namespace {

// The folder of the programs: scripts/mutation_test.py names another, with faults in them.
std::string folder() {
    const char* other = std::getenv("DEVICE_PROGRAMS");
    return other ? other : PROGRAM_FOLDER;
}

class Kernels : public testing::TestWithParam<std::string> {};

TEST_P(Kernels, AreTheHostsBitForBit) {
    VerifyOptions options;
    options.programs = {folder() + "/" + GetParam() + ".elf"};
    options.output = testing::TempDir() + "kernels_test." + GetParam();
    options.selection.implementations = {"default", "small", "saturating"};
    options.samples = GetParam() == "q32_32" ? 400 : 4000;  // of 64 bits calls are long
    EXPECT_EQ(verify_kernels(options), 0u);
}

// Calls of a kernel, compared a batch at a time.
class DenseCalls {
  public:
    DenseCalls(const simulator::Elf& elf, const HostSubject& host)
        : host_(host),
          function_(elf, host.name(), interface_of(calling_of(host.subject)), {.options = "-O1"}),
          session_(function_),
          results_(function_.result_count()),
          expected_(function_.result_count()) {}

    void add(Raws operands) {
        operands_.insert(operands_.end(), operands.begin(), operands.end());
        if (operands_.size() >= batch * function_.arity()) compare();
    }
    // Whether all calls gave what the host gives.
    bool finish() {
        compare();
        if (mismatches_ != 0) {
            ADD_FAILURE() << fmt::format("{}: {} results differ from the host's, the first: {}",
                                         host_.name(), mismatches_, first_);
        }
        return mismatches_ == 0;
    }

  private:
    static constexpr std::size_t batch = 4096;

    static instructions::Interface interface_of(const Calling& calling) {
        return instructions::interface_of(calling.signature, calling.pointers);
    }
    void compare() {
        const std::size_t arity = function_.arity(), results = function_.result_count();
        const std::size_t calls = operands_.size() / arity;
        results_.resize(calls * results);
        expected_.resize(calls * results);
        cycles_.resize(calls);
        session_.run(operands_, results_, cycles_);
        host_.evaluate(operands_, expected_);
        for (std::size_t i = 0; i < results_.size(); ++i) {
            if (results_[i] == expected_[i]) continue;
            if (mismatches_++ == 0) {
                const auto first = operands_.begin() + std::ptrdiff_t(i / results * arity);
                first_ = fmt::format("{}", fmt::join(first, first + std::ptrdiff_t(arity), " "));
            }
        }
        operands_.clear();
    }

    const HostSubject& host_;
    instructions::CompiledFunction function_;
    instructions::CompiledFunction::Session session_;
    std::vector<std::int64_t> operands_, results_, expected_;
    std::vector<std::uint32_t> cycles_;
    std::uint64_t mismatches_ = 0;
    std::string first_;
};

// Every first operand with every boundary operand as the second, and the other way round: all
// carries of a 16-bit kernel, its paths at their edges.
void all_of_one_operand(DenseCalls& calls, const reference::NumberFormat& format) {
    for (const operands::BoundaryOperand& each : operands::boundary_operands(format)) {
        for (std::int64_t raw = format.min(); raw <= format.max(); ++raw) {
            calls.add(std::array{raw, each.raw});
            calls.add(std::array{each.raw, raw});
        }
    }
}

// Long runs of equal bits make long carries, which random bits seldom do.
std::int64_t runs_of_bits(std::mt19937_64& random) {
    const auto power = [&] { return std::uint64_t(1) << random() % 64; };
    return std::int64_t((power() - power()) ^ (power() - power()));
}

void test_densely(const simulator::Elf& elf, const HostSubject& host, std::uint64_t samples) {
    const reference::NumberFormat& format = host.subject.operand_format;
    DenseCalls calls(elf, host);
    for (const operands::BoundaryCase& each :
         operands::boundary_cases(host.subject.operation, format)) {
        calls.add(each.operands);
    }
    const std::size_t arity = reference::shape(host.subject.operation).operands;
    if (host.input_bits() <= 32 && format.width <= 16 && arity == 2)
        all_of_one_operand(calls, format);
    std::vector<std::int64_t> raws(arity);
    for (const operands::OperandClass each :
         {operands::OperandClass::physics, operands::OperandClass::full,
          operands::OperandClass::uniform}) {
        operands::Sampler sampler(host.subject.operation, format, each, 3);
        for (std::uint64_t i = 0; i < samples / 4; ++i) {
            sampler.next(raws);
            calls.add(raws);
        }
    }
    std::mt19937_64 random(3);
    for (std::uint64_t i = 0; i < samples / 4; ++i) {
        for (std::int64_t& raw : raws) raw = format.sign_extend(std::uint64_t(runs_of_bits(random)));
        calls.add(raws);
    }
    calls.finish();
}

// Kernels have a second name, under which the library calls them.
bool is_kernel(const simulator::Elf& elf, const std::string& subject) {
    return std::ranges::any_of(elf.functions(), [&](const auto& function) {
        return function.first.starts_with("fixedpoint_") &&
               function.second.address == elf.function(subject).address;
    });
}

TEST_P(Kernels, AreTheHostsOverDenseOperands) {
    const simulator::Elf elf(folder() + "/" + GetParam() + ".elf");
    std::size_t kernels = 0;
    for (const HostSubject& host : host_subjects()) {
        const std::string name = host.name();
        if (!elf.has_function(name) || !is_kernel(elf, name)) continue;
        ++kernels;
        auto t0 = std::chrono::steady_clock::now();
        ASSERT_NO_THROW(test_densely(elf, host, 1 << 18)) << name;
        fmt::print("{} {:.2f}\n", name, std::chrono::duration<double>(std::chrono::steady_clock::now()-t0).count());
    }
    EXPECT_GT(kernels, 0u);
}

INSTANTIATE_TEST_SUITE_P(Programs, Kernels,
                         testing::Values("q4_4", "q8_8", "q16_16", "q8_24", "q32_32"),
                         [](const auto& program) { return program.param; });

}  // namespace
}  // namespace operations
