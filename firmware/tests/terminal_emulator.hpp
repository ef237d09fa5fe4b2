// SPDX-License-Identifier: MIT
// A terminal: takes bytes and stores what its screen shows. Anything that the firmware should not
// send throws.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

class TerminalEmulator {
  public:
    TerminalEmulator(int columns, int lines)
        : columns_(columns), screen_(lines, std::string(columns, '?')) {}

    void take(char character) {
        if (!sequence_.empty() || character == '\x1b') {
            sequence_ += character;
            if (sequence_.size() == 2 && character != '[') fail();
            if (sequence_.size() > 2 && character >= '@' && character <= '~') obey();
        } else if (character == '\r') {
            column_ = 0;
        } else if (character == '\n') {
            if (++line_ == static_cast<int>(screen_.size())) {
                --line_;
                screen_.erase(screen_.begin());
                screen_.push_back(std::string(columns_, ' '));
            }
        } else {
            if (column_ >= columns_ || character < ' ' || character > '~') fail();
            screen_[line_][column_++] = character;
        }
    }
    void take(const std::string& text) {
        for (const char character : text) take(character);
    }

    const std::vector<std::string>& screen() const { return screen_; }
    // The first `lines` lines from the top.
    std::vector<std::string> top(int lines) const {
        return {screen_.begin(), screen_.begin() + lines};
    }
    bool within_sequence() const { return !sequence_.empty(); }

  private:
    void obey() {
        const std::string text = sequence_.substr(2);
        if (text == "2J") {
            for (auto& line : screen_) line.assign(columns_, ' ');
        } else if (text == "K") {
            screen_[line_].replace(column_, std::string::npos, columns_ - column_, ' ');
        } else if (text.back() == 'H') {
            std::size_t end = 0;
            line_ = std::stoi(text, &end) - 1;
            if (text[end] != ';') fail();
            column_ = std::stoi(text.substr(end + 1)) - 1;
            if (line_ < 0 || line_ >= static_cast<int>(screen_.size()) || column_ < 0 ||
                column_ >= columns_)
                fail();
        } else {
            fail();
        }
        sequence_.clear();
    }
    [[noreturn]] void fail() const {
        throw std::runtime_error("the terminal does not understand the byte at line " +
                                 std::to_string(line_ + 1) + ", column " +
                                 std::to_string(column_ + 1));
    }

    int columns_;
    std::vector<std::string> screen_;
    std::string sequence_;
    int line_ = 0, column_ = 0;
};
