// SPDX-License-Identifier: MIT
/// \file
/// The force that the opposed sensors feel from the acceleration of their own frame, by the
/// published Table D.2: when the frame speeds up, the lever lags behind and presses on one of them.
/// An option of the lever, which takes no space if it is off.
#pragma once

#include <engine/time_step.hpp>
#include <firmware/calibration_curves.hpp>
#include <firmware/projection.hpp>
#include <fixedpoint/program_memory.hpp>

namespace firmware {
namespace frame_correction {

/// N per m/s^2 at 5, 6 .. 30 m/s^2, in units of 2^-16.
constexpr uint8_t least = 5, most = 30;
template <class = void>
struct Table {
    static const uint16_t entries[most - least + 1];
};
template <class T>
const uint16_t Table<T>::entries[] FIXEDPOINT_PROGRAM_MEMORY = {
    7333, 7148, 6558, 5633, 5535, 4772, 5264, 5556, 4994, 5325, 4243, 4499, 4266,
    3692, 3906, 4617, 4179, 3502, 4178, 3735, 3835, 3751, 3309, 3684, 3492, 3244,
};

/// The force in N at an acceleration in m/s^2, by the nearest entry. Above 30 m/s^2 it is that of
/// 30 m/s^2.
template <class Scalar>
Scalar force(Scalar acceleration) {
    const Scalar limit = CellArithmetic<Scalar>::from_integer(most);
    const Scalar held = acceleration > limit    ? limit
                        : acceleration < -limit ? Scalar(-limit)
                                                : acceleration;
    const int16_t whole = CellArithmetic<Scalar>::nearest(held < Scalar() ? Scalar(-held) : held);
    const uint16_t& entry = Table<>::entries[whole < least ? 0 : whole - least];
    return held * calibration::Constant<Scalar>::of(fixedpoint::read_program_memory(entry));
}

}  // namespace frame_correction

/// The correction and the state that it needs; empty if it is off.
template <class Scalar, bool on>
class FrameCorrection {
  public:
    /// The force to add to that of the sensors. `speed` is that of the arm's end; call it once per
    /// step.
    template <class TimeStep>
    Scalar correction(Scalar speed, TimeStep dt) {
        const Scalar change = speed - last_speed_;
        last_speed_ = speed;
        return frame_correction::force<Scalar>(change / engine::seconds<Scalar>(dt));
    }

  private:
    Scalar last_speed_ = Scalar();
};
/// \cond internal
template <class Scalar>
class FrameCorrection<Scalar, false> {
  public:
    template <class TimeStep>
    static Scalar correction(Scalar, TimeStep) {
        return Scalar();
    }
};
/// \endcond

}  // namespace firmware
