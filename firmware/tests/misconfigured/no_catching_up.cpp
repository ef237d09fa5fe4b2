// SPDX-License-Identifier: MIT
// max_behind must be above 0, or no late step is made up for.
#include <firmware/frame_clock.hpp>

template class firmware::FixedSteps<2000, 0>;
