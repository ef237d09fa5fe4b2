// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/instructions/instruction.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace instructions {
namespace {

using enum Flow;

// Source: Atmel, "AVR Instruction Set Manual" (DS40002198).
constexpr InstructionRow rows[] = {
    {"0000000000000000", "nop", "", next, 1, ""},
    {"00000001DDDDRRRR", "movw", "r{d}, r{r}", next, 1, "r{d} = r{r}, r{d1} = r{r1}"},
    {"00000010ddddrrrr", "muls", "r{d}, r{r}", next, 2, "muls(r{d}, r{r}, r0, r1, f)"},
    {"000000110ddd0rrr", "mulsu", "r{d}, r{r}", next, 2, "mulsu(r{d}, r{r}, r0, r1, f)"},
    {"000000110ddd1rrr", "fmul", "r{d}, r{r}", next, 2, "fmul(r{d}, r{r}, r0, r1, f)"},
    {"000000111ddd0rrr", "fmuls", "r{d}, r{r}", next, 2, "fmuls(r{d}, r{r}, r0, r1, f)"},
    {"000000111ddd1rrr", "fmulsu", "r{d}, r{r}", next, 2, "fmulsu(r{d}, r{r}, r0, r1, f)"},
    {"000001rdddddrrrr", "cpc", "r{d}, r{r}", next, 1, "cpc(r{d}, r{r}, f)"},
    {"000010rdddddrrrr", "sbc", "r{d}, r{r}", next, 1, "sbc(r{d}, r{r}, f)"},
    {"000011rdddddrrrr", "add", "r{d}, r{r}", next, 1, "add(r{d}, r{r}, f)"},
    {"000100rdddddrrrr", "cpse", "r{d}, r{r}", skip, 1, "r{d} == r{r}"},
    {"000101rdddddrrrr", "cp", "r{d}, r{r}", next, 1, "cp(r{d}, r{r}, f)"},
    {"000110rdddddrrrr", "sub", "r{d}, r{r}", next, 1, "sub(r{d}, r{r}, f)"},
    {"000111rdddddrrrr", "adc", "r{d}, r{r}", next, 1, "adc(r{d}, r{r}, f)"},
    {"001000rdddddrrrr", "and", "r{d}, r{r}", next, 1, "and_(r{d}, r{r}, f)"},
    {"001001rdddddrrrr", "eor", "r{d}, r{r}", next, 1, "eor(r{d}, r{r}, f)"},
    {"001010rdddddrrrr", "or", "r{d}, r{r}", next, 1, "or_(r{d}, r{r}, f)"},
    {"001011rdddddrrrr", "mov", "r{d}, r{r}", next, 1, "r{d} = r{r}"},
    {"0011KKKKddddKKKK", "cpi", "r{d}, 0x{K:02X}", next, 1, "cp(r{d}, {K}, f)"},
    {"0100KKKKddddKKKK", "sbci", "r{d}, 0x{K:02X}", next, 1, "sbc(r{d}, {K}, f)"},
    {"0101KKKKddddKKKK", "subi", "r{d}, 0x{K:02X}", next, 1, "sub(r{d}, {K}, f)"},
    {"0110KKKKddddKKKK", "ori", "r{d}, 0x{K:02X}", next, 1, "or_(r{d}, {K}, f)"},
    {"0111KKKKddddKKKK", "andi", "r{d}, 0x{K:02X}", next, 1, "and_(r{d}, {K}, f)"},
    {"1110KKKKddddKKKK", "ldi", "r{d}, 0x{K:02X}", next, 1, "r{d} = {K}"},

    {"1000000ddddd0000", "ld", "r{d}, Z", next, 2, "r{d} = m.load(word(r30, r31))"},
    {"1000000ddddd1000", "ld", "r{d}, Y", next, 2, "r{d} = m.load(word(r28, r29))"},
    {"10q0qq0ddddd0qqq", "ldd", "r{d}, Z+{q}", next, 2, "r{d} = m.load(word(r30, r31) + {q})"},
    {"10q0qq0ddddd1qqq", "ldd", "r{d}, Y+{q}", next, 2, "r{d} = m.load(word(r28, r29) + {q})"},
    {"1000001rrrrr0000", "st", "Z, r{r}", next, 2, "m.store(word(r30, r31), r{r})"},
    {"1000001rrrrr1000", "st", "Y, r{r}", next, 2, "m.store(word(r28, r29), r{r})"},
    {"10q0qq1rrrrr0qqq", "std", "Z+{q}, r{r}", next, 2, "m.store(word(r30, r31) + {q}, r{r})"},
    {"10q0qq1rrrrr1qqq", "std", "Y+{q}, r{r}", next, 2, "m.store(word(r28, r29) + {q}, r{r})"},
    {"1001000ddddd0000", "lds", "r{d}, 0x{a:04X}", next, 2, "r{d} = m.load({a})", true},
    {"1001000ddddd0001", "ld", "r{d}, Z+", next, 2, "r{d} = m.load(moved_after(r30, r31))"},
    {"1001000ddddd0010", "ld", "r{d}, -Z", next, 2, "r{d} = m.load(moved_before(r30, r31))"},
    {"1001000ddddd0100", "lpm", "r{d}, Z", next, 3, "r{d} = flash[word(r30, r31)]"},
    {"1001000ddddd0101", "lpm", "r{d}, Z+", next, 3, "r{d} = flash[moved_after(r30, r31)]"},
    {"1001000ddddd0110", "elpm", "r{d}, Z", unsupported, 0, ""},
    {"1001000ddddd0111", "elpm", "r{d}, Z+", unsupported, 0, ""},
    {"1001000ddddd1001", "ld", "r{d}, Y+", next, 2, "r{d} = m.load(moved_after(r28, r29))"},
    {"1001000ddddd1010", "ld", "r{d}, -Y", next, 2, "r{d} = m.load(moved_before(r28, r29))"},
    {"1001000ddddd1100", "ld", "r{d}, X", next, 2, "r{d} = m.load(word(r26, r27))"},
    {"1001000ddddd1101", "ld", "r{d}, X+", next, 2, "r{d} = m.load(moved_after(r26, r27))"},
    {"1001000ddddd1110", "ld", "r{d}, -X", next, 2, "r{d} = m.load(moved_before(r26, r27))"},
    {"1001000ddddd1111", "pop", "r{d}", next, 2, "r{d} = m.pop()"},
    {"1001001rrrrr0000", "sts", "0x{a:04X}, r{r}", next, 2, "m.store({a}, r{r})", true},
    {"1001001rrrrr0001", "st", "Z+, r{r}", next, 2, "m.store(moved_after(r30, r31), r{r})"},
    {"1001001rrrrr0010", "st", "-Z, r{r}", next, 2, "m.store(moved_before(r30, r31), r{r})"},
    {"1001001rrrrr0100", "xch", "Z, r{r}", unsupported, 0, ""},
    {"1001001rrrrr0101", "las", "Z, r{r}", unsupported, 0, ""},
    {"1001001rrrrr0110", "lac", "Z, r{r}", unsupported, 0, ""},
    {"1001001rrrrr0111", "lat", "Z, r{r}", unsupported, 0, ""},
    {"1001001rrrrr1001", "st", "Y+, r{r}", next, 2, "m.store(moved_after(r28, r29), r{r})"},
    {"1001001rrrrr1010", "st", "-Y, r{r}", next, 2, "m.store(moved_before(r28, r29), r{r})"},
    {"1001001rrrrr1100", "st", "X, r{r}", next, 2, "m.store(word(r26, r27), r{r})"},
    {"1001001rrrrr1101", "st", "X+, r{r}", next, 2, "m.store(moved_after(r26, r27), r{r})"},
    {"1001001rrrrr1110", "st", "-X, r{r}", next, 2, "m.store(moved_before(r26, r27), r{r})"},
    {"1001001rrrrr1111", "push", "r{r}", next, 2, "m.push(r{r})"},

    {"1001010ddddd0000", "com", "r{d}", next, 1, "com(r{d}, f)"},
    {"1001010ddddd0001", "neg", "r{d}", next, 1, "neg(r{d}, f)"},
    {"1001010ddddd0010", "swap", "r{d}", next, 1, "r{d} = Byte(r{d} << 4 | r{d} >> 4)"},
    {"1001010ddddd0011", "inc", "r{d}", next, 1, "inc(r{d}, f)"},
    {"1001010ddddd0101", "asr", "r{d}", next, 1, "asr(r{d}, f)"},
    {"1001010ddddd0110", "lsr", "r{d}", next, 1, "lsr(r{d}, f)"},
    {"1001010ddddd0111", "ror", "r{d}", next, 1, "ror(r{d}, f)"},
    {"1001010ddddd1010", "dec", "r{d}", next, 1, "dec(r{d}, f)"},
    {"1001010000001000", "sec", "", next, 1, "f.c = true"},
    {"1001010000011000", "sez", "", next, 1, "f.z = true"},
    {"1001010000101000", "sen", "", next, 1, "f.n = true"},
    {"1001010000111000", "sev", "", next, 1, "f.v = true"},
    {"1001010001001000", "ses", "", next, 1, "f.s = true"},
    {"1001010001011000", "seh", "", next, 1, "f.h = true"},
    {"1001010001101000", "set", "", next, 1, "f.t = true"},
    {"1001010001111000", "sei", "", next, 1, "f.i = true"},
    {"1001010010001000", "clc", "", next, 1, "f.c = false"},
    {"1001010010011000", "clz", "", next, 1, "f.z = false"},
    {"1001010010101000", "cln", "", next, 1, "f.n = false"},
    {"1001010010111000", "clv", "", next, 1, "f.v = false"},
    {"1001010011001000", "cls", "", next, 1, "f.s = false"},
    {"1001010011011000", "clh", "", next, 1, "f.h = false"},
    {"1001010011101000", "clt", "", next, 1, "f.t = false"},
    {"1001010011111000", "cli", "", next, 1, "f.i = false"},
    {"1001010000001001", "ijmp", "", unsupported, 0, ""},
    {"1001010000011001", "eijmp", "", unsupported, 0, ""},
    {"1001010100001001", "icall", "", unsupported, 0, ""},
    {"1001010100011001", "eicall", "", unsupported, 0, ""},
    {"1001010100001000", "ret", "", ret, 4, ""},
    {"1001010100011000", "reti", "", unsupported, 0, ""},
    {"1001010110001000", "sleep", "", unsupported, 0, ""},
    {"1001010110011000", "break", "", unsupported, 0, ""},
    {"1001010110101000", "wdr", "", unsupported, 0, ""},
    {"1001010111001000", "lpm", "", next, 3, "r0 = flash[word(r30, r31)]"},
    {"1001010111011000", "elpm", "", unsupported, 0, ""},
    {"1001010111101000", "spm", "", unsupported, 0, ""},
    {"1001010111111000", "spm", "Z+", unsupported, 0, ""},
    {"10010100KKKK1011", "des", "{K}", unsupported, 0, ""},
    {"1001010hhhhh110h", "jmp", "0x{t:x}", jump, 3, "", true},
    {"1001010hhhhh111h", "call", "0x{t:x}", call, 4, "", true},
    {"10010110KKddKKKK", "adiw", "r{d}, 0x{K:02x}", next, 2, "adiw(r{d}, r{d1}, {K}, f)"},
    {"10010111KKddKKKK", "sbiw", "r{d}, 0x{K:02x}", next, 2, "sbiw(r{d}, r{d1}, {K}, f)"},
    {"10011000AAAAAbbb", "cbi", "0x{A:02x}, {b}", unsupported, 0, ""},
    {"10011001AAAAAbbb", "sbic", "0x{A:02x}, {b}", unsupported, 0, ""},
    {"10011010AAAAAbbb", "sbi", "0x{A:02x}, {b}", unsupported, 0, ""},
    {"10011011AAAAAbbb", "sbis", "0x{A:02x}, {b}", unsupported, 0, ""},
    {"100111rdddddrrrr", "mul", "r{d}, r{r}", next, 2, "mul(r{d}, r{r}, r0, r1, f)"},

    {"10110AAdddddAAAA", "in", "r{d}, 0x{A:02x}", next, 1, "r{d} = m.in<{A}>(f)"},
    {"10111AArrrrrAAAA", "out", "0x{A:02x}, r{r}", next, 1, "m.out<{A}>(r{r}, f)"},
    {"1100kkkkkkkkkkkk", "rjmp", ".{k:+}", jump, 2, ""},
    {"1101kkkkkkkkkkkk", "rcall", ".{k:+}", call, 3, ""},

    {"111100kkkkkkk000", "brcs", ".{k:+}", branch, 1, "f.c"},
    {"111100kkkkkkk001", "breq", ".{k:+}", branch, 1, "f.z"},
    {"111100kkkkkkk010", "brmi", ".{k:+}", branch, 1, "f.n"},
    {"111100kkkkkkk011", "brvs", ".{k:+}", branch, 1, "f.v"},
    {"111100kkkkkkk100", "brlt", ".{k:+}", branch, 1, "f.s"},
    {"111100kkkkkkk101", "brhs", ".{k:+}", branch, 1, "f.h"},
    {"111100kkkkkkk110", "brts", ".{k:+}", branch, 1, "f.t"},
    {"111100kkkkkkk111", "brie", ".{k:+}", branch, 1, "f.i"},
    {"111101kkkkkkk000", "brcc", ".{k:+}", branch, 1, "!f.c"},
    {"111101kkkkkkk001", "brne", ".{k:+}", branch, 1, "!f.z"},
    {"111101kkkkkkk010", "brpl", ".{k:+}", branch, 1, "!f.n"},
    {"111101kkkkkkk011", "brvc", ".{k:+}", branch, 1, "!f.v"},
    {"111101kkkkkkk100", "brge", ".{k:+}", branch, 1, "!f.s"},
    {"111101kkkkkkk101", "brhc", ".{k:+}", branch, 1, "!f.h"},
    {"111101kkkkkkk110", "brtc", ".{k:+}", branch, 1, "!f.t"},
    {"111101kkkkkkk111", "brid", ".{k:+}", branch, 1, "!f.i"},
    {"1111100ddddd0bbb", "bld", "r{d}, {b}", next, 1,
     "r{d} = Byte((r{d} & ~(1 << {b})) | f.t << {b})"},
    {"1111101ddddd0bbb", "bst", "r{d}, {b}", next, 1, "f.t = r{d} >> {b} & 1"},
    {"1111110rrrrr0bbb", "sbrc", "r{r}, {b}", skip, 1, "!(r{r} >> {b} & 1)"},
    {"1111111rrrrr0bbb", "sbrs", "r{r}, {b}", skip, 1, "r{r} >> {b} & 1"},
};

constexpr int opcode_bits = 16;

constexpr bool matches(const InstructionRow& row, std::uint16_t opcode) {
    for (int i = 0; i < opcode_bits; ++i) {
        const char letter = row.pattern[std::size_t(i)];
        const int bit = opcode >> (opcode_bits - 1 - i) & 1;
        if ((letter == '0' && bit) || (letter == '1' && !bit)) return false;
    }
    return true;
}

// The row of each opcode.
const std::array<const InstructionRow*, 0x10000>& rows_by_opcode() {
    static const auto table = [] {
        std::array<const InstructionRow*, 0x10000> found{};
        for (std::size_t opcode = 0; opcode < found.size(); ++opcode) {
            for (const InstructionRow& row : rows) {
                // ldd with q = 0 is ld, which comes first.
                if (!found[opcode] && matches(row, std::uint16_t(opcode))) found[opcode] = &row;
            }
        }
        return found;
    }();
    return table;
}

struct Field {
    int value = 0;
    int bits = 0;
};

Field field(const InstructionRow& row, std::uint16_t opcode, char letter) {
    Field found;
    for (int i = 0; i < opcode_bits; ++i) {
        if (row.pattern[std::size_t(i)] != letter) continue;
        found.value = found.value << 1 | (opcode >> (opcode_bits - 1 - i) & 1);
        ++found.bits;
    }
    return found;
}

int register_of(const InstructionRow& row, std::uint16_t opcode, char letter, char pair_letter) {
    const Field single = field(row, opcode, letter);
    switch (single.bits) {
        case 5:
            return single.value;
        case 4:
        case 3:
            return 16 + single.value;
        case 2:
            return 24 + 2 * single.value;
        default:
            return 2 * field(row, opcode, pair_letter).value;
    }
}

int sign_extend(const Field& field) {
    const int sign = field.bits ? 1 << (field.bits - 1) : 0;
    return (field.value ^ sign) - sign;
}

std::string filled_in(std::string_view text, const Instruction& of) {
    return fmt::format(fmt::runtime(text), fmt::arg("d", of.d), fmt::arg("d1", of.d + 1),
                       fmt::arg("r", of.r), fmt::arg("r1", of.r + 1), fmt::arg("K", of.K),
                       fmt::arg("q", of.q), fmt::arg("A", of.A), fmt::arg("b", of.b),
                       fmt::arg("k", 2 * of.k), fmt::arg("a", of.second_word),
                       fmt::arg("t", 2 * of.absolute()));
}

}  // namespace

std::span<const InstructionRow> instruction_set() { return rows; }

std::uint32_t Instruction::target() const {
    return row->two_words ? 2 * absolute() : next() + std::uint32_t(2 * k);
}

std::string Instruction::text() const {
    if (!row) return fmt::format(".word 0x{:04x}", opcode);
    if (row->operands.empty()) return std::string(row->mnemonic);
    return fmt::format("{} {}", row->mnemonic, filled_in(row->operands, *this));
}

std::string Instruction::statement() const { return filled_in(row->statement, *this); }

Instruction decode(std::span<const std::uint8_t> flash, std::uint32_t address) {
    const auto word = [&](std::uint32_t at) {
        if (at + 2 > flash.size())
            throw std::out_of_range(fmt::format("no instruction at 0x{:04x}: the flash ends", at));
        return std::uint16_t(flash[at] | flash[at + 1] << 8);
    };
    Instruction decoded{.address = address, .opcode = word(address)};
    const InstructionRow* row = rows_by_opcode()[decoded.opcode];
    decoded.row = row;
    if (!row) return decoded;
    const auto value = [&](char letter) { return field(*row, decoded.opcode, letter).value; };
    if (row->two_words) decoded.second_word = word(address + 2);
    decoded.d = register_of(*row, decoded.opcode, 'd', 'D');
    decoded.r = register_of(*row, decoded.opcode, 'r', 'R');
    decoded.K = value('K');
    decoded.q = value('q');
    decoded.A = value('A');
    decoded.b = value('b');
    decoded.h = value('h');
    decoded.k = sign_extend(field(*row, decoded.opcode, 'k'));
    return decoded;
}

}  // namespace instructions
