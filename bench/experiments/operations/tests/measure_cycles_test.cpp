// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects that break the rules of calls, measured together with good ones.
#include "bench/experiments/operations/measure_cycles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "bench/lab/records/csv.hpp"
#include "this_build.hpp"

namespace operations {
namespace {

using testing::HasSubstr;

// The message for each subject that misbehaves, always for the operand 256; the others are
// measured.
struct Fault {
    const char* subject;
    const char* what;
};
constexpr Fault faults[] = {
    {"hangs", "not done after 1000000 cycles"},
    {"clobbers", "call-saved register r16 is changed"},
    {"frames", "call-saved register r29 is changed"},
    {"multiplies", "r1 is not zero"},
    {"strays", "wrote to 0x0234"},
    {"pushes", "the stack pointer is not balanced"},
    {"jumps", "jump out of the program"},
    {"interrupts", "interrupts are on"},
    {"overflows", "beyond the RAM"},
    {"recurses", "the stack ran into the data"},
    {"sleeps", "sleep"},
    {"unaware", ""},
};

TEST(MeasureCycles, ABadSubjectIsNamedWithItsOperandsAndLeavesTheOthersMeasured) {
    CycleOptions options;
    options.programs = {build_folder() / "bench/experiments/operations/misbehaving.elf"};
    options.output = testing::TempDir() + "measure_cycles_test";
    options.selection.operands = {"boundary"};
    options.threads = 2;
    testing::internal::CaptureStderr();
    const std::uint64_t violations = measure_cycles(options);
    const std::string messages = "\n" + testing::internal::GetCapturedStderr();
    EXPECT_EQ(violations, std::size(faults) + 1) << messages;

    for (const Fault& fault : faults) {
        const std::string subject = std::string("negate_q8_8_") + fault.subject;
        const std::size_t begin = messages.find("\n" + subject + ": boundary operands: ") + 1;
        ASSERT_NE(begin, 0u) << subject << " is not in\n" << messages;
        const std::string line = messages.substr(begin, messages.find('\n', begin) - begin);
        EXPECT_THAT(line, HasSubstr(fault.what));
        EXPECT_THAT(line, testing::EndsWith(", with the operands 256"));
        EXPECT_EQ(messages.find(subject, begin + line.size()), messages.npos) << messages;
    }
    EXPECT_THAT(messages,
                HasSubstr(" boundary operands contradict the definition, the first: 256\n"));

    const records::Table table = records::Table::load(options.output / "operations.csv");
    std::map<std::string, std::vector<std::string>> rows;
    for (const auto& row : table.rows()) rows[row[table.column("implementation")]] = row;
    ASSERT_EQ(rows.size(), 3u);
    for (const auto& [name, violated] :
         {std::pair("before", "0"), std::pair("default", "1"), std::pair("zafter", "0")}) {
        ASSERT_TRUE(rows.contains(name)) << name;
        EXPECT_EQ(rows[name][table.column("samples")], rows["before"][table.column("samples")]);
        EXPECT_EQ(rows[name][table.column("violations")], violated);
    }
    // call 4, three instructions of one cycle each, ret 4
    EXPECT_EQ(rows["zafter"][table.column("cycles_min")], "11");
    EXPECT_EQ(rows["zafter"][table.column("cycles_max")], "11");
}

}  // namespace
}  // namespace operations
