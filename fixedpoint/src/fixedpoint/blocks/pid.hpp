// SPDX-License-Identifier: MIT
/// \file
/// Pid: a controller with proportional, integral and derivative action, limited output and
/// anti-windup.
///
/// - The derivative is that of the measurement, not of the error: a new setpoint would otherwise
///   kick the output.
/// - Anti-windup is conditional integration: while the output is at a limit, the integral does not
///   move further towards it. Back-calculation would need a fourth gain and one more product, and
///   drives the integral away from where it stopped.
/// - The integral carries its rounding errors, so that an error too small for one step adds up:
///   without, the loop would stop where integral gain times error rounds to 0.
#pragma once

#include <fixedpoint/blocks/carried_error.hpp>

namespace fixedpoint {

/// The gains for one step of h seconds.
template <class Number>
struct PidGains {
    /// Output per error.
    Number proportional;
    /// Output per error and step: the gain per second times h.
    Number integral;
    /// Output per change of the measurement in a step: the gain in seconds over h.
    Number derivative;
};

/// A controller whose output stays in [low, high].
///
/// For every input and every arithmetic: errors, changes, products and sums that leave the range
/// stay at its end, so that nothing changes its sign; the integral stays in the range. Where low is
/// above high, the output is low.
template <class Number>
class Pid {
  public:
    /// The integral begins at 0.
    Pid(const PidGains<Number>& gains, Number low, Number high)
        : gains_{N::saturated(gains.proportional), N::saturated(gains.integral),
                 N::saturated(gains.derivative)},
          low_(N::saturated(low)),
          high_(N::saturated(high < low ? low : high)) {}

    /// The output for the next step. The first measurement has no derivative.
    Number update(Number setpoint, Number measurement) {
        const Saturated position = N::saturated(measurement);
        const Saturated error = N::saturated(setpoint) - position;
        Saturated output = gains_.proportional * error;
        if (started_) output -= gains_.derivative * (position - measurement_);
        measurement_ = position;
        started_ = true;

        CarriedError<Saturated> carried = carried_;
        const Saturated integral = carried.multiply_add(gains_.integral, error, integral_);
        output += integral;
        bool winds_up = false;
        if (output > high_) {
            output = high_;
            winds_up = integral > integral_;
        } else if (output < low_) {
            output = low_;
            winds_up = integral < integral_;
        }
        if (!winds_up) {
            integral_ = integral;
            carried_ = carried;
        }
        return N::plain(output);
    }

  private:
    using N = BlockNumber<Number>;
    using Saturated = typename N::Saturated;

    PidGains<Saturated> gains_;
    Saturated low_, high_, integral_ = Saturated(), measurement_ = Saturated();
    CarriedError<Saturated> carried_;
    bool started_ = false;
};

}  // namespace fixedpoint
