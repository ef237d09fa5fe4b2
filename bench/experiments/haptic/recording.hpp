// SPDX-License-Identifier: GPL-3.0-or-later
// A run as files: the plant's state (CSV, each millisecond), the pins (VCD) and the screen.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/experiments/haptic/device_loop.hpp"
#include "bench/lab/records/csv.hpp"

namespace haptic {

// Value change dump (IEEE 1364), one wire per pin, in units of 100 ps: a cycle is 625 units.
std::string value_change_dump(const std::vector<PinEdge>& edges);

class Recording {
  public:
    explicit Recording(DeviceLoop& loop);

    // Must be called each millisecond.
    void watch(DeviceLoop& loop);
    const std::vector<PinEdge>& edges() const { return edges_; }

    // Writes <name>.csv, <name>.vcd and <name>.screen.txt. The last contains each screen that
    // differs from the one before: its time in s and its lines.
    void save(const std::filesystem::path& folder, const std::string& name) const;

  private:
    records::Table table_;
    std::vector<PinEdge> edges_;
    std::string screens_;
    std::vector<std::string> last_screen_;
};

}  // namespace haptic
