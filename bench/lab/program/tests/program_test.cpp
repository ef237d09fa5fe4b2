// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line is built on: names, output, cores that processes share, times, comparison.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "bench/lab/parallel.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/program/output.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "bench/sequence/comparison.hpp"
#include "bench/sequence/times.hpp"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

fs::path fresh(const std::string& name) {
    const fs::path folder = fs::path(testing::TempDir()) / "program_test" / name;
    fs::remove_all(folder);
    return folder;
}

template <class Call>
std::string refusal(Call call) {
    try {
        call();
    } catch (const std::exception& error) {
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        return error.what();
    }
    return "accepted";
}

TEST(Names, UnknownNamesAreRefusedWithThoseThatExist) {
    const std::vector<std::string> known = {"q8_8", "q16_16", "float", "q8_8"};
    EXPECT_EQ(refusal([&] {
                  fixbench::check_names("--format", {"q16_16", "float"}, known);
              }),
              "accepted");
    const std::string half_wrong = refusal([&] {
        fixbench::check_names("--format", {"q8_8", "q16_61"}, known);
    });
    EXPECT_EQ(half_wrong,
              "--format 'q16_61' does not exist (did you mean q16_16?); allowed are float, q16_16, "
              "q8_8");
    EXPECT_THAT(refusal([&] { fixbench::check_names("--format", {"zzzzzzzz"}, known); }),
                Not(HasSubstr("did you mean")));
    EXPECT_THAT(refusal([&] { fixbench::check_names("--format", {""}, known); }),
                HasSubstr("allowed are"));
}

int writes_table(const fs::path& folder) {
    records::write_whole(folder / "table.csv", "name,value\na,1\n");
    return 0;
}

TEST(Output, ASelectionDoesNotReplaceAFile) {
    fixbench::Output output;
    output.folder = fresh("selection");
    output.prints = {"table.csv"};
    EXPECT_EQ(output.collect(writes_table), 0);
    output.is_selection = true;
    bool measured = false;
    const std::string reason = refusal([&] {
        output.collect([&](const fs::path&) {
            measured = true;
            return 0;
        });
    });
    EXPECT_THAT(reason, HasSubstr("table.csv already exists"));
    EXPECT_FALSE(measured);
    output.is_selection = false;
    EXPECT_EQ(output.collect(writes_table), 0);
}

TEST(Output, AFolderThatIsNotWritableIsReportedBeforeTheMeasurement) {
    const fs::path file = fresh("file");
    records::write_whole(file, "");
    fixbench::Output output;
    output.folder = file / "below";
    output.prints = {"table.csv"};
    bool measured = false;
    EXPECT_THAT(refusal([&] {
                    output.collect([&](const fs::path&) {
                        measured = true;
                        return 0;
                    });
                }),
                HasSubstr("cannot write"));
    EXPECT_FALSE(measured);
}

TEST(Output, WithoutAFolderTheTableIsPrintedAndNothingStays) {
    fixbench::Output output;
    output.prints = {"other.csv", "table.csv"};
    fs::path used;
    const auto measure = [&](const fs::path& folder) {
        used = folder;
        records::write_whole(folder / "table.csv", "name,value,none\na,1,\nlonger,22,\n");
        return 1;
    };
    testing::internal::CaptureStdout();
    EXPECT_EQ(output.collect(measure), 1);
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "name    value\na           1\nlonger     22\n");
    EXPECT_FALSE(fs::exists(used));
    output.json = true;
    testing::internal::CaptureStdout();
    output.collect(measure);
    EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("\"value\": 22"));
    output.json = false;
    output.csv = true;
    testing::internal::CaptureStdout();
    output.collect(measure);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "name,value,none\na,1,\nlonger,22,\n");
}

TEST(Times, SurviveTheProgramAndADamagedFile) {
    const fs::path file = fresh("times") / "times.json";
    sequence::Times(file).set("scenes", false, {12.5, 7});
    const sequence::Times loaded(file);
    ASSERT_TRUE(loaded.of("scenes", false));
    EXPECT_EQ(loaded.of("scenes", false)->cpu, 12.5);
    EXPECT_FALSE(loaded.of("scenes", true));
    for (const char* text : {"", "{", "[]", R"({"full/scenes": 3})", R"({"full/scenes": {}})"}) {
        records::write_whole(file, text);
        EXPECT_FALSE(sequence::Times(file).of("scenes", false)) << text;
    }
}

TEST(Comparison, NamesTheFirstLineThatDiffers) {
    const fs::path folder = fresh("comparison");
    const fs::path a = folder / "a" / "t.csv", b = folder / "b" / "t.csv";
    records::write_whole(a, "x\n1\n2\n");
    records::write_whole(b, "x\n1\n2\n");
    EXPECT_EQ(sequence::first_difference(a, b), "");
    records::write_whole(b, "x\n1\n3\n4\n");
    EXPECT_THAT(
        sequence::first_difference(a, b),
        testing::AllOf(HasSubstr("t.csv:3"), HasSubstr("committed 2"), HasSubstr("measured  3")));
    records::write_whole(b, "x\n1\n2");
    EXPECT_THAT(sequence::first_difference(a, b), HasSubstr("t.csv:4"));
    fs::remove(b);
    EXPECT_THAT(sequence::first_difference(a, b), HasSubstr("missing"));
}

// A process that shares the cores works on its own core and on those that it gets. It gives these
// back, and no task is lost or done twice.
TEST(Pool, BoundsTheThreadsOfAProcess) {
    lab::Pool pool(1);
    setenv(lab::Pool::variable,
           (std::to_string(pool.read_end()) + "," + std::to_string(pool.write_end())).c_str(), 1);
    ASSERT_NE(lab::Pool::shared(), nullptr);
    std::atomic<int> running = 0, most = 0;
    std::vector<std::atomic<int>> done(40);
    operations::in_parallel(6, done.size(), [&](std::size_t k) {
        const int now = ++running;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ++done[k];
        --running;
    });
    EXPECT_EQ(most, 2);
    for (const auto& count : done) EXPECT_EQ(count, 1);
    EXPECT_TRUE(pool.try_take());
    EXPECT_FALSE(pool.try_take());
    EXPECT_THROW(operations::in_parallel(3, 9, [](std::size_t) { throw std::runtime_error("no"); }),
                 std::runtime_error);
    pool.refill(3);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(pool.try_take());
    EXPECT_FALSE(pool.try_take());
}

}  // namespace
