// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/instructions/fingerprint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gelf.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <memory>

namespace machine_code {
namespace {

struct Relocation {
    unsigned type;
    std::uint32_t target;  // the symbol's address and the addend
};

struct Object {
    std::uint32_t address, size;
};

// The relocations of the code, by the address of the instruction, and the objects in flash.
struct LinkRecord {
    std::map<std::uint32_t, Relocation> relocations;
    std::vector<Object> tables;

    const Object* table_at(std::uint32_t address) const {
        for (const Object& table : tables)
            if (table.address <= address && address < table.address + table.size) return &table;
        return nullptr;
    }
};

constexpr std::uint32_t data_origin = 0x800000;  // the linker's address of data space

void read_symbols(LinkRecord& record, Elf_Scn* section) {
    Elf_Data* const data = elf_getdata(section, nullptr);
    GElf_Sym symbol;
    for (int i = 0; gelf_getsym(data, i, &symbol); ++i) {
        if (GELF_ST_TYPE(symbol.st_info) == STT_OBJECT && symbol.st_value < data_origin)
            record.tables.push_back(
                {std::uint32_t(symbol.st_value), std::uint32_t(symbol.st_size)});
    }
}

void read_relocations(LinkRecord& record, ::Elf* file, Elf_Scn* section, const GElf_Shdr& about) {
    GElf_Shdr code;
    gelf_getshdr(elf_getscn(file, about.sh_info), &code);
    if (!(code.sh_flags & SHF_EXECINSTR)) return;
    Elf_Data* const data = elf_getdata(section, nullptr);
    Elf_Data* const symbols = elf_getdata(elf_getscn(file, about.sh_link), nullptr);
    GElf_Rela entry;
    for (int i = 0; gelf_getrela(data, i, &entry); ++i) {
        GElf_Sym symbol;
        gelf_getsym(symbols, int(GELF_R_SYM(entry.r_info)), &symbol);
        record.relocations[std::uint32_t(entry.r_offset)] = {
            unsigned(GELF_R_TYPE(entry.r_info)), std::uint32_t(symbol.st_value + entry.r_addend)};
    }
}

LinkRecord read_link_record(const std::filesystem::path& path) {
    elf_version(EV_CURRENT);
    const int descriptor = open(path.c_str(), O_RDONLY);
    const std::unique_ptr<::Elf, decltype(&elf_end)> file(
        elf_begin(descriptor, ELF_C_READ_MMAP, nullptr), &elf_end);
    LinkRecord record;
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(file.get(), section));) {
        GElf_Shdr about;
        gelf_getshdr(section, &about);
        if (about.sh_type == SHT_SYMTAB) read_symbols(record, section);
        if (about.sh_type == SHT_RELA) read_relocations(record, file.get(), section, about);
    }
    close(descriptor);
    if (record.relocations.empty())
        throw TranslationError(fmt::format(
            "{}: linked without --emit-relocs, so that a function's tables are not known",
            path.string()));
    return record;
}

std::string sha256(const std::string& text) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    if (!EVP_Digest(text.data(), text.size(), digest, &length, EVP_sha256(), nullptr))
        throw std::runtime_error("SHA-256 is not available in libcrypto");
    return fmt::format("{:02x}", fmt::join(digest, digest + length, ""));
}

}  // namespace

std::string fingerprint(const simulator::Elf& elf, std::string_view symbol) {
    const LinkRecord record = read_link_record(elf.path());
    const ControlFlow flow = control_flow(elf, symbol);
    std::map<std::uint32_t, std::size_t> ordinal;
    for (const Instruction& instruction : flow.instructions)
        ordinal.emplace(instruction.address, ordinal.size());
    std::vector<const Object*> tables;
    const auto ordinal_of_table = [&](const Object* table) {
        const auto index = std::find(tables.begin(), tables.end(), table) - tables.begin();
        if (index == std::ssize(tables)) tables.push_back(table);
        return index;
    };

    std::string text;
    for (const Instruction& instruction : flow.instructions) {
        text += instruction.row->mnemonic;
        if (instruction.row->flow != Flow::next) {
            // A skip's register and bit; the others' operand is their target.
            if (instruction.row->flow == Flow::skip) text += instruction.text();
            for (const std::uint32_t address : ControlFlow::successors(instruction, elf.flash()))
                text += fmt::format(" {}", ordinal.at(address));
        } else if (const auto found = record.relocations.find(instruction.address);
                   found != record.relocations.end()) {
            const auto& [type, target] = found->second;
            const Object* const table = record.table_at(target);
            if (!table)
                throw TranslationError(fmt::format("{}: {}: 0x{:x} is no table's address",
                                                   elf.describe(instruction.address),
                                                   instruction.text(), target));
            text += fmt::format(" r{} table {} relocation {} offset {}", instruction.d,
                                ordinal_of_table(table), type, target - table->address);
        } else {
            text += ' ' + instruction.text();
        }
        text += '\n';
    }
    for (const Object* table : tables)
        text.append(elf.flash().begin() + table->address,
                    elf.flash().begin() + table->address + table->size);
    return sha256(text);
}

}  // namespace machine_code
