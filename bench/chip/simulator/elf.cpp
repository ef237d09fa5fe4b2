// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/elf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gelf.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include "bench/chip/edit_distance.hpp"

namespace simulator {
namespace {

constexpr std::uint32_t data_origin = 0x800000;    // the linker's address of data space
constexpr std::uint32_t eeprom_origin = 0x810000;  // the linker's address of EEPROM

constexpr std::string_view same_device = "atmega328";  // identical except for its signature
constexpr unsigned architecture_mask = 0x7f, device_architecture = 5;

// No program for 32 KiB of flash comes close to these limits; a file that exceeds them would only
// take time.
constexpr std::size_t largest_file = 64 << 20, max_entries = 1 << 20, longest_name = 512;

std::vector<char> read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw ElfError(fmt::format("{}: cannot be opened", path.string()));
    std::vector<char> bytes;
    std::vector<char> chunk(1 << 16);
    while (file.read(chunk.data(), std::ssize(chunk)), file.gcount()) {
        bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + file.gcount());
        if (bytes.size() > largest_file)
            throw ElfError(fmt::format("{}: larger than {} bytes, no program for the {}",
                                       path.string(), largest_file, Elf::device));
    }
    return bytes;
}

}  // namespace

std::string sha256_of(std::span<const std::uint8_t> bytes) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    if (!EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr))
        throw ElfError("SHA-256 is not available in libcrypto");
    return fmt::format("{:02x}", fmt::join(digest, digest + length, ""));
}

// Reads the file part by part; each part is checked as it is read.
class Elf::Reader {
  public:
    Reader(Elf& elf, std::vector<char>& bytes)
        : elf_(elf), size_(bytes.size()), file_(elf_memory(bytes.data(), size_), &elf_end) {
        if (!file_ || elf_kind(file_.get()) != ELF_K_ELF || !gelf_getehdr(file_.get(), &header_))
            refuse("not an ELF file");
        if (header_.e_machine != EM_AVR || header_.e_type != ET_EXEC ||
            header_.e_ident[EI_CLASS] != ELFCLASS32 || header_.e_ident[EI_DATA] != ELFDATA2LSB)
            refuse("not a linked program for the AVR");
        // libelf treats a file that ends before its table of sections as one without sections.
        std::size_t sections = 0;
        expect(elf_getshdrnum(file_.get(), &sections) == 0 && (sections || !header_.e_shoff) &&
                   header_.e_shoff + sections * header_.e_shentsize <= size_,
               "table of sections");
    }

    void read(const std::vector<char>& bytes) {
        expect_device();
        load_segments(bytes);
        // Symbols are checked against the loaded flash, and relocations refer to symbols.
        for_each_section([&](Elf_Scn*, const GElf_Shdr& about) { add_section(about); });
        for_each_section([&](Elf_Scn* section, const GElf_Shdr& about) {
            if (about.sh_type == SHT_SYMTAB) add_symbols(section, about);
        });
        for_each_section([&](Elf_Scn* section, const GElf_Shdr& about) {
            if (about.sh_type == SHT_RELA) add_relocations(section, about);
        });
        size_labels();
    }

  private:
    [[noreturn]] void refuse(std::string_view why) const {
        throw ElfError(fmt::format("{}: {}", elf_.path_.string(), why));
    }
    void expect(bool intact, const char* part) const {
        if (!intact) refuse(fmt::format("its {} is damaged", part));
    }

    template <class Visit>
    void for_each_section(Visit&& visit) const {
        for (Elf_Scn* section = nullptr; (section = elf_nextscn(file_.get(), section));) {
            GElf_Shdr about;
            expect(gelf_getshdr(section, &about), "table of sections");
            visit(section, about);
        }
    }

    std::string text(std::size_t section, std::size_t offset) const {
        const char* const found = elf_strptr(file_.get(), section, offset);
        const std::string_view name = found ? found : "";
        // A name that is shown on a terminal must stay on its line.
        expect(found && std::none_of(name.begin(), name.end(),
                                     [](unsigned char c) { return std::iscntrl(c); }),
               "table of names");
        return std::string(name);
    }

    void expect_device() const {
        std::string built_for;
        for_each_section([&](Elf_Scn* section, const GElf_Shdr& about) {
            if (about.sh_type != SHT_NOTE) return;
            Elf_Data* const data = elf_getdata(section, nullptr);
            expect(data, "note");
            GElf_Nhdr note;
            std::size_t name, description;
            expect(gelf_getnote(data, 0, &note, &name, &description), "note");
            const char* const bytes = static_cast<const char*>(data->d_buf);
            if (std::string_view(bytes + name, note.n_namesz) != std::string_view("AVR\0", 4))
                return;
            built_for = device_of({bytes + description, note.n_descsz});
        });
        if (!built_for.empty() && built_for != device && built_for != same_device)
            refuse(fmt::format("built for the {}, not for the {}", built_for, device));
        const unsigned architecture = header_.e_flags & architecture_mask;
        if (architecture != device_architecture)
            refuse(fmt::format("built for the architecture avr:{}; the {} is an avr:{}",
                               architecture, device, device_architecture));
    }

    // The note contains six words of addresses and sizes, a table of offsets preceded by its size,
    // and the strings at these offsets. The first string is the name of the device.
    std::string device_of(std::string_view note) const {
        constexpr std::size_t table = 6 * 4;
        const auto word = [&](std::size_t at) {
            expect(at + 4 <= note.size(), "note");
            std::uint32_t value;
            std::memcpy(&value, note.data() + at, sizeof value);
            return value;
        };
        const std::uint64_t begin = std::uint64_t(table) + word(table) + word(table + 4);
        expect(begin < note.size(), "note");
        const std::size_t end = note.find('\0', begin);
        expect(end != note.npos && end > begin, "note");
        const std::string name(note.substr(begin, end - begin));
        expect(
            std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c); }),
            "note");
        return name;
    }

    void load_segments(const std::vector<char>& bytes) {
        std::vector<std::uint8_t>& flash = elf_.flash_;
        std::vector<bool> loaded(flash_size);
        std::size_t segments = 0;
        expect(elf_getphdrnum(file_.get(), &segments) == 0, "table of segments");
        for (std::size_t i = 0; i < segments; ++i) {
            GElf_Phdr segment;
            expect(gelf_getphdr(file_.get(), static_cast<int>(i), &segment), "table of segments");
            if (segment.p_type != PT_LOAD || !segment.p_filesz || segment.p_paddr >= data_origin)
                continue;
            expect(segment.p_offset <= size_ && segment.p_filesz <= size_ - segment.p_offset,
                   "segment");
            const std::size_t begin = segment.p_paddr, end = begin + segment.p_filesz;
            if (end > flash_size)
                refuse(fmt::format("{} bytes do not fit into {} bytes of flash", end, flash_size));
            if (std::find(loaded.begin() + begin, loaded.begin() + end, true) !=
                loaded.begin() + end)
                refuse("two of its segments overlap");
            std::fill(loaded.begin() + begin, loaded.begin() + end, true);
            if (flash.size() < end) flash.resize(end, 0xff);
            std::copy_n(bytes.data() + segment.p_offset, segment.p_filesz,
                        reinterpret_cast<char*>(flash.data()) + begin);
        }
        if (flash.empty()) refuse("nothing to load");
        elf_.sha256_ = sha256_of(flash);
    }

    void add_section(const GElf_Shdr& about) {
        if (!(about.sh_flags & SHF_ALLOC) || about.sh_addr >= eeprom_origin) return;
        const bool in_ram = about.sh_addr >= data_origin;
        const std::uint64_t end = about.sh_addr + about.sh_size;
        if (!in_ram && end > flash_size)
            refuse(fmt::format("{} bytes do not fit into {} bytes of flash", end, flash_size));
        if (in_ram && about.sh_size &&
            (about.sh_addr < data_origin + ram_begin || end > data_origin + ram_end))
            refuse(fmt::format("data from 0x{:x} to 0x{:x} is not in the RAM, 0x{:x} to 0x{:x}",
                               about.sh_addr - data_origin, end - 1 - data_origin, ram_begin,
                               ram_end - 1));
        elf_.sections_.push_back(
            {text(header_.e_shstrndx, about.sh_name), static_cast<std::uint32_t>(about.sh_addr),
             static_cast<std::uint32_t>(about.sh_size), about.sh_type == SHT_PROGBITS, in_ram});
    }

    // The entries of a table of symbols or relocations.
    std::pair<Elf_Data*, int> table_of(Elf_Scn* section, const GElf_Shdr& about,
                                       const char* part) const {
        Elf_Data* const data = elf_getdata(section, nullptr);
        expect(data && about.sh_entsize, part);
        expect(data->d_size / about.sh_entsize <= max_entries, part);
        return {data, static_cast<int>(data->d_size / about.sh_entsize)};
    }

    void add_symbols(Elf_Scn* section, const GElf_Shdr& about) {
        const char* const part = "table of symbols";
        const auto [table, count] = table_of(section, about, part);
        for (int i = 0; i < count; ++i) {
            GElf_Sym symbol;
            expect(gelf_getsym(table, i, &symbol), part);
            const std::string name = text(about.sh_link, symbol.st_name);
            const auto address = static_cast<std::uint32_t>(symbol.st_value);
            const auto size = static_cast<std::uint32_t>(symbol.st_size);
            const int type = GELF_ST_TYPE(symbol.st_info);
            const bool global = GELF_ST_BIND(symbol.st_info) != STB_LOCAL;
            const bool in_flash = address < elf_.flash_.size();
            const std::uint64_t end = std::uint64_t(address) + size;
            // Not checked against the end of the program: avr-libc states the size of some
            // functions, such as __mulsf3x, too large.
            if (size && address < eeprom_origin)
                expect(end <= (address < data_origin ? flash_size : data_origin + ram_end), part);
            // Includes tables without a name, since relocations refer to them.
            if (type == STT_OBJECT && address < data_origin)
                elf_.flash_objects_.push_back({name, address, size});
            if (name.empty() || symbol.st_shndx == SHN_UNDEF) continue;
            if (address >= data_origin && address < eeprom_origin)
                elf_.objects_[name] = {name, address - data_origin, size};
            else if (in_flash && (type == STT_FUNC || (type == STT_NOTYPE && global)))
                elf_.functions_[name] = {
                    name, address,
                    std::min(size, static_cast<std::uint32_t>(elf_.flash_.size()) - address)};
        }
    }

    void add_relocations(Elf_Scn* section, const GElf_Shdr& about) {
        const char* const part = "table of relocations";
        GElf_Shdr code, names;
        Elf_Scn* const symbols_section = elf_getscn(file_.get(), about.sh_link);
        expect(gelf_getshdr(elf_getscn(file_.get(), about.sh_info), &code) &&
                   gelf_getshdr(symbols_section, &names),
               part);
        if (!(code.sh_flags & SHF_EXECINSTR)) return;
        const auto [table, count] = table_of(section, about, part);
        Elf_Data* const symbols = elf_getdata(symbols_section, nullptr);
        expect(symbols, part);
        for (int i = 0; i < count; ++i) {
            GElf_Rela entry;
            GElf_Sym symbol;
            expect(gelf_getrela(table, i, &entry) &&
                       gelf_getsym(symbols, static_cast<int>(GELF_R_SYM(entry.r_info)), &symbol),
                   part);
            elf_.relocations_[static_cast<std::uint32_t>(entry.r_offset)] = {
                static_cast<unsigned>(GELF_R_TYPE(entry.r_info)),
                static_cast<std::uint32_t>(symbol.st_value + entry.r_addend)};
        }
    }

    // Gives a label without a size that of the function at its address.
    void size_labels() {
        std::map<std::uint32_t, std::uint32_t> sizes;
        for (const auto& [name, symbol] : elf_.functions_) {
            std::uint32_t& size = sizes[symbol.address];
            size = std::max(size, symbol.size);
        }
        for (auto& [name, symbol] : elf_.functions_)
            if (!symbol.size) symbol.size = sizes.at(symbol.address);
    }

    Elf& elf_;
    std::size_t size_;
    std::unique_ptr<::Elf, decltype(&elf_end)> file_;
    GElf_Ehdr header_;
};

Elf::Elf(const std::filesystem::path& path) : path_(path) {
    std::vector<char> bytes = read_file(path);
    elf_version(EV_CURRENT);
    Reader(*this, bytes).read(bytes);
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
        if (other.size() <= longest_name) closest.emplace_back(edit_distance(name, other), other);
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
