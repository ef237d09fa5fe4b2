// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "bench/lab/records/benchmark_json.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace {

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::path(testing::TempDir()) / ("records_test_" + name);
}

TEST(Cell, PrintsWhatAReaderExpects) {
    EXPECT_EQ(records::cell(84), "84");
    EXPECT_EQ(records::cell(-1e9), "-1000000000");
    EXPECT_EQ(records::cell(0.5), "0.5");
    EXPECT_EQ(records::cell(1.0 / 3), "0.333333");
    EXPECT_EQ(records::cell(std::nan("")), "");
}

TEST(Progress, TellsTheTimeLeftOnceAShareIsDone) {
    EXPECT_EQ(records::Progress::time_left(30, 0.25), "1:30");
    EXPECT_EQ(records::Progress::time_left(5, 1), "0:00");
    // A minute of preparation before the first of 10^7 steps says nothing about the others.
    EXPECT_EQ(records::Progress::time_left(60, 1e-7), "?");
    EXPECT_EQ(records::Progress::time_left(10, 0), "?");
}

struct Named {
    std::string name;
    static constexpr auto columns = std::tuple(records::column("name", &Named::name));
};
struct Reading : Named {
    int count;
    double mean;
    std::optional<double> error;
    double grams;
    bool held;
    std::vector<double> parts;

    static std::vector<std::string> names_of_parts() { return {"low", "high"}; }
    static constexpr auto columns = std::tuple_cat(
        Named::columns,
        std::tuple(records::column("count", &Reading::count),
                   records::column("mean", &Reading::mean),
                   records::column("error", &Reading::error, "{:.3f}"),
                   records::column("grams", &Reading::grams, "{:.2f}"),
                   records::column("held", &Reading::held),
                   records::columns_of(&Reading::names_of_parts, &Reading::parts, "{:.1f}")));
};
constexpr const char* readings_file =
    "name,count,mean,error,grams,held,low,high\n\"a, b\",3,0.333333,0.250,0.12,yes,0.5,-1.0\n"
    "c,-1,,,1000000.00,no,0.0,2.0\n";

TEST(Record, ColumnsFollowFromTheStruct) {
    const std::vector<Reading> readings = {{{"a, b"}, 3, 1.0 / 3, 0.25, 0.125, true, {0.5, -1}},
                                           {{"c"}, -1, std::nan(""), {}, 1e6, false, {0, 2}}};
    EXPECT_EQ(records::table_of(readings).to_csv(), readings_file);
}

TEST(Record, TellsWhatItsColumnsHold) {
    const records::Header expected = {
        {"name", "text"},    {"count", "number"}, {"mean", "number"}, {"error", "optional"},
        {"grams", "number"}, {"held", "text"},    {"low", "number"},  {"high", "number"}};
    EXPECT_EQ(records::header_of<Reading>(), expected);
    EXPECT_STREQ(records::holds<records::Digits>, "number");
    EXPECT_STREQ(records::holds<std::optional<std::string>>, "text");
    EXPECT_STREQ(records::holds<std::optional<bool>>, "text");
    // Known from the start, since this program makes tables of it, and not of the other.
    const auto& known = records::headers();
    EXPECT_EQ(std::count(known.begin(), known.end(), &records::header_of<Reading>), 1);
    EXPECT_EQ(std::count(known.begin(), known.end(), &records::header_of<Named>), 0);
}

TEST(Record, IsReadAsItWasWritten) {
    const records::Table table = records::Table::parse(readings_file, "readings");
    EXPECT_EQ(records::table_of(records::rows_of<Reading>(table)).to_csv(), readings_file);
    EXPECT_EQ(records::rows_of<Named>(table).at(1).name, "c");  // some of the columns
}

TEST(Record, RefusesACellOfTheWrongType) {
    const auto refusal = [](const char* cells) -> std::string {
        const std::string text = std::string("name,count,mean,error,grams,held,low,high\n") + cells;
        try {
            records::rows_of<Reading>(records::Table::parse(text, "readings"));
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("a,1,2,3,4,yes,5,6"), "");
    EXPECT_EQ(refusal("a,1.5,2,3,4,yes,5,6"), "readings:2: '1.5' is not a value of column 'count'");
    EXPECT_EQ(refusal("a,,2,3,4,yes,5,6"), "readings:2: '' is not a value of column 'count'");
    EXPECT_EQ(refusal("a,1,2 m,3,4,yes,5,6"), "readings:2: '2 m' is not a value of column 'mean'");
    EXPECT_EQ(refusal("a,1,2,none,4,yes,5,6"),
              "readings:2: 'none' is not a value of column 'error'");
    EXPECT_EQ(refusal("a,1,2,3,4,true,5,6"), "readings:2: 'true' is not a value of column 'held'");
    EXPECT_EQ(refusal("a,1,2,3,4,yes,5,six"), "readings:2: 'six' is not a value of column 'high'");
    EXPECT_THROW(records::rows_of<Reading>(records::Table({"name"})), std::runtime_error);
}

TEST(Table, SurvivesQuotesCommasAndLineBreaks) {
    records::Table table({"name", "reason"});
    table.add({"plain", "a, \"quoted\" word\nand a second line"});
    table.add({"", "x"});
    const auto path = scratch("quotes.csv");
    table.save(path);
    const records::Table loaded = records::Table::load(path);
    EXPECT_EQ(loaded.columns(), table.columns());
    EXPECT_EQ(loaded.rows(), table.rows());
}

TEST(Table, RefusesMalformedText) {
    EXPECT_THROW(records::Table({"a", "b"}).add({"1"}), std::logic_error);
    EXPECT_THROW(records::Table({"a"}).column("b"), std::runtime_error);
    EXPECT_THROW(records::Table::load(scratch("absent.csv")), std::runtime_error);
    records::write_whole(scratch("short.csv"), "a,b\n1\n");
    EXPECT_THROW(records::Table::load(scratch("short.csv")), std::runtime_error);
    records::write_whole(scratch("open.csv"), "a,b\n1,\"2\n");
    EXPECT_THROW(records::Table::load(scratch("open.csv")), std::runtime_error);
}

TEST(WholeFile, LeavesTheOldFileIfTheNewOneCannotBeWritten) {
    const auto folder = scratch("folder.csv");
    std::filesystem::create_directories(folder / "occupied");
    EXPECT_THROW(records::write_whole(folder, "text"), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_directory(folder));
    for (const auto& entry : std::filesystem::directory_iterator(folder.parent_path())) {
        EXPECT_EQ(entry.path().string().find("folder.csv.partial"), std::string::npos);
    }
}

TEST(WholeFile, ThreadsMayWriteTheSameOne) {
    const auto path = scratch("shared.txt");
    std::atomic<int> failures = 0;
    std::vector<std::thread> threads;
    for (const char letter : {'a', 'b', 'c', 'd'})
        threads.emplace_back([&, letter] {
            for (int i = 0; i < 100; ++i) {
                try {
                    records::write_whole(path, std::string(100'000, letter));
                } catch (const std::runtime_error&) {
                    ++failures;
                }
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    std::ifstream stream(path);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_EQ(text, std::string(100'000, text.front()));
}

TEST(BenchmarkJson, TimesAreCyclesAt16MHz) {
    const auto document = records::benchmark_document(
        {{"multiply_q16_16_default/physics", 1000, 84, {{"max", 84}}}}, {});
    const auto& entry = document["benchmarks"][0];
    EXPECT_DOUBLE_EQ(entry["real_time"], 84 * 62.5);
    EXPECT_EQ(entry["time_unit"], "ns");
    EXPECT_EQ(entry["max"], 84);
}

}  // namespace
