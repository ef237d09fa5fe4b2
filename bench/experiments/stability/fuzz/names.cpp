// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: names with a meaning (formats, operations, symbols of subjects, operand classes,
// shards), and the command line of the battery.
#include "bench/lab/program/names.hpp"

#include <sstream>
#include <vector>

#include "bench/experiments/exhaustive/exhaustive.hpp"
#include "bench/experiments/stability/fuzz/refusal.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "reference/operation.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    // What a shell passes on: a message quotes it unchanged.
    for (const char c : text)
        if (static_cast<unsigned char>(c) < ' ') return -1;
    switch (data[0] % 6) {
        case 0:
            fuzz::takes([&] {
                const reference::NumberFormat format = reference::parse_format(text);
                fuzz::check(format_name(format) == text, "a format of another name");
            });
            break;
        case 1:
            fuzz::takes([&] { reference::parse_operation(text); });
            break;
        case 2:
            fuzz::takes([&] { reference::parse_symbol(text); });
            break;
        case 3:
            fuzz::takes([&] {
                fuzz::check(class_name(operands::parse_class(text)) == text,
                            "a class of another name");
            });
            break;
        case 4:
            fuzz::takes([&] {
                const machine_code::Shard shard = machine_code::parse_shard(text);
                fuzz::check(1 <= shard.index && shard.index <= shard.count, "no such shard");
            });
            break;
        case 5:
            fuzz::takes([&] {
                std::istringstream words(text);
                std::vector<std::string> names;
                for (std::string word; words >> word;) names.push_back(word);
                fixbench::check_names("--name", names, {"q8_8", "q16_16", "float"});
            });
            break;
    }
    return 0;
}
