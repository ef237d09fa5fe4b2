// SPDX-License-Identifier: MIT
/// \file
/// MovingAverage: the mean of the last N inputs. The running sum is exact: it neither drifts nor
/// overflows.
#pragma once

#include <fixedpoint/fixed.hpp>

namespace fixedpoint {

/// \cond internal
constexpr unsigned char log2_of(uint16_t n) {
    return n <= 1 ? 0 : static_cast<unsigned char>(1 + log2_of(static_cast<uint16_t>(n / 2)));
}
/// \endcond

/// For float and double, for comparison: the sum keeps every rounding error forever.
template <class Number, uint16_t N>
class MovingAverage {
  public:
    /// As if all previous inputs had been `value`.
    explicit MovingAverage(Number value = Number()) : sum_(value * N) {
        for (uint16_t i = 0; i < N; ++i) window_[i] = value;
    }
    /// Takes the next input and returns the mean.
    Number update(Number input) {
        sum_ += input - window_[oldest_];
        window_[oldest_] = input;
        oldest_ = static_cast<uint8_t>((oldest_ + 1) % N);
        return sum_ * (Number(1) / N);
    }

  private:
    Number window_[N];
    Number sum_;
    uint8_t oldest_ = 0;
};

/// The mean of the last N inputs, rounded once, for every input. N must be a power of two from 2 to
/// 256; any other would take a division.
///
/// The sum of the raws has one byte more than a raw. It always fits, and no wider addition is
/// needed.
template <int IntegerBits, int F, class A, uint16_t N>
class MovingAverage<Fixed<IntegerBits, F, A>, N> {
    static_assert(N >= 2 && N <= 256 && (N & (N - 1)) == 0,
                  "The number of inputs must be 2, 4, 8, ... or 256.");

  public:
    /// The type of the numbers averaged.
    using Number = Fixed<IntegerBits, F, A>;

    /// As if all previous inputs had been `value`.
    explicit MovingAverage(Number value = Number())
        : sum_(static_cast<Low>(Unsigned<Raw>(value.raw()) << log2_of(N))),
          sum_above_(static_cast<int8_t>(value.raw() >> (RawLimits<Raw>::width - log2_of(N)))) {
        for (uint16_t i = 0; i < N; ++i) window_[i] = value.raw();
    }
    /// Takes the next input and returns the mean.
    Number update(Number input) {
        const Raw oldest = window_[oldest_], newest = input.raw();
        window_[oldest_] = newest;
        oldest_ = static_cast<uint8_t>((oldest_ + 1) % N);
        // A negative difference is 2^W less than its unsigned value.
        const Low difference = static_cast<Low>(wrapping_subtract(newest, oldest));
        sum_ = static_cast<Low>(sum_ + difference);
        if (sum_ < difference) ++sum_above_;
        if (newest < oldest) --sum_above_;
        const Low above = static_cast<uint8_t>(sum_above_ << (8 - log2_of(N)));
        const Raw floor = static_cast<Raw>(static_cast<Low>(above << (RawLimits<Raw>::width - 8)) |
                                           static_cast<Low>(sum_ >> log2_of(N)));
        const bool rounds_up = sum_ & (N / 2);
        return Number::from_raw(wrapping_add(floor, static_cast<Raw>(rounds_up)));
    }

  private:
    using Raw = typename Number::Raw;
    using Low = Unsigned<Raw>;

    Raw window_[N];
    // The sum is 2^W sum_above_ + sum_.
    Low sum_;
    int8_t sum_above_;
    uint8_t oldest_ = 0;
};

}  // namespace fixedpoint
