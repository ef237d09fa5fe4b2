// SPDX-License-Identifier: GPL-3.0-or-later
// Which format to use, what it costs, and where it is worse.
import { formats, has, implementations, physics, rows, subjects as styled, unique } from "./data.js";
import { h } from "./dom.js";
import { letter } from "./chart.js";
import { known } from "./point.js";
import { formatLabel, number, words } from "./text.js";

const columns = [["add", "+"], ["multiply", "×"], ["divide", "÷"], ["sqrt", "√"], ["sin", "sin"], ["atan2", "atan2"]];
export const title = "Overview";
export const defaults = { range: "", resolution: "" };

const of = (format, implementation) => rows("operations").filter((row) => row.format === format && row.implementation === implementation && row.operands === "physics");
const subjects = [...Object.keys(formats).filter((format) => format.startsWith("q") && `${format}/default` in styled).map((format) => [format, "default"]), ["float", "libc"], ["q16_16", "published"]];

// The operations that take more cycles, or more flash, in a subject than in its rival.
function loses(format, implementation) {
  const [rivalFormat, rivalImplementation] = implementation === "default" ? ["float", "libc"] : ["q16_16", "default"];
  const rivals = new Map(of(rivalFormat, rivalImplementation).map((row) => [row.operation, row]));
  const mine = of(format, implementation).filter((row) => rivals.has(row.operation));
  const more = (column) => mine.filter((row) => row[column] > rivals.get(row.operation)[column])
    .map((row) => `${words(row.operation)} (${number(row[column])}:${number(rivals.get(row.operation)[column])})`);
  const cycles = more("cycles_mean"), flash = more("flash_bytes");
  const list = (found, what) => (found.length === 0 ? `no operation takes more ${what}`
    : `${found.length} of ${mine.length} operations ${found.length === 1 ? "takes" : "take"} more ${what}${found.length <= 4 ? `: ${found.join(", ")}` : ""}`);
  return `Compared with ${rivalImplementation === "default" ? "our " : ""}${formatLabel(rivalFormat)}: ${list(cycles, "cycles")}; ${list(flash, "flash")}.`;
}

// The largest known error in ulp of the six operations, over all runs.
function worstOfSix(format, implementation) {
  const judged = columns.map(([operation]) => known({ operation, format, implementation })).filter((row) => row?.bound);
  const largest = judged.reduce((best, row) => (row.max_ulp > (best?.max_ulp ?? -1) ? row : best), null);
  return largest ? [number(largest.max_ulp), h("small", {}, `${words(largest.operation)}, ${largest.bound}`), h("small", {}, `${physics[0]} to ${physics[1]}: ${number(worstOfPhysics(format, implementation))}`)] : "–";
}

// The largest error of the six operations on operands that occur in a scene.
function worstOfPhysics(format, implementation) {
  const judged = of(format, implementation).filter((row) => columns.some(([operation]) => operation === row.operation) && row.max_ulp !== null);
  return Math.max(...judged.map((row) => row.max_ulp));
}

export function build(root, state) {
  const told = h("p", { role: "status" }), holder = h("div", { class: "scroll free" });
  const input = (name, label) => h("label", {}, label, h("input", { type: "number", min: "0", step: "any", inputmode: "decimal", name, size: "9", value: state.get(name), oninput: (event) => state.set(name, event.target.value) }));
  root.append(h("h2", {}, "Which format?"),
    h("div", { class: "controls" }, input("range", "largest magnitude"), input("resolution", "smallest step at that magnitude"), told), holder,
    h("p", { class: "soft", style: "margin-top:10px" }, `Cycles: mean over operands of ${physics[0]} to ${physics[1]} (or those that the format holds), including call and return; below it, the largest in any run. `,
      has("flash") ? "Flash of nine: a program with + − × ÷ sqrt sin atan2 exp log, with shared code counted once. " : "", "Error: the largest of the six operations in any run, in ulp of the format."),
    h("div", { class: "panels" }, [["operations", "Error against cost", "Each operation in every format, ours and the rivals', with witnesses, bounds and histograms."],
      ["scenes", "Work and precision", "What a scene costs for a given error, by format, method and step."],
      ["stability", "Stability", "Where each case breaks, and what goes wrong first."], ["table", "Tables", "Every row, to filter, sort and save."]]
      .map(([view, name, text]) => h("a", { class: "card", href: `#view=${view}`, style: "text-decoration:none;color:inherit" }, h("h3", {}, name), text))));

  function draw() {
    const range = Number(state.get("range") || NaN), resolution = Number(state.get("resolution") || NaN);
    const fits = (format) => {
      const { maximum, resolution: least, relative } = formats[format];
      const place = least ?? 2 * relative * (range || 1);
      return !(range > maximum) && !(place > resolution);
    };
    const fitting = unique(subjects.map(([format]) => format)).filter(fits);
    told.textContent = Number.isNaN(range) && Number.isNaN(resolution) ? "Type what you need. Formats that do not fit are struck out."
      : fitting.length ? `${fitting.map(formatLabel).join(", ")} ${fitting.length === 1 ? "fits" : "fit"}.` : "None of these formats fits.";
    holder.replaceChildren(h("table", {}, h("thead", {}, h("tr", {}, ["format", "range, resolution", "largest error, ulp"].map((text, index) => h("th", { scope: "col", class: index ? null : "corner" }, text)),
      columns.map(([operation, sign]) => h("th", { scope: "col" }, h("abbr", { title: `${operation}, cycles`, style: "text-decoration:none" }, sign), h("small", { class: "unit" }, "cycles"))), has("flash") && h("th", { scope: "col" }, "flash of nine", h("small", { class: "unit" }, "bytes")), h("th", { scope: "col" }, "where it loses"))),
    h("tbody", {}, subjects.map(([format, implementation]) => {
      const mine = of(format, implementation), found = (operation) => mine.find((row) => row.operation === operation);
      const together = rows("flash").find((row) => row.format === format && row.implementation === implementation);
      const { maximum, resolution: least, relative } = formats[format];
      return h("tr", { class: fits(format) ? null : "unfit", "data-subject": `${format}/${implementation}` },
        h("th", { scope: "row" }, letter(styled[`${format}/${implementation}`]), " ", formatLabel(format), implementation === "published" && h("small", { class: "unit" }, implementations.published.label),
          !fits(format) && h("span", { class: "unseen" }, "does not fit")),
        h("td", {}, `±${number(maximum < 1e10 ? Math.round(maximum) : maximum)}`, h("small", {}, least === null ? `${number(2 * relative)} × value` : number(least))),
        h("td", {}, worstOfSix(format, implementation)),
        columns.map(([operation]) => {
          const row = found(operation);
          return h("td", { class: "number" }, row ? [h("a", { href: `#view=operations&operation=${operation}&pin=${operation}/${format}/${implementation}/physics` }, number(Math.round(row.cycles_mean))), h("small", {}, `≤ ${number(known(row).cycles_max)}`)] : "–");
        }),
        has("flash") && h("td", { class: "number" }, together ? number(together.flash_bytes) : "–"),
        h("td", { class: "wrap" }, h("small", {}, loses(format, implementation))));
    }))));
  }
  draw();
  return draw;
}
