// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/error_statistics.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace reference {
namespace {

constexpr double half_bin = 0.5 / ErrorStatistics::bins_per_ulp;

nlohmann::json operands_of(const Witness& witness) {
    return std::vector<std::int64_t>(witness.operands().begin(), witness.operands().end());
}

Witness witness_of(const nlohmann::json& json) {
    const auto operands = json.get<std::vector<std::int64_t>>();
    if (operands.size() > max_operands)
        throw std::invalid_argument("a witness of error statistics has too many operands");
    return Witness(operands);
}

// JSON has no infinity; an infinite error is stored as null.
nlohmann::json finite_or_null(double number) {
    return std::isfinite(number) ? nlohmann::json(number) : nlohmann::json();
}
double number_or_infinity(const nlohmann::json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

}  // namespace

ErrorStatistics::ErrorStatistics() : histogram_(gsl_histogram_alloc(bin_count)) {
    gsl_histogram_set_ranges_uniform(histogram_.get(), -ulps_each_side - half_bin,
                                     ulps_each_side + half_bin);
}

ErrorStatistics::ErrorStatistics(const ErrorStatistics& other) : ErrorStatistics() { merge(other); }

ErrorStatistics& ErrorStatistics::operator=(ErrorStatistics other) noexcept {
    histogram_ = std::move(other.histogram_);
    count_ = other.count_;
    defined_ = other.defined_;
    underflowed_ = other.underflowed_;
    excluded_ = other.excluded_;
    wrong_ = other.wrong_;
    below_ = other.below_;
    above_ = other.above_;
    sum_ = other.sum_;
    sum_of_squares_ = other.sum_of_squares_;
    max_error_ = other.max_error_;
    max_witness_ = other.max_witness_;
    wrong_witness_ = other.wrong_witness_;
    return *this;
}

void ErrorStatistics::merge(const ErrorStatistics& later) {
    if (later.count_ > 0 && (count_ == 0 || std::abs(later.max_error_) > std::abs(max_error_))) {
        max_error_ = later.max_error_;
        max_witness_ = later.max_witness_;
    }
    if (wrong_ == 0) wrong_witness_ = later.wrong_witness_;
    gsl_histogram_add(histogram_.get(), later.histogram_.get());
    count_ += later.count_;
    defined_ += later.defined_;
    underflowed_ += later.underflowed_;
    excluded_ += later.excluded_;
    wrong_ += later.wrong_;
    below_ += later.below_;
    above_ += later.above_;
    sum_ += later.sum_;
    sum_of_squares_ += later.sum_of_squares_;
}

double ErrorStatistics::rms_ulp() const {
    const std::uint64_t regular = count_ - underflowed_;
    return regular ? std::sqrt(sum_of_squares_ / double(regular)) : 0;
}

double ErrorStatistics::mean_ulp() const {
    const std::uint64_t regular = count_ - underflowed_;
    return regular ? sum_ / double(regular) : 0;
}

void to_json(nlohmann::json& json, const ErrorStatistics& statistics) {
    const gsl_histogram& histogram = statistics.histogram();
    json = {{"count", statistics.count_},
            {"defined", statistics.defined_},
            {"underflowed", statistics.underflowed_},
            {"excluded", statistics.excluded_},
            {"wrong", statistics.wrong_},
            {"wrong_witness", operands_of(statistics.wrong_witness_)},
            {"sum_ulp", finite_or_null(statistics.sum_)},
            {"sum_of_squares_ulp", finite_or_null(statistics.sum_of_squares_)},
            {"max_error_ulp", finite_or_null(statistics.max_error_)},
            {"max_witness", operands_of(statistics.max_witness_)},
            {"below", statistics.below_},
            {"above", statistics.above_},
            {"bins_per_ulp", ErrorStatistics::bins_per_ulp},
            {"histogram", std::vector<std::uint64_t>(histogram.bin, histogram.bin + histogram.n)}};
}

void from_json(const nlohmann::json& json, ErrorStatistics& statistics) {
    const auto bins = json.at("histogram").get<std::vector<std::uint64_t>>();
    if (bins.size() != ErrorStatistics::bin_count ||
        json.at("bins_per_ulp").get<int>() != ErrorStatistics::bins_per_ulp) {
        throw std::invalid_argument(
            "error statistics of another histogram layout cannot be merged");
    }
    ErrorStatistics read;
    json.at("count").get_to(read.count_);
    json.at("defined").get_to(read.defined_);
    json.at("underflowed").get_to(read.underflowed_);
    json.at("excluded").get_to(read.excluded_);
    json.at("wrong").get_to(read.wrong_);
    json.at("below").get_to(read.below_);
    json.at("above").get_to(read.above_);
    read.sum_ = number_or_infinity(json.at("sum_ulp"));
    read.sum_of_squares_ = number_or_infinity(json.at("sum_of_squares_ulp"));
    read.max_error_ = number_or_infinity(json.at("max_error_ulp"));
    read.max_witness_ = witness_of(json.at("max_witness"));
    read.wrong_witness_ = witness_of(json.at("wrong_witness"));
    std::copy(bins.begin(), bins.end(), read.histogram_->bin);
    statistics = std::move(read);
}

}  // namespace reference
