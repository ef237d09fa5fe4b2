// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/flame_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "bench/chip/profile/short_name.hpp"

namespace profile {
namespace {

constexpr double width = 1200, margin = 10, bar_height = 18, header = 62;  // pixels
constexpr double character_width = 6.7;  // of 11 pixels' monospace, with some room
constexpr double narrowest = 0.1;        // a bar below this many pixels is not drawn
constexpr double text_padding = 3;

struct Colour {
    std::string_view meaning;
    int hue, saturation, lightness;  // of HSL, in degrees and per cent
};
constexpr Colour program{"program", 32, 85, 70}, kernel{"fixed-point kernels", 208, 65, 74},
    run_time{"compiler's run-time", 150, 38, 70}, interrupt{"interrupts", 350, 70, 78},
    ground_colour{"", 0, 0, 86};
constexpr std::string_view asleep = "(asleep)", kernel_prefix = "fixedpoint_";

struct Bar {
    std::string name;
    Cycle self = 0, inclusive = 0;
    std::vector<Bar> above{};
};

void add(Bar& ground, const StackCost& stack) {
    Bar* bar = &ground;
    bar->inclusive += stack.self_cycles;
    for (const std::string& name : stack.path) {
        auto found = std::ranges::find(bar->above, name, &Bar::name);
        if (found == bar->above.end()) found = bar->above.insert(found, Bar{.name = name});
        bar = &*found;
        bar->inclusive += stack.self_cycles;
    }
    bar->self += stack.self_cycles;
}

void widest_first(Bar& bar) {
    std::ranges::stable_sort(bar.above, std::greater(), &Bar::inclusive);
    for (Bar& next : bar.above) widest_first(next);
}

std::size_t levels(const Bar& bar) {
    std::size_t most = 0;
    for (const Bar& next : bar.above) most = std::max(most, levels(next));
    return most + 1;
}

const Colour& colour_of(const std::string& name, bool in_interrupt) {
    if (name.starts_with(kernel_prefix)) return kernel;
    if (name.starts_with("__") || name.starts_with('(')) return run_time;
    return in_interrupt ? interrupt : program;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '&':
                result += "&amp;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string hsl(const Colour& colour, int lightness) {
    return fmt::format("hsl({},{}%,{}%)", colour.hue, colour.saturation, lightness);
}

// The colour marks kernels.
std::string fitting(const std::string& name, double pixels) {
    std::string label = short_name(name);
    if (label.starts_with(kernel_prefix)) label.erase(0, kernel_prefix.size());
    const auto room = static_cast<std::size_t>(std::max(0.0, pixels / character_width));
    if (label.size() <= room) return label;
    return room < 4 ? "" : label.substr(0, room - 2) + "..";
}

class Drawing {
  public:
    Drawing(const Profile& profile, std::string_view title) {
        Bar ground{.name = "awake"};
        for (const StackCost& stack : profile.stacks)
            if (stack.path.back() != asleep) add(ground, stack);
        widest_first(ground);
        const Cycle whole = std::max<Cycle>(profile.elapsed, 1);
        awake_ = static_cast<double>(std::max<Cycle>(ground.inclusive, 1));
        for (const InterruptCost& vector : profile.interrupts) handlers_.push_back(vector.handler);

        height_ = header + bar_height * static_cast<double>(levels(ground)) + margin;
        text_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
            "height=\"{1}\" font-family=\"monospace\" font-size=\"11\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
            "<text x=\"{2}\" y=\"22\" font-size=\"15\">{3}: awake for {4} cycles, {5:.2f}% of the "
            "time</text>\n",
            width, height_, margin, escaped(title), ground.inclusive,
            100.0 * static_cast<double>(ground.inclusive) / static_cast<double>(whole));
        legend();
        draw(ground, margin, 0, false);
        text_ += "</svg>\n";
    }

    std::string text() && { return std::move(text_); }

  private:
    void legend() {
        double x = margin;
        for (const Colour& colour : {program, kernel, run_time, interrupt}) {
            text_ += fmt::format(
                "<rect x=\"{:.1f}\" y=\"34\" width=\"12\" height=\"12\" fill=\"{}\"/>"
                "<text x=\"{:.1f}\" y=\"44\">{}</text>\n",
                x, hsl(colour, colour.lightness), x + 17, colour.meaning);
            x += 40 + character_width * static_cast<double>(colour.meaning.size());
        }
    }

    void draw(const Bar& bar, double x, int level, bool in_interrupt) {
        const double share = static_cast<double>(bar.inclusive) / awake_;
        const double pixels = share * (width - 2 * margin);
        if (pixels < narrowest) return;
        // The colours of neighbours and callers differ slightly.
        const Colour& colour = level ? colour_of(bar.name, in_interrupt) : ground_colour;
        const int lightness = colour.lightness + (level % 2 ? 0 : 5);
        const double y = height_ - margin - bar_height * (level + 1);
        text_ += fmt::format(
            "<g><title>{0}: {1} cycles ({2:.2f}%), {3} of its own</title>"
            "<rect x=\"{4:.2f}\" y=\"{5:.0f}\" width=\"{6:.2f}\" height=\"{7}\" fill=\"{8}\" "
            "stroke=\"#ffffff\" stroke-width=\"0.6\"/>",
            escaped(bar.name), bar.inclusive, 100 * share, bar.self, x, y, pixels, bar_height,
            hsl(colour, lightness));
        const std::string label = fitting(bar.name, pixels - 2 * text_padding);
        if (!label.empty())
            text_ +=
                fmt::format("<text x=\"{:.2f}\" y=\"{:.0f}\" pointer-events=\"none\">{}</text>",
                            x + text_padding, y + bar_height - 5, escaped(label));
        text_ += "</g>\n";
        for (const Bar& next : bar.above) {
            const bool handler =
                level == 0 && std::ranges::find(handlers_, next.name) != handlers_.end();
            draw(next, x, level + 1, in_interrupt || handler);
            x += static_cast<double>(next.inclusive) / awake_ * (width - 2 * margin);
        }
    }

    double awake_ = 1;  // cycles
    double height_ = 0;
    std::vector<std::string> handlers_;
    std::string text_;
};

}  // namespace

std::string flame_graph(const Profile& profile, std::string_view title) {
    return Drawing(profile, title).text();
}

}  // namespace profile
