// SPDX-License-Identifier: GPL-3.0-or-later
// Executes single instructions in avr8js and prints what they did.
//
//     node step.mjs IMAGE ADDRESS < STEPS
//
// IMAGE is the raw content of flash. ADDRESS is the byte address at which each instruction is put.
// Each line of STEPS is, in hexadecimal,
//     FIRST_WORD SECOND_WORD SREG SP REGISTERS
// where REGISTERS are 32 bytes without spaces. Before each step the RAM contains ram_byte(address),
// and GPIOR0 the byte 0xa5. The answer is a line, cycles in decimal and the rest in hexadecimal,
//     CYCLES PC SREG SP REGISTERS GPIOR0 ADDRESS:BYTE ...
// where PC is a byte address, and the bytes are those of RAM that the step changed.

import { readFileSync } from "node:fs";
import { CPU, avrInstruction } from "avr8js";

const FLASH_SIZE = 0x8000;
const RAM_BEGIN = 0x100;
const RAM_END = 0x900;
const GPIOR0 = 0x3e;
const SREG = 0x5f;

const hex = (number, digits) => number.toString(16).padStart(digits, "0");
const ramByte = (address) => (address * 167 + (address >> 8) * 29 + 13) & 0xff;

const [imagePath, addressText] = process.argv.slice(2);
const flash = new Uint8Array(FLASH_SIZE).fill(0xff);
flash.set(readFileSync(imagePath).subarray(0, FLASH_SIZE));
const cpu = new CPU(new Uint16Array(flash.buffer), RAM_END - RAM_BEGIN);
const word = parseInt(addressText, 16) / 2;

function step(line) {
    const [first, second, sreg, sp, registers] = line.split(" ");
    cpu.progMem[word] = parseInt(first, 16);
    cpu.progMem[word + 1] = parseInt(second, 16);
    for (let i = 0; i < 32; ++i) cpu.data[i] = parseInt(registers.substr(2 * i, 2), 16);
    for (let i = RAM_BEGIN; i < RAM_END; ++i) cpu.data[i] = ramByte(i);
    cpu.data[GPIOR0] = 0xa5;
    cpu.data[SREG] = parseInt(sreg, 16);
    cpu.SP = parseInt(sp, 16);
    cpu.pc = word;
    const begin = cpu.cycles;
    avrInstruction(cpu);
    const changed = [];
    for (let i = RAM_BEGIN; i < RAM_END; ++i)
        if (cpu.data[i] !== ramByte(i)) changed.push(`${hex(i, 4)}:${hex(cpu.data[i], 2)}`);
    const all = Array.from(cpu.data.subarray(0, 32), (byte) => hex(byte, 2)).join("");
    return [cpu.cycles - begin, hex(2 * cpu.pc, 4), hex(cpu.data[SREG], 2), hex(cpu.SP, 4), all,
            hex(cpu.data[GPIOR0], 2), ...changed].join(" ");
}

const lines = readFileSync(0, "utf8").split("\n").filter((line) => line.trim());
console.log(lines.map(step).join("\n"));
