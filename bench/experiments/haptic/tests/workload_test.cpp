// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/workload.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bench/lab/records/csv.hpp"
#include "this_build.hpp"

namespace haptic {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::filesystem::path& file) {
    const records::Table table = records::Table::load(file);
    std::vector<Row> rows;
    for (const auto& cells : table.rows()) {
        Row row;
        for (std::size_t i = 0; i < cells.size(); ++i) row[table.columns()[i]] = cells[i];
        rows.push_back(row);
    }
    return rows;
}

class Workload : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        Options options;
        options.firmware = build_folder() / "firmware";
        options.output = testing::TempDir() + "haptic_workload_test";
        write_workload(options);
        workload_ = rows_of(options.output / "workload_firmware.csv");
        pins_ = rows_of(options.output / "haptic_pins.csv");
    }
    static double measured(const std::string& quantity, const std::string& arithmetic) {
        for (const Row& row : workload_)
            if (row.at("quantity") == quantity && row.at("arithmetic") == arithmetic)
                return std::stod(row.at("measured"));
        ADD_FAILURE() << "no " << quantity << " of " << arithmetic;
        return 0;
    }

    static inline std::vector<Row> workload_, pins_;
};

// A ratio within 10% is reproduced; every other one has a reason.
TEST_F(Workload, JudgesEachPublishedFigureOfTheDevice) {
    std::set<std::string> judged;
    for (const Row& row : workload_) {
        if (row.at("published").empty()) {
            EXPECT_EQ(row.at("verdict"), "measured");
            continue;
        }
        judged.insert(row.at("quantity"));
        const double ratio = std::stod(row.at("measured")) / std::stod(row.at("published"));
        EXPECT_NEAR(std::stod(row.at("ratio")), ratio, 1e-4);
        EXPECT_EQ(row.at("verdict") == "reproduced", ratio >= 0.9 && ratio <= 1.1)
            << row.at("quantity");
        EXPECT_FALSE(row.at("reason").empty());
        EXPECT_EQ(row.at("elf_sha256").size(), 64u);
    }
    EXPECT_EQ(judged, (std::set<std::string>{"render_frame", "render_rate", "flash", "static_ram",
                                             "physics_step", "contact_resolution",
                                             "square_roots_share", "fall_time"}));
}

TEST_F(Workload, ReportsWhatTheSketchCosts) {
    EXPECT_NEAR(measured("loop_rate", "q16_16_arduino"), measured("loop_rate", "q16_16"), 1);
    EXPECT_GT(measured("flash_bytes", "q16_16_arduino"), measured("flash_bytes", "q16_16"));
    EXPECT_GT(measured("static_ram_bytes", "q16_16_arduino"),
              measured("static_ram_bytes", "q16_16"));
    EXPECT_LT(measured("worst_lateness", "q16_16_arduino"), 1);
}

TEST_F(Workload, SharesOfAStepAreParts) {
    for (const char* device : {"fixed_16_16", "q16_16"}) {
        const double found = measured("contact_finding_share", device),
                     resolved = measured("contact_resolution_share", device);
        EXPECT_LT(found + resolved, 100) << device;
        EXPECT_GT(found, measured("square_roots_share", device)) << "the root is in the finding";
        EXPECT_NEAR(resolved / 100 * measured("physics_step", device),
                    measured("contact_resolution", device), 1e-3);
        EXPECT_LT(measured("operations_share", device), 100);
    }
}

// Between two steps there is at most the rest of a period, or the drawing of a frame.
TEST_F(Workload, ThePinsShowEveryStep) {
    for (const char* device : {"published", "q16_16"}) {
        const double pause =
            1e3 / measured("loop_rate", device) + measured("render_frame_sent", device);
        double longest = 0, end = 0;  // ms
        for (const Row& row : pins_) {
            if (row.at("device") != device || row.at("view") != "frames" || row.at("pin") != "step")
                continue;
            const double begin = std::stod(row.at("begin_ms"));
            EXPECT_LT(begin - end, pause) << device;
            end = std::stod(row.at("end_ms"));
            longest = std::max(longest, end - begin);
        }
        EXPECT_LT((pins_to - pins_from) * 1e3 - end, pause + longest) << device;
    }
}

TEST_F(Workload, ThePinsOfAStepLieWithinIt) {
    for (const char* device : {"published", "q16_16"}) {
        std::map<std::string, int> frames, step;
        double end = 0;
        for (const Row& row : pins_)
            if (row.at("device") == device && row.at("pin") == "step" && row.at("view") == "step")
                end = std::stod(row.at("end_ms"));
        for (const Row& row : pins_) {
            if (row.at("device") != device) continue;
            ++(row.at("view") == "step" ? step : frames)[row.at("pin")];
            EXPECT_LT(std::stod(row.at("begin_ms")), std::stod(row.at("end_ms")));
            if (row.at("view") != "step") continue;
            EXPECT_GE(std::stod(row.at("begin_ms")), 0);
            EXPECT_LE(std::stod(row.at("end_ms")), end);
        }
        EXPECT_GT(frames["render"], 3) << device;
        EXPECT_EQ(step["step"], 1) << device;
        EXPECT_EQ(step["collision"], 2) << device;
        // A fixed-point rod in an arithmetic that rounds stores 1 / length and takes no root.
        EXPECT_EQ(step["square_root"], device == std::string("published") ? 1 : 0) << device;
        EXPECT_GT(step["operation"], 20) << device;
    }
}

}  // namespace
}  // namespace haptic
