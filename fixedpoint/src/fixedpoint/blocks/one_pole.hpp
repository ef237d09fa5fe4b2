// SPDX-License-Identifier: MIT
/// \file
/// OnePole: the first-order low-pass filter y += k (x - y), with error feedback. Written by hand,
/// it stops short of its input once k (x - y) rounds to 0: in Q8.8 with k = 1/256, half a percent
/// of the range away. This one always arrives.
#pragma once

#include <fixedpoint/blocks/carried_error.hpp>
#include <fixedpoint/blocks/filter_kernel.hpp>

namespace fixedpoint {

/// \cond internal
// The state of a filter, in the order that its kernel expects, and one step.
template <class Number>
struct OnePoleState {
    Number coefficient;
    CarriedError<Number> error;
    Number output;
};
template <class Number, bool in_kernel = FilterKernel<Number>::exists>
struct OnePoleStep {
    static Number take(OnePoleState<Number>& state, Number input) {
        using N = BlockNumber<Number>;
        const Number distance = N::plain(N::saturated(input) - N::saturated(state.output));
        return state.output = state.error.multiply_add(state.coefficient, distance, state.output);
    }
};
template <class Number>
struct OnePoleStep<Number, true> {
    static Number take(OnePoleState<Number>& state, Number input) {
        return FilterKernel<Number>::one_pole(input, &state);
    }
};
/// \endcond

/// A low-pass filter with a time constant of 1/k steps; x - y is the high-pass filter.
///
/// For every input, the output stays between the smallest and the largest input, and nothing
/// overflows. If k is not 0, a constant input is reached exactly, without a limit cycle. If x - y
/// exceeds the range, it saturates.
template <class Number>
class OnePole {
  public:
    /// The coefficient k is limited to [0, 1]; a time constant needs k = 1 - e^(-step / time
    /// constant).
    explicit OnePole(Number coefficient, Number output = Number())
        : state_{limited(coefficient), CarriedError<Number>(), output} {}

    /// Takes the next input and returns the output.
    Number update(Number input) { return OnePoleStep<Number>::take(state_, input); }
    /// The last result of update, or the initial output.
    Number output() const { return state_.output; }

  private:
    static Number limited(Number coefficient) {
        return coefficient < Number()                     ? Number()
               : BlockNumber<Number>::one() < coefficient ? BlockNumber<Number>::one()
                                                          : coefficient;
    }

    OnePoleState<Number> state_;
};

}  // namespace fixedpoint
