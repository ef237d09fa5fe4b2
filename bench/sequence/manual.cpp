// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sequence/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace sequence {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
    return app.get_options([](const CLI::Option*) { return true; });
}

std::vector<std::string> flags_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options_of(app))
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

// Text for roff: no line starts with a control character, hyphens are hyphens.
std::string roff(const std::string& text) {
    std::string escaped;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else
            escaped += c;
        begins = c == '\n';
    }
    return escaped;
}

// Lines stay as they are; an empty one starts a paragraph.
std::string paragraphs(const std::string& text) {
    std::string result = ".nf\n";
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find('\n', i), text.size());
        const std::string line = text.substr(i, end - i);
        result += line.empty() ? ".sp\n" : roff(line) + '\n';
        i = end + 1;
    }
    return result + ".fi\n";
}

std::string entries(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : options_of(app)) {
        const std::string type = option->get_type_size() == 0 ? "" : " " + option->get_type_name();
        text += fmt::format(".TP\n.B {}{}\n{}\n", roff(option->get_name(false, true)), roff(type),
                            roff(option->get_description()));
    }
    return text;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
    std::vector<std::string> names = flags_of(app);
    std::string cases;
    for (const CLI::App* command : commands_of(app)) {
        names.push_back(command->get_name());
        cases += fmt::format("        {}) words=\"{}\" ;;\n", command->get_name(),
                             fmt::join(flags_of(*command), " "));
    }
    return fmt::format(
        "# Completion of fixbench for bash. Made by `fixbench completion`.\n"
        "_fixbench() {{\n"
        "    local words current=${{COMP_WORDS[COMP_CWORD]}}\n"
        "    COMPREPLY=()\n"
        "    case $COMP_CWORD in 1) words=\"{}\" ;; *)\n"
        "        case ${{COMP_WORDS[1]}} in\n{}"
        "        esac ;;\n"
        "    esac\n"
        "    case $current in\n"
        "        -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n"
        "        *) [ \"$COMP_CWORD\" -eq 1 ] && COMPREPLY=($(compgen -W \"$words\" -- "
        "\"$current\")) ;;\n"
        "    esac\n"
        "}}\n"
        "complete -o default -F _fixbench fixbench\n",
        fmt::join(names, " "), cases);
}

std::string manual_page(const CLI::App& app) {
    std::string text = fmt::format(
        ".\\\" Made by `fixbench man`.\n.TH FIXBENCH 1\n.SH NAME\nfixbench \\- measures "
        "fixed\\-point "
        "arithmetic on a simulated ATmega328P\n.SH SYNOPSIS\n.B fixbench\n.I command\n[options]\n"
        ".SH DESCRIPTION\n{}.SH OPTIONS\n{}.SH COMMANDS\n",
        paragraphs(app.get_description()), entries(app));
    for (const CLI::App* command : commands_of(app))
        text += fmt::format(".SS {}\n{}{}", roff(command->get_name()),
                            paragraphs(command->get_description()), entries(*command));
    return text +
           ".SH EXIT STATUS\n"
           ".TP\n.B 0\neverything was done, and every check held\n"
           ".TP\n.B 1\na check failed\n"
           ".TP\n.B 2\nthe call or its input was wrong\n";
}

}  // namespace sequence
