// SPDX-License-Identifier: GPL-3.0-or-later
// What a subject takes of a program's memory, as bench/device/link_subjects.py writes it next to
// the program.
#pragma once

#include <string>
#include <tuple>

#include "bench/lab/records/record.hpp"

namespace operations {

// A row of <program>.footprints.csv.
struct Footprint {
    std::string subject;
    int flash_bytes, ram_bytes;

    static constexpr auto columns =
        std::tuple(records::column("subject", &Footprint::subject),
                   records::column("flash_bytes", &Footprint::flash_bytes),
                   records::column("ram_bytes", &Footprint::ram_bytes));
};

}  // namespace operations
