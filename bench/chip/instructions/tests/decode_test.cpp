// SPDX-License-Identifier: GPL-3.0-or-later
// The decoder, compared with avr-objdump for every opcode word.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "bench/chip/instructions/instruction.hpp"

namespace instructions {
namespace {

constexpr std::uint32_t opcodes = 0x10000;
constexpr std::uint16_t second_word = 0x5123;  // one instruction of one word, if it is one

// Each opcode word, followed by a second word.
std::vector<std::uint8_t> every_opcode() {
    std::vector<std::uint8_t> bytes;
    for (std::uint32_t opcode = 0; opcode < opcodes; ++opcode)
        for (const std::uint32_t word : {opcode, std::uint32_t(second_word)}) {
            bytes.push_back(std::uint8_t(word));
            bytes.push_back(std::uint8_t(word >> 8));
        }
    return bytes;
}

// "ldi\tr24, 0x0A\t; 10" to "ldi r24, 0x0a".
std::string normalised(std::string text) {
    text = text.substr(0, text.find(';'));
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    std::replace(text.begin(), text.end(), '\t', ' ');
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

// The disassembly by address.
std::map<std::uint32_t, std::string> objdump(const std::vector<std::uint8_t>& bytes) {
    const auto path =
        std::filesystem::temp_directory_path() / fmt::format("every_opcode.{}.bin", getpid());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
    const std::string command = fmt::format(
        "avr-objdump --disassemble-all --disassemble-zeroes --target=binary "
        "--architecture=avr5 {}",
        path.string());
    std::map<std::uint32_t, std::string> lines;
    {
        const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
        char line[200];
        while (pipe && std::fgets(line, sizeof line, pipe.get())) {
            // "   4:\t01 00       \t.word\t0x0001\t; ????"
            unsigned address;
            const std::string text = line;
            const std::size_t first = text.find('\t'), second = text.find('\t', first + 1);
            if (second == text.npos || std::sscanf(line, "%x:", &address) != 1) continue;
            lines[address] = normalised(text.substr(second + 1));
        }
    }
    std::filesystem::remove(path);
    return lines;
}

TEST(DecodeTest, AgreesWithObjdumpOnEveryOpcode) {
    const std::vector<std::uint8_t> bytes = every_opcode();
    const auto expected = objdump(bytes);
    ASSERT_GE(expected.size(), opcodes);
    for (std::uint32_t opcode = 0; opcode < opcodes; ++opcode) {
        const Instruction decoded = decode(bytes, 4 * opcode);
        const std::string& truth = expected.at(4 * opcode);
        ASSERT_EQ(normalised(decoded.text()), truth) << fmt::format("opcode 0x{:04x}", opcode);
        // objdump puts the second word on a line of its own unless it belongs to the first.
        ASSERT_EQ(decoded.size() == 4, !expected.contains(4 * opcode + 2)) << truth;
    }
}

TEST(DecodeTest, TargetsOfJumpsAreByteAddresses) {
    const std::vector<std::uint8_t> flash = {0xff, 0xcf, 0x09, 0xf4, 0x0e, 0x94, 0x34, 0x12};
    EXPECT_EQ(decode(flash, 0).target(), 0u);       // rjmp .-2
    EXPECT_EQ(decode(flash, 2).target(), 6u);       // brne .+2
    EXPECT_EQ(decode(flash, 4).target(), 0x2468u);  // call 0x2468
    EXPECT_THROW(decode(flash, 8), std::out_of_range);
}

}  // namespace
}  // namespace instructions
