// SPDX-License-Identifier: MIT
// Steps that are late at all cannot be made up for.
#include <firmware/frame_clock.hpp>

template class firmware::FixedSteps<2000, 0>;
