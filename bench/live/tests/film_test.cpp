// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/film.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "bench/live/pace.hpp"

namespace live {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Bar, FillsInEighthsFromOneShareToTheOther) {
    EXPECT_EQ(bar(4, 0, 0), L"\u00b7\u00b7\u00b7\u00b7");
    EXPECT_EQ(bar(4, 0, 1), L"\u2588\u2588\u2588\u2588");
    EXPECT_EQ(bar(4, 0, 0.25 + 1.0 / 32), L"\u2588\u258f\u00b7\u00b7");
    EXPECT_EQ(bar(4, 0.5, 0.25), L"\u00b7\u2588\u00b7\u00b7");
    EXPECT_EQ(bar(4, 0.375, 0.5), L"\u00b7\u2590\u00b7\u00b7");
    EXPECT_EQ(bar(4, -3, 7), bar(4, 0, 1));
}

TEST(Utf8, TakesOneToThreeBytes) {
    EXPECT_EQ(utf8(L'a'), "a");
    EXPECT_EQ(utf8(L'\u00b0'), "\xc2\xb0");
    EXPECT_EQ(utf8(L'\u2588'), "\xe2\x96\x88");
}

TEST(Picture, CutsWhatReachesBeyondItsEdge) {
    Picture picture;
    picture.put(3, Picture::columns - 2, L"abcd");
    EXPECT_EQ(picture.at(3, Picture::columns - 1).glyph, L'b');
    EXPECT_EQ(picture.at(4, 0).glyph, L' ');
}

// A terminal that understands what a cast may contain, and nothing else.
std::vector<std::wstring> played(const std::string& cast, double until) {
    std::vector<std::wstring> screen(Picture::rows, std::wstring(Picture::columns, L' '));
    std::istringstream lines(cast);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        const auto event = nlohmann::json::parse(line);
        if (event[0].get<double>() > until) break;
        const std::string text = event[2];
        std::size_t row = 0, column = 0;
        for (std::size_t i = 0; i < text.size();) {
            std::smatch move;
            const std::string rest = text.substr(i);
            if (std::regex_search(rest, move, std::regex("^\x1b\\[([0-9;?]*)([HJlm])"))) {
                if (move[2] == "H") {
                    row = std::stoul(move[1]) - 1;
                    column = std::stoul(move[1].str().substr(move[1].str().find(';') + 1)) - 1;
                }
                i += move.length();
                continue;
            }
            const auto first = static_cast<unsigned char>(text[i]);
            const std::size_t bytes = first < 0x80 ? 1 : first < 0xe0 ? 2 : 3;
            wchar_t glyph = bytes == 1 ? first : first & (bytes == 2 ? 0x1f : 0x0f);
            for (std::size_t k = 1; k < bytes; ++k)
                glyph = static_cast<wchar_t>(glyph << 6 | (text[i + k] & 0x3f));
            screen.at(row).at(column++) = glyph;
            i += bytes;
        }
    }
    return screen;
}

class ThreePictures : public testing::Test {
  protected:
    ThreePictures() {
        first_.put(2, 5, L"one & <two>", Ink::title);
        first_.put(9, 70, L"\u2588\u2588\u2592", Ink::weight);
        first_.put(11, 0, L"ab", Ink::dim);
        first_.put(11, 2, L"cd", Ink::warning);
        second_ = first_;
        second_.put(2, 5, L"1  ");
        third_ = second_;
        third_.put(9, 71, L" ");
        film_.add(0, first_);
        film_.add(0.5, second_);
        film_.add(0.7, second_);
        film_.add(1, third_);
        film_.end(2);
    }
    static void expect_shown(const Picture& picture, const std::vector<std::wstring>& screen) {
        for (int row = 0; row < Picture::rows; ++row)
            for (int column = 0; column < Picture::columns; ++column)
                ASSERT_EQ(screen[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)],
                          picture.at(row, column).glyph)
                    << row << ' ' << column;
    }
    Picture first_, second_, third_;
    Film film_;
};

TEST_F(ThreePictures, AreWhatATerminalShowsThatPlaysTheCast) {
    const std::string cast = film_.cast("title");
    const auto head = nlohmann::json::parse(cast.substr(0, cast.find('\n')));
    EXPECT_EQ(head["version"], 2);
    EXPECT_EQ(head["width"], 80);
    EXPECT_EQ(head["height"], 24);
    EXPECT_EQ(std::count(cast.begin(), cast.end(), '\n'), 4);  // the third picture is the second
    expect_shown(first_, played(cast, 0.49));
    expect_shown(second_, played(cast, 0.99));
    expect_shown(third_, played(cast, 2));
}

TEST_F(ThreePictures, AreGroupsOfAnImageThatComeAndGo) {
    const std::string svg = film_.svg("a < b");
    EXPECT_THAT(svg, HasSubstr("<title>a &lt; b</title>"));
    EXPECT_THAT(svg, HasSubstr(">&amp;</text>"));
    EXPECT_THAT(svg, HasSubstr(">&lt;two></text>"));
    EXPECT_THAT(svg, HasSubstr("<text class=\"b\" x=\"12\" y=\"224\" textLength=\"18\">ab</text>"));
    EXPECT_THAT(svg, HasSubstr("<text class=\"h\" x=\"30\" y=\"224\" textLength=\"18\">cd</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("<script")));
    // "one" until 0.5 s, "1" from then on, a block until 1 s; everything else always.
    EXPECT_THAT(svg, HasSubstr("values=\"inline;none\" keyTimes=\"0;0.25000\"/><text"));
    EXPECT_THAT(svg, HasSubstr("values=\"none;inline\" keyTimes=\"0;0.25000\"/><text"));
    EXPECT_THAT(svg, HasSubstr("values=\"inline;none\" keyTimes=\"0;0.50000\"/><path"));
    std::size_t groups = 0;
    for (std::size_t i = svg.find("<g"); i != std::string::npos; i = svg.find("<g", i + 1))
        ++groups;
    EXPECT_EQ(groups, 3u);
}

TEST(Pace, FollowsTheWall) {
    Pace pace(0);
    EXPECT_DOUBLE_EQ(pace.due(0.05, 0.01), 0.05);
    EXPECT_DOUBLE_EQ(pace.due(1.2, 1.2), 1.2);
    EXPECT_DOUBLE_EQ(pace.factor(), 1);
}

// At half the speed of the wall clock it is behind by no more than is allowed, however long it
// takes.
TEST(Pace, GivesUpWhatTheMachineCannotKeepUpWith) {
    Pace pace(0);
    double simulated = 0;
    for (double wall = 0; wall < 60; wall += 0.04) {
        const double due = pace.due(wall, simulated);
        EXPECT_LE(due - simulated, Pace::max_behind + 1e-9);
        simulated = std::min(due, simulated + 0.02);
    }
    EXPECT_NEAR(pace.factor(), 0.5, 0.02);
}

}  // namespace
}  // namespace live
