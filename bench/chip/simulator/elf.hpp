// SPDX-License-Identifier: GPL-3.0-or-later
// An ELF file for the ATmega328P: its flash image, symbols, sections and relocations. Addresses of
// functions are flash byte addresses (twice the program counter's word addresses). Addresses of
// data are data-space addresses, without the 0x800000 that the linker adds.
//
// A file is checked as a whole before it is used: programs for other chips, programs that do not
// fit and damaged files are refused, so that every address and size below lies within the chip.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace simulator {

class ElfError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct Symbol {
    std::string name;
    std::uint32_t address;
    std::uint32_t size;  // bytes; 0 if the file does not say
};

// In hexadecimal, in the form of sha256sum.
std::string sha256_of(std::span<const std::uint8_t> bytes);

struct Section {
    std::string name;
    std::uint32_t address;  // as in the file: data at 0x800000 and above
    std::uint32_t size;
    bool in_flash;  // counts towards flash: text, tables, initial values of data
    bool in_ram;    // counts towards RAM: data, bss, noinit
};

// A constant that the linker inserted into an instruction.
struct Relocation {
    unsigned type;         // R_AVR_...
    std::uint32_t target;  // the address that it represents
};

class Elf {
  public:
    static constexpr std::string_view device = "atmega328p";
    static constexpr std::uint32_t flash_size = 0x8000;
    static constexpr std::uint32_t ram_begin = 0x0100;
    static constexpr std::uint32_t ram_end = 0x0900;  // one past the last byte

    // Throws ElfError with one line if there is no such file, or it is not a complete program for
    // the device. The note .note.gnu.avr.deviceinfo says which device a program was built for;
    // without it (no start-up code of avr-libc) the architecture and the sizes must fit.
    explicit Elf(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return path_; }
    // Of the flash image, as `avr-objcopy -O binary -j .text -j .data` writes it. Debugging
    // information, which contains the build folder, does not matter.
    const std::string& sha256() const { return sha256_; }

    // The bytes from flash address 0 to the last byte that the program sets.
    const std::vector<std::uint8_t>& flash() const { return flash_; }
    const std::vector<Section>& sections() const { return sections_; }
    std::uint32_t flash_bytes() const;
    std::uint32_t ram_bytes() const;

    // Throws ElfError with the closest existing names if the name does not exist.
    const Symbol& function(std::string_view name) const { return find(functions_, name); }
    const Symbol& object(std::string_view name) const { return find(objects_, name); }
    bool has_function(std::string_view name) const {
        return functions_.find(name) != functions_.end();
    }

    // Functions, and global labels in flash without a type (assembly labels, the linker's
    // --defsym), which take the size of the function at the same address. By name.
    using Symbols = std::map<std::string, Symbol, std::less<>>;
    const Symbols& functions() const { return functions_; }
    const Symbols& objects() const { return objects_; }

    // Constant tables, in the order of the file.
    const std::vector<Symbol>& flash_objects() const { return flash_objects_; }
    // Relocations of the code, by the address of the instruction. Empty without the linker's
    // --emit-relocs.
    const std::map<std::uint32_t, Relocation>& relocations() const { return relocations_; }

    // "name" or "name+offset" of the function that contains a flash address, for messages.
    std::string describe(std::uint32_t flash_address) const;

  private:
    class Reader;
    const Symbol& find(const Symbols& symbols, std::string_view name) const;

    std::filesystem::path path_;
    std::string sha256_;
    std::vector<std::uint8_t> flash_;
    std::vector<Section> sections_;
    Symbols functions_, objects_;
    std::vector<Symbol> flash_objects_;
    std::map<std::uint32_t, Relocation> relocations_;
};

}  // namespace simulator
