// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page. Tables are decoded when a view first asks for them.
const page = JSON.parse(document.getElementById("data").textContent);
const decoded = new Map();

export const { views, styles, formats, implementations, subjects, scalars, physics, compared, hertz, verdicts } = page;
export const tableNames = Object.keys(page.tables);
export const has = (name) => name in page.tables;
export const command = (name) => page.tables[name].command;
export const columns = (name) => Object.keys(page.tables[name].columns);

// The rows of <name>.csv as objects; empty if there is no such file.
export function rows(name) {
  if (!has(name)) return [];
  if (!decoded.has(name)) {
    const { rows: count, columns: cells } = page.tables[name];
    const made = Array.from({ length: count }, () => ({}));
    for (const [column, coded] of Object.entries(cells))
      for (let row = 0; row < count; ++row)
        made[row][column] = coded.index ? coded.values[coded.index[row]] : coded[row];
    decoded.set(name, made);
  }
  return decoded.get(name);
}

// Rows of operations.csv, and those of other libraries in its terms.
let joined = null;
export function measured() {
  return joined ??= [...rows("operations"), ...rows("rivals").filter((row) => row.regular && row.failure === null && `${row.format}/${row.variant}` in subjects)
    .map((row) => ({ ...row, implementation: row.variant }))];
}

export const unique = (values) => [...new Set(values)];

// The columns' names, and a line per row, with cells quoted if necessary.
export function csv(names, selected) {
  const cell = (value) => {
    const text = value === null ? "" : String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return [names, ...selected.map((row) => names.map((name) => row[name]))]
    .map((line) => line.map(cell).join(",")).join("\n") + "\n";
}
