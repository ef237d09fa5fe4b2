// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace live {

void Picture::put(int row, int column, std::wstring_view text, Ink ink) {
    for (const wchar_t glyph : text) {
        if (column >= columns) return;
        cells_[row * columns + column++] = {glyph, ink};
    }
}

std::wstring bar(int cells, double from, double to) {
    if (from > to) std::swap(from, to);
    const auto eighths = [&](double share) {
        return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * cells * 8));
    };
    const int begin = eighths(from), end = eighths(to);
    std::wstring text;
    for (int cell = 0; cell < cells; ++cell) {
        const int left = std::clamp(begin - 8 * cell, 0, 8);
        const int right = std::clamp(end - 8 * cell, 0, 8);
        if (right <= left) {
            text += L'\u00b7';  // a dot: the background of the bar
        } else if (left > 2 && right == 8) {
            text += L'\u2590';  // the right half, the only such block on that side
        } else {
            text += static_cast<wchar_t>(L'\u2588' + 8 - right);
        }
    }
    return text;
}

std::string utf8(wchar_t glyph) {
    const auto code = static_cast<std::uint32_t>(glyph);
    const auto tail = [&](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3f)); };
    if (code < 0x80) return {static_cast<char>(code)};
    if (code < 0x800) return {static_cast<char>(0xc0 | code >> 6), tail(0)};
    return {static_cast<char>(0xe0 | code >> 12), tail(6), tail(0)};
}

}  // namespace live
