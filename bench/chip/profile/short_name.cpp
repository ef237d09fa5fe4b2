// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/short_name.hpp"

#include <cctype>

namespace profile {
namespace {

constexpr std::string_view anonymous = "(anonymous namespace)::", operator_word = "operator";

// "Lever<Q16_16>::step(int)" becomes "Lever::step"; everything before a space is dropped.
std::string without_arguments(std::string_view name) {
    std::string plain;
    int depth = 0;  // in angle brackets
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::string_view rest = name.substr(i);
        if (depth == 0 && rest.starts_with(operator_word)) {
            const std::size_t sign = operator_word.size();
            const std::size_t arguments = rest.substr(sign).starts_with("()") ? sign + 2 : sign;
            return plain + std::string(rest.substr(0, rest.find('(', arguments)));
        }
        const char c = name[i];
        if (c == '<') {
            ++depth;
        } else if (c == '>') {
            --depth;
        } else if (depth == 0 && rest.starts_with(anonymous)) {
            i += anonymous.size() - 1;
        } else if (depth == 0 && c == '(') {
            return plain;
        } else if (depth == 0) {
            c == ' ' ? plain.clear() : plain.push_back(c);
        }
    }
    return plain;
}

}  // namespace

std::string short_name(std::string_view name) {
    const bool in_parentheses = name.starts_with('(') && !name.starts_with(anonymous);
    if (in_parentheses || name.find('(') == std::string_view::npos) return std::string(name);
    const std::string plain = without_arguments(name);
    const std::size_t last = plain.rfind("::");
    if (last == std::string::npos) return plain;
    const std::size_t before = last == 0 ? std::string::npos : plain.rfind("::", last - 1);
    const std::size_t owner = before == std::string::npos ? 0 : before + 2;
    const bool is_class = std::isupper(static_cast<unsigned char>(plain[owner])) != 0;
    return plain.substr(is_class ? owner : last + 2);
}

}  // namespace profile
