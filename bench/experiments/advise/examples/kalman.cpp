// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a Kalman filter whose state is position and velocity; the position is measured 64 times
// a second. Input: the measurement. Result: the estimated position.
#include <engine/decimal.hpp>
#include <fixedpoint/watch.hpp>

using namespace engine::literals;

template <class Number>
class Program {
  public:
    Number step(Number measured) {
        using fixedpoint::watch;
        const Number predicted = position_ + velocity_ * dt_;
        const Number cross = watch(p01_ + p11_ * dt_, "cross covariance");
        const Number variance = watch(p00_ + (p01_ + cross) * dt_ + q0_, "variance");
        const Number rate_variance = watch(p11_ + q1_, "variance of the velocity");

        const Number total = variance + noise_;
        const Number gain = watch(variance / total, "gain");
        const Number rate_gain = watch(cross / total, "gain of the velocity");
        const Number innovation = watch(measured - predicted, "innovation");
        position_ = predicted + gain * innovation;
        velocity_ = watch(velocity_ + rate_gain * innovation, "velocity");
        p00_ = variance - gain * variance;
        p01_ = cross - gain * cross;
        p11_ = rate_variance - rate_gain * cross;
        return position_;
    }

  private:
    Number dt_ = 0.015625_d, noise_ = 0.04_d, q0_ = 0.0001_d, q1_ = 0.01_d;
    Number position_{}, velocity_{};
    Number p00_ = 1_d, p01_{}, p11_ = 1_d;
};
