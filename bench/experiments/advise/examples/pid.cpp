// SPDX-License-Identifier: GPL-3.0-or-later
// A PID controller with the derivative of the measured value, and an integral that stops at the
// actuator's limits. Inputs: the setpoint and the measured value, 100 times a second.
#include <engine/decimal.hpp>
#include <fixedpoint/watch.hpp>

using namespace engine::literals;

template <class Number>
class Program {
  public:
    Number step(Number wanted, Number measured) {
        using fixedpoint::watch;
        const Number error = watch(wanted - measured, "error");
        const Number slope = watch((measured - last_) * rate_, "slope");
        last_ = measured;
        const Number integral = watch(integral_ + error * integral_gain_, "integral");
        const Number wish = proportional_gain_ * error + integral - derivative_gain_ * slope;
        if (wish > limit_) return limit_;
        if (wish < -limit_) return -limit_;
        integral_ = integral;
        return wish;
    }

  private:
    Number proportional_gain_ = 1.8_d, integral_gain_ = 0.025_d, derivative_gain_ = 0.04_d;
    Number rate_ = 100_d, limit_ = 12_d;
    Number integral_{}, last_{};
};
