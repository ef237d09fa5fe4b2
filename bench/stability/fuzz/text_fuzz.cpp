// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: every parser of text: decimal numbers, CSV, sensor readings and the command line. Bad
// input is refused, by a status or an exception of one line; nothing else may happen.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/text.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "bench/calibration/readings.hpp"
#include "bench/records/csv.hpp"
#include "bench/records/whole_file.hpp"
#include "bench/stability/command.hpp"

namespace {

void check(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

// What was read and printed reads as the same number.
template <class Number>
void decimal(std::string_view text) {
    const auto parsed = fixedpoint::parse<Number>(text.data(), text.size());
    char buffer[fixedpoint::text_capacity<Number>()];
    const std::size_t size = fixedpoint::print(parsed.number, buffer, sizeof buffer);
    const auto again = fixedpoint::parse<Number>(buffer, size);
    check(again.number == parsed.number, "a printed number reads as another one");
    check(parsed.position <= text.size(), "reading stopped behind the end");
}

template <class Function>
void refuses(Function function) {
    try {
        function();
    } catch (const std::exception& error) {
        check(std::string_view(error.what()).find('\n') == std::string_view::npos,
              "an error of more than one line");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    static const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("text_fuzz." + std::to_string(getpid()));
    switch (data[0] % 4) {
        case 0:
            decimal<fixedpoint::Q8_8>(text);
            decimal<fixedpoint::Q16_16>(text);
            decimal<fixedpoint::Q32_32>(text);
            decimal<fixedpoint::Fixed<8, 24>>(text);
            break;
        case 1:
            records::write_whole(file, text);
            refuses([] {
                const records::Table table = records::Table::load(file);
                const std::string csv = table.to_csv();
                records::write_whole(file, csv);
                check(records::Table::load(file).to_csv() == csv, "a table saved is another one");
            });
            break;
        case 2:
            records::write_whole(file, text);
            refuses([] { calibration::load_readings(file); });
            break;
        case 3: {
            CLI::App app;
            fixbench::Action action;
            stability::add_stability_command(app, action);
            std::istringstream words{std::string(text)};
            std::vector<std::string> arguments;
            for (std::string word; words >> word;) arguments.insert(arguments.begin(), word);
            try {
                app.parse(arguments);
            } catch (const CLI::ParseError&) {
            }
            break;
        }
    }
    return 0;
}
