// SPDX-License-Identifier: GPL-3.0-or-later
// Work-precision curves: error against cycles per simulated second, with a panel for each scene, a
// curve for each number format and method, and a point for each time step.
import * as Plot from "@observablehq/plot";
import { hertz, rows, scalars as subjects, unique } from "./data.js";
import { choice, h, select } from "./dom.js";
import { chart, front, frontLine, letter, logAxis } from "./chart.js";
import { number, words } from "./text.js";

const errors = { larger: "larger of method and arithmetic", error: "total", error_method: "of the method", error_arithmetic: "of the arithmetic" };
const dashes = { explicit_euler: "1 3", semi_implicit_euler: null, velocity_verlet: "6 3", implicit_springs: "8 3 1 3", direct_rods: "2 2" };

export const title = "Scenes";
// Runs on the chip that held and have a truth to be compared with.
const measured = () => rows("scenes").filter((row) => row.cycles_per_simulated_second !== null && row.error !== null
  && row.error_arithmetic !== null && row.verdict === "held");
const scalarOf = (row) => `${row.scalar}/${row.arithmetic}`;
const scalarLabel = (scalar) => subjects[scalar].label;
const step = (row) => (row.dt >= 1 ? `${row.dt} s` : `1/${Math.round(1 / row.dt)} s`);
// A sum of the two parts would look better than either if they cancel.
const errorOf = (row, error) => (error === "larger" ? Math.max(Math.abs(row.error_method), Math.abs(row.error_arithmetic)) : Math.abs(row[error]));

const first = unique(measured().map((row) => row.scene)).slice(0, 6);
export const defaults = { scene: first.join(","), error: "larger", scalar: unique(measured().map(scalarOf)).join(","),
  method: unique(measured().map((row) => row.integrator)).join(",") };

function describe(row) {
  return { title: `${words(row.scene)}: ${scalarLabel(scalarOf(row))}, ${words(row.integrator)}, ${step(row)}`, facts: [
    ["error", `${number(row.error)} ${row.unit}`],
    ["of the method", `${number(row.error_method)} ${row.unit}`],
    ["of the arithmetic", `${number(row.error_arithmetic)} ${row.unit}`],
    ["cycles per step", `${number(row.cycles_per_step_mean)} mean, ${number(row.cycles_per_step_max)} largest`],
    ["cycles per simulated second", `${number(row.cycles_per_simulated_second)}: ${number(100 * row.cycles_per_simulated_second / hertz)} % of the chip`],
    ["energy drift", number(row.energy_drift)],
    ["flash, RAM, stack", `${number(row.flash_bytes)}, ${number(row.ram_bytes)}, ${number(row.stack_bytes)} bytes`],
    ["steps", number(row.steps)],
  ] };
}

function panel(scene, state) {
  const error = state.get("error");
  const selected = measured().filter((row) => row.scene === scene && state.list("scalar").includes(scalarOf(row)) && state.list("method").includes(row.integrator));
  const other = rows("scenes").filter((row) => row.scene === scene && row.verdict !== "held").length;
  const y = logAxis(selected.map((row) => errorOf(row, error)), `error (${errors[error]}), ${selected[0]?.unit ?? ""}`);
  const x = logAxis(selected.map((row) => row.cycles_per_simulated_second), "cycles per simulated second", [hertz]);
  const points = selected.map((row) => ({ row, x: row.cycles_per_simulated_second, y: y.place(errorOf(row, error)), ...subjects[scalarOf(row)], series: `${scalarOf(row)}/${row.integrator}` }));
  const kept = front(points), few = unique(points.map((point) => point.series)).length <= 6;
  for (const point of points) if (few || kept.includes(point)) point.text = step(point.row).replace(" s", "");
  const lines = unique(selected.map((row) => row.integrator)).map((integrator) => Plot.line(
    points.filter((point) => point.row.integrator === integrator).sort((a, b) => b.row.dt - a.row.dt),
    { x: "x", y: "y", z: "series", stroke: "style", strokeWidth: 1.2, strokeOpacity: 0.75, strokeDasharray: dashes[integrator] ?? "3 2" }));
  const affordable = kept.filter((point) => point.x <= hertz);
  const best = affordable.at(-1)?.row;
  return h("figure", { "data-scene": scene }, h("h2", {}, words(scene)),
    points.length
      ? chart({ label: `${words(scene)}: error against cycles per simulated second`, points, x, y, height: 300, describe: (point) => describe(point.row),
        under: [frontLine(kept, x.domain[1], "var(--soft)"), ...lines,
          Plot.ruleX([hertz], { stroke: "var(--text)", strokeDasharray: "2 3" }),
          Plot.text([hertz], { x: (value) => value, frameAnchor: "top", dy: 2, dx: -4, textAnchor: "end", lineAnchor: "top", text: () => `the chip's limit, ${number(hertz / 1e6)} MHz`, fill: "var(--soft)" })] })
      : h("p", { class: "soft" }, "No successful run has these formats and methods."),
    h("figcaption", {}, best ? `Smallest error within the chip's limit: ${number(errorOf(best, error))} ${best.unit}, ${scalarLabel(scalarOf(best))}, ${words(best.integrator)}, ${step(best)}, ${number(100 * best.cycles_per_simulated_second / hertz)} % of its cycles.` : "",
      other ? ` ${other} runs of this scene failed and are not drawn.` : ""));
}

export function build(root, state) {
  const scenes = unique(measured().map((row) => row.scene));
  const unjudged = unique(rows("scenes").map((row) => row.scene)).filter((scene) => !scenes.includes(scene));
  const scalars = unique(measured().map(scalarOf)), methods = unique(measured().map((row) => row.integrator));
  const panels = h("div", { class: "panels" });
  const dash = (method) => {
    const sample = h("span", { "aria-hidden": "true" });
    sample.innerHTML = `<svg width="26" height="6"><line x1="0" x2="26" y1="3" y2="3" stroke="currentColor" stroke-width="1.6" stroke-dasharray="${dashes[method] ?? (method in dashes ? "none" : "3 2")}"/></svg>`;
    return sample;
  };
  root.append(h("div", { class: "controls" },
    select(state, "error", "error", Object.entries(errors)),
    choice(state, "scene", "Scenes", scenes.map((scene) => [scene, words(scene)])),
    choice(state, "scalar", "Number formats", scalars.map((scalar) => [scalar, scalarLabel(scalar), letter(subjects[scalar])])),
    choice(state, "method", "Methods", methods.map((method) => [method, words(method), dash(method)]))),
  panels, h("p", { class: "soft" }, "A curve is a format and a method, a point on it a time step; hollow symbols saturate. The grey line is the Pareto front, whose points ",
    "are labelled with the step in seconds; the dotted line is the chip's limit. The error is the largest distance of a particle from its true position. ",
    "In the total error, those of method and arithmetic may cancel by chance, and its front rewards that.",
    unjudged.length ? ` Without a reference to be judged by: ${unjudged.map(words).join(", ")}.` : ""));
  function draw() {
    panels.replaceChildren(...scenes.filter((scene) => state.list("scene").includes(scene)).map((scene) => panel(scene, state)));
  }
  draw();
  return draw;
}
