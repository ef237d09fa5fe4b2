// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost: a panel for each operation, a point for each format and implementation.
import { compared, formats, implementations, measured, physics, styles, unique } from "./data.js";
import { choice, h, select } from "./dom.js";
import { chart, front, frontLine, letter, logAxis, colour } from "./chart.js";
import { formatLabel, number, subjectLabel, subjectOf, words } from "./text.js";
import { describe, details } from "./point.js";

const errors = { max: "largest", rms: "rms", bias: "bias (mean)" };
const units = { absolute: "in the unit of the result", ulp: "in ulp of the format" };
const costs = { cycles_mean: "cycles, mean", cycles_max: "cycles, largest", flash_bytes: "flash, bytes", stack_bytes: "stack, bytes" };
const classes = { small: "below 1", physics: `${physics[0]} to ${physics[1]}`, full: "all magnitudes", published: "of the 2016 table",
  boundary: "boundary table", all: "every input" };

export const title = "Operations";
export const defaults = { operation: "add,multiply,divide,sqrt,sin,atan2", format: "q8_8,q16_16,q32_32,float,s16_15", pin: "",
  implementation: Object.keys(implementations).join(","), operands: "physics", error: "max", unit: "absolute", cost: "cycles_mean" };

const all = measured;

function errorOf(row, error, unit) {
  if (error === "bias") return row.mean_ulp === null ? null : Math.abs(row.mean_ulp);
  return row[`${error}_${unit === "ulp" ? "ulp" : "error"}`];
}

// Errors in the unit of the result can be compared across the formats that share operands and domain; all others only
// within a format.
export function group(row, unit) {
  return unit === "absolute" && row.operands === "physics" && compared[row.operation].includes(row.format) ? "shared" : row.format;
}

function panel(operation, state, pin) {
  const error = state.get("error"), cost = state.get("cost");
  const unit = error === "bias" ? "ulp" : state.get("unit");
  const selected = all().filter((row) => row.operation === operation && row.operands === state.get("operands")
    && state.list("format").includes(row.format) && state.list("implementation").includes(row.implementation));
  const judged = selected.filter((row) => errorOf(row, error, unit) !== null);
  const groups = Map.groupBy(judged, (row) => group(row, unit));
  const shared = groups.has("shared");
  const y = logAxis(judged.map((row) => errorOf(row, error, unit)), unit === "ulp" ? `${errors[error]} error, ulp` : `${errors[error]} error`);
  const x = logAxis(judged.map((row) => row[cost]), costs[cost]);
  const points = judged.map((row) => {
    const { style, hollow } = subjectOf(row);
    return { row, x: x.place(row[cost]), y: y.place(errorOf(row, error, unit)), style, hollow, faded: shared && group(row, unit) !== "shared",
      text: style === "published" ? formatLabel(row.format) : style === "rival" ? implementations[row.implementation].label : hollow ? row.implementation : "" };
  });
  const right = x.domain[1];
  const fronts = [...groups.keys()].filter((key) => !shared || key === "shared")
    .map((key) => [key, front(points.filter((point) => group(point.row, unit) === key))]);
  const drawn = fronts.filter(([key, kept]) => key === "shared" || kept.length > 1 || groups.get(key).length > 1);
  const told = drawn.map(([key, kept]) => `${key === "shared" ? "Front" : `Front of ${formatLabel(key)}`}: ${kept
    .map(({ row }) => `${subjectLabel(row)} (${number(row[cost])}; ${number(errorOf(row, error, unit))})`).join(", ")}.`);
  const apart = shared ? unique(points.filter((point) => point.faded).map((point) => formatLabel(point.row.format))) : [];
  const unjudged = selected.filter((row) => !judged.includes(row)).map(subjectLabel);
  return h("figure", { "data-operation": operation }, h("h2", {}, words(operation)),
    points.length
      ? chart({ label: `${operation}: ${errors[error]} error against ${costs[cost]}`, points, x, y, pin: (point) => pin(point.row),
        under: drawn.map(([key, kept]) => frontLine(kept, right, key === "shared" ? "var(--soft)" : colour(formats[key].style))),
        describe: (point) => ({ ...describe(point.row), hint: "Click or Enter pins it." }) })
      : h("p", { class: "soft" }, "The data have no row for these formats, implementations and operands."),
    h("figcaption", {}, told.join(" "),
      apart.length ? ` Faint, not compared: ${apart.join(", ")}, because an operand or a result may not fit.` : "",
      unjudged.length ? ` Without a judged error: ${unjudged.join(", ")}.` : ""));
}

export function build(root, state) {
  const operations = unique(all().map((row) => row.operation));
  const panels = h("div", { class: "panels" }), pinned = h("div", {});
  const unit = select(state, "unit", "unit", Object.entries(units));
  const present = new Set(all().map((row) => row.format));
  const used = new Set(all().map((row) => row.implementation));
  root.append(h("div", { class: "controls" },
      select(state, "operands", "operands", Object.entries(classes).map(([value, text]) => [value, `${value}: ${text}`])),
      select(state, "error", "error", Object.entries(errors)), unit,
      select(state, "cost", "against", Object.entries(costs)),
      choice(state, "operation", "Operations", operations.map((value) => [value, words(value)])),
      choice(state, "format", "Formats", Object.entries(formats).filter(([name]) => present.has(name)).map(([value, facts]) => [value, facts.label, letter(facts)])),
      choice(state, "implementation", "Implementations", Object.entries(implementations).filter(([value]) => used.has(value)).map(([value, { label }]) => [value, label]))),
    pinned, panels,
    h("p", { class: "soft" }, "Each number format has a colour and a symbol; ", letter({ style: "published" }), ` is the ${styles.published.label}, labelled with its format; `, letter({ style: "rival" }), ` is ${styles.rival.label}; hollow symbols are variants of ours. The grey line is the Pareto front of what can be compared: `,
      "errors in the unit of the result across formats that hold all operands and results, other errors within one format. ",
      "A result that the definition fixes (saturated, outside the domain) has no error and does not count as an error of 0; 0 on an axis is an exact result. ",
      "Mean cycles and errors in the unit of the result are over the regular operands, whose result is neither fixed in this way nor underflows."));

  function draw() {
    unit.querySelector("select").disabled = state.get("error") === "bias";
    const pin = (row) => {
      state.set("pin", [row.operation, row.format, row.implementation, row.operands].join("/"));
      pinned.querySelector("[tabindex]")?.focus();
    };
    const [operation, format, implementation, operands] = state.get("pin").split("/");
    const row = all().find((row) => row.operation === operation && row.format === format && row.implementation === implementation && row.operands === operands);
    pinned.replaceChildren(...(row ? [details(row, () => state.set("pin", ""))] : []));
    panels.replaceChildren(...operations.filter((name) => state.list("operation").includes(name)).map((name) => panel(name, state, pin)));
  }
  draw();
  return draw;
}
