// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects called through the translator, compared with the simulated chip: raws and cycles.
#include <gtest/gtest.h>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "this_build.hpp"

namespace instructions {
namespace {

using simulator::Chip;
using simulator::Elf;

// Subjects in assembly have a second name, by which the library calls them.
bool is_kernel(const Elf& elf, const std::string& subject) {
    for (const auto& [name, symbol] : elf.functions())
        if (name.starts_with("fixedpoint_") && symbol.address == elf.function(subject).address)
            return true;
    return false;
}

TEST(TranslatedSubjectsTest, CallTheKernelsAsTheSimulatorDoes) {
    const Elf library(build_folder() / "bench/device/q16_16.elf");
    Chip chip(library);
    chip.run_until_function("main");
    int subjects = 0;
    for (const std::string& symbol : operations::subjects_of(library)) {
        const reference::NamedSubject named = reference::parse_symbol(symbol);
        if (!is_kernel(library, symbol)) continue;
        ++subjects;
        const operations::Calling calling = operations::calling_of(named.subject);
        const CompiledFunction function(
            library, symbol, interface_of(calling.signature, calling.pointers), {.options = "-O0"});
        CompiledFunction::Session session(function);
        operations::DeviceSubject device(chip, symbol);
        operands::Sampler sampler(named.subject.operation, named.subject.operand_format,
                                  operands::OperandClass::full, 1);
        std::vector<std::int64_t> operands(function.arity()), results(function.result_count());
        for (int i = 0; i < 300; ++i) {
            sampler.next(operands);
            std::uint32_t cycles;
            session.run(operands, results, {&cycles, 1});
            const auto expected = device.call(operands);
            ASSERT_EQ(cycles, expected.cycles) << symbol << " of " << operands[0];
            for (std::size_t k = 0; k < results.size(); ++k)
                ASSERT_EQ(results[k], expected.raws[k]) << symbol << " of " << operands[0];
        }
    }
    EXPECT_GT(subjects, 0);
}

}  // namespace
}  // namespace instructions
