// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures over time as an animation: as a terminal's recording and as an image for a browser.
#pragma once

#include <string>
#include <vector>

#include "bench/live/picture.hpp"

namespace live {

class Film {
  public:
    // The image ends here, to stay small; the terminal's recording does not.
    static constexpr double longest_image = 10;  // s

    // What is shown from `time` on, in s; times rise.
    void add(double time, const Picture& picture);
    // It ends, and begins anew, so much after its last picture.
    void end(double time) { end_ = time; }

    // For asciinema's players, version 2 of its format.
    std::string cast(const std::string& title) const;

    // An SVG that plays by itself, without a script. Cells that come and go together are a group.
    std::string svg(const std::string& title) const;

  private:
    // A cell and since when it is so.
    struct Shown {
        Cell cell;
        double since = 0;
    };
    // A cell that was so for a time.
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
