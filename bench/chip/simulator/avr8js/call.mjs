// SPDX-License-Identifier: GPL-3.0-or-later
// Calls functions of a flash image in avr8js and prints their results and costs.
//
//     node call.mjs IMAGE MAIN < CALLS
//
// IMAGE is the raw content of flash from address 0. MAIN is the byte address of main(), up to which
// the start-up code runs first. Each line of CALLS is
//     ADDRESS RESULT_SIZE SIZE:VALUE SIZE:VALUE ...
// with hexadecimal numbers, and sizes in bytes. The answer is a line `RESULT CYCLES`, hexadecimal
// and decimal. Cycles include the `call` (4) and the `ret`.

import { readFileSync } from "node:fs";
import { CPU, avrInstruction } from "avr8js";

const FLASH_SIZE = 0x8000;
const RAM_SIZE = 2048;
const RAM_END = 0x900;
const RETURN_ADDRESS = FLASH_SIZE / 2 - 1; // in words
const CALL_CYCLES = 4;
const BUDGET = 1_000_000;

const [imagePath, mainAddress] = process.argv.slice(2);
const flash = new Uint8Array(FLASH_SIZE).fill(0xff);
flash.set(readFileSync(imagePath));
const cpu = new CPU(new Uint16Array(flash.buffer), RAM_SIZE);

function runUntil(wordAddress) {
    const limit = cpu.cycles + BUDGET;
    while (cpu.pc !== wordAddress) {
        if (cpu.cycles > limit) throw new Error(`not done after ${BUDGET} cycles`);
        avrInstruction(cpu);
    }
}

// avr-gcc's convention: operands go downwards from r25, each in an even register. From the first
// that would start below r8, all are on the stack, the first one lowest.
function place(operands) {
    let next = 26;
    const onStack = [];
    for (const { size, value } of operands) {
        next -= size + (size % 2);
        if (next < 8) next = 0;
        for (let byte = 0; byte < size; ++byte) {
            const bits = Number((value >> BigInt(8 * byte)) & 0xffn);
            if (next) cpu.data[next + byte] = bits;
            else onStack.push(bits);
        }
    }
    const stack = RAM_END - onStack.length;
    cpu.data.set(onStack, stack);
    cpu.data[stack - 1] = RETURN_ADDRESS & 0xff;
    cpu.data[stack - 2] = RETURN_ADDRESS >> 8;
    cpu.SP = stack - 3;
}

function call(line) {
    const [address, resultSize, ...rest] = line.trim().split(/\s+/);
    cpu.data[1] = 0;
    place(rest.map((text) => {
        const [size, value] = text.split(":");
        return { size: Number(size), value: BigInt("0x" + value) };
    }));
    cpu.pc = parseInt(address, 16) / 2;
    const begin = cpu.cycles;
    runUntil(RETURN_ADDRESS);
    const size = Number(resultSize);
    const first = 26 - (size + (size % 2));
    let result = 0n;
    for (let byte = size; byte-- > 0; ) result = (result << 8n) | BigInt(cpu.data[first + byte]);
    return `${result.toString(16)} ${cpu.cycles - begin + CALL_CYCLES}`;
}

runUntil(parseInt(mainAddress, 16) / 2);
const lines = readFileSync(0, "utf8").split("\n").filter((line) => line.trim());
console.log(lines.map(call).join("\n"));
