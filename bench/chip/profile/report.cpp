// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "bench/chip/profile/short_name.hpp"

namespace profile {
namespace {

constexpr std::size_t name_width = 34;

double share(Cycle part, Cycle whole) {
    return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

std::string cells(const Spread& spread, int column) {
    if (!spread.count) return fmt::format("{0:>{1}} {0:>{1}} {0:>{1}}", "-", column);
    return fmt::format("{:>{}} {:>{}.1f} {:>{}}", spread.min, column, spread.mean(), column,
                       spread.max, column);
}

std::string bytes_or_dash(const std::optional<unsigned>& bytes) {
    return bytes ? fmt::format("{}", *bytes) : "-";
}

std::string bound_text(const StackBound& bound, unsigned measured) {
    std::string text = fmt::format("Stack: {} bytes measured, ", measured);
    if (bound.bytes)
        text += fmt::format("at most {} by the machine code:\n", *bound.bytes);
    else
        text += "without a bound by the machine code:\n";
    for (const std::string& reason : bound.unbounded) text += fmt::format("  {}\n", reason);
    if (!bound.bytes) return text;
    std::vector<std::string> path;
    for (const std::string& function : bound.path) path.push_back(short_name(function));
    text += fmt::format("  {} for {}\n", bound.path_bytes, fmt::join(path, " > "));
    if (!bound.interrupts.empty())
        text += fmt::format("  {} for {}\n", bound.interrupt_bytes,
                            fmt::join(bound.interrupts, " in "));
    for (const std::string& handler : bound.interruptible)
        text += fmt::format("  provided that {} is not interrupted by itself\n", handler);
    return text;
}

}  // namespace

std::string readable_report(const Profile& profile, const StackBound& bound) {
    std::map<std::string, std::optional<unsigned>> bounds;
    for (const FunctionBound& function : bound.functions)
        bounds[function.name] = function.stack_bytes;

    std::string text = fmt::format(
        "{} cycles, {:.3f} ms\n\n"
        "{:<{}} {:>8} {:>12} {:>6} {:>12} {:>6} {:>26} {:>17}\n"
        "{:<{}} {:>8} {:>12} {:>6} {:>12} {:>6} {:>8} {:>8} {:>8} {:>5} {:>5} {:>5}\n",
        profile.elapsed, 1e3 * static_cast<double>(profile.elapsed) / simulator::Chip::frequency,
        "", name_width, "", "self", "", "inclusive", "", "cycles a call", "stack bytes", "function",
        name_width, "calls", "cycles", "%", "cycles", "%", "min", "mean", "max", "frame", "all",
        "bound");
    for (const FunctionCost& function : profile.functions) {
        const auto known = bounds.find(function.name);
        text += fmt::format(
            "{:<{}} {:>8} {:>12} {:>6.2f} {:>12} {:>6.2f} {} {:>5} {:>5} {:>5}\n",
            short_name(function.name), name_width, function.calls, function.self_cycles,
            100 * share(function.self_cycles, profile.elapsed), function.inclusive_cycles,
            100 * share(function.inclusive_cycles, profile.elapsed), cells(function.per_call, 8),
            function.frame_bytes, function.stack_bytes,
            known == bounds.end() ? "" : bytes_or_dash(known->second));
    }
    if (!profile.interrupts.empty()) {
        text += fmt::format(
            "\n{:<20} {:>8} {:>26} {:>26}\n{:<20} {:>8} {:>8} {:>8} {:>8} {:>8} "
            "{:>8} {:>8}\n",
            "", "", "latency, cycles", "duration, cycles", "interrupt", "count", "min", "mean",
            "max", "min", "mean", "max");
        for (const InterruptCost& interrupt : profile.interrupts)
            text += fmt::format("{:<20} {:>8} {} {}\n", interrupt.name, interrupt.entries,
                                cells(interrupt.latency, 8), cells(interrupt.duration, 8));
    }
    return text + '\n' + bound_text(bound, profile.stack_bytes);
}

}  // namespace profile
