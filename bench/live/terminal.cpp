// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/terminal.hpp"

#include <fmt/format.h>
#include <langinfo.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>

#define NCURSES_WIDECHAR 1
#include <ncurses.h>

namespace live {
namespace {

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
constexpr int escape = 27;
volatile std::sig_atomic_t caught = 0;

SCREEN* screen = nullptr;
struct sigaction former[std::size(ending_signals)];

void require_window() {
    if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0)
        throw std::runtime_error(
            "the lever needs a terminal for input and output; only --scenario with --record "
            "does not");
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < Picture::columns ||
        size.ws_row < Picture::rows)
        throw std::runtime_error(
            fmt::format("the window has {} x {} cells, at least {} x {} are "
                        "needed",
                        size.ws_col, size.ws_row, Picture::columns, Picture::rows));
}

}  // namespace

Terminal::Terminal() {
    require_window();
    // Only this encoding contains the panel's characters.
    std::setlocale(LC_CTYPE, "");
    if (std::string_view(nl_langinfo(CODESET)) != "UTF-8") std::setlocale(LC_CTYPE, "C.UTF-8");
    // Before ncurses installs its handlers: it ends the program at a signal that nobody handles.
    caught = 0;
    struct sigaction action {};
    action.sa_handler = [](int number) { caught = number; };
    for (std::size_t i = 0; i < std::size(ending_signals); ++i)
        sigaction(ending_signals[i], &action, &former[i]);
    screen = newterm(nullptr, stdout, stdin);
    if (screen == nullptr) {
        for (std::size_t i = 0; i < std::size(ending_signals); ++i)
            sigaction(ending_signals[i], &former[i], nullptr);
        const char* const type = std::getenv("TERM");
        throw std::runtime_error(
            fmt::format("no terminal of the type TERM='{}' is known", type ? type : ""));
    }
    cbreak();
    noecho();
    keypad(stdscr, TRUE);
    set_escdelay(25);
    // Some terminals send these in any mode; Escape alone would end the session.
    for (const auto& [sequence, key] : {std::pair{"\x1b[A", KEY_UP},
                                        {"\x1b[B", KEY_DOWN},
                                        {"\x1b[C", KEY_RIGHT},
                                        {"\x1b[D", KEY_LEFT}})
        define_key(sequence, key);
    curs_set(0);
    if (!has_colors()) return;
    start_color();
    use_default_colors();
    constexpr short few[inks] = {-1,           -1, COLOR_WHITE, COLOR_CYAN,
                                 COLOR_YELLOW, -1, COLOR_GREEN, COLOR_RED};
    for (int ink = 0; ink < inks; ++ink)
        init_pair(static_cast<short>(ink + 1),
                  COLORS >= 256 ? static_cast<short>(colours[ink].terminal) : few[ink], -1);
}

Terminal::~Terminal() {
    endwin();
    delscreen(screen);
    for (std::size_t i = 0; i < std::size(ending_signals); ++i)
        sigaction(ending_signals[i], &former[i], nullptr);
}

void Terminal::show(const Picture& picture) {
    // ncurses reports a new size by the key KEY_RESIZE.
    if (COLS < Picture::columns || LINES < Picture::rows) {
        erase();
        mvaddnstr(
            0, 0,
            fmt::format("too small: {} x {} cells are needed", Picture::columns, Picture::rows)
                .c_str(),
            COLS);
        refresh();
        return;
    }
    for (int row = 0; row < Picture::rows; ++row)
        for (int column = 0; column < Picture::columns; ++column) {
            const Cell& cell = picture.at(row, column);
            const wchar_t text[] = {cell.glyph, 0};
            cchar_t character;
            setcchar(&character, text, cell.ink == Ink::title ? A_BOLD : A_NORMAL,
                     static_cast<short>(static_cast<int>(cell.ink) + 1), nullptr);
            mvadd_wch(row, column, &character);
        }
    refresh();
}

std::optional<Key> Terminal::key(double seconds) {
    timeout(seconds <= 0 ? 0 : static_cast<int>(seconds * 1e3) + 1);
    switch (getch()) {
        case KEY_UP:
        case 'k':
            return Key::push_up;
        case KEY_DOWN:
        case 'j':
            return Key::push_down;
        case ' ':
            return Key::grip;
        case KEY_RIGHT:
        case 'l':
            return Key::dial_up;
        case KEY_LEFT:
        case 'h':
            return Key::dial_down;
        case 'u':
            return Key::unplug;
        case 's':
            return Key::stall;
        case 'f':
            return Key::full_frame;
        case 'r':
            return Key::reset;
        case 'q':
        case escape:
            return Key::quit;
        default:
            return {};
    }
}

int Terminal::signal() { return caught; }

}  // namespace live
