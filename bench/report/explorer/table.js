// SPDX-License-Identifier: GPL-3.0-or-later
// Every table of the data: filtered by column, sorted, and saved as CSV.
import { columns, command, csv, rows, tableNames } from "./data.js";
import { h, select } from "./dom.js";
import { number, words } from "./text.js";

export const title = "Table";
export const defaults = { file: tableNames[0], sort: "" };
const page = 100;

// "text" must be contained, "=text" is the whole cell; "<3", "<=3", ">3", ">=3" compare numbers.
export function matches(value, wanted) {
  const [, operator, operand] = wanted.match(/^\s*(<=|>=|<|>|=)?\s*(.*?)\s*$/);
  if (operator && operator !== "=") {
    if (typeof value !== "number" || operand === "" || Number.isNaN(Number(operand))) return false;
    return { "<": value < operand, "<=": value <= operand, ">": value > operand, ">=": value >= operand }[operator];
  }
  const text = value === null ? "" : String(value);
  return operator ? text === operand : text.toLowerCase().includes(operand.toLowerCase());
}

export function selected(state) {
  const name = state.get("file"), sort = state.get("sort");
  const filters = state.names("is.").map((key) => [key.slice(3), state.get(key)]).filter(([column]) => columns(name).includes(column));
  const kept = rows(name).filter((row) => filters.every(([column, wanted]) => matches(row[column], wanted)));
  if (!sort) return kept;
  const column = sort.replace(/^-/, ""), sign = sort.startsWith("-") ? -1 : 1;
  // Numbers before texts, missing values last.
  const rank = (value) => (value === null ? 2 : typeof value === "number" ? 0 : 1);
  return [...kept].sort(({ [column]: a }, { [column]: b }) => rank(a) - rank(b)
    || sign * (typeof a === "number" ? a - b : String(a).localeCompare(String(b))));
}

export function build(root, state) {
  const holder = h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Table" }), told = h("span", { class: "soft", role: "status" });
  const made = h("p", { class: "soft" });
  const save = () => {
    const address = URL.createObjectURL(new Blob([csv(columns(state.get("file")), selected(state))], { type: "text/csv" }));
    h("a", { href: address, download: `${state.get("file")}.csv` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  };
  const file = select(state, "file", "table", tableNames.map((name) => [name, words(name)]));
  root.append(h("div", { class: "controls" }, file, h("button", { type: "button", id: "download", onclick: save }, "Save as CSV"),
    h("button", { type: "button", onclick: () => { for (const name of state.names("is.")) state.set(name, ""); head(); } }, "Clear filters"), told), holder, made);
  let body, limit, shown = null;

  function head() {
    shown = state.get("file");
    body = h("tbody");
    holder.replaceChildren(h("table", {}, h("thead", {}, h("tr", {}, columns(shown).map((column, index) => h("th", { scope: "col", "data-column": column, class: index ? null : "corner" },
      h("button", { type: "button", title: "sort", onclick: () => state.set("sort", state.get("sort") === column ? `-${column}` : state.get("sort") === `-${column}` ? "" : column) }, words(column)),
      h("input", { type: "text", value: state.get(`is.${column}`), "aria-label": `filter ${words(column)}`, placeholder: index ? null : "text, =text, <3", oninput: (event) => state.set(`is.${column}`, event.target.value) }))))), body));
    made.replaceChildren(h("a", { href: `data/${shown}.csv` }, `${shown}.csv`), ...(command(shown) ? [", written by ", h("code", {}, command(shown))] : []),
      ". Filters: text that a cell contains, =text for the whole cell, <3, <=3, >3, >=3 for numbers.");
    draw();
  }

  function fill() {
    const list = selected(state), names = columns(shown);
    const numeric = new Set(names.filter((name) => list.every((row) => typeof row[name] !== "string")));
    told.textContent = `${number(list.length)} of ${number(rows(shown).length)} rows`;
    for (const th of holder.querySelectorAll("th")) {
      const sort = state.get("sort");
      if (sort.replace(/^-/, "") === th.dataset.column) th.setAttribute("aria-sort", sort.startsWith("-") ? "descending" : "ascending");
      else th.removeAttribute("aria-sort");
    }
    // Cells show the content of the file, unrounded.
    body.replaceChildren(...list.slice(0, limit).map((row) => h("tr", {}, names.map((name) => h("td",
      { class: numeric.has(name) ? "number" : String(row[name]).length > 40 ? "wrap" : null }, row[name] === null ? "" : String(row[name]))))),
    ...(list.length > limit ? [h("tr", {}, h("td", { colspan: names.length }, h("button", { type: "button", onclick: () => { limit += 10 * page; fill(); } }, `Show more; ${number(list.length - limit)} rows are not shown`)))] : []));
  }

  function draw(changed) {
    if (changed === "file") {
      for (const name of [...state.names("is."), "sort"]) state.chosen.delete(name);
      state.save();
    }
    if (shown !== state.get("file")) return head();
    limit = page;
    fill();
  }
  head();
  return draw;
}
