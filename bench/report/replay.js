// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the recording at a time t, in s; everything else only says which t.
"use strict";
const $ = id => document.getElementById(id);
const recording = JSON.parse($("recording").textContent);
const {signals, pins, screens, sample, plant} = recording;
const samples = signals.lever.length, end = (samples - 1) * sample;
const radians = Math.PI / 180, lowerStop = -30;  // degrees above the horizontal
const mm = 1000;

// Sample k is at (k + 1) * sample of the recording's clock, by which pins and screens are stamped.
const clock = t => t + sample;
const index = t => Math.min(samples - 1, Math.max(0, Math.floor(t / sample + 1e-6)));
function at(name, t) {
  const values = signals[name], k = index(t), next = Math.min(k + 1, samples - 1);
  return values[k] + (values[next] - values[k]) * Math.min(1, Math.max(0, t / sample - k));
}
const number = (value, places, unit) => `${value.toFixed(places).replace("-", "\u2212")}\u202f${unit}`;
function make(parent, name, attributes = {}, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.textContent = text;
  parent.append(element);
  return element;
}
const set = (element, attributes) => {
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
};

// Side view. The lever points to the left; an angle of the servo turns it clockwise on the page.
const turn = degrees => `rotate(${(degrees + lowerStop).toFixed(3)})`;
const point = (degrees, radius) => {
  const angle = (degrees + lowerStop) * radians;
  return [-Math.cos(angle) * radius, -Math.sin(angle) * radius];
};
const reach = Math.max(...signals.arm) * mm + 24;
function drawProtractor() {
  const high = Math.max(reach / 2, 150) + 26;
  $("scene").setAttribute("viewBox", `${-reach - 56} ${-high} ${reach + 130} ${2 * high}`);
  const radius = 140, group = $("protractor");
  const [x0, y0] = point(0, radius), [x1, y1] = point(60, radius);
  make(group, "path", {d: `M${x0},${y0}A${radius},${radius} 0 0 1 ${x1},${y1}`});
  for (let degrees = 0; degrees <= 60; degrees += 10) {
    const [ax, ay] = point(degrees, radius), [bx, by] = point(degrees, radius + (degrees % 30 ? 6 : 12));
    make(group, "line", {x1: ax, y1: ay, x2: bx, y2: by});
    // Beside the lines of the stops.
    const [tx, ty] = point(degrees + (degrees - 30) / 4.5, radius + 4);
    if (degrees % 60 === 0) make(group, "text", {x: tx, y: ty + 4, "text-anchor": "middle"}, `${degrees}°`);
  }
  for (const degrees of [0, 60]) {
    const [x, y] = point(degrees, reach);
    make(group, "line", {class: "stop", x1: 0, y1: 0, x2: x, y2: y});
  }
}
// Of each sample, the last one until then in which the hand held on.
const lastHeld = [];
signals.held.forEach((held, k) => lastHeld.push(held ? k : k ? lastHeld[k - 1] : -samples));
const trail = Array.from({length: 14}, (_, k) => make($("trail"), "circle", {r: 12 - k * 0.6, opacity: 0.22 * (1 - k / 14)}));
function drawScene(t) {
  const lever = at("lever", t), servo = at("servo", t), arm = at("arm", t) * mm;
  const told = at("told", t), force = at("hand", t), held = signals.held[index(t)];
  $("frame").setAttribute("transform", turn(servo));
  $("lever").setAttribute("transform", turn(lever));
  // Once it lets go it stays where it was, draws back and fades.
  const last = lastHeld[index(t)], free = index(t) - last, away = Math.min(1, free * sample / 0.15);
  $("hand").setAttribute("transform",
    `${turn(free ? signals.lever[Math.max(0, last)] : lever)} translate(${-34 * away} ${26 * away})`);
  $("hand").setAttribute("opacity", Math.max(0, 1 - free * sample / 0.4));
  const [x, y] = point(told, arm), [line, weight, label] = $("arm").children;
  const [x1, y1] = point(told, plant.lever * mm + 6);  // from where the lever ends
  set(line, {x1, y1, x2: x, y2: y});
  set(weight, {cx: x, cy: y});
  set(label, {x: x - 20, y: y + 5});
  trail.forEach((circle, k) => {
    const before = Math.max(0, t - (k + 1) * 0.012);
    const [cx, cy] = point(at("told", before), at("arm", before) * mm);
    set(circle, {cx, cy});
  });
  const strong = Math.abs(force) > 0.1;
  const [px, py] = point(lever, plant.lever * mm);
  const angle = (lever + lowerStop) * radians, length = force * 16;
  const [dx, dy] = [Math.sin(angle) * length, -Math.cos(angle) * length];
  set($("push"), {x1: px, y1: py, x2: px + dx, y2: py + dy, visibility: strong ? "visible" : "hidden"});
  set($("push-label"), {x: px + 10 + dx, y: py + dy - 2});
  $("push-label").textContent = strong ? number(Math.abs(force), 1, "N") : "";
  $("state").replaceChildren(`Arm ${number(arm / 10, 1, "cm")}`,
    Object.assign(document.createElement("small"), {textContent: held ? "the hand holds the lever" : "nobody holds the lever"}));
}

// What the frame sees: 6 units a millimetre; the foam fills what there is between sensor and lever.
function drawClose(t) {
  const scale = 6, room = 40, half = 9, gap = room - half;  // units; at rest a foam fills the gap
  const shift = (at("lever", t) - at("servo", t)) * radians * plant.sensor_radius * mm * scale;
  const least = 3, y = Math.max(-gap + least, Math.min(gap - least, -shift));
  set($("close-lever"), {y: y - half});
  const free = gap + (plant.preload * mm) * scale;  // of a foam that nothing presses
  const above = Math.min(free, gap + y), below = Math.min(free, gap - y);
  set($("foam-a"), {y: -room, height: above});
  set($("foam-b"), {y: room - below, height: below});
  const strength = force => 0.35 + 0.65 * Math.min(1, force / 14);
  const a = at("force_a", t), b = at("force_b", t);
  $("foam-a").setAttribute("opacity", strength(a));
  $("foam-b").setAttribute("opacity", strength(b));
  const k = index(t);
  $("text-a").textContent = `A  ${number(a, 1, "N")}  reads ${signals.reading_a[k]}`;
  $("text-b").textContent = `B  ${number(b, 1, "N")}  reads ${signals.reading_b[k]}`;
}

const kinds = {".": "cells-rod", "o": "cells-weight", "#": "cells-pivot"};
let shownScreen = null;
function drawScreen(t) {
  let low = 0, high = screens.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (screens[middle].at <= clock(t) + 1e-6) low = middle; else high = middle;
  }
  if (shownScreen === low) return;
  shownScreen = low;
  const paths = {"cells-rod": "", "cells-weight": "", "cells-pivot": ""};
  [...screens[low].cells].forEach((cell, k) => {
    if (kinds[cell]) paths[kinds[cell]] += `M${k % 20 + 0.04},${Math.floor(k / 20) + 0.04}h.92v.92h-.92z`;
  });
  for (const [id, path] of Object.entries(paths)) $(id).setAttribute("d", path);
}

// Graphs over the whole recording: drawn once for a width, then only their cursor moves.
const left = 34, right = 6, top_ = 6, bottom = 18;
const graphs = [
  {id: "angles", traces: [["told", "k-told"], ["servo", "k-servo"], ["lever", "k-lever"]], step: 20},
  {id: "forces", traces: [["force_a", "k-a"], ["force_b", "k-b"], ["hand", "k-hand"]], step: 5},
];
function spans(values) {  // [begin, end) of the samples that are not 0
  const list = [];
  values.forEach((value, k) => {
    if (value && !values[k - 1]) list.push([k, k + 1]);
    else if (value) list.at(-1)[1] = k + 1;
  });
  return list;
}
function layOut(graph) {
  const svg = $(graph.id), width = svg.clientWidth, height = svg.clientHeight;
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.replaceChildren();
  const all = graph.traces.flatMap(([name]) => signals[name]);
  // A quarter of a step beyond the axis is let be.
  const low = Math.floor(Math.min(...all) / graph.step + 0.25) * graph.step;
  const high = Math.ceil(Math.max(...all) / graph.step - 0.05) * graph.step;
  const x = t => left + t / end * (width - left - right);
  const y = value => top_ + (high - value) / (high - low) * (height - top_ - bottom);
  graph.x = x;
  for (const [from, to] of spans(signals.held))
    make(svg, "rect", {class: "held", x: x(from * sample), y: top_, width: x(to * sample) - x(from * sample),
                       height: height - top_ - bottom});
  for (let value = Math.ceil(low / graph.step) * graph.step; value <= high; value += graph.step) {
    make(svg, "line", {class: "grid", x1: left, x2: width - right, y1: y(value), y2: y(value)});
    make(svg, "text", {x: left - 6, y: y(value) + 4, "text-anchor": "end"}, String(value).replace("-", "\u2212"));
  }
  const every = width < 500 ? 1 : 0.5;
  for (let t = 0; t <= end + sample; t += every)
    make(svg, "text", {x: x(t), y: height - 3, "text-anchor": t === 0 ? "start" : t + every > end + sample ? "end" : "middle"}, `${t} s`);
  for (const [name, key] of graph.traces) {
    const points = signals[name].map((value, k) => `${x(k * sample).toFixed(1)},${y(value).toFixed(1)}`);
    make(svg, "polyline", {class: key, points: points.join(" ")});
  }
  graph.cursor = make(svg, "line", {class: "cursor", y1: top_, y2: height - bottom});
}

// Pins: when each goes up and down, from how long it stays, and the lengths that are shown.
const lanes = [["step", "k-step"], ["render", "k-render"], ["servo", "k-pulse"]];
const edges = {};
for (const [name] of lanes) {
  let now = 0;
  edges[name] = pins[name].map(stay => (now += stay) / 1e6);
}
function firstFrom(list, time) {  // the index of the first up edge whose pulse ends after `time`
  let low = 0, high = list.length >> 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((list[2 * middle + 1] ?? Infinity) > time) high = middle; else low = middle + 1;
  }
  return 2 * low;
}
function drawPins(t) {
  const svg = $("pins"), width = svg.clientWidth, height = svg.clientHeight;
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.replaceChildren();
  const span = 0.06, from = clock(t) - span / 2, to = from + span;
  const x = time => left + (Math.min(to, Math.max(from, time)) - from) / span * (width - left - right);
  const lane = (height - top_ - bottom) / lanes.length;
  for (let offset = -30; offset <= 30; offset += 10) {
    const place = x(clock(t) + offset / 1000);
    make(svg, "line", {class: "grid", x1: place, x2: place, y1: top_, y2: height - bottom});
    make(svg, "text", {x: place, y: height - 3, "text-anchor": offset < -20 ? "start" : offset > 20 ? "end" : "middle"},
         offset ? `${offset > 0 ? "+" : "\u2212"}${Math.abs(offset)}` : "ms");
  }
  lanes.forEach(([name, key], row) => {
    const list = edges[name], y = top_ + row * lane + 4, high = lane - 8;
    let path = "";
    for (let k = firstFrom(list, from); k < list.length && list[k] < to; k += 2) {
      const a = x(list[k]), b = x(list[k + 1] ?? to);
      path += `M${a.toFixed(1)},${y}h${Math.max(0.8, b - a).toFixed(1)}v${high}H${a.toFixed(1)}z`;
    }
    make(svg, "path", {class: `lane ${key}`, d: path});
    make(svg, "line", {class: "grid", x1: left, x2: width - right, y1: y + high, y2: y + high});
  });
  make(svg, "line", {class: "cursor", x1: x(clock(t)), x2: x(clock(t)), y1: top_, y2: height - bottom});
}
// Of the pulses in the second before t: how many, and how long they are together.
function lately(name, t) {
  const list = edges[name], to = clock(t), from = Math.max(0, to - 1);
  let count = 0, high = 0;
  for (let k = firstFrom(list, from); k + 1 < list.length && list[k + 1] <= to; k += 2) {
    ++count;
    high += list[k + 1] - list[k];
  }
  return {count, share: high / (to - from), length: count ? high / count : 0, rate: count / (to - from)};
}

function drawValues(t) {
  const degrees = name => number(at(name, t), 1, "°"), newtons = name => number(at(name, t), 1, "N");
  for (const name of ["lever", "servo", "told"]) $(`v-${name}`).textContent = degrees(name);
  $("v-hand").textContent = newtons("hand");
  $("v-a").textContent = newtons("force_a");
  $("v-b").textContent = newtons("force_b");
  const step = lately("step", t), render = lately("render", t);
  $("v-step").textContent = `${number(step.rate, 0, "a second")}, ${number(step.length * 1000, 2, "ms")} each`;
  $("v-render").textContent = `${number(render.share * 100, 1, "% of the time")}`;
  const list = edges.servo, last = firstFrom(list, clock(t)) - 2;
  $("v-pulse").textContent = last >= 0 ? number((list[last + 1] - list[last]) * 1e6, 0, "µs") : "";
}

// Moments worth a button, found in the signals.
function findMoments() {
  const found = [], {lever, told, arm, held} = signals;
  const first = (from, test) => { for (let k = from; k < samples; ++k) if (test(k)) return k; return -1; };
  const note = (k, text) => { if (k >= 0) found.push([k, text]); };
  const moves = first(0, k => lever[k] - lever[0] > 1 && held[k]);
  note(moves, "pushed");
  if (moves >= 0) note(first(moves, k => arm[k] - arm[moves] > 0.002), "arm lengthened");
  const free = first(1, k => held[k - 1] && !held[k]);
  note(free, "let go");
  if (free >= 0) {
    const lands = first(free, k => told[k] < 1);
    note(lands, "at the stop");
    if (lands >= 0) {
      const up = first(lands + 1, k => told[k] > 1);
      if (up >= 0) {
        let top = up;
        while (top + 1 < samples && told[top + 1] >= told[top]) ++top;
        note(top, "bounced");
      }
    }
  }
  return found;
}

let now = 0, playing = false, before = null;
function draw() {
  drawScene(now);
  drawClose(now);
  drawScreen(now);
  drawPins(now);
  drawValues(now);
  for (const graph of graphs) set(graph.cursor, {x1: graph.x(now), x2: graph.x(now)});
  $("time").textContent = `${now.toFixed(3)} s`;
  $("scrub").value = Math.round(now / sample);
  $("scrub").setAttribute("aria-valuetext", `${now.toFixed(2)} seconds`);
}
function go(t) {
  now = Math.min(end, Math.max(0, t));
  draw();
}
function play(on) {
  playing = on;
  before = null;
  $("play-icon").setAttribute("d", on ? "M5,3h5v18h-5zM14,3h5v18h-5z" : "M6,3L21,12L6,21z");
  $("play").setAttribute("aria-label", on ? "Pause" : "Play");
  if (on) requestAnimationFrame(frame);
}
function frame(time) {
  if (!playing) return;
  if (before !== null) {
    const next = now + (time - before) / 1000 * Number($("speed").value);
    go(next > end ? 0 : next);
  }
  before = time;
  requestAnimationFrame(frame);
}

$("scrub").max = samples - 1;
$("scrub").addEventListener("input", () => { play(false); go($("scrub").value * sample); });
$("play").addEventListener("click", () => play(!playing));
for (const [k, text] of findMoments()) {
  const button = Object.assign(document.createElement("button"), {type: "button", textContent: text});
  button.append(Object.assign(document.createElement("small"), {textContent: `${(k * sample).toFixed(2)} s`}));
  button.addEventListener("click", () => { go(k * sample); });
  $("moments").append(button);
}
addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches("select")) return;
  const onButton = event.target.matches("button");
  const move = event.shiftKey ? 0.1 : sample;
  if (event.key === " " && !onButton) play(!playing);
  else if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
    play(false);
    go((Math.round(now / sample) * sample) + (event.key === "ArrowLeft" ? -move : move));
  } else if (event.key === "Home") go(0);
  else if (event.key === "End") go(end);
  else return;
  event.preventDefault();
});
for (const {id} of graphs) {
  const follow = event => {
    if (event.type === "pointermove" && !(event.buttons & 1)) return;
    const box = $(id).getBoundingClientRect();
    play(false);
    go((event.clientX - box.left - left) / (box.width - left - right) * end);
  };
  $(id).addEventListener("pointerdown", follow);
  $(id).addEventListener("pointermove", follow);
}
new ResizeObserver(() => { graphs.forEach(layOut); draw(); }).observe(document.querySelector(".graphs"));

function fromAddress() {
  const wanted = /^#t=([\d.]+)$/.exec(location.hash);
  if (wanted) { play(false); go(Number(wanted[1])); }
  return wanted;
}
addEventListener("hashchange", fromAddress);
drawProtractor();
graphs.forEach(layOut);
if (!fromAddress()) {
  go(0);
  play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
}
