// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: decimal text of fixed-point numbers, read by parse() and by a stream.
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/host/stream.hpp>
#include <fixedpoint/text.hpp>
#include <sstream>

#include "bench/experiments/stability/fuzz/refusal.hpp"

namespace {

// A number that was read and printed reads as the same number, by a stream as by parse().
template <class Number>
void read(std::string_view text) {
    using fixedpoint::TextStatus;
    const auto parsed = fixedpoint::parse<Number>(text.data(), text.size());
    fuzz::check(parsed.position <= text.size(), "reading stopped behind the end");
    char buffer[fixedpoint::text_capacity<Number>()];
    const std::size_t size = fixedpoint::print(parsed.number, buffer, sizeof buffer);
    fuzz::check(size <= sizeof buffer, "more printed than there is room for");
    const auto again = fixedpoint::parse<Number>(buffer, size);
    fuzz::check(again.number == parsed.number && again.status == TextStatus::ok,
                "a printed number reads as another one");
    if (parsed.status != TextStatus::ok) return;
    std::istringstream stream{std::string(text)};
    Number streamed;
    stream >> streamed;
    fuzz::check(!stream.fail() && streamed == parsed.number, "a stream reads another number");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    read<fixedpoint::Q4_4>(text);
    read<fixedpoint::Q8_8>(text);
    read<fixedpoint::Q16_16>(text);
    read<fixedpoint::Fixed<8, 24>>(text);
    read<fixedpoint::Q32_32>(text);
    std::istringstream stream{std::string(text)};
    for (fixedpoint::Q16_16 number; stream >> number;) {
    }
    return 0;
}
