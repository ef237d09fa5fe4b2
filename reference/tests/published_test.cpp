// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/published.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace reference {
namespace {

using testing::HasSubstr;

TEST(Published, FilesLoad) {
    const auto table = load_table_3_2();
    ASSERT_EQ(table.size(), 24u);
    EXPECT_EQ(table[19].type, "fixed_16_16");
    EXPECT_EQ(table[19].operation, "divide");
    EXPECT_NEAR(table[19].cycles_per_operation(), 1922.67, 0.01);
    ASSERT_EQ(load_functions().size(), 4u);
    EXPECT_EQ(load_functions()[3].type, "int64_t");
    EXPECT_EQ(load_functions()[3].operation, "shift_left_16");
    EXPECT_EQ(load_workload().size(), 15u);
    EXPECT_EQ(load_workload()[0].where, "single step of the lever scene (two objects and one rod)");
    EXPECT_EQ(load_table_d_1().size(), 17u);
    EXPECT_EQ(load_table_d_1()[3].calculated_grams, 169.5);
    EXPECT_EQ(load_table_d_2().size(), 26u);
    EXPECT_EQ(load_table_d_2()[25].acceleration, 30);
}

class Malformed : public testing::Test {
  protected:
    std::string reason(const std::string& content) const {
        const auto folder =
            std::filesystem::path(testing::TempDir()) / "malformed_published_figures";
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "table_d_2.csv") << content;
        try {
            load_table_d_2(folder);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no error";
    }
    const std::string header = "acceleration_m_s2,correction_n_per_m_s2\n";
};

TEST_F(Malformed, SaysFileLineAndReason) {
    EXPECT_THAT(reason(header + "5,0.1\n6,zero\n"),
                HasSubstr("table_d_2.csv:3: 'zero' is not a number"));
    EXPECT_THAT(reason(header + "5,0.1x\n"), HasSubstr(":2: '0.1x' is not a number"));
    EXPECT_THAT(reason(header + "5,\n"), HasSubstr(":2: '' is not a number"));
    EXPECT_THAT(reason(header + "5,nan\n"), HasSubstr(":2: 'nan' is not a number"));
    EXPECT_THAT(reason(header + "5,0.1,7\n"), HasSubstr(":2: 3 fields, expected 2"));
    EXPECT_THAT(reason("a,b\n5,0.1\n"), HasSubstr(":1: the header is 'a,b', expected"));
    EXPECT_THAT(reason(header), HasSubstr("holds no rows"));
    EXPECT_EQ(reason(header + "5,0.1\r\n"), "no error");
}

TEST(Published, AMissingFileIsNamed) {
    try {
        load_workload("/nowhere");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/workload.csv: cannot be read"));
    }
}

}  // namespace
}  // namespace reference
