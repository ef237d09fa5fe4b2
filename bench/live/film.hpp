// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures over time as an animation: as a terminal recording and as an image for a browser.
#pragma once

#include <string>
#include <vector>

#include "bench/live/picture.hpp"

namespace live {

class Film {
  public:
    // The image ends here, to stay small; the terminal recording does not.
    static constexpr double longest_image = 10;  // s

    // Shows `picture` from `time` on, in s. Times must rise.
    void add(double time, const Picture& picture);
    // The time at which the animation ends and starts again, in s.
    void end(double time) { end_ = time; }

    // For asciinema's players, version 2 of its format.
    std::string cast(const std::string& title) const;

    // An SVG that plays without a script. Cells that appear and disappear together are a group.
    std::string svg(const std::string& title) const;

  private:
    // A cell, and since when it is shown.
    struct Shown {
        Cell cell;
        double since = 0;
    };
    // A cell that was shown for a time.
    struct Span {
        int row, column;
        Cell cell;
        double begin, end;
    };
    std::vector<Span> spans() const;

    Picture last_;
    bool empty_ = true;
    std::string events_;  // of the cast
    std::vector<Span> over_;
    std::array<Shown, Picture::rows * Picture::columns> shown_;
    double end_ = 0;
};

}  // namespace live
