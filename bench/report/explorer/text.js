// SPDX-License-Identifier: GPL-3.0-or-later
// How numbers and names are written.
import { formats, subjects } from "./data.js";

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

// Four significant digits, with a power of ten if the number is very small or large.
export function number(value) {
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  const size = Math.abs(value);
  if (size === 0) return "0";
  if (Number.isInteger(value) && size < 1e7) return whole(value).replace("-", "−");
  if (size >= 1e-3 && size < 1e5) return String(Number(value.toPrecision(4))).replace("-", "−");
  const [mantissa, exponent] = value.toExponential(3).split("e");
  return scientific(Number(mantissa), Number(exponent));
}

// A count, with all of its digits.
export const whole = (value) => value.toLocaleString("en").replaceAll(",", "\u202f");

const scientific = (mantissa, exponent) => (mantissa === 1 ? power(exponent) : `${mantissa}·${power(exponent)}`.replace("-", "−"));

export function power(exponent) {
  const digits = String(Math.abs(exponent)).replace(/\d/g, (digit) => superscripts[digit]);
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

// A tick of a logarithmic axis.
export function tick(value) {
  if (value === 0) return "0";
  if (value >= 0.01 && value < 1e4) return String(Number(value.toPrecision(3)));
  if (value >= 1e4 && value < 1e9)
    return value < 1e6 ? `${Number((value / 1e3).toPrecision(3))}k` : `${Number((value / 1e6).toPrecision(3))}M`;
  const [mantissa, exponent] = value.toExponential(1).split("e");
  return scientific(Number(mantissa), Number(exponent));
}

export const words = (name) => name.replaceAll("_", " ").replace("euler", "Euler").replace("verlet", "Verlet").replace("semi implicit", "semi-implicit");
export const formatLabel = (format) => formats[format]?.label ?? words(format);

export const subjectOf = (row) => subjects[`${row.format}/${row.implementation}`];
export const subjectLabel = (row) => subjectOf(row).label;

// The number that a raw operand stands for.
function value(format, raw) {
  const { fraction } = formats[format];
  if (fraction !== null) return Number(raw) / 2 ** fraction;
  const bits = new DataView(new ArrayBuffer(8));
  bits.setBigInt64(0, BigInt(raw));
  return format === "float64" ? bits.getFloat64(0) : bits.getFloat32(4);
}

export function witness(format, raws) {
  if (raws === null) return "–";
  const all = String(raws).split(" ");
  return `raw ${all.join(", ")} = ${all.map((raw) => String(Number(value(format, raw).toPrecision(9)))).join(", ").replaceAll("-", "−")}`;
}

export function hash(text, whole) {
  const code = document.createElement("code");
  code.title = text;
  code.textContent = whole ? text : `${text.slice(0, 12)}…`;
  return code;
}
