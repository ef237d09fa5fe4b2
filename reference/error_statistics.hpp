// SPDX-License-Identifier: GPL-3.0-or-later
// Accumulates judgements: the largest error with its witness, rms, bias and histogram, and how many
// inputs were pinned, excluded or wrong. Use one object per thread or shard and merge them in the
// order of the shards: the figures then do not depend on timing.
#pragma once

#include <gsl/gsl_histogram.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "reference/judgement.hpp"
#include "reference/operation.hpp"

namespace reference {

// The operands of one judgement.
class Witness {
  public:
    Witness() = default;
    explicit Witness(std::span<const std::int64_t> operands) : count_(operands.size()) {
        for (std::size_t i = 0; i < count_; ++i) operands_[i] = operands[i];
    }
    std::span<const std::int64_t> operands() const { return {operands_.data(), count_}; }
    bool empty() const { return count_ == 0; }

  private:
    std::size_t count_ = 0;
    std::array<std::int64_t, max_operands> operands_{};
};

class ErrorStatistics {
  public:
    // Bins are centred on the multiples of 1/32 ulp from -2 to 2: errors of 0 and 1/2 ulp, which
    // exact arithmetic produces often, lie in the middle of a bin.
    static constexpr int bins_per_ulp = 32;
    static constexpr int ulps_each_side = 2;
    static constexpr std::size_t bin_count = 2 * bins_per_ulp * ulps_each_side + 1;

    ErrorStatistics();
    ErrorStatistics(const ErrorStatistics& other);
    ErrorStatistics& operator=(ErrorStatistics other) noexcept;
    ErrorStatistics(ErrorStatistics&&) noexcept = default;

    void add(const Judgement& judgement, std::span<const std::int64_t> operands) {
        if (judgement.excluded) {
            ++excluded_;
            return;
        }
        if (!judgement.as_defined) [[unlikely]] {
            if (wrong_++ == 0) wrong_witness_ = Witness(operands);
        }
        if (judgement.defined) {
            ++defined_;
            // A pinned result that is right has no rounding error.
            if (judgement.as_defined) return;
        }
        add_error(judgement, operands);
    }

    // Appends what `later` accumulated. Of equal maxima the earlier one is kept.
    void merge(const ErrorStatistics& later);

    std::uint64_t count() const { return count_; }                   // judged inputs
    std::uint64_t defined() const { return defined_; }               // those with a pinned result
    std::uint64_t underflowed() const { return underflowed_; }       // those below half an ulp
    std::uint64_t excluded() const { return excluded_; }             // inputs that were not judged
    std::uint64_t wrong() const { return wrong_; }                   // judged inputs not as defined
    const Witness& wrong_witness() const { return wrong_witness_; }  // the first

    double max_ulp() const { return std::abs(max_error_); }
    double max_error_ulp() const { return max_error_; }  // signed
    const Witness& max_witness() const { return max_witness_; }
    // Over the inputs that did not underflow; 0 if there are none.
    double rms_ulp() const;
    double mean_ulp() const;  // the bias

    // Counts per bin of the inputs that did not underflow. Errors beyond the first and the last bin
    // are counted in below_histogram() and above_histogram().
    const gsl_histogram& histogram() const { return *histogram_; }
    std::uint64_t below_histogram() const { return below_; }
    std::uint64_t above_histogram() const { return above_; }

    // The file of a shard. Reading shards back and merging them gives the result of a single run.
    friend void to_json(nlohmann::json& json, const ErrorStatistics& statistics);
    friend void from_json(const nlohmann::json& json, ErrorStatistics& statistics);

  private:
    void add_error(const Judgement& judgement, std::span<const std::int64_t> operands) {
        const double error = judgement.error_ulp;
        if (!(std::abs(error) <= std::abs(max_error_)) || count_ == 0) [[unlikely]] {
            max_error_ = error;
            max_witness_ = Witness(operands);
        }
        ++count_;
        if (judgement.underflow) {
            ++underflowed_;
            return;
        }
        sum_ += error;
        sum_of_squares_ += error * error;
        // gsl_histogram_increment without its search: the bins are uniform.
        const double bin = error * bins_per_ulp + (bins_per_ulp * ulps_each_side + 0.5);
        if (bin >= 0 && bin < double(bin_count)) [[likely]]
            histogram_->bin[std::size_t(bin)] += 1;
        else
            ++(bin < 0 ? below_ : above_);
    }

    struct FreeHistogram {
        void operator()(gsl_histogram* histogram) const { gsl_histogram_free(histogram); }
    };

    std::unique_ptr<gsl_histogram, FreeHistogram> histogram_;
    std::uint64_t count_ = 0, defined_ = 0, underflowed_ = 0, excluded_ = 0, wrong_ = 0, below_ = 0,
                  above_ = 0;
    double sum_ = 0, sum_of_squares_ = 0, max_error_ = 0;
    Witness max_witness_, wrong_witness_;
};

}  // namespace reference
