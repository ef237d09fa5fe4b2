// SPDX-License-Identifier: GPL-3.0-or-later
// How long each step took in its last run on this machine, stored in the build folder.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace sequence {

struct Taken {
    double cpu, wall;  // s
};

class Times {
  public:
    // A file that is missing or damaged counts as empty.
    explicit Times(std::filesystem::path file);

    std::optional<Taken> of(const std::string& step, bool quick) const;
    // Saved immediately.
    void set(const std::string& step, bool quick, Taken taken);

  private:
    std::filesystem::path file_;
    std::map<std::string, Taken> taken_;
};

}  // namespace sequence
