// SPDX-License-Identifier: MIT
/// \file
/// MovingAverage: the mean of the last N inputs, from a running sum that is exact: it neither
/// drifts nor overflows.
#pragma once

#include <fixedpoint/fixed.hpp>

namespace fixedpoint {

/// \cond internal
constexpr unsigned char log2_of(uint16_t n) {
    return n <= 1 ? 0 : static_cast<unsigned char>(1 + log2_of(static_cast<uint16_t>(n / 2)));
}
/// \endcond

/// Of float numbers, for comparison: the sum keeps each rounding error for ever.
template <class Number, uint16_t N>
class MovingAverage {
  public:
    /// As if all former inputs had been `value`.
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

/// The mean of the last N inputs, rounded once, for every input. N is a power of two from 2 to 256:
/// any other takes a division.
///
/// The sum is held as N quotient + remainder with 0 <= remainder < N. The quotient is the mean
/// rounded down, so that it always fits, and no sum wider than a number is needed.
template <int IntegerBits, int F, class A, uint16_t N>
class MovingAverage<Fixed<IntegerBits, F, A>, N> {
    static_assert(N >= 2 && N <= 256 && (N & (N - 1)) == 0,
                  "A moving average takes 2, 4, 8 ... 256 inputs.");

  public:
    /// The numbers that it averages.
    using Number = Fixed<IntegerBits, F, A>;

    /// As if all former inputs had been `value`.
    explicit MovingAverage(Number value = Number()) : quotient_(value.raw()) {
        for (uint16_t i = 0; i < N; ++i) window_[i] = value.raw();
    }
    /// Takes the next input and returns the mean.
    Number update(Number input) {
        const Raw oldest = window_[oldest_];
        window_[oldest_] = input.raw();
        oldest_ = static_cast<uint8_t>((oldest_ + 1) % N);
        const int16_t remainder =
            static_cast<int16_t>(remainder_ + low(input.raw()) - low(oldest));  // -N to 2 N
        remainder_ = low(remainder);
        quotient_ = wrapping_add(quotient_, wrapping_subtract(high(input.raw()), high(oldest)));
        quotient_ = wrapping_add(quotient_, static_cast<Raw>(remainder >> log2_of(N)));
        return Number::from_raw(
            wrapping_add(quotient_, static_cast<Raw>(remainder_ >= static_cast<int16_t>(N / 2))));
    }

  private:
    using Raw = typename Number::Raw;
    // a = N high(a) + low(a).
    static constexpr Raw high(Raw a) { return static_cast<Raw>(a >> log2_of(N)); }
    template <class Int>
    static constexpr int16_t low(Int a) {
        return static_cast<int16_t>(static_cast<uint8_t>(a) & (N - 1));
    }

    Raw window_[N];
    Raw quotient_;
    int16_t remainder_ = 0;
    uint8_t oldest_ = 0;
};

}  // namespace fixedpoint
