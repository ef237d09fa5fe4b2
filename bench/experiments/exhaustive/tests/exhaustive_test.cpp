// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/exhaustive/exhaustive.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "bench/chip/instructions/tests/programs.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace machine_code {
namespace {

namespace fs = std::filesystem;

class ExhaustiveTest : public testing::Test {
  protected:
    ExhaustiveTest()
        : folder_(fs::temp_directory_path() / fmt::format("exhaustive_test.{}", getpid())) {
        options_.program = instructions::test_program("functions");
        options_.output = folder_;
        options_.threads = 2;
    }
    ~ExhaustiveTest() override { fs::remove_all(folder_); }

    std::string csv() const {
        std::ifstream stream(folder_ / "exhaustive.csv");
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    // The cell of the only row, or of the row of an implementation.
    std::string cell(const char* column, const char* implementation = "default") const {
        const records::Table table = records::Table::load(folder_ / "exhaustive.csv");
        for (const auto& row : table.rows())
            if (row[table.column("implementation")] == implementation)
                return row[table.column(column)];
        return "no such row";
    }

    fs::path folder_;
    Options options_;
};

TEST_F(ExhaustiveTest, KnownAnswersOfAHandMadeProduct) {
    options_.symbols = {"multiply_q4_4_default"};
    EXPECT_EQ(run_exhaustive(options_), 0u);
    EXPECT_EQ(cell("inputs"), "65536");
    EXPECT_EQ(cell("max_ulp"), "0.5");
    EXPECT_EQ(cell("cycles_min"), "12");
    EXPECT_EQ(cell("cycles_max"), "26");
    EXPECT_EQ(cell("cycles_max_witness"), "0 1");
    EXPECT_EQ(cell("cycles_mean"), "25.9453");  // 26 - 14 / 256
    EXPECT_EQ(cell("unreached_instructions"), "2");
    EXPECT_EQ(cell("violations"), "0");
    EXPECT_EQ(cell("portable_differences"), "0");
    EXPECT_EQ(cell("operands"), "all");
}

TEST_F(ExhaustiveTest, ViolationsAreCounted) {
    options_.symbols = {"multiply_q4_4_unrounded"};
    // Every product whose fraction is a half or more: counted here by the same formula.
    std::uint64_t wrong = 0;
    for (int a = -128; a < 128; ++a)
        for (int b = -128; b < 128; ++b) wrong += (a * b & 15) >= 8;
    EXPECT_EQ(run_exhaustive(options_), wrong);
    EXPECT_EQ(cell("violations", "unrounded"), fmt::to_string(wrong));
    EXPECT_EQ(cell("max_ulp", "unrounded"), "0.9375");
    EXPECT_EQ(cell("portable_differences", "unrounded"), "");
    // Rows of other functions are kept.
    options_.symbols = {"multiply_q4_4_default"};
    run_exhaustive(options_);
    EXPECT_EQ(cell("violations", "unrounded"), fmt::to_string(wrong));
    EXPECT_EQ(cell("violations"), "0");
}

TEST_F(ExhaustiveTest, LargerSpacesAreSearched) {
    options_.symbols = {"add_q32_32_default"};
    options_.search_operands = 100000;
    EXPECT_EQ(run_exhaustive(options_), 0u);
    EXPECT_GT(std::stoull(cell("inputs")), 90000u);
    EXPECT_EQ(cell("operands"), "search");
    EXPECT_EQ(cell("max_ulp"), "0");
    EXPECT_EQ(cell("rms_ulp"), "");
    EXPECT_EQ(cell("cycles_min"), "19");
    EXPECT_EQ(cell("cycles_max"), "21");
    EXPECT_EQ(cell("unreached_instructions"), "0");
    const std::string first = csv();
    options_.threads = 1;
    run_exhaustive(options_);
    EXPECT_EQ(csv(), first);
}

TEST_F(ExhaustiveTest, ShardsMergeToWhatOneRunGives) {
    options_.symbols = {"multiply_q4_4_default", "multiply_q4_4_unrounded"};
    options_.threads = 1;
    run_exhaustive(options_);
    const std::string whole = csv();
    fs::remove(folder_ / "exhaustive.csv");

    std::vector<fs::path> shards;
    for (const unsigned index : {3u, 1u, 2u}) {
        options_.shard = {index, 3};
        options_.threads = index;
        run_exhaustive(options_);
        for (const std::string& symbol : options_.symbols)
            shards.push_back(folder_ / fmt::format("exhaustive.{}.{}-of-3.json", symbol, index));
    }
    EXPECT_FALSE(fs::exists(folder_ / "exhaustive.csv"));
    EXPECT_GT(merge_exhaustive(shards, folder_), 0u);
    EXPECT_EQ(csv(), whole);

    EXPECT_THROW(merge_exhaustive({shards.begin(), shards.begin() + 4}, folder_),
                 std::runtime_error);
    EXPECT_THROW(merge_exhaustive({shards[0], shards[0]}, folder_), std::runtime_error);
    records::write_whole(folder_ / "none.json", "{}");
    EXPECT_THROW(merge_exhaustive({folder_ / "none.json"}, folder_), std::runtime_error);
}

TEST_F(ExhaustiveTest, ShardsOfSearchesOfDifferentLengthsAreRefused) {
    options_.symbols = {"add_q32_32_default"};
    std::vector<fs::path> shards;
    for (const unsigned index : {1u, 2u}) {
        options_.shard = {index, 2};
        options_.search_operands = 10000 * index;
        run_exhaustive(options_);
        shards.push_back(folder_ /
                         fmt::format("exhaustive.add_q32_32_default.{}-of-2.json", index));
    }
    try {
        merge_exhaustive(shards, folder_);
        ADD_FAILURE() << "nothing was refused";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "add_q32_32_default: the shards are of searches of 10000 and of 20000 operands");
    }
    EXPECT_FALSE(fs::exists(folder_ / "exhaustive.csv"));
}

TEST_F(ExhaustiveTest, PartsThatDoNotExistAreRefused) {
    options_.symbols = {"multiply_q4_4_default"};
    options_.shard = {1, 256};
    run_exhaustive(options_);
    const fs::path path = folder_ / "exhaustive.multiply_q4_4_default.1-of-256.json";
    std::ifstream stream(path);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    const std::string key = "\"parts\":{\"0\"";
    const std::size_t place = text.find(key);
    ASSERT_NE(place, text.npos);
    for (const char* other : {"256", "-1", "0x", ""}) {
        std::string damaged = text;
        damaged.replace(place, key.size(), fmt::format("\"parts\":{{\"{}\"", other));
        records::write_whole(path, damaged);
        EXPECT_THROW(merge_exhaustive({path}, folder_), std::runtime_error) << other;
    }
}

std::string content(const fs::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// A child process is killed during a run of two functions, whatever it is doing. The next run
// continues from the checkpoint and writes what an undisturbed one does.
TEST_F(ExhaustiveTest, AKilledRunContinues) {
    options_.symbols = {"multiply_q4_4_default", "add_q32_32_default"};
    options_.search_operands = 3'000'000;
    run_exhaustive(options_);
    const std::string whole = csv();
    fs::remove_all(folder_);

    const fs::path checkpoint = folder_ / "exhaustive.add_q32_32_default.1-of-1.checkpoint.json";
    int resumed_parts = 0;
    bool interrupted = false;
    for (const int signal : {SIGKILL, SIGINT}) {
        const std::string before = content(checkpoint);
        const pid_t child = fork();
        if (child == 0) {
            run_exhaustive(options_);
            _exit(0);
        }
        int status = 0;
        while (waitpid(child, &status, WNOHANG) == 0) {
            if (fs::exists(checkpoint) && content(checkpoint) != before) kill(child, signal);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        interrupted = WIFSIGNALED(status);
        resumed_parts += interrupted;
    }
    EXPECT_GT(resumed_parts, 0) << "the run was over before its first checkpoint";
    EXPECT_EQ(fs::exists(checkpoint), interrupted);
    run_exhaustive(options_);
    EXPECT_EQ(csv(), whole);
    for (const auto& file : fs::directory_iterator(folder_))
        EXPECT_EQ(file.path().string().find("checkpoint"), std::string::npos) << file.path();
}

// Checkpoints of another program or with other parameters do not count.
TEST_F(ExhaustiveTest, CheckpointsOfOtherRunsAreNotUsed) {
    options_.symbols = {"multiply_q4_4_default"};
    run_exhaustive(options_);
    const std::string whole = csv();
    const fs::path checkpoint = folder_ / "exhaustive.multiply_q4_4_default.1-of-1.checkpoint.json";
    for (const char* text : {"", "{}", "[1, 2]", "{\"judge\": 1, \"measurement\": {}}"}) {
        records::write_whole(checkpoint, text);
        run_exhaustive(options_);
        EXPECT_EQ(csv(), whole);
    }
}

TEST_F(ExhaustiveTest, RejectsSubjectsThatCannotBeJudged) {
    options_.symbols = {"skips"};
    EXPECT_THROW(run_exhaustive(options_), std::invalid_argument);
    EXPECT_THROW(parse_shard("0/3"), std::invalid_argument);
    EXPECT_THROW(parse_shard("4/3"), std::invalid_argument);
    EXPECT_THROW(parse_shard("1"), std::invalid_argument);
    EXPECT_THROW(parse_shard("1/300"), std::invalid_argument);
    EXPECT_EQ(parse_shard("2/3").index, 2u);
}

}  // namespace
}  // namespace machine_code
