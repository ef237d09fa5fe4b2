// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/compare/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace compare {
namespace {

const std::string header =
    "operation,format,implementation,operands,samples,cycles_mean,cycles_max,max_ulp,rms_ulp,"
    "flash_bytes,ram_bytes,stack_bytes,violations,rms_error\n";

records::Table table(const std::string& rows) {
    return records::Table::parse(header + rows, "operations.csv");
}

std::string text_of(const std::vector<Change>& changes) {
    std::string text;
    for (const Change& each : changes)
        text += each.operation + " " + each.quantity + " " + each.verdict + "; ";
    return text;
}

TEST(Compare, ReportsWhatBecameBetterAndWorse) {
    const records::Table before = table(
        "sqrt,q16_16,default,full,10,100,120,0.5,0.3,50,0,2,0,1e-6\n"
        "sin,q16_16,default,full,10,100,120,0.5,0.3,50,0,2,0,1e-6\n"
        "cos,q16_16,default,full,10,100,120,0.5,0.3,50,0,2,0,1e-6\n");
    const records::Table after = table(
        "sqrt,q16_16,default,full,10,99.5,121,0.5,0.3,50,0,2,0,1e-6\n"
        "cos,q16_16,default,full,20,300,300,0.9,0.9,51,0,2,0,1e-6\n"
        "exp,q16_16,default,full,10,100,120,0.5,,50,0,2,0,1e-6\n");
    EXPECT_EQ(text_of(changes(before, after)),
              "sqrt cycles_mean better; sqrt cycles_max worse; cos flash_bytes worse; exp subject "
              "new; sin subject gone; ");
    EXPECT_EQ(text_of(changes(before, before)), "");
}

TEST(Compare, TheScoreIsTheGeometricMeanOfItsParts) {
    const records::Table run = table(
        "multiply,q16_16,default,physics,10,100,0,0,0,50,0,2,0,1e-6\n"
        "divide,q16_16,default,physics,10,100,0,0,0,50,0,2,0,4e-6\n"
        "multiply,float,libc,physics,10,200,0,0,0,100,0,2,0,1e-6\n"
        "divide,float,libc,physics,10,800,0,0,0,25,0,2,0,1e-6\n");
    const std::vector<Change> rows = score(run, run);
    ASSERT_EQ(rows.size(), 3u * 2 + 3 + 1);
    EXPECT_DOUBLE_EQ(*rows[6].after, 4);    // cycles: 2 and 8
    EXPECT_DOUBLE_EQ(*rows[7].after, 1);    // flash: 2 and 1/2
    EXPECT_DOUBLE_EQ(*rows[8].after, 0.5);  // error: 1 and 1/4
    EXPECT_DOUBLE_EQ(*rows[9].after, std::cbrt(4 * 1 * 0.5));
    EXPECT_EQ(rows[9].verdict, "");
}

TEST(Compare, WithoutFloatThereIsNoScore) {
    const records::Table run = table("sqrt,q16_16,default,physics,10,1,1,0,0,5,0,2,0,1e-6\n");
    EXPECT_FALSE(score(run, run).back().after);
}

TEST(Compare, RefusesWhatIsNotARun) {
    const std::filesystem::path here = testing::TempDir();
    EXPECT_THROW(operations_of((here / "absent").string(), here), std::invalid_argument);
    EXPECT_THROW(operations_of("--help", here), std::invalid_argument);
    std::filesystem::create_directories(here / "empty_run");
    EXPECT_THROW(operations_of((here / "empty_run").string(), here), std::invalid_argument);
    const records::Table bad = table("sqrt,q16_16,default,full,x,1,1,0,0,5,0,2,0,1e-6\n");
    EXPECT_THROW(changes(bad, bad), std::invalid_argument);
}

}  // namespace
}  // namespace compare
