// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of an operation in a format and an implementation: figures with their witnesses and bounds, the worst
// of any run, and hashes; the histogram of its error, and the error along the input.
import * as Plot from "@observablehq/plot";
import { command, has, implementations, measured, rows } from "./data.js";
import { facts, h } from "./dom.js";
import { colour, drawing, hide } from "./chart.js";
import { hash, number, subjectLabel, subjectOf, tick, whole, witness, words } from "./text.js";

const same = (row) => (other) => other.operation === row.operation && other.format === row.format && other.implementation === row.implementation;
const first = (name, row) => rows(name).find(same(row));

// An implementation that has no results of its own has, by definition, those of the default.
const judgedAs = (row) => (implementations[row.implementation].as_default ? { ...row, implementation: "default" } : row);

// The row of bounds.csv for an operation, format and implementation; none for other libraries.
export const known = (row) => first("bounds", row);

export function describe(row, whole) {
  const bound = known(row);
  const kernel = row.kernel_sha256 ?? first("exhaustive", row)?.kernel_sha256;
  const judged = row.max_ulp !== null;
  return { title: `${words(row.operation)}, ${subjectLabel(row)}`, facts: [
    ["operands", `${row.operands}, ${number(row.samples)} samples, ${number(row.regular)} regular`],
    ["cycles", `${number(row.cycles_min)} / ${number(row.cycles_mean)} / ${number(row.cycles_max)} (least, mean, largest)`],
    judged ? ["largest error", `${number(row.max_ulp)} ulp, ${number(row.max_error)} in the result's unit`] : ["error", "not judged"],
    judged && ["witness", witness(row.format, row.max_ulp_witness)],
    judged && ["rms, bias", `${number(row.rms_ulp)}, ${number(row.mean_ulp)} ulp`],
    bound?.bound && ["worst of any run", `${number(bound.max_ulp)} ulp (${[bound.bound, bound.proof, bound.ulp_run].filter(Boolean).join("; ")}) at ${witness(row.format, bound.max_ulp_witness)}`],
    bound && ["most cycles of any run", `${number(bound.cycles_max)} (${bound.cycles_bound}; ${bound.cycles_run}) at ${witness(row.format, bound.cycles_max_witness)}`],
    ["flash, stack", `${number(row.flash_bytes)}, ${number(row.stack_bytes)} bytes`],
    row.rival && ["library", `${row.origin} ${row.version ?? ""} ${row.commit ?? ""}, measured ${row.measured}`.replace(/ +/g, " ")],
    row.edges && ["at the edges", row.edges],
    kernel && ["kernel", hash(kernel, whole)],
  ] };
}

function histogram(row) {
  const judged = judgedAs(row), bins = rows("error_histograms").filter(same(judged));
  if (!bins.length) return h("p", { class: "soft" }, "The data have no histogram of its error.");
  const total = bins.reduce((sum, bin) => sum + bin.count, 0);
  const inside = bins.filter((bin) => Number.isFinite(bin.low_ulp) && Number.isFinite(bin.high_ulp));
  const beyond = total - inside.reduce((sum, bin) => sum + bin.count, 0);
  const run = first("accuracy", judged);
  const reach = Math.max(0.6, ...inside.map((bin) => Math.max(Math.abs(bin.low_ulp), Math.abs(bin.high_ulp))));
  return h("figure", { "data-part": "histogram" }, h("h3", {}, "Distribution of the error"),
    drawing(`Histogram of the error of ${row.operation} in ulp`, { height: 210, marginLeft: 48, marginBottom: 36,
      x: { label: "error, ulp", domain: [-reach, reach], labelAnchor: "center", labelArrow: "none" },
      y: { label: "share of inputs", grid: true, labelArrow: "none", tickFormat: tick, ticks: 5 },
      marks: [Plot.rectY(inside, { x1: "low_ulp", x2: "high_ulp", y: (bin) => bin.count / total, fill: colour(subjectOf(row).style) }),
        Plot.ruleX([-0.5, 0.5], { stroke: "var(--soft)", strokeDasharray: "2 3" }), Plot.ruleY([0])] }),
    h("figcaption", {}, run ? `Operands: ${run.operands}; ${whole(run.samples)} judged; the definition fixes the result of ${whole(run.defined)} more; ${number(run.underflowed)} underflow. ` : "",
      `${whole(beyond)} beyond ±${number(reach)} ulp. Dotted: ±0.5 ulp, correct rounding.`,
      judged.implementation !== row.implementation ? ` Its results are by definition those of ${implementations.default.label}.` : ""));
}

function along(row) {
  const judged = judgedAs(row), parts = rows("error_along_input").filter(same(judged));
  if (!parts.length) return h("p", { class: "soft" }, "The data have no error along its input.");
  const lines = [["max_ulp", "largest", null], ["rms_ulp", "rms", "5 3"], ["mean_ulp", "bias", "1 3"]];
  const middle = (part) => Math.sqrt(part.low * part.high);
  return h("figure", { "data-part": "along" }, h("h3", {}, "Error along the input"),
    drawing(`Error of ${row.operation} along its input, in ulp`, { height: 210, marginLeft: 48, marginRight: 46, marginBottom: 36,
      x: { type: "log", label: "input (positive)", labelAnchor: "center", labelArrow: "none", tickFormat: tick, ticks: 5 },
      y: { label: "error, ulp", grid: true, labelArrow: "none", ticks: 5 },
      marks: [Plot.ruleY([0]), ...lines.flatMap(([column, name, dash]) => [
        Plot.line(parts, { x: middle, y: column, stroke: colour(subjectOf(row).style), strokeDasharray: dash, strokeWidth: 1.4 }),
        Plot.text(parts.slice(-1), { x: middle, y: column, text: () => name, dx: 4, textAnchor: "start" })])] }),
    h("figcaption", {}, `${whole(parts.reduce((sum, part) => sum + part.samples, 0))} samples in ${number(parts.length)} parts. The worst part errs by ${number(Math.max(...parts.map((part) => part.max_ulp)))} ulp; the worst of any run is ${number(known(row).max_ulp)}.`));
}

// The card of a pinned point.
export function details(row, unpin) {
  hide();
  const told = describe(row, true);
  const runs = measured().filter(same(row));
  const columns = [["operands", "operands"], ["cycles_mean", "cycles, mean"], ["cycles_max", "largest"], ["max_ulp", "largest error, ulp"], ["rms_ulp", "rms"], ["mean_ulp", "bias"]];
  return h("section", { class: "card pinned", "aria-label": `Pinned: ${told.title}`, tabindex: "-1" },
    h("header", {}, h("h2", {}, told.title), h("button", { type: "button", onclick: unpin }, "Unpin")),
    h("div", { class: "panels" },
      h("div", {}, facts(told.facts)),
      histogram(row), along(row),
      h("div", { class: "scroll free whole" }, h("table", {}, h("thead", {}, h("tr", {}, columns.map(([, text]) => h("th", { scope: "col" }, text)))),
        h("tbody", {}, runs.map((run) => h("tr", {}, columns.map(([column]) => h("td", { class: typeof run[column] === "number" ? "number" : null }, number(run[column])))))))),
    ),
    h("p", { class: "soft" }, "Data: ",
      [...[row.rival ? "rivals" : "operations", "accuracy", "exhaustive", "error_histograms", "error_along_input"].filter(has)].map((name, index) => [
        index ? ", " : "", h("a", { href: `data/${name}.csv` }, `${name}.csv`), command(name) ? [" (", h("code", {}, command(name)), ")"] : ""]), "."));
}
