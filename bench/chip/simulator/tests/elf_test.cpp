// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/elf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>

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

// A program's bytes to damage; fields are those of the ELF specification for 32 bits.
class DamagedElfTest : public testing::Test {
  protected:
    static constexpr std::size_t e_type = 0x10, e_machine = 0x12, e_phoff = 0x1c, e_shoff = 0x20,
                                 e_flags = 0x24, e_phentsize = 0x2a, e_phnum = 0x2c,
                                 e_shentsize = 0x2e, e_shnum = 0x30, e_shstrndx = 0x32;
    static constexpr std::size_t header_size = 52, segment_size = 32, section_size = 40;
    static constexpr std::size_t p_offset = 4, p_paddr = 12, p_filesz = 16;
    static constexpr std::size_t sh_type = 4, sh_addr = 12, sh_offset = 16, sh_size = 20,
                                 sh_link = 24, sh_entsize = 36;
    static constexpr std::uint32_t symtab = 2, strtab = 3, note = 7;
    static constexpr std::size_t st_value = 4, st_size = 8, symbol_size = 16;

    DamagedElfTest() {
        std::ifstream stream(test_program("calls").path(), std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(stream), {});
    }
    std::uint32_t number(std::size_t at, int size = 4) const {
        std::uint32_t value = 0;
        std::memcpy(&value, &bytes.at(at), std::size_t(size));
        return value;
    }
    void set(std::size_t at, std::uint32_t value, int size = 4) {
        std::memcpy(&bytes.at(at), &value, std::size_t(size));
    }
    std::size_t section(std::uint32_t type) const {
        std::size_t at = number(e_shoff);
        while (number(at + sh_type) != type) at += section_size;
        return at;
    }
    std::size_t segment(int index) const {
        return number(e_phoff) + std::size_t(index) * segment_size;
    }
    // Some file systems wait for the disk when a file is truncated and rewritten.
    void write() const {
        std::filesystem::remove(path);
        std::ofstream(path, std::ios::binary) << bytes;
    }
    // The message about the bytes, without the path; empty if they are accepted.
    std::string message() const {
        write();
        const std::string text = message_of([&] { Elf{path}; });
        if (text == "no exception") return "";
        EXPECT_EQ(text.find(path.string() + ": "), 0u) << text;
        EXPECT_EQ(text.find('\n'), text.npos) << text;
        return text.substr(path.string().size() + 2);
    }
    void expect(const std::string& expected) const { EXPECT_EQ(message(), expected); }

    std::string bytes;
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) /
        fmt::format("damaged.{}.elf",
                    testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(DamagedElfTest, ProgramsForOtherChipsAreRefused) {
    const std::size_t name = bytes.find("atmega328p");
    ASSERT_NE(name, bytes.npos);
    const auto rename = [&](std::string other) {
        other.resize(std::strlen("atmega328p"));  // filled with zeros, which end it
        bytes.replace(name, other.size(), other);
    };
    for (const char* other : {"atmega644", "atmega644p", "atmega2560", "attiny85", "atmega168"}) {
        rename(other);
        expect(std::string("built for the ") + other + ", not for the atmega328p");
    }
    rename("atmega328");  // the same chip without the P's lower power
    expect("");
    // Without the note, the architecture decides.
    set(section(note) + sh_type, 1);
    expect("");
    for (const std::uint32_t architecture : {6, 25, 51}) {
        set(e_flags, architecture);
        expect("built for the architecture avr:" + std::to_string(architecture) +
               "; the atmega328p is an avr:5");
    }
}

TEST_F(DamagedElfTest, ProgramsThatDoNotFitAreRefused) {
    const std::string intact = bytes;
    set(segment(0) + p_paddr, 0x7fff);
    expect(std::to_string(0x7fff + number(segment(0) + p_filesz)) +
           " bytes do not fit into 32768 bytes of flash");
    bytes = intact;
    set(segment(0) + p_paddr, 2);  // over the initial values of data
    expect("two of its segments overlap");
    bytes = intact;
    std::size_t data = number(e_shoff);
    while (number(data + sh_addr) < 0x800000 || !number(data + sh_size)) data += section_size;
    set(data + sh_size, 0x801);
    expect("data from 0x100 to 0x900 is not in the RAM, 0x100 to 0x8ff");
    set(data + sh_size, 0xffffffff);
    EXPECT_NE(message(), "");
    set(data + sh_size, 1);
    set(data + sh_addr, 0x8000ff);  // an I/O register
    expect("data from 0xff to 0xff is not in the RAM, 0x100 to 0x8ff");
}

TEST_F(DamagedElfTest, AnotherMachineOrKindIsRefused) {
    set(e_machine, 40, 2);  // Arm
    expect("not a linked program for the AVR");
    set(e_machine, 83, 2);
    expect("");
    set(e_type, 1, 2);  // an object file
    expect("not a linked program for the AVR");
}

TEST_F(DamagedElfTest, TablesAreCheckedEntryByEntry) {
    const std::string intact = bytes;
    const auto damaged = [&](std::size_t at, std::uint32_t value, int size, const char* part) {
        set(at, value, size);
        const std::string text = message();
        EXPECT_TRUE(text == std::string("its ") + part + " is damaged" ||
                    text == "not an ELF file" || text == "nothing to load")
            << part << " at " << at << ": " << text;
        bytes = intact;
    };
    const std::size_t symbols = section(symtab), about = section(note),
                      names = number(e_shoff) + number(symbols + sh_link) * section_size;
    for (const std::uint32_t huge : {0x7fffffffu, 0xfffffff0u, 0xffffffffu}) {
        damaged(e_phoff, huge, 4, "table of segments");
        damaged(e_shoff, huge, 4, "table of sections");
        damaged(segment(0) + p_offset, huge, 4, "segment");
        damaged(symbols + sh_offset, huge, 4, "table of symbols");
        damaged(symbols + sh_size, huge, 4, "table of symbols");
        damaged(symbols + sh_link, huge, 4, "table of names");
        damaged(names + sh_offset, huge, 4, "table of names");
        damaged(about + sh_offset, huge, 4, "note");
        damaged(number(about + sh_offset) + 4, huge, 4, "note");        // the description's size
        damaged(number(about + sh_offset) + 16 + 24, huge, 4, "note");  // of its table of names
    }
    damaged(symbols + sh_entsize, 0, 4, "table of symbols");
    for (std::size_t i = 1; i < 20; ++i) {
        const std::size_t entry = number(symbols + sh_offset) + i * symbol_size;
        damaged(entry, 0x7fffffff, 4, "table of names");
        damaged(entry + st_size, 0xffffffff, 4, "table of symbols");
    }
    for (const std::size_t field : {e_phentsize, e_phnum, e_shentsize, e_shnum, e_shstrndx})
        for (const std::uint32_t value : {0u, 1u, 0xffffu}) {
            bytes = intact;
            set(field, value, 2);
            message();  // read or refused, in one line
        }
}

TEST_F(DamagedElfTest, EndsAnywhere) {
    const std::string intact = bytes;
    for (std::size_t size = 0; size < intact.size(); size += 1 + size / 16) {
        bytes.resize(size);
        EXPECT_NE(message(), "") << size;
        bytes = intact;
    }
}

TEST_F(DamagedElfTest, AnyByteOfItsTables) {
    const std::string intact = bytes;
    std::vector<std::size_t> places(header_size);
    std::iota(places.begin(), places.end(), 0);
    for (const std::size_t table : {segment(0), section(symtab), section(strtab), section(note),
                                    std::size_t(number(section(note) + sh_offset))})
        for (std::size_t i = 0; i < section_size; ++i) places.push_back(table + i);
    for (const std::size_t at : places)
        for (const char byte : {'\0', '\1', '\x7f', '\x80', '\xff'}) {
            bytes[at] = byte;
            message();
            bytes = intact;
        }
}

// Thousands of random faults, quickly: what is refused is refused early, what is read is complete.
TEST_F(DamagedElfTest, RandomFaults) {
    const std::string intact = bytes;
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        for (int count = int(random() % 4); count >= 0; --count)
            bytes[random() % bytes.size()] = char(random());
        write();
        try {
            const Elf elf(path);
            EXPECT_LE(elf.flash().size(), Elf::flash_size);
            EXPECT_LE(elf.ram_bytes(), Elf::ram_end - Elf::ram_begin);
            for (const auto& [name, symbol] : elf.functions())
                EXPECT_LE(symbol.address + symbol.size, elf.flash().size()) << name;
            Chip chip(elf);
            chip.run_until_function("main", 10000);
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
        bytes = intact;
    }
}

TEST(ElfTest, ReportsWhatIsWrongWithAFile) {
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
