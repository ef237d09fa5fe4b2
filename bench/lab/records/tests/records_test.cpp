// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "bench/lab/records/benchmark_json.hpp"
#include "bench/lab/records/csv.hpp"
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

struct Reading {
    std::string name;
    int count;
    double mean;
    std::optional<double> error;
    double grams;
    bool held;

    static constexpr auto columns = std::tuple(records::column("name", &Reading::name),
                                               records::column("count", &Reading::count),
                                               records::column("mean", &Reading::mean),
                                               records::column("error", &Reading::error, "{:.3f}"),
                                               records::column("grams", &Reading::grams, "{:.2f}"),
                                               records::column("held", &Reading::held));
};

TEST(Record, ColumnsFollowFromTheStruct) {
    const std::vector<Reading> readings = {{"a, b", 3, 1.0 / 3, 0.25, 0.125, true},
                                           {"c", -1, 2, {}, 1e6, false}};
    EXPECT_EQ(records::table_of(readings).to_csv(),
              "name,count,mean,error,grams,held\n\"a, b\",3,0.333333,0.250,0.12,yes\n"
              "c,-1,2,,1000000.00,no\n");
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

TEST(Table, RefusesWhatIsMalformed) {
    EXPECT_THROW(records::Table({"a", "b"}).add({"1"}), std::logic_error);
    EXPECT_THROW(records::Table({"a"}).column("b"), std::runtime_error);
    EXPECT_THROW(records::Table::load(scratch("absent.csv")), std::runtime_error);
    records::write_whole(scratch("short.csv"), "a,b\n1\n");
    EXPECT_THROW(records::Table::load(scratch("short.csv")), std::runtime_error);
    records::write_whole(scratch("open.csv"), "a,b\n1,\"2\n");
    EXPECT_THROW(records::Table::load(scratch("open.csv")), std::runtime_error);
}

TEST(WholeFile, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
    const auto folder = scratch("folder.csv");
    std::filesystem::create_directories(folder / "occupied");
    EXPECT_THROW(records::write_whole(folder, "text"), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_directory(folder));
    for (const auto& entry : std::filesystem::directory_iterator(folder.parent_path())) {
        EXPECT_EQ(entry.path().string().find("folder.csv.partial"), std::string::npos);
    }
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
