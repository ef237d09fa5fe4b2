// SPDX-License-Identifier: GPL-3.0-or-later
// Where each case fails in each format, and what goes wrong first; and how far the maps of two parameters reach.
import * as Plot from "@observablehq/plot";
import { command, rows, scalars as subjects, unique, verdicts } from "./data.js";
import { h, select } from "./dom.js";
import { chart, hide, letter, logAxis, say, show } from "./chart.js";
import { number, words } from "./text.js";

const kind = (row) => row.verdict.split(" ")[0];
const scalarOf = (row) => `${row.scalar}/${row.arithmetic}`;
const scalarLabel = (scalar) => subjects[scalar].label;

export const title = "Stability";
export const defaults = { method: "semi_implicit_euler", case: "", verdict: "", map: rows("stability_map")[0]?.map };

function describe(row) {
  return { title: `${words(row.case)}, ${scalarLabel(scalarOf(row))}, ${words(row.integrator)}`, facts: [
    [`limit of ${row.parameter}`, `${number(row.limit)}${row.unit === 1 ? "" : ` ${row.unit}`}${kind(row) === "stable" ? " (end of the search)" : ""}`],
    ["beyond it", row.verdict],
    ["first event", row.first_event ?? "none reported"],
    row.step !== null && ["in step", number(row.step)],
    ["judged by", row.reference],
  ] };
}

function cell(row) {
  const [mark, level] = verdicts[kind(row)];
  const element = h("td", { tabindex: "-1", style: `--level:${level}`, "data-verdict": kind(row) }, h("b", {}, mark), number(row.limit),
    row.first_event && h("small", { class: "event" }, words(row.first_event).replace(/^(overflow|underflow) /, "")));
  element.row = row;
  return element;
}

function grid(state) {
  const shown = rows("stability").filter((row) => row.integrator === state.get("method"));
  const scalars = unique(rows("stability").map(scalarOf));
  const wanted = state.get("case").toLowerCase();
  const cases = [...Map.groupBy(shown, (row) => row.case)].filter(([name, of]) => words(name).toLowerCase().includes(wanted)
    && (!state.get("verdict") || of.some((row) => kind(row) === state.get("verdict"))));
  const table = h("table", { class: "map", role: "grid", "aria-label": "Limit and verdict by case and format; the arrow keys walk through it" },
    h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "corner" }, "case, parameter"), scalars.map((scalar) => h("th", { scope: "col" }, letter(subjects[scalar]), " ", scalarLabel(scalar))))),
    h("tbody", {}, cases.map(([name, of]) => h("tr", {}, h("th", { scope: "row" }, words(name), h("small", { class: "soft" }, ` ${of[0].parameter}${of[0].unit === 1 ? "" : `, ${of[0].unit}`}`)),
      scalars.map((scalar) => { const row = of.find((row) => scalarOf(row) === scalar); return row ? cell(row) : h("td", {}, "–"); })))));
  table.querySelector("td[data-verdict]")?.setAttribute("tabindex", "0");
  const tell = (target, spoken) => {
    const at = target.closest?.("td[data-verdict]");
    if (!at) return hide();
    const box = at.getBoundingClientRect();
    show(describe(at.row), box.left, box.bottom - 10);
    if (spoken) say(describe(at.row));
  };
  table.addEventListener("pointerover", (event) => tell(event.target, false));
  table.addEventListener("pointerleave", hide);
  table.addEventListener("focusin", (event) => tell(event.target, true));
  table.addEventListener("focusout", hide);
  table.addEventListener("keydown", (event) => {
    const [down, across] = { ArrowDown: [1, 0], ArrowUp: [-1, 0], ArrowRight: [0, 1], ArrowLeft: [0, -1] }[event.key] ?? [0, 0];
    const at = event.target.closest("td");
    if (!at || (!down && !across)) return;
    const line = table.tBodies[0].rows[at.parentElement.sectionRowIndex + down];
    const next = line?.cells[at.cellIndex + across];
    if (next?.matches("td")) { at.tabIndex = -1; next.tabIndex = 0; next.focus(); }
    event.preventDefault();
  });
  return [cases, scalars, table];
}

function map(state) {
  const shown = rows("stability_map").filter((row) => row.map === state.get("map") && row.integrator === state.get("method"));
  const limited = shown.filter((row) => typeof row.limit === "number" && row.limit > 0);
  if (!limited.length) return h("p", { class: "soft" }, "This method has no limits in this map.");
  const bounds = unique(shown.map((row) => row.x)).map((at) => ({ x: at, y: shown.find((row) => row.x === at).bound })).filter(({ y }) => typeof y === "number");
  const x = logAxis(limited.map((row) => row.x), shown[0].x_name);
  const y = logAxis(limited.map((row) => row.limit), `${shown[0].y_name}${shown[0].unit === 1 ? "" : `, ${shown[0].unit}`}`, bounds.map((bound) => bound.y));
  const points = limited.map((row) => ({ row, x: row.x, y: row.limit, ...subjects[scalarOf(row)], series: scalarOf(row) }));
  const widest = Map.groupBy(limited, scalarOf);
  const none = shown.length - limited.length;
  return h("figure", { "data-map": state.get("map") }, chart({ label: `${words(state.get("map"))}: limit against ${shown[0].x_name}`, points, x, y, height: 340,
    under: [Plot.line(points.toSorted((a, b) => a.x - b.x), { x: "x", y: "y", z: "series", stroke: "style", strokeWidth: 1.3 }),
      bounds.length ? Plot.line(bounds.sort((a, b) => a.x - b.x), { x: "x", y: "y", stroke: "var(--text)", strokeDasharray: "5 4" }) : null],
    describe: ({ row }) => ({ title: `${scalarLabel(scalarOf(row))}, ${words(row.integrator)}`, facts: [
      [row.x_name, number(row.x)], [row.y_name, `${number(row.limit)}${row.unit === 1 ? "" : ` ${row.unit}`}`], ["limited by", row.limited_by], ["theoretical bound", number(row.bound)]] }) }),
  h("figcaption", {}, [...widest].map(([scalar, of]) => `${scalarLabel(scalar)}: ${number(Math.min(...of.map((row) => row.limit)))} to ${number(Math.max(...of.map((row) => row.limit)))}`).join("; "), ".",
    bounds.length ? " Dashed: theoretical bound." : "", none ? ` ${none} points have no limit to draw, because the case breaks everywhere there.` : ""));
}

export function build(root, state) {
  const all = rows("stability");
  const told = h("p", { class: "verdicts", role: "status" }), holder = h("div", { class: "scroll" }), maps = h("div", { class: "panels wide" });
  const search = h("label", {}, "cases containing", h("input", { type: "search", name: "case", value: state.get("case"), oninput: (event) => state.set("case", event.target.value) }));
  root.append(h("div", { class: "controls" },
    select(state, "method", "method", unique(all.map((row) => row.integrator)).map((name) => [name, words(name)])), search,
    select(state, "verdict", "with the verdict", [["", "any"], ...unique(all.map(kind)).map((name) => [name, name])])),
  h("p", { class: "soft" }, Object.entries(verdicts).filter(([name]) => all.some((row) => kind(row) === name)).map(([name, [mark, level, meaning]]) => h("span", { style: "margin-right:14px;display:inline-block" },
    h("span", { class: "key", style: `--level:${level}` }, mark), `${name}: ${meaning}`))),
  told, holder,
  h("p", { class: "soft" }, "Data: ", h("a", { href: "data/stability.csv" }, "stability.csv"), command("stability") ? [" (", h("code", {}, command("stability")), ")"] : "", "."),
  ...(rows("stability_map").length ? [h("h2", { style: "margin-top:18px" }, "Limits along a second parameter"),
    h("div", { class: "controls" }, select(state, "map", "map", unique(rows("stability_map").map((row) => row.map)).map((name) => [name, words(name)]))), maps] : []));
  function draw() {
    hide();
    const [cases, scalars, table] = grid(state);
    const held = scalars.map((scalar) => [scalar, cases.filter(([, of]) => of.some((row) => scalarOf(row) === scalar && kind(row) === "stable")).length]);
    told.textContent = `${cases.length} cases. Stable over the whole range: ${held.map(([scalar, count]) => `${scalarLabel(scalar)} ${count}`).join(", ")}.`;
    holder.replaceChildren(table);
    if (rows("stability_map").length) maps.replaceChildren(map(state));
  }
  draw();
  return draw;
}
