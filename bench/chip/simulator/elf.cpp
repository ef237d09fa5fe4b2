// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/elf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gelf.h>
#include <openssl/evp.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <numeric>

namespace simulator {
namespace {

constexpr std::uint32_t data_origin = 0x800000;    // the linker's address of data space
constexpr std::uint32_t eeprom_origin = 0x810000;  // the linker's address of EEPROM

std::vector<char> read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw ElfError(fmt::format("{}: cannot be opened", path.string()));
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substitution = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substitution, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string sha256_of(std::span<const std::uint8_t> bytes) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    if (!EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr))
        throw ElfError("SHA-256 is not available in libcrypto");
    return fmt::format("{:02x}", fmt::join(digest, digest + length, ""));
}

Elf::Elf(const std::filesystem::path& path) : path_(path) {
    std::vector<char> bytes = read_file(path);
    const auto expect = [&](bool intact, const char* part) {
        if (!intact) throw ElfError(fmt::format("{}: its {} is damaged", path.string(), part));
    };

    elf_version(EV_CURRENT);
    const std::unique_ptr<::Elf, decltype(&elf_end)> file(elf_memory(bytes.data(), bytes.size()),
                                                          &elf_end);
    GElf_Ehdr header;
    if (!file || elf_kind(file.get()) != ELF_K_ELF || !gelf_getehdr(file.get(), &header))
        throw ElfError(fmt::format("{}: not an ELF file", path.string()));
    if (header.e_machine != EM_AVR || header.e_type != ET_EXEC)
        throw ElfError(fmt::format("{}: not a linked program for the AVR", path.string()));

    std::size_t segments = 0;
    expect(elf_getphdrnum(file.get(), &segments) == 0, "table of segments");
    for (std::size_t i = 0; i < segments; ++i) {
        GElf_Phdr segment;
        expect(gelf_getphdr(file.get(), static_cast<int>(i), &segment), "table of segments");
        if (segment.p_type != PT_LOAD || !segment.p_filesz || segment.p_paddr >= data_origin)
            continue;
        expect(
            segment.p_offset <= bytes.size() && segment.p_filesz <= bytes.size() - segment.p_offset,
            "segment");
        const std::size_t end = segment.p_paddr + segment.p_filesz;
        if (end > flash_size)
            throw ElfError(fmt::format("{}: {} bytes do not fit into {} bytes of flash",
                                       path.string(), end, flash_size));
        if (flash_.size() < end) flash_.resize(end, 0xff);
        std::copy_n(bytes.data() + segment.p_offset, segment.p_filesz,
                    reinterpret_cast<char*>(flash_.data()) + segment.p_paddr);
    }
    sha256_ = sha256_of(flash_);
    if (flash_.empty()) throw ElfError(fmt::format("{}: nothing to load", path.string()));

    const auto text = [&](std::size_t section, std::size_t offset) {
        const char* const found = elf_strptr(file.get(), section, offset);
        expect(found, "table of names");
        return std::string(found);
    };
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(file.get(), section));) {
        GElf_Shdr about;
        expect(gelf_getshdr(section, &about), "table of sections");
        if (about.sh_flags & SHF_ALLOC && about.sh_addr < eeprom_origin) {
            const bool in_ram = about.sh_addr >= data_origin;
            sections_.push_back(
                {text(header.e_shstrndx, about.sh_name), static_cast<std::uint32_t>(about.sh_addr),
                 static_cast<std::uint32_t>(about.sh_size), about.sh_type == SHT_PROGBITS, in_ram});
        }
        if (about.sh_type != SHT_SYMTAB) continue;
        Elf_Data* const table = elf_getdata(section, nullptr);
        expect(table && about.sh_entsize, "table of symbols");
        for (int i = 0; i < static_cast<int>(about.sh_size / about.sh_entsize); ++i) {
            GElf_Sym symbol;
            expect(gelf_getsym(table, i, &symbol), "table of symbols");
            const std::string name = text(about.sh_link, symbol.st_name);
            const auto address = static_cast<std::uint32_t>(symbol.st_value);
            const auto size = static_cast<std::uint32_t>(symbol.st_size);
            const int type = GELF_ST_TYPE(symbol.st_info);
            const bool global = GELF_ST_BIND(symbol.st_info) != STB_LOCAL;
            if (name.empty() || symbol.st_shndx == SHN_UNDEF) continue;
            if (address >= data_origin && address < eeprom_origin)
                objects_[name] = {name, address - data_origin, size};
            else if (address < flash_.size() &&
                     (type == STT_FUNC || (type == STT_NOTYPE && global)))
                functions_[name] = {name, address, size};
        }
    }
    for (auto& [name, symbol] : functions_)
        if (!symbol.size)
            for (const auto& [other, twin] : functions_)
                if (twin.address == symbol.address) symbol.size = std::max(symbol.size, twin.size);
}

std::uint32_t Elf::flash_bytes() const {
    std::uint32_t sum = 0;
    for (const Section& section : sections_) sum += section.in_flash ? section.size : 0;
    return sum;
}

std::uint32_t Elf::ram_bytes() const {
    std::uint32_t sum = 0;
    for (const Section& section : sections_) sum += section.in_ram ? section.size : 0;
    return sum;
}

const Symbol& Elf::find(const Symbols& symbols, std::string_view name) const {
    if (const auto found = symbols.find(name); found != symbols.end()) return found->second;
    std::vector<std::pair<std::size_t, std::string_view>> closest;
    for (const auto& [other, symbol] : symbols)
        closest.emplace_back(edit_distance(name, other), other);
    const std::size_t count = std::min<std::size_t>(3, closest.size());
    std::partial_sort(closest.begin(), closest.begin() + count, closest.end());
    closest.resize(count);
    std::vector<std::string_view> names;
    for (const auto& [distance, other] : closest) names.push_back(other);
    throw ElfError(fmt::format("{}: no symbol '{}'; the closest are: {}", path_.string(), name,
                               fmt::join(names, ", ")));
}

std::string Elf::describe(std::uint32_t flash_address) const {
    const Symbol* best = nullptr;
    for (const auto& [name, symbol] : functions_)
        if (symbol.address <= flash_address && flash_address < symbol.address + symbol.size)
            if (!best || symbol.address > best->address) best = &symbol;
    if (!best) return fmt::format("flash address 0x{:04x}", flash_address);
    return fmt::format("{}+{}", best->name, flash_address - best->address);
}

}  // namespace simulator
