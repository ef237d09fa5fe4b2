// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/panel.hpp"

#include <fmt/format.h>
#include <fmt/xchar.h>

namespace live {
namespace {

using haptic::DeviceLoop;

constexpr int screen_row = 1, panel_column = 44, bar_cells = 15;
constexpr double slow = 0.97;  // of real time; below it the panel says so
constexpr const wchar_t* help =
    L"\u2191\u2193 push  space grip  \u2190\u2192 dial  u unplug  s stall  f full frame  r reset  "
    L"q quit";

std::wstring wide(const std::string& ascii) { return {ascii.begin(), ascii.end()}; }

// Two columns per cell, so that it is as wide as it is high; distinguishable without colours, too.
void draw_screen(Picture& picture, const std::vector<std::string>& screen) {
    const std::wstring line(2 * DeviceLoop::columns, L'\u2500');
    picture.put(screen_row, 0, L"\u256d" + line + L"\u256e", Ink::dim);
    picture.put(screen_row, 2, L" screen, as the serial port sends it ", Ink::dim);
    for (int row = 0; row < DeviceLoop::rows; ++row) {
        const int y = screen_row + 1 + row;
        picture.put(y, 0, L"\u2502", Ink::dim);
        for (int column = 0; column < DeviceLoop::columns; ++column) {
            const char cell =
                screen[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            const int x = 1 + 2 * column;
            switch (cell) {
                case '.':
                    picture.put(y, x, L"\u2592\u2592", Ink::rod);
                    break;
                case 'o':
                    picture.put(y, x, L"\u2588\u2588", Ink::weight);
                    break;
                case '#':
                    picture.put(y, x, L"\u2593\u2593", Ink::pivot);
                    break;
                default:
                    picture.put(y, x, std::wstring(2, cell), Ink::dim);
            }
        }
        picture.put(y, 1 + 2 * DeviceLoop::columns, L"\u2502", Ink::dim);
    }
    picture.put(screen_row + 1 + DeviceLoop::rows, 0, L"\u2570" + line + L"\u256f", Ink::dim);
}

// A line of the panel: name, value with its unit, bar.
class Lines {
  public:
    Lines(Picture& picture, int row) : picture_(picture), row_(row) {}

    void line(std::wstring_view name, const std::wstring& value, std::wstring_view bar = L"",
              Ink ink = Ink::measure) {
        picture_.put(row_, panel_column, name, Ink::dim);
        picture_.put(row_, panel_column + 8, fmt::format(L"{:>12}", value));
        picture_.put(row_++, panel_column + 21, bar, ink);
    }
    void measure(std::wstring_view name, const std::wstring& value, double share,
                 Ink ink = Ink::measure) {
        line(name, value, bar(bar_cells, 0, share), ink);
    }
    void text(const std::wstring& text, Ink ink) { picture_.put(row_++, panel_column, text, ink); }
    void space() { ++row_; }

  private:
    Picture& picture_;
    int row_;
};

void draw_state(Lines& lines, const Status& s) {
    std::wstring fault;
    if (s.unplugged)
        fault += fmt::format(L"sensor {} unplugged  ", *s.unplugged == 0 ? L'A' : L'B');
    if (s.stalled) fault += L"servo stalled";
    lines.text(s.held ? L"the hand holds the lever" : L"the lever is free", Ink::plain);
    lines.text(fault, Ink::warning);
}

void draw_plant(Lines& lines, const Status& s) {
    constexpr double travel = haptic::degrees(60), max_force = 10, counts = 1023;
    const auto angle = [&](std::wstring_view name, double value, Ink ink) {
        lines.measure(name, fmt::format(L"{:.2f} \u00b0", value / haptic::degrees(1)),
                      value / travel, ink);
    };
    angle(L"lever", s.lever, Ink::weight);
    angle(L"servo", s.servo, Ink::rod);
    lines.measure(L"pulse", fmt::format(L"{:.0f} \u00b5s", s.pulse * 1e6), (s.pulse - 1e-3) / 1e-3);
    lines.space();
    lines.line(L"hand", fmt::format(L"{:.2f} N", s.hand_force),
               bar(bar_cells, 0.5, 0.5 + s.hand_force / max_force / 2), Ink::weight);
    for (const int sensor : {0, 1})
        lines.measure(sensor == 0 ? L"sensor A" : L"sensor B",
                      fmt::format(L"{:.0f}", s.reading[sensor]), s.reading[sensor] / counts,
                      s.unplugged == sensor ? Ink::warning : Ink::measure);
    lines.space();
    lines.measure(L"dial", fmt::format(L"{:.0f} %", s.dial * 100), s.dial);
    const double arm = s.arm.value_or(0);
    lines.measure(L"arm", s.arm ? fmt::format(L"{:.1f} cm", arm * 100) : L"", arm / 0.48);
}

void draw_timing(Lines& lines, const Status& s) {
    if (!s.loop_rate) {
        lines.line(L"loop", L"\u2013");
        for (int unknown = 0; unknown < 4; ++unknown) lines.space();
        return;
    }
    lines.line(L"loop", fmt::format(L"{:.0f} Hz", *s.loop_rate), L"of steps", Ink::dim);
    lines.measure(L"CPU", fmt::format(L"{:.1f} %", s.cpu_share * 100), s.cpu_share);
    lines.measure(L"drawing", fmt::format(L"{:.1f} %", s.rendering_share * 100), s.rendering_share);
    lines.line(L"late by", s.lateness ? fmt::format(L"{:.3f} ms", *s.lateness * 1e3) : L"\u2013",
               L"at most", Ink::dim);
    lines.line(L"frames", fmt::format(L"{:.0f} /s", s.frames_per_second),
               fmt::format(L"{:.0f} bytes/s", s.bytes_per_second), Ink::dim);
}

}  // namespace

Picture panel(const Session& session, const std::optional<WallClock>& clock) {
    const Status s = session.status();
    Picture picture;
    picture.put(0, 1,
                fmt::format(L"haptic lever  {}  {}", wide(session.firmware().arithmetic),
                            wide(session.scenario().name)),
                Ink::title);
    draw_screen(picture, s.screen);
    Lines lines(picture, screen_row);
    draw_state(lines, s);
    lines.space();
    draw_plant(lines, s);
    lines.space();
    draw_timing(lines, s);
    lines.space();
    lines.line(L"time", fmt::format(L"{:.2f} s", s.time), L"simulated", Ink::dim);
    if (clock) {
        lines.line(L"", fmt::format(L"{:.2f} s", clock->seconds), L"on the wall", Ink::dim);
        const bool behind = clock->factor < slow;
        picture.put(
            0, panel_column,
            fmt::format(L"{:.2f} x real time{}", clock->factor, behind ? L": a slow machine" : L""),
            behind ? Ink::warning : Ink::title);
        picture.put(Picture::rows - 1, 1, help, Ink::dim);
    }
    return picture;
}

}  // namespace live
