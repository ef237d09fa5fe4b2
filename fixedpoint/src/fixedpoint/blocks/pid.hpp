// SPDX-License-Identifier: MIT
/// \file
/// Pid: a controller with proportional, integral and derivative action, limited output and
/// anti-windup.
///
/// - The derivative is taken of the measurement, not of the error: a new setpoint would otherwise
///   kick the output.
/// - Anti-windup is conditional integration: while the output is at a limit, the integral does not
///   move further towards it. Back-calculation would need a fourth gain and one more product, and
///   would drive the integral away from where it stopped.
/// - The integral carries its rounding error, so an increment too small for one step still
///   accumulates. Without that the loop would stall once integral gain times error rounds to 0.
#pragma once

#include <stddef.h>

#include <fixedpoint/blocks/carried_error.hpp>
#include <fixedpoint/blocks/filter_kernel.hpp>

namespace fixedpoint {

/// The gains for one step of h seconds.
template <class Number>
struct PidGains {
    /// Output per unit of error.
    Number proportional;
    /// Output per unit of error and step: the gain per second times h.
    Number integral;
    /// Output per change of the measurement in one step: the gain in seconds divided by h.
    Number derivative;
};

/// \cond internal
// The state of a controller, in the order that its kernel expects, and one step. The numbers
// saturate.
template <class Number>
struct PidState {
    PidGains<Number> gains;
    Number low, high, integral, measurement;
    CarriedError<Number> carried;
    bool started;
};
template <class Number, bool has_kernels = kernel::has_assembly>
struct PidStep {
    static Number take(PidState<Number>& state, Number setpoint, Number measurement) {
        const Number error = setpoint - measurement;
        Number output = state.gains.proportional * error;
        if (state.started) output -= state.gains.derivative * (measurement - state.measurement);
        state.measurement = measurement;
        state.started = true;

        CarriedError<Number> carried = state.carried;
        const Number integral = carried.multiply_add(state.gains.integral, error, state.integral);
        output += integral;
        bool winds_up = false;
        if (output > state.high) {
            output = state.high;
            winds_up = integral > state.integral;
        } else if (output < state.low) {
            output = state.low;
            winds_up = integral < state.integral;
        }
        if (!winds_up) {
            state.integral = integral;
            state.carried = carried;
        }
        return output;
    }
};
template <int F>
struct PidStep<Fixed<32 - F, F, Saturating>, true> {
    using Number = Fixed<32 - F, F, Saturating>;
    using State = PidState<Number>;
    static_assert(offsetof(State, gains) == 0 && offsetof(State, low) == 12 &&
                      offsetof(State, high) == 16 && offsetof(State, integral) == 20 &&
                      offsetof(State, measurement) == 24 && offsetof(State, carried) == 28 &&
                      offsetof(State, started) == (F <= 8    ? 29
                                                   : F <= 16 ? 30
                                                             : 32),
                  "The layout must be that of avr/pid_32.S.");
    static Number take(PidState<Number>& state, Number setpoint, Number measurement) {
        return Number::from_raw(PidKernel<F>::update(setpoint.raw(), measurement.raw(), &state));
    }
};
/// \endcond

/// A controller whose output stays in [low, high].
///
/// For every input and in every arithmetic, errors, changes, products and sums saturate, so none
/// changes its sign, and so does the integral. If low is above high, the output is low.
template <class Number>
class Pid {
  public:
    /// The integral starts at 0.
    Pid(const PidGains<Number>& gains, Number low, Number high)
        : state_{{N::saturated(gains.proportional), N::saturated(gains.integral),
                  N::saturated(gains.derivative)},
                 N::saturated(low),
                 N::saturated(high < low ? low : high),
                 Saturated(),
                 Saturated(),
                 CarriedError<Saturated>(),
                 false} {}

    /// The output for the next step. At the first call the derivative is 0.
    Number update(Number setpoint, Number measurement) {
        return N::plain(
            PidStep<Saturated>::take(state_, N::saturated(setpoint), N::saturated(measurement)));
    }

  private:
    using N = BlockNumber<Number>;
    using Saturated = typename N::Saturated;

    PidState<Saturated> state_;
};

}  // namespace fixedpoint
