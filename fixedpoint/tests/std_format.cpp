// SPDX-License-Identifier: MIT
// Numbers and std::format, with a standard library that has it: the same texts as with fmt.
#include <cstdio>
#include <fixedpoint/host/std_format.hpp>
#include <fixedpoint/literals.hpp>
#include <format>
#include <string>
#include <string_view>

using namespace fixedpoint::literals;

int failures = 0;

void expect(const std::string& text, std::string_view wanted) {
    if (text == wanted) return;
    std::printf("\"%s\" for \"%.*s\"\n", text.c_str(), static_cast<int>(wanted.size()),
                wanted.data());
    ++failures;
}

int main() {
    const fixedpoint::Q16_16 x = -0.38_q16_16;
    expect(std::format("{}", x), "-0.38");
    expect(std::format("{:.3f}", x), "-0.380");
    expect(std::format("{:8}|", x), "   -0.38|");
    expect(std::format("{:<8}|{:^8}|", x, x), "-0.38   | -0.38  |");
    expect(std::format("{:.>9.1f}", x), ".....-0.4");
    expect(std::format("{:08.3}", x), "-000.380");
    try {
        (void)std::vformat("{:x}", std::make_format_args(x));
        expect("no error", "an error");
    } catch (const std::format_error&) {
    }
    return failures;
}
