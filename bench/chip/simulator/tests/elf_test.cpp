// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/elf.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "programs.hpp"

namespace simulator {
namespace {

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const ElfError& error) {
        return error.what();
    }
    return "no exception";
}

TEST(ElfTest, HasFunctionsObjectsAndSizes) {
    const Elf elf = test_program("calls");
    EXPECT_EQ(elf.function("negate_int8").size, 4u);  // neg, ret
    EXPECT_EQ(elf.object("scale").size, 2u);
    EXPECT_GE(elf.object("scale").address, Chip::ram_begin);
    EXPECT_EQ(elf.flash_bytes(), elf.flash().size());
    EXPECT_GE(elf.ram_bytes(), 2u);
    EXPECT_EQ(elf.describe(elf.function("dot3").address + 2), "dot3+2");
}

TEST(ElfTest, InitialValuesOfDataAreInFlash) {
    const Elf elf = test_program("calls");
    const auto& flash = elf.flash();
    const std::uint8_t thousand[] = {1000 & 0xff, 1000 >> 8};
    const std::uint32_t load_address =
        elf.function("__data_load_start").address + elf.object("scale").address - Chip::ram_begin;
    EXPECT_EQ(flash.at(load_address), thousand[0]);
    EXPECT_EQ(flash.at(load_address + 1), thousand[1]);
}

TEST(ElfTest, SymbolsMadeByTheLinkerAreFunctionsToo) {
    const Elf elf = test_program("calls");
    EXPECT_EQ(elf.function("product_int32").address, elf.function("multiply_int32").address);
    EXPECT_EQ(elf.function("product_int32").size, elf.function("multiply_int32").size);
}

TEST(ElfTest, HashIsThatOfSha256sum) {
    const auto path = std::filesystem::path(testing::TempDir()) / "abc";
    std::ofstream(path) << "abc";
    EXPECT_NE(message_of([&] { Elf{path}; }).find("not an ELF file"), std::string::npos);
    EXPECT_EQ(sha256_of(std::array<std::uint8_t, 3>{'a', 'b', 'c'}),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    const Elf program = test_program("calls");
    EXPECT_EQ(program.sha256(), sha256_of(program.flash()));
}

// Each byte of the ELF header and of the symbol table's header, as all zeros and all ones: the file
// is read or refused, and one whose entries have no size is refused.
TEST(ElfTest, ADamagedHeaderIsReadOrRefused) {
    const Elf intact = test_program("calls");
    std::ifstream stream(intact.path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    const auto number = [&](std::size_t at, int size) {
        std::size_t value = 0;
        for (int i = size; i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(bytes.at(at + std::size_t(i)));
        return value;
    };
    constexpr std::size_t header = 52, entry = 40, type_of_symbols = 2, entry_size = 36;
    std::size_t symbols = number(0x20, 4);
    while (number(symbols + 4, 4) != type_of_symbols) symbols += entry;

    const auto path = std::filesystem::path(testing::TempDir()) / "damaged.elf";
    const auto message_with = [&](std::size_t at, std::size_t count, char byte) {
        std::string damaged = bytes;
        damaged.replace(at, count, count, byte);
        std::ofstream(path, std::ios::binary) << damaged;
        return message_of([&] { Elf{path}; });
    };
    for (const char byte : {'\0', '\xff'}) {
        for (std::size_t i = 0; i < header; ++i) message_with(i, 1, byte);
        for (std::size_t i = 0; i < entry; ++i) message_with(symbols + i, 1, byte);
    }
    EXPECT_EQ(message_with(symbols + entry_size, 4, '\0'),
              path.string() + ": its table of symbols is damaged");
}

TEST(ElfTest, SaysWhatIsWrongWithAFile) {
    EXPECT_EQ(message_of([] { Elf{"/no/such.elf"}; }), "/no/such.elf: cannot be opened");
    EXPECT_EQ(message_of([] { Elf{"/proc/self/exe"}; }),
              "/proc/self/exe: not a linked program for the AVR");
    const std::string message = message_of([] { test_program("calls").function("multply_int32"); });
    EXPECT_NE(message.find("no symbol 'multply_int32'; the closest are: multiply_int32,"),
              std::string::npos)
        << message;
}

}  // namespace
}  // namespace simulator
