// SPDX-License-Identifier: GPL-3.0-or-later
// The machine code of every subject compared with the host: in the simulated chip, as `fixbench
// verify` runs it; and the library's assembly, translated to host code, over operands so dense that
// no path and no carry can be missed.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <ostream>
#include <random>
#include <ranges>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/device/tests/program_folder.hpp"
#include "bench/experiments/operations/verify_kernels.hpp"
#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/subjects/calling.hpp"
#include "bench/lab/subjects/host_subject.hpp"

namespace operations {
namespace {

class Kernels : public testing::TestWithParam<std::string> {};

std::uint64_t differences(const std::string& program, std::uint64_t samples) {
    VerifyOptions options;
    options.programs = {program_folder() + "/" + program + ".elf"};
    options.output = testing::TempDir() + "kernels_test." + program;
    options.selection.implementations = {"default",           "small",       "saturating",
                                         "correctly_rounded", "toward_zero", "downward",
                                         "half_to_even"};
    options.samples = samples;
    return verify_kernels(options);
}
TEST_P(Kernels, AreTheHostsBitForBit) {
    // Calls of 64 bits take long.
    EXPECT_EQ(differences(GetParam(), GetParam().starts_with("q32_32") ? 400 : 4000), 0u);
}
// Mostly the compiler's code: a few samples show whether the chip agrees with the host.
class Compiled : public testing::TestWithParam<std::string> {};
TEST_P(Compiled, IsTheHostsBitForBit) { EXPECT_EQ(differences(GetParam(), 100), 0u); }

// Calls of a kernel, compared in batches.
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
    // Fails unless all calls gave the host's results.
    void finish() {
        compare();
        EXPECT_EQ(mismatches_, 0u) << host_.name() << ", the first: " << first_;
    }
    const instructions::CompiledFunction& function() const { return function_; }
    std::set<std::uint32_t> reached_blocks() const {
        const std::vector<std::uint32_t> blocks = session_.reached_blocks();
        return {blocks.begin(), blocks.end()};
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
            if (host_.subject.format.extend(std::uint64_t(results_[i])) == expected_[i]) continue;
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

// Every first operand with every boundary operand as the second, and vice versa: all carries of a
// 16-bit kernel, and the edges of its paths.
void all_of_one_operand(DenseCalls& calls, const reference::NumberFormat& format) {
    for (const operands::BoundaryOperand& each : operands::boundary_operands(format)) {
        for (std::int64_t raw = format.min(); raw <= format.max(); ++raw) {
            calls.add(std::array{raw, each.raw});
            calls.add(std::array{each.raw, raw});
        }
    }
}

// A space of at most 2^16 inputs is run completely.
void all_of_the_only_operand(DenseCalls& calls, const reference::NumberFormat& format) {
    for (std::int64_t raw = format.min(); raw <= format.max(); ++raw) calls.add(std::array{raw});
}

// Long runs of equal bits make long carries, which random bits seldom do.
std::int64_t runs_of_bits(const reference::NumberFormat& format, std::mt19937_64& random) {
    const auto power = [&] { return std::uint64_t(1) << random() % unsigned(format.width); };
    return format.extend((power() - power()) ^ (power() - power()));
}

// Vectors whose length is half an ulp from the limit of the format, on both sides of it.
void lengths_beside_the_limit(DenseCalls& calls, const reference::NumberFormat& format,
                              std::size_t arity) {
    using Wide = unsigned __int128;
    std::mt19937_64 random(5);
    std::vector<std::int64_t> raws(arity);
    for (int i = 0; i < 1000; ++i) {
        Wide rest = Wide(1) << (2 * format.width - 2);
        for (std::size_t k = 1; k < arity; ++k) {
            raws[k] = runs_of_bits(format, random) / 4;
            rest -= Wide(raws[k]) * Wide(raws[k]);
        }
        std::int64_t root = format.max();
        if (const auto above = std::sqrt(static_cast<long double>(rest)); above < root)
            root = std::int64_t(above) + 1;
        while (Wide(root) * Wide(root) >= rest) --root;
        for (const std::int64_t longest : {root - 1, root, std::min(root, format.max() - 1) + 1}) {
            raws[0] = longest;
            calls.add(raws);
        }
    }
}

// Next to the limits of the intervals of 64-bit functions' tables: of a number's leading bits, of
// the quarter turn, of the remainder modulo ln 2, and of the ratio of two numbers.
void beside_limits_of_tables(DenseCalls& calls, const reference::NumberFormat& format,
                             std::size_t arity) {
    std::mt19937_64 random(7);
    const auto near = [&](double raw) {
        return format.extend(static_cast<std::uint64_t>(std::int64_t(raw)) + random() % 5 - 2);
    };
    for (int i = 0; i < 1 << 16; ++i) {
        const int index = static_cast<int>(random() % 2048),
                  scale = static_cast<int>(random() % 54);
        const double number = std::ldexp(256 + index % 256, scale);
        if (arity == 2) {
            const double sign = random() % 2 == 0 ? 1 : -1, ratio = double(random() % 257) / 256;
            const std::int64_t a = near(number * ratio), b = near(sign * number);
            calls.add(random() % 2 == 0 ? std::array{a, b} : std::array{b, a});
        } else {
            for (const double raw :
                 {number / 256, std::ldexp((index - 1024) * (M_PI / 512), format.fraction),
                  std::ldexp((scale - 32) * M_LN2 - index / 256.0 / (index % 2 == 0 ? 1 : 256),
                             format.fraction)}) {
                calls.add(std::array{near(raw)});
            }
        }
    }
}

// Bases anywhere, next to 1 and next to the limits of the first intervals of pow's table, each with
// an exponent whose power is in the range of Q32.32, in its highest octaves, or just beyond.
void powers_in_the_range(DenseCalls& calls) {
    std::mt19937_64 random(8);
    for (int i = 0; i < 1 << 18; ++i) {
        const std::uint64_t digits = random() >> (1 + random() % 60);
        std::int64_t a = std::int64_t(digits);
        if (i % 4 == 1) a = (std::int64_t(1) << 32) + std::int64_t(digits >> (35 + random() % 28));
        if (i % 4 == 2) a = (std::int64_t(1) << 32) - std::int64_t(digits >> (35 + random() % 28));
        if (i % 4 == 3)
            a = std::int64_t((64 + random() % 64) << 56 >> (1 + random() % 61)) + i % 5 - 2;
        if (a <= 0) continue;
        const double logarithm = std::log(std::ldexp(double(a), -32));
        const double place = std::ldexp(double(random() >> 11), -53);
        const double b = (i / 4 % 2 == 0 ? 21.5 - place : 46 * place - 23.5) / logarithm;
        if (std::fabs(b) < std::ldexp(1.0, 31)) {
            calls.add(std::array{a, std::int64_t(std::ldexp(b, 32)) ^ i});
        }
    }
    // Once in 10^5 bases the sum of the series' squares and fourth powers carries out of its lowest
    // 24 bits: these are such bases next to 1, whose powers with large exponents show it.
    for (const std::int64_t above_1 : {-9695, 59290, -205163, 226716, 368867, -511731}) {
        const std::int64_t a = (std::int64_t(1) << 32) + above_1;
        const double logarithm = std::log1p(std::ldexp(double(above_1), -32));
        for (int i = 0; i < 16; ++i)
            calls.add(std::array{a, std::int64_t(std::ldexp((21.4 - i / 32.0) / logarithm, 32))});
    }
}

// r^2 + r, the largest sum of squares below (r + 1/2)^2, belongs to (m^2, m), and r^2 + r + 1, the
// next one, to (m^2 - 1, m).
void lengths_beside_halves(DenseCalls& calls, const reference::NumberFormat& format,
                           std::size_t arity) {
    std::mt19937_64 random(6);
    std::vector<std::int64_t> raws(arity, 0);
    for (int i = 0; i < 1000; ++i) {
        const auto m = std::int64_t((random() >> (65 - format.width / 2)) >> random() % 4);
        for (const std::int64_t longer : {m * m, m * m - 1}) {
            raws[i % 2] = longer;
            raws[1 - i % 2] = -m;
            calls.add(raws);
        }
    }
}

void call_densely(DenseCalls& calls, const HostSubject& host, std::uint64_t samples) {
    const reference::NumberFormat& format = host.subject.operand_format;
    for (const operands::BoundaryCase& each :
         operands::boundary_cases(host.subject.operation, format)) {
        calls.add(each.operands);
    }
    const std::size_t arity = reference::shape(host.subject.operation).operands;
    if (format.width <= 16 && arity == 1) all_of_the_only_operand(calls, format);
    if (format.width <= 16 && arity == 2) all_of_one_operand(calls, format);
    if (reference::shape(host.subject.operation).signature == reference::Signature::length) {
        lengths_beside_the_limit(calls, format, arity);
        lengths_beside_halves(calls, format, arity);
    }
    if (format.width == 64 && arity <= 2) beside_limits_of_tables(calls, format, arity);
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
        for (std::int64_t& raw : raws) raw = runs_of_bits(format, random);
        calls.add(raws);
    }
    calls.finish();
}

// Kernels have a second name, by which the library calls them.
bool is_kernel(const simulator::Elf& elf, const std::string& subject) {
    return std::ranges::any_of(elf.functions(), [&](const auto& function) {
        return function.first.starts_with("fixedpoint_") &&
               function.second.address == elf.function(subject).address;
    });
}

TEST_P(Kernels, AreTheHostsOverDenseOperandsWhichTakeEveryPath) {
    const simulator::Elf elf(program_folder() + "/" + GetParam() + ".elf");
    std::vector<std::unique_ptr<DenseCalls>> kernels;
    std::set<std::uint32_t> reached;
    for (const HostSubject& host : host_subjects()) {
        if (!elf.has_function(host.name()) || !is_kernel(elf, host.name())) continue;
        const auto& calls = kernels.emplace_back(std::make_unique<DenseCalls>(elf, host));
        ASSERT_NO_THROW(call_densely(*calls, host, 1 << 18)) << host.name();
        if (HasFailure()) return;
        reached.merge(calls->reached_blocks());
    }
    EXPECT_FALSE(kernels.empty());
    // Functions share code, as the cosine uses the sine's: code reached by one counts for all.
    for (const auto& calls : kernels)
        EXPECT_EQ(fmt::format("{:04x}", fmt::join(calls->function().unreached(reached), " ")), "")
            << "in " << calls->function().symbol();
}

// A kernel after a test of the range, in the compiler's code.
struct AfterATest {
    std::string program, subject;
    friend void PrintTo(const AfterATest& it, std::ostream* to) { *to << it.subject; }
};
class Ranged : public testing::TestWithParam<AfterATest> {};
TEST_P(Ranged, IsTheHostsOverDenseOperands) {
    const auto& [program, subject] = GetParam();
    const simulator::Elf elf(program_folder() + "/" + program + ".elf");
    const auto& hosts = host_subjects();
    const auto host =
        std::ranges::find(hosts, subject, [](const HostSubject& one) { return one.name(); });
    ASSERT_NE(host, hosts.end());
    DenseCalls calls(elf, *host);
    if (subject == "pow_q32_32_default") powers_in_the_range(calls);
    ASSERT_NO_THROW(call_densely(calls, *host, 1 << 18));
}

// The last part of a name is the program's: the build runs the tests of the programs that changed.
std::vector<std::string> words(std::string_view list) {
    std::vector<std::string> found;
    for (const auto word : std::views::split(list, ','))
        found.emplace_back(word.begin(), word.end());
    return found;
}
constexpr auto name_of = [](const auto& program) { return program.param; };
constexpr auto program_of = [](const auto& subject) { return subject.param.program; };
INSTANTIATE_TEST_SUITE_P(Programs, Kernels, testing::ValuesIn(words(KERNEL_PROGRAMS)), name_of);
INSTANTIATE_TEST_SUITE_P(Programs, Compiled, testing::ValuesIn(words(COMPILED_PROGRAMS)), name_of);
INSTANTIATE_TEST_SUITE_P(PowerOfTwo, Ranged,
                         testing::Values(AfterATest{"q16_16_powers", "exp2_q16_16_default"}),
                         program_of);
INSTANTIATE_TEST_SUITE_P(CubeRoot, Ranged,
                         testing::Values(AfterATest{"q32_32_powers", "cbrt_q32_32_default"}),
                         program_of);
INSTANTIATE_TEST_SUITE_P(Power, Ranged,
                         testing::Values(AfterATest{"q32_32_powers", "pow_q32_32_default"}),
                         program_of);

}  // namespace
}  // namespace operations
