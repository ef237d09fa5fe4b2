// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of the ablations is numbers: the committed file read as records, and written
// again byte for byte.
#include "bench/experiments/stability/ablations.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "bench/lab/program/scratch.hpp"
#include "this_build.hpp"

namespace stability {
namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Ablations, AreNumbersAndSurviveReadingAndWriting) {
    const std::filesystem::path committed = source_folder() / "results/data/ablations.csv";
    const auto rows = records::rows_of<AblationRow>(records::Table::load(committed));
    ASSERT_FALSE(rows.empty());
    for (const AblationRow& row : rows) {
        ASSERT_TRUE(row.before && row.after && row.before_error && row.after_error) << row.of_case;
        EXPECT_GT(*row.before, 0) << row.of_case;
        EXPECT_GT(*row.before_error, 1) << row.of_case;  // it does not withstand that parameter
    }
    const fixbench::Scratch scratch;
    const std::filesystem::path again = scratch.folder() / "ablations.csv";
    records::table_of(rows).save(again);
    EXPECT_EQ(text_of(again), text_of(committed));
}

TEST(Ablations, HaveAnEmptyCellForANumberThatThereIsNot) {
    const fixbench::Scratch scratch;
    const std::filesystem::path file = scratch.folder() / "ablations.csv";
    records::table_of(std::vector<AblationRow>(1)).save(file);
    const auto read = [&] { return records::rows_of<AblationRow>(records::Table::load(file)); };
    EXPECT_FALSE(read().at(0).before);
    EXPECT_FALSE(read().at(0).after_error);
    // A word in its place is refused.
    std::string text = text_of(file);
    text.replace(text.find(",,,,,,,,,", text.find('\n')) + 5, 1, ",none");
    std::ofstream(file) << text;
    try {
        read();
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_TRUE(std::string(error.what())
                        .ends_with(":2: 'none' is not a value of column "
                                   "'before'"))
            << error.what();
    }
}

}  // namespace
}  // namespace stability
