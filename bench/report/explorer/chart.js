// SPDX-License-Identifier: GPL-3.0-or-later
// A chart of Observable Plot whose points can be pointed at, visited with the arrow keys, and pinned. All three show
// the same details of a point.
import * as Plot from "@observablehq/plot";
import { h, facts } from "./dom.js";
import { styles } from "./data.js";
import { tick } from "./text.js";

const names = Object.keys(styles);
export const colour = (style) => `color-mix(in oklab, ${styles[style].colour}, white var(--lighten))`;
// A symbol in a text.
export const letter = ({ style, hollow }) => h("span", { class: hollow ? "letter hollow" : "letter", style: `--of:${colour(style)}`, "aria-hidden": "true" }, styles[style].letter);
// The library's cross, turned.
const saltire = { draw(context, size) {
  const arm = Math.sqrt(size / 5) / 2, turned = (x, y) => [(x - y) * Math.SQRT1_2, (x + y) * Math.SQRT1_2];
  const corners = [[-3, -1], [-1, -1], [-1, -3], [1, -3], [1, -1], [3, -1], [3, 1], [1, 1], [1, 3], [-1, 3], [-1, 1], [-3, 1]];
  corners.forEach(([x, y], index) => context[index ? "lineTo" : "moveTo"](...turned(x * arm, y * arm)));
  context.closePath();
} };
// The scales that every chart shares: a colour and a symbol per number format, and one per rival.
export const scales = {
  color: { domain: names, range: names.map(colour) },
  symbol: { domain: names, range: names.map((name) => (styles[name].symbol === "saltire" ? saltire : styles[name].symbol)) },
};

const tip = document.getElementById("tip"), live = document.getElementById("live");
export function hide() { tip.hidden = true; }
document.addEventListener("keydown", (event) => { if (event.key === "Escape") hide(); });

// Shows details next to a place of the document, within the window.
export function show(told, left, top) {
  tip.replaceChildren(h("strong", {}, told.title), facts(told.facts), told.hint ? h("div", { class: "soft" }, told.hint) : "");
  tip.hidden = false;
  const { width, height } = tip.getBoundingClientRect();
  const right = document.documentElement.clientWidth - width - 8;
  tip.style.left = `${Math.max(8, Math.min(left + 14, right)) + scrollX}px`;
  const below = top + 14 + height < innerHeight || top < height + 14;
  tip.style.top = `${(below ? top + 14 : top - height - 14) + scrollY}px`;
}
export function say(told) {
  live.textContent = [told.title, ...told.facts.filter((pair) => pair).map(([name, value]) => `${name}: ${value.title ?? value}`)].join("; ");
}

// Ticks of a logarithmic axis: powers of ten, and multiples if there are few of them.
function ticks([low, high]) {
  const first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high)), decades = last - first;
  const multiples = high / low < 4 ? [1, 1.5, 2, 3, 4, 5, 6, 8] : decades <= 3 ? [1, 2, 5] : [1];
  const stride = Math.max(1, Math.ceil(decades / 7));
  const all = [];
  for (let exponent = first; exponent <= last; exponent += stride)
    for (const multiple of multiples) all.push(multiple * 10 ** exponent);
  return all.map((value) => Number(value.toPrecision(3))).filter((value) => value >= low && value <= high);
}

// A logarithmic axis over the values. Zero has no place on it, and is put below all others.
export function logAxis(values, label, more = []) {
  const positive = [...values, ...more].filter((value) => value > 0);
  let low = Math.min(...positive), high = Math.max(...positive);
  if (!positive.length) [low, high] = [0.1, 1];
  const floor = values.some((value) => value === 0) ? low / 10 : null;
  const span = Math.max(1.3, (high / low) ** 0.06);
  const domain = [(floor ?? low) / span, high * span];
  const shown = ticks([low / span ** 0.5, domain[1]]);
  return { floor, domain, label, place: (value) => (value === 0 ? floor : value),
    ticks: floor ? [floor, ...shown] : shown, written: (value) => (value === floor ? "0" : tick(value)) };
}

// The points whose labels do not overlap others; each says whether its label is on the left.
function legible(points, x, y, width, height) {
  const part = (value, [low, high]) => Math.log(value / low) / Math.log(high / low);
  const kept = [];
  for (const point of points.filter((point) => point.text)) {
    const across = part(point.x, x.domain) * width, up = part(point.y, y.domain) * height;
    const length = 6 * point.text.length + 8, left = across + length > width;
    const from = left ? across - length : across;
    if (kept.some((other) => from < other.to && other.from < from + length && Math.abs(up - other.up) < 12)) continue;
    kept.push({ point, left, from, to: from + length, up });
  }
  return kept;
}

// points: {x, y, style, hollow, faded, text, ...}. `describe` returns {title, facts} of a point, `pin` takes a point;
// `under` are the marks below the points.
export function chart({ label, points, x, y, under = [], height = 280, describe, pin }) {
  const holder = h("div", { class: "chart", tabindex: points.length ? "0" : null, role: "group",
    "aria-label": `${label}. ${points.length} points; the arrow keys walk through them${pin ? ", Enter pins one" : ""}.` });
  const ordered = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const place = { x: "x", y: "y", clip: false };
  let plot, ring, current = null;

  function point(at, spoken) {
    current = at;
    ring?.remove();
    if (!at) return hide();
    ring = document.createElementNS("http://www.w3.org/2000/svg", "circle");
    const left = plot.scale("x").apply(at.x), top = plot.scale("y").apply(at.y);
    for (const [name, value] of Object.entries({ cx: left, cy: top, r: 9, fill: "none", stroke: "currentColor", "stroke-width": 1.5 }))
      ring.setAttribute(name, value);
    plot.append(ring);
    const box = plot.getBoundingClientRect();
    const told = describe(at);
    show(told, box.left + left, box.top + top);
    if (spoken) say(told);
  }

  function draw(width) {
    const drawn = (filter, options) => Plot.dot(points.filter(filter), { ...place, symbol: "style", r: 5, ...options,
      opacity: (at) => (at.faded ? 0.35 : 1) });
    const labels = legible(points, x, y, width - 66, height - 64);
    const texts = (left) => Plot.text(labels.filter((label) => label.left === left).map(({ point }) => point),
      { ...place, text: "text", dx: left ? -8 : 8, dy: -6, textAnchor: left ? "end" : "start", fill: "var(--soft)", stroke: "var(--card)", strokeWidth: 3 });
    plot = Plot.plot({ width, height, marginLeft: 50, marginRight: 16, marginBottom: 38, marginTop: 26, ...scales,
      x: { type: "log", domain: x.domain }, y: { type: "log", domain: y.domain },
      marks: [
        // The library would leave out some of the labels that a logarithmic axis is given.
        Plot.gridX(x.ticks), Plot.gridY(y.ticks),
        Plot.axisX(x.ticks, { text: x.written, label: x.label, labelAnchor: "center", labelArrow: "none" }),
        Plot.axisY(y.ticks, { text: y.written, label: y.label, labelAnchor: "top", labelArrow: "none" }),
        ...under,
        texts(false), texts(true),
        drawn((at) => !at.hollow, { fill: "style", stroke: "var(--card)", strokeWidth: 1 }),
        drawn((at) => at.hollow, { stroke: "style", fill: "var(--card)", strokeWidth: 1.8 }),
        // Finds the nearest point and draws nothing.
        Plot.dot(points, Plot.pointer({ ...place, stroke: "none", maxRadius: 30 }))] });
    // The holder provides the text for screen readers.
    plot.setAttribute("aria-hidden", "true");
    plot.addEventListener("input", () => point(plot.value, false));
    holder.replaceChildren(plot);
  }

  holder.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (step) {
      const index = current ? ordered.indexOf(current) + step : step > 0 ? 0 : ordered.length - 1;
      point(ordered[(index + ordered.length) % ordered.length], true);
      event.preventDefault();
    } else if (event.key === "Enter" && current) pin?.(current);
  });
  holder.addEventListener("blur", () => point(null));
  holder.addEventListener("click", () => { if (current) pin?.(current); });
  new ResizeObserver(([{ contentRect }]) => {
    const width = Math.floor(contentRect.width);
    if (width > 0 && width !== plot?.drawnWidth) { draw(width); plot.drawnWidth = width; hide(); }
  }).observe(holder);
  return holder;
}

// A chart without interactive points, drawn as wide as possible.
export function drawing(label, options) {
  const holder = h("div", { class: "chart", role: "img", "aria-label": label });
  let last = 0;
  new ResizeObserver(([{ contentRect }]) => {
    const width = Math.floor(contentRect.width);
    if (width === 0 || width === last) return;
    const plot = Plot.plot({ ...options, width: (last = width) });
    plot.setAttribute("aria-hidden", "true");
    holder.replaceChildren(plot);
  }).observe(holder);
  return holder;
}

// The points that no other beats in both coordinates, by x.
export function front(points) {
  const kept = [];
  for (const point of [...points].sort((a, b) => a.x - b.x || a.y - b.y))
    if (!kept.length || point.y < kept.at(-1).y) kept.push(point);
  return kept;
}

// The front as a line of steps that continues to the right end.
export function frontLine(kept, right, stroke) {
  return Plot.line([...kept, { ...kept.at(-1), x: right }], { x: "x", y: "y", curve: "step-after", stroke, strokeWidth: 1.2, strokeOpacity: 0.7 });
}
