// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <utility>

namespace live {
namespace {

// Of the image, in pixels. A character of a common fixed-width font of size 15 is 9 pixels wide.
constexpr int cell_width = 9, cell_height = 18, font_size = 15, baseline = 14, margin = 12;
constexpr int image_width = Picture::columns * cell_width + 2 * margin;
constexpr int image_height = Picture::rows * cell_height + 2 * margin;

// Of a cell among all cells of a picture, row by row.
std::size_t place_of(int row, int column) {
    const int place = row * Picture::columns + column;
    return static_cast<std::size_t>(place);
}

// The text that changes `from` to `to` on a terminal.
std::string difference(const Picture& from, const Picture& to) {
    std::string text;
    std::optional<Ink> ink;
    for (int row = 0; row < Picture::rows; ++row) {
        int written = -1;  // the column after the last one
        for (int column = 0; column < Picture::columns; ++column) {
            const Cell& cell = to.at(row, column);
            if (cell == from.at(row, column)) continue;
            if (written != column) text += fmt::format("\x1b[{};{}H", row + 1, column + 1);
            if (ink != cell.ink)
                text += fmt::format("\x1b[38;5;{}m", colours[static_cast<int>(cell.ink)].terminal);
            ink = cell.ink;
            text += utf8(cell.glyph);
            written = column + 1;
        }
    }
    return text;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<')
            safe += "&lt;";
        else if (c == '&')
            safe += "&amp;";
        else
            safe += c;
    }
    return safe;
}

// Blocks are drawn as rectangles, since fonts differ in them: how much of the cell, how dense, and
// from where.
struct Block {
    double from, to, density;
};
std::optional<Block> block_of(wchar_t glyph) {
    if (glyph >= L'\u2588' && glyph <= L'\u258f') return Block{0, (L'\u2590' - glyph) / 8.0, 1};
    if (glyph == L'\u2590') return Block{0.5, 1, 1};
    if (glyph == L'\u2592') return Block{0, 1, 0.5};
    if (glyph == L'\u2593') return Block{0, 1, 0.75};
    return {};
}

std::string drawn(int row, int column, int cells, const std::wstring& text, Ink ink) {
    const auto x = margin + column * cell_width, y = margin + row * cell_height;
    const char tag = static_cast<char>('a' + static_cast<int>(ink));
    if (const auto block = block_of(text.front())) {
        const double width = (block->to - block->from) * cell_width * cells;
        const std::string density =
            block->density < 1 ? fmt::format(" opacity=\"{}\"", block->density) : "";
        return fmt::format("<path class=\"{}\" d=\"M{:g} {}h{:g}v{}h-{:g}z\"{}/>", tag,
                           x + block->from * cell_width, y, width, cell_height, width, density);
    }
    std::string characters;
    for (const wchar_t glyph : text) characters += utf8(glyph);
    const std::string width =
        cells > 1 ? fmt::format(" textLength=\"{}\"", cells * cell_width) : "";
    return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\"{}>{}</text>", tag, x, y + baseline,
                       width, escaped(characters));
}

// Shown between two fractions of the animation's length; each value holds until the next one's
// time. Without animation the first picture is shown.
std::string beginning_of_group(double from, double to, double length) {
    std::string values, times;
    if (from > 0) {
        values = "none;";
        times = fmt::format("0;{:.5f}", from);
    } else {
        times = "0";
    }
    values += "inline";
    if (to < 1) {
        values += ";none";
        times += fmt::format(";{:.5f}", to);
    }
    return fmt::format(
        "<g{}><animate attributeName=\"display\" calcMode=\"discrete\" dur=\"{:.3f}s\" "
        "repeatCount=\"indefinite\" values=\"{}\" keyTimes=\"{}\"/>",
        from > 0 ? " display=\"none\"" : "", length, values, times);
}

// Whether a cell can be drawn together with the one to its left.
bool joins(const Cell& left, const Cell& right) {
    if (left.ink != right.ink) return false;
    const auto a = block_of(left.glyph), b = block_of(right.glyph);
    if (!a && !b) return true;
    return a && b && left.glyph == right.glyph && a->from == 0 && a->to == 1;
}

}  // namespace

void Film::add(double time, const Picture& picture) {
    end_ = time;
    if (!empty_ && picture == last_) return;
    if (empty_) time = 0;
    std::string output = empty_ ? "\x1b[2J\x1b[?25l" : "";
    output += difference(last_, picture);
    events_ += nlohmann::json::array({std::round(time * 1e3) / 1e3, "o", output}).dump() + "\n";
    if (time <= longest_image) {
        for (int row = 0; row < Picture::rows; ++row)
            for (int column = 0; column < Picture::columns; ++column) {
                Shown& shown = shown_[place_of(row, column)];
                const Cell& now = picture.at(row, column);
                if (shown.cell == now) continue;
                over_.push_back({row, column, shown.cell, shown.since, time});
                shown = {now, time};
            }
    }
    last_ = picture;
    empty_ = false;
}

std::string Film::cast(const std::string& title) const {
    const nlohmann::ordered_json head = {{"version", 2},
                                         {"width", Picture::columns},
                                         {"height", Picture::rows},
                                         {"title", title},
                                         {"env", {{"TERM", "xterm-256color"}}}};
    return head.dump() + "\n" + events_;
}

// The spans that are not blank, in the order in which they are joined.
std::vector<Film::Span> Film::spans() const {
    std::vector<Span> all = over_;
    const double end = std::min(end_, longest_image);
    for (int row = 0; row < Picture::rows; ++row)
        for (int column = 0; column < Picture::columns; ++column) {
            const Shown& shown = shown_[place_of(row, column)];
            all.push_back({row, column, shown.cell, shown.since, end});
        }
    std::erase_if(all, [](const Span& s) { return s.cell.glyph == L' ' || s.begin >= s.end; });
    std::sort(all.begin(), all.end(), [](const Span& a, const Span& b) {
        return std::tie(a.begin, a.end, a.row, a.column) <
               std::tie(b.begin, b.end, b.row, b.column);
    });
    return all;
}

std::string Film::svg(const std::string& title) const {
    const double length = std::max(std::min(end_, longest_image), 1e-3);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" role=\"img\">\n<title>{2}</title>\n"
        "<style>text{{font:{3}px ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace;"
        "white-space:pre}}",
        image_width, image_height, escaped(title), font_size);
    for (int ink = 0; ink < inks; ++ink)
        text += fmt::format(".{}{{fill:#{:06x}}}", static_cast<char>('a' + ink), colours[ink].rgb);
    text += fmt::format("</style>\n<rect width=\"{}\" height=\"{}\" rx=\"8\" fill=\"#16181d\"/>\n",
                        image_width, image_height);
    const std::vector<Span> all = spans();
    for (std::size_t i = 0; i < all.size();) {
        const double begin = all[i].begin, end = all[i].end;
        const bool always = begin <= 0 && end >= length;
        if (!always) text += beginning_of_group(begin / length, end / length, length);
        while (i < all.size() && all[i].begin == begin && all[i].end == end) {
            std::size_t next = i + 1;
            std::wstring run(1, all[i].cell.glyph);
            while (next < all.size() && all[next].begin == begin && all[next].end == end &&
                   all[next].row == all[i].row && all[next].column == all[next - 1].column + 1 &&
                   joins(all[next - 1].cell, all[next].cell))
                run += all[next++].cell.glyph;
            text +=
                drawn(all[i].row, all[i].column, static_cast<int>(next - i), run, all[i].cell.ink);
            i = next;
        }
        text += always ? "\n" : "</g>\n";
    }
    return text + "</svg>\n";
}

}  // namespace live
