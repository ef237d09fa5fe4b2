// SPDX-License-Identifier: GPL-3.0-or-later
// A biquad, transposed direct form II: a Butterworth low-pass filter of second order at a twentieth
// of the sampling rate.
#include <engine/decimal.hpp>
#include <fixedpoint/watch.hpp>

using namespace engine::literals;

template <class Number>
class Program {
  public:
    Number step(Number x) {
        using fixedpoint::watch;
        const Number y = b0_ * x + first_;
        first_ = watch(b1_ * x - a1_ * y + second_, "first");
        second_ = watch(b0_ * x - a2_ * y, "second");
        return y;
    }

  private:
    Number b0_ = 0.0200833655642112_d, b1_ = 0.0401667311284225_d;
    Number a1_ = -1.561018075800718_d, a2_ = 0.641351538057563_d;
    Number first_{}, second_{};
};
