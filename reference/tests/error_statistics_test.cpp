// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/error_statistics.hpp"

#include <gsl/gsl_rstat.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace reference {
namespace {

using Raws = std::vector<std::int64_t>;

// Errors in eighths of an ulp, so that sums of them are exact in any order.
std::vector<double> some_errors(std::size_t count) {
    std::mt19937_64 random(3);
    std::vector<double> errors(count);
    for (double& error : errors) error = (double(random() % 41) - 20) / 8;
    return errors;
}

ErrorStatistics statistics_of(std::span<const double> errors, std::int64_t first_operand = 0) {
    ErrorStatistics statistics;
    for (const double error : errors)
        statistics.add({.error_ulp = error, .as_defined = std::abs(error) <= 1.875},
                       Raws{first_operand++, 5});
    return statistics;
}

Raws operands(const Witness& witness) {
    return {witness.operands().begin(), witness.operands().end()};
}

TEST(ErrorStatistics, EmptyIsAllZero) {
    const ErrorStatistics statistics;
    EXPECT_EQ(statistics.count(), 0u);
    EXPECT_EQ(statistics.max_ulp(), 0);
    EXPECT_EQ(statistics.rms_ulp(), 0);
    EXPECT_EQ(statistics.mean_ulp(), 0);
    EXPECT_TRUE(statistics.max_witness().empty());
}

TEST(ErrorStatistics, AgreesWithGsl) {
    const auto errors = some_errors(5000);
    const ErrorStatistics statistics = statistics_of(errors);
    gsl_rstat_workspace* running = gsl_rstat_alloc();
    for (const double error : errors) gsl_rstat_add(error, running);
    EXPECT_EQ(statistics.count(), gsl_rstat_n(running));
    EXPECT_NEAR(statistics.mean_ulp(), gsl_rstat_mean(running), 1e-12);
    EXPECT_NEAR(statistics.rms_ulp(), gsl_rstat_rms(running), 1e-12);
    EXPECT_EQ(statistics.max_ulp(), std::max(gsl_rstat_max(running), -gsl_rstat_min(running)));
    gsl_rstat_free(running);

    gsl_histogram* histogram = gsl_histogram_clone(&statistics.histogram());
    gsl_histogram_reset(histogram);
    for (const double error : errors) gsl_histogram_increment(histogram, error);
    for (std::size_t i = 0; i < histogram->n; ++i)
        EXPECT_EQ(statistics.histogram().bin[i], histogram->bin[i]) << i;
    gsl_histogram_free(histogram);
}

TEST(ErrorStatistics, KeepsSignAndFirstWitnessOfTheMaximum) {
    const double errors[] = {0.25, -0.5, 0.5, 0.125};
    const ErrorStatistics statistics = statistics_of(errors, 10);
    EXPECT_EQ(statistics.max_error_ulp(), -0.5);
    EXPECT_EQ(operands(statistics.max_witness()), (Raws{11, 5}));
    const double exact[] = {0, 0};
    EXPECT_EQ(operands(statistics_of(exact, 10).max_witness()), (Raws{10, 5}));
}

TEST(ErrorStatistics, CountsKindsOfJudgement) {
    ErrorStatistics statistics;
    statistics.add({.error_ulp = 9, .excluded = "undefined"}, Raws{1});
    statistics.add({.defined = true}, Raws{2});
    statistics.add({.error_ulp = 3, .as_defined = false}, Raws{3});
    statistics.add({.error_ulp = -4, .defined = true, .as_defined = false}, Raws{4});
    EXPECT_EQ(statistics.excluded(), 1u);
    EXPECT_EQ(statistics.count(), 2u);  // a pinned result that is right has no error
    EXPECT_EQ(statistics.defined(), 2u);
    EXPECT_EQ(statistics.wrong(), 2u);
    EXPECT_EQ(operands(statistics.wrong_witness()), Raws{3});
    EXPECT_EQ(statistics.above_histogram(), 1u);
    EXPECT_EQ(statistics.below_histogram(), 1u);
    EXPECT_EQ(gsl_histogram_sum(&statistics.histogram()), 0);
}

TEST(ErrorStatistics, UnderflowCountsOnlyTowardsTheMaximum) {
    ErrorStatistics statistics;
    statistics.add({.error_ulp = 0.25}, Raws{1});
    statistics.add({.error_ulp = -0.375, .underflow = true}, Raws{2});
    statistics.add({.error_ulp = 0.125, .underflow = true}, Raws{3});
    EXPECT_EQ(statistics.count(), 3u);
    EXPECT_EQ(statistics.underflowed(), 2u);
    EXPECT_EQ(statistics.max_error_ulp(), -0.375);
    EXPECT_EQ(statistics.rms_ulp(), 0.25);
    EXPECT_EQ(statistics.mean_ulp(), 0.25);
    EXPECT_EQ(gsl_histogram_sum(&statistics.histogram()), 1);
    ErrorStatistics read;
    from_json(nlohmann::json::parse(nlohmann::json(statistics).dump()), read);
    EXPECT_EQ(nlohmann::json(read), nlohmann::json(statistics));
    read.merge(statistics);
    EXPECT_EQ(read.underflowed(), 4u);
}

TEST(ErrorStatistics, AnInfiniteErrorIsTheMaximum) {
    ErrorStatistics statistics;
    statistics.add({.error_ulp = -1}, Raws{1});
    statistics.add({.error_ulp = std::numeric_limits<double>::infinity()}, Raws{2});
    statistics.add({.error_ulp = 7}, Raws{3});
    EXPECT_EQ(statistics.max_ulp(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(operands(statistics.max_witness()), Raws{2});
    ErrorStatistics read;
    from_json(nlohmann::json::parse(nlohmann::json(statistics).dump()), read);
    EXPECT_EQ(read.max_ulp(), std::numeric_limits<double>::infinity());
}

TEST(ErrorStatistics, MergedShardsEqualOneRun) {
    const auto errors = some_errors(3000);
    const nlohmann::json whole = statistics_of(errors);
    for (const std::size_t cut : {0, 1, 1234, 3000}) {
        ErrorStatistics merged = statistics_of(std::span(errors).first(cut));
        merged.merge(statistics_of(std::span(errors).subspan(cut), std::int64_t(cut)));
        EXPECT_EQ(nlohmann::json(merged), whole) << cut;
    }
    ErrorStatistics read;
    from_json(nlohmann::json::parse(whole.dump()), read);
    EXPECT_EQ(nlohmann::json(read), whole);
    const ErrorStatistics copy = read;
    EXPECT_EQ(nlohmann::json(copy), whole);
}

TEST(ErrorStatistics, AWitnessHasAsManyOperandsAsAnyOperationTakes) {
    const Raws most = {1, -2, 3, -4, 5, -6};
    ErrorStatistics statistics;
    statistics.add({.error_ulp = 1, .as_defined = false}, most);
    const nlohmann::json json = statistics;
    ErrorStatistics read;
    from_json(json, read);
    EXPECT_EQ(operands(read.max_witness()), most);
    EXPECT_EQ(operands(read.wrong_witness()), most);
    for (const char* witness : {"max_witness", "wrong_witness"}) {
        nlohmann::json longer = json;
        longer[witness].push_back(7);
        EXPECT_THROW(from_json(longer, read), std::invalid_argument) << witness;
    }
}

TEST(ErrorStatistics, AnotherLayoutIsRejected) {
    nlohmann::json json = ErrorStatistics();
    json["bins_per_ulp"] = 7;
    ErrorStatistics read;
    EXPECT_THROW(from_json(json, read), std::invalid_argument);
    EXPECT_THROW(from_json(nlohmann::json::object(), read), nlohmann::json::exception);
}

}  // namespace
}  // namespace reference
