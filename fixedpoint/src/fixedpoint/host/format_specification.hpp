// SPDX-License-Identifier: MIT
/// \file
/// The format specification for fmt and std::format: {:[[fill]align][0][width][.decimals][f]}.
/// Numbers are right-aligned by default. As for double, 0 pads with zeros after the sign if no
/// alignment is given. Without decimals the text is the shortest that reads back as the same
/// number.
#pragma once

#include <algorithm>
#include <fixedpoint/host/text.hpp>

namespace fixedpoint {

/// \cond internal
// A formatter of numbers that throws Error at a specification it does not know.
template <class Error>
class NumberFormatter {
  public:
    template <class Context>
    FIXEDPOINT_CONSTEXPR auto parse(Context& context) {
        const char* at = context.begin();
        const char* const end = context.end();
        const auto is_align = [end](const char* c) {
            return c < end && (*c == '<' || *c == '>' || *c == '^');
        };
        if (at != end && *at != '}' && is_align(at + 1)) fill_ = *at++;
        if (is_align(at)) align_ = *at++;
        if (at != end && *at == '0') {
            ++at;
            if (align_ == default_align) align_ = '0';
        }
        width_ = parse_count(at, end);
        if (at != end && *at == '.') {
            const char* const digits = ++at;
            decimals_ = parse_count(at, end);
            if (at == digits) throw Error("decimals are missing behind the point");
        }
        if (at != end && *at == 'f') ++at;
        if (at != end && *at != '}') {
            throw Error("allowed for fixed point: [[fill]align][0][width][.decimals][f]");
        }
        return at;
    }

    template <int IntegerBits, int F, class A, class Context>
    auto format(Fixed<IntegerBits, F, A> number, Context& context) const {
        std::string text =
            decimals_ < 0 ? to_string(number) : to_string(number, static_cast<uint8_t>(decimals_));
        if (align_ == '0') {
            text = fill_behind_sign(text, static_cast<std::size_t>(width_), '0');
        }
        const int padding = std::max(0, width_ - static_cast<int>(text.size()));
        const int left = align_ == '<' ? 0 : align_ == '^' ? padding / 2 : padding;
        auto out = std::fill_n(context.out(), left, fill_);
        out = std::copy(text.begin(), text.end(), out);
        return std::fill_n(out, padding - left, fill_);
    }

  private:
    static FIXEDPOINT_CONSTEXPR int parse_count(const char*& at, const char* end) {
        int count = 0;
        for (; at != end && portable::is_digit(*at); ++at) {
            count = 10 * count + (*at - '0');
            if (count > 255) throw Error("width and decimals are at most 255");
        }
        return count;
    }

    static constexpr char default_align = '\0';

    char fill_ = ' ';
    char align_ = default_align;
    int width_ = 0;
    int decimals_ = -1;
};
/// \endcond

}  // namespace fixedpoint
