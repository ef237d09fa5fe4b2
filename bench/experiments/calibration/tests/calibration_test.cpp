// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/calibration/calibrate.hpp"
#include "bench/experiments/calibration/verdicts.hpp"
#include "reference/published.hpp"

namespace calibration {
namespace {

using testing::HasSubstr;

const DeviceProgram program;

std::filesystem::path scratch() {
    const auto folder = std::filesystem::path(testing::TempDir()) / "calibration_test";
    std::filesystem::create_directories(folder);
    return folder;
}

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Reading> published_readings() {
    return load_readings(reference::published_folder() / "table_d_1.csv");
}

std::string reason(const std::string& csv) {
    const auto file = scratch() / "bad.csv";
    std::ofstream(file) << csv;
    try {
        calibrate({file, scratch() / "bad", scratch() / "bad" / "table.hpp", program});
    } catch (const std::runtime_error& error) {
        EXPECT_FALSE(std::filesystem::exists(scratch() / "bad"));
        return error.what();
    }
    return "no error";
}

TEST(Readings, BadOnesAreRefusedWithTheirLine) {
    const std::string header = "adc_reading,actual_g\n";
    EXPECT_THAT(reason("reading,actual_g\n1,2\n"), HasSubstr("bad.csv:1: no column 'adc_reading'"));
    EXPECT_THAT(reason("adc_reading,grams\n1,2\n"), HasSubstr(":1: no column 'actual_g'"));
    EXPECT_THAT(reason(header + "1,10\nmany,20\n"), HasSubstr(":3: adc_reading 'many' is not"));
    EXPECT_THAT(reason(header + "1,10\n2.5,20\n"), HasSubstr(":3: adc_reading '2.5' is not"));
    EXPECT_THAT(reason(header + "1,10\n1024,20\n"), HasSubstr(":3: adc_reading '1024' is not"));
    EXPECT_THAT(reason(header + "1,nan\n"), HasSubstr(":2: actual_g 'nan' is not"));
    EXPECT_THAT(reason(header + "1,-3\n"), HasSubstr(":2: actual_g '-3' is not"));
    EXPECT_THAT(reason(header + "1,\n"), HasSubstr(":2: actual_g '' is not"));
    EXPECT_THAT(reason(header + "5,10\n5,20\n"), HasSubstr(":3: adc_reading 5 of 20 g after 5"));
    EXPECT_THAT(reason(header + "\n5,10\n6,9\n"), HasSubstr(":3: adc_reading 5 of 10 g after 6"));
    EXPECT_THAT(reason(header + "5,10,3\n"), HasSubstr(":2: 3 cells"));
    EXPECT_THAT(reason(header + "1,1\n2,2\n3,3\n4,4\n"), HasSubstr("4 readings; at least 5"));
}

// As spreadsheets write them.
TEST(Readings, ComeInAnyOrderAndWithDecimalCommas) {
    const auto loaded = [](const std::string& text) {
        const auto file = scratch() / "sheet.csv";
        std::ofstream(file) << text;
        std::string readings;
        for (const Reading& reading : load_readings(file))
            readings += std::to_string(reading.adc) + ":" + std::to_string(reading.grams) + " ";
        return readings;
    };
    const std::string expected = "10:1.500000 20:2.000000 31:4.000000 ";
    EXPECT_EQ(loaded("adc_reading,actual_g\n10,1.5\n20,2\n31,4\n"), expected);
    EXPECT_EQ(loaded("\xef\xbb\xbf"
                     "adc_reading;actual_g;note\r\n31;4;\r\n10;1,5;x\r\n 20 ; 2,0 ;\r\n;;\r\n\r\n"),
              expected);
    // Readings of a weight are averaged.
    EXPECT_EQ(loaded("actual_g,adc_reading\n4,30\n1.5,10\n4,32\n2,20\n4,31\n"), expected);
    EXPECT_EQ(loaded("actual_g,\"adc_reading\"\n\"1.5\",10\n2,20\n4,31"), expected);
}

// The curves that the fit must recover from readings without error.
const Curve known[] = {{Family::line, {1.7, -210}},
                       {Family::rational_quadratic, {-1.3e-5, 1.06e-2, 2.3}},
                       {Family::quadratic, {8.5e-4, -0.29, 55}},
                       {Family::hyperbola, {70, 60, 990}},
                       {Family::conductance_power, {40, 4.1, 1.2}}};

TEST(Fit, FindsKnownCurves) {
    for (const Curve& curve : known) {
        std::vector<Reading> readings;
        for (int x = 200; x <= 950; x += 50) readings.push_back({x, value<double>(curve, x)});
        const Fit found = fit(curve.family, readings);
        for (std::size_t i = 0; i < curve.coefficients.size(); ++i)
            EXPECT_NEAR(found.curve.coefficients[i] / curve.coefficients[i], 1, 1e-7)
                << name_of(curve.family) << " coefficient " << i;
    }
}

TEST(Fit, NoNeighbourHasASmallerSquareSum) {
    const auto readings = published_readings();
    for (const Curve& curve : known) {
        const Fit found = fit(curve.family, readings);
        for (std::size_t i = 0; i < curve.coefficients.size(); ++i) {
            for (const double shift : {-1e-3, 1e-3}) {
                Curve neighbour = found.curve;
                neighbour.coefficients[i] += shift * found.standard_errors[i];
                EXPECT_GT(square_sum(neighbour, readings), found.square_sum)
                    << name_of(curve.family) << " coefficient " << i;
            }
        }
    }
}

TEST(Fit, TheCubicPassesThroughEveryReadingAndRises) {
    const auto readings = published_readings();
    const Curve curve = fit(Family::monotone_cubic, readings).curve;
    for (const Reading& r : readings) EXPECT_NEAR(value<double>(curve, r.adc), r.grams, 1e-9);
    for (int x = 1; x <= readings.back().adc; ++x)
        EXPECT_GE(value<double>(curve, x), value<double>(curve, x - 1)) << x;
}

TEST(Fit, TooFewReadingsAreRefused) {
    EXPECT_THROW(fit(Family::hyperbola, {{100, 1}, {200, 2}, {300, 4}}), std::runtime_error);
}

TEST(Range, EndsBeforeThePole) {
    const auto readings = published_readings();
    const Range range = rising_range(published_function_1, readings);
    EXPECT_EQ(range.lowest, 0);
    EXPECT_LE(value<double>(published_function_1, range.highest), max_grams);
    EXPECT_GT(value<double>(published_function_1, range.highest + 1), max_grams);
    EXPECT_LT(value<double>(published_function_1, 1023), 0);
    EXPECT_EQ(held_value(published_function_1, range, 1023),
              value<double>(published_function_1, range.highest));
    // A parabola is used from its lowest point, at 173.2.
    EXPECT_EQ(rising_range(published_function_2, readings).lowest, 173);
}

// The range goes from the middle reading as far as the curve neither falls nor is negative, up to
// the last reading of the converter; it may start at 0 grams and at reading 0.
TEST(Range, EndsWhereTheCurveTurnsOrIsNegative) {
    const std::vector<Reading> readings{{400, 1}, {500, 2}, {600, 3}};
    const auto range = [&](std::vector<double> coefficients) {
        const Range found = rising_range({Family::quadratic, coefficients}, readings);
        return std::pair(found.lowest, found.highest);
    };
    // a x^2 + b x + c
    EXPECT_EQ(range({0, 1, 0}), std::pair(0, 1023));
    EXPECT_EQ(range({0, 1, 5}), std::pair(0, 1023));
    EXPECT_EQ(range({0, 1, -100}), std::pair(100, 1023));  // 0 g at reading 100
    EXPECT_EQ(range({0, 1, -100.5}), std::pair(101, 1023));
    EXPECT_EQ(range({0.015625, -6.25, 625}), std::pair(200, 557));  // (x - 200)^2 / 64, to 2000 g
    EXPECT_EQ(range({0, 4, 0}), std::pair(0, 500));                 // 2000 g itself
    EXPECT_EQ(range({0, 0, 70}), std::pair(0, 1023));               // constant is not falling
    EXPECT_EQ(range({0, 0, 0}), std::pair(0, 1023));
    EXPECT_EQ(range({1, -999, 249900}), std::pair(499, 539));    // constant from 499 to 500
    EXPECT_EQ(range({-1, 1001, -248600}), std::pair(457, 501));  // constant from 500 to 501
}

// The published table is the truth for the published curve.
TEST(Published, Function1GivesThePublishedTable) {
    for (const reference::ForceCalibration& row : reference::load_table_d_1())
        EXPECT_NEAR(value<double>(published_function_1, row.adc_reading), row.calculated_grams,
                    0.0501);
}

TEST(Published, VerdictsTellCurvesApart) {
    std::vector<Reading> readings;
    for (int x = 0; x <= 900; x += 100) {
        // Alternating errors, so that the least square sum is not zero.
        readings.push_back({x, value<double>(published_function_2, x) + (x % 200 == 0 ? 1 : -1)});
    }
    const Curve right = fit(Family::quadratic, readings).curve;
    EXPECT_EQ(reproduce("right", right, readings).verdict, "reproduced");
    Curve wrong = right;
    wrong.coefficients[2] += 0.2;
    EXPECT_EQ(reproduce("wrong", wrong, readings).verdict, "not reproducible");
    Curve near = right;
    near.coefficients[2] += 0.001;
    EXPECT_EQ(reproduce("near", near, readings).verdict, "equivalent");
}

// About the least square sum S of n readings, a constant that is off by d has S + n d^2: the curve
// is equivalent below S plus a ten-thousandth, and reproduced below a millionth of each value.
TEST(Published, VerdictsChangeAtTheirThresholds) {
    std::vector<Reading> readings;
    for (int x = 0; x <= 900; x += 100)
        readings.push_back({x, value<double>(published_function_2, x) + (x % 200 == 0 ? 1 : -1)});
    const Fit least = fit(Family::quadratic, readings);
    const auto off_by = [&](std::size_t coefficient, double difference) {
        Curve curve = least.curve;
        curve.coefficients[coefficient] += difference;
        return reproduce("test", curve, readings);
    };
    const double at_limit = std::sqrt(1e-4 * least.square_sum / 10);
    for (const double side : {-1, 1}) {
        EXPECT_EQ(off_by(2, side * at_limit * 0.999).verdict, "equivalent");
        EXPECT_EQ(off_by(2, side * at_limit * 1.001).verdict, "not reproducible");
    }
    const PublishedFit shifted = off_by(2, 0.004);
    EXPECT_EQ(shifted.first, 0);
    EXPECT_EQ(shifted.last, 900);
    EXPECT_NEAR(shifted.excess, 10 * 0.004 * 0.004 / least.square_sum, 1e-9);
    EXPECT_NEAR(shifted.largest_distance, 0.004, 1e-9);
    EXPECT_NEAR(shifted.worst_coefficient, 0.004 / (least.curve.coefficients[2] + 0.004), 1e-8);
    for (const std::size_t i : {0u, 1u, 2u}) {
        const double millionth = 1e-6 * least.curve.coefficients[i];
        EXPECT_EQ(off_by(i, 0.99 * millionth).verdict, "reproduced") << i;
        EXPECT_NE(off_by(i, 1.01 * millionth).verdict, "reproduced") << i;
        EXPECT_EQ(off_by(i, -0.99 * millionth).verdict, "reproduced") << i;
        EXPECT_NE(off_by(i, -1.01 * millionth).verdict, "reproduced") << i;
    }
}

// The readings that the published coefficients were fitted to are found among others, at either
// end.
TEST(Published, FindsTheRunOfReadings) {
    std::vector<Reading> run;
    for (int x = 200; x <= 700; x += 100)
        run.push_back({x, value<double>(published_function_2, x) + (x % 200 == 0 ? 1 : -1)});
    const Curve published = fit(Family::quadratic, run).curve;
    std::vector<Reading> readings = run;
    readings.insert(readings.begin(), {{0, 500}, {100, 90}});
    readings.push_back({800, 900});
    for (const bool cut : {false, true}) {
        const std::vector<Reading> given = cut ? run : readings;
        const PublishedFit found = reproduce("test", published, given);
        EXPECT_EQ(found.verdict, "reproduced");
        EXPECT_EQ(found.first, 200);
        EXPECT_EQ(found.last, 700);
    }
    const std::vector<Reading> fewest(run.begin(), run.begin() + 4);
    EXPECT_EQ(reproduce("test", fit(Family::quadratic, fewest).curve, fewest).last, 500);
    EXPECT_THROW(reproduce("test", published, {run[0], run[1], run[2]}), std::runtime_error);
}

TEST(EvaluationError, SeesWhatIsWrong) {
    const Curve curve = {Family::hyperbola, {70, 60, 990}};
    const Range range = rising_range(curve, published_readings());
    std::array<std::int32_t, 1024> raw;
    const DeviceCurve device(curve, range);
    for (int x = 0; x < 1024; ++x) raw[static_cast<std::size_t>(x)] = device.raw(x);
    EXPECT_LT(evaluation_error(curve, range, raw), 0.01);
    auto wrong = raw;
    for (std::size_t x = 500; x < 1024; ++x) wrong[x] += 65536 / 2;
    EXPECT_NEAR(evaluation_error(curve, range, wrong), 0.5, 0.01);
    wrong = raw;
    wrong[600] = wrong[599] - 1;
    EXPECT_THROW(evaluation_error(curve, range, wrong), std::runtime_error);
    wrong = raw;
    wrong[0] = -1;
    EXPECT_THROW(evaluation_error(curve, range, wrong), std::runtime_error);
    wrong = raw;
    wrong[1023] = 2001 << 16;
    EXPECT_THROW(evaluation_error(curve, range, wrong), std::runtime_error);
}

TEST(DeviceCurve, RefusesCoefficientsThatDoNotFit) {
    EXPECT_THROW(DeviceCurve({Family::hyperbola, {0, 1000, 990}}, {0, 900}), std::runtime_error);
    EXPECT_THROW(DeviceCurve({Family::hyperbola, {0, 10, 2100}}, {0, 900}), std::runtime_error);
}

TEST(Choice, FewestCyclesWithinOneStandardError) {
    const auto candidate = [](double leave_one_out, double cycles, const char* rejected) {
        Candidate c{"", {Family::hyperbola, {}}, {}, {}, {}, {}, leave_one_out, {}, 0, rejected};
        c.device = DeviceMeasurement{{}, cycles, cycles, 0, 0};
        return c;
    };
    // 1 + 1 / sqrt(2 x 18) = 1.1667 for 20 readings.
    EXPECT_EQ(choose({candidate(10, 500, ""), candidate(11.6, 300, ""), candidate(11.7, 100, ""),
                      candidate(5, 1, "for a reason")},
                     20),
              1u);
    EXPECT_THROW(choose({candidate(10, 500, "for a reason")}, 20), std::runtime_error);
}

// The command makes exactly the committed header from the published readings.
TEST(Calibrate, MakesTheCommittedHeader) {
    const auto root = reference::published_folder().parent_path().parent_path();
    std::filesystem::current_path(root);
    const auto header = scratch() / "calibration_table.hpp";
    calibrate({"reference/published/table_d_1.csv", scratch() / "data", header, program});
    EXPECT_EQ(content(header), content(root / "firmware/src/firmware/calibration_table.hpp"));
    const records::Table table = records::Table::load(scratch() / "data/calibration.csv");
    EXPECT_EQ(table.rows().size(), published_readings().size());
}

// What the firmware compiles from the header, with its coefficients as constants.
TEST(Calibrate, TheFirmwareEvaluatesTheChosenCurve) {
    const auto readings = published_readings();
    const auto all = candidates(readings, program);
    const Candidate& chosen = all[choose(all, readings.size())];
    simulator::Chip chip{simulator::Elf(program.elf)};
    chip.run_until_function("main");
    simulator::DeviceFunction grams(chip, "grams_q16_16_default", {4, {2}});
    for (int x = -5; x < 1100; ++x) {
        const auto i = static_cast<std::size_t>(std::clamp(x, 0, 1023));
        const simulator::Outcome outcome = grams(static_cast<std::int16_t>(x));
        ASSERT_EQ(outcome.as<std::int32_t>(), chosen.device->raw[i]) << x;
        ASSERT_LE(outcome.cycles, chosen.device->cycles_max);
    }
}

}  // namespace
}  // namespace calibration
