// SPDX-License-Identifier: MIT
/// \file
/// OnePole: the low-pass filter y += k (x - y) of the first order, with error feedback. Written by
/// hand it stops short of its input, where k (x - y) rounds to 0: with k = 1/256 half a percent of
/// the range away in Q8.8. This one always arrives.
#pragma once

#include <fixedpoint/blocks/carried_error.hpp>
#include <fixedpoint/blocks/filter_kernel.hpp>

namespace fixedpoint {

/// \cond internal
// The state of a filter, in the order of its kernel, and a step.
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

/// A low-pass filter with the time constant 1/k steps; the high-pass filter is x - y.
///
/// For every input: the output stays between the smallest and the largest input, nothing overflows,
/// and a constant input becomes the output exactly, without a limit cycle, where k is not 0. An x
/// further from y than the largest number counts as if it were at that distance.
template <class Number>
class OnePole {
  public:
    /// The coefficient k is limited to 0..1: k = 1 - e^(-step / time constant).
    explicit OnePole(Number coefficient, Number output = Number())
        : state_{limited(coefficient), CarriedError<Number>(), output} {}

    /// Takes the next input and returns the output.
    Number update(Number input) { return OnePoleStep<Number>::take(state_, input); }
    /// What update returned last.
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
