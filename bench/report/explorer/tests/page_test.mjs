// SPDX-License-Identifier: GPL-3.0-or-later
// The page in Chromium, without a network, compared with the CSV files. PAGE and DATA name them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { chromium } from "playwright-core";

const address = `file://${process.env.PAGE}`;
const views = ["overview", "operations", "scenes", "stability", "table"];

// Rows of a CSV file: quoted cells may contain commas and quotes, but no line breaks.
function parsed(text) {
  const [names, ...rows] = text.trimEnd().split("\n").map((line) => {
    const cells = [];
    for (const [, quoted, plain] of line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)) cells.push(quoted?.replaceAll('""', '"') ?? plain);
    return cells;
  });
  return rows.map((cells) => Object.fromEntries(names.map((name, index) => [name, cells[index]])));
}
const load = (name) => parsed(readFileSync(`${process.env.DATA}/${name}.csv`, "utf8"));
const operations = load("operations");

// The number at the start of a text of the page: "1 127", "7.629·10⁻⁶", "−0.5".
function read(text) {
  const [, mantissa, exponent] = text.replaceAll("\u202f", "").replace("−", "-").match(/^(-?[\d.]+)?(?:·?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/);
  const digits = (exponent ?? "⁰").replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(digit)).replace("⁻", "-");
  return Number(mantissa ?? 1) * 10 ** Number(digits);
}
const close = (found, wanted, what) => assert.ok(Math.abs(found - Number(wanted)) <= 6e-4 * Math.abs(Number(wanted)), `${what}: ${found}, not ${wanted}`);

// All except other libraries.
const own = "implementation=default,portable,published,small,libc,accum,native";
let browser, page;
const wrong = [];

function watch(each) {
  each.on("console", (message) => wrong.push(`console: ${message.text()}`));
  each.on("pageerror", (error) => wrong.push(`error: ${error.stack}`));
  each.on("request", (request) => { if (!/^(file|blob|data|about):/.test(request.url())) wrong.push(`request: ${request.url()}`); });
  return each;
}
async function open(state) {
  const each = watch(await browser.newPage({ viewport: { width: 1280, height: 900 }, acceptDownloads: true }));
  await each.context().setOffline(true);
  each.setDefaultTimeout(8000);
  await each.goto(`${address}#${state}`);
  await each.waitForSelector("body[data-ready]");
  return each;
}
// Shows another state in the open page.
async function go(state) {
  await page.mouse.move(0, 0);
  await page.evaluate((hash) => { location.hash = hash; }, state);
  const view = new URLSearchParams(state).get("view");
  await page.waitForSelector(`body[data-view=${view}]`);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
const told = async (scope = "#tip") => Object.fromEntries(await page.locator(`${scope} dl`).first().evaluate((list) =>
  [...list.querySelectorAll("dt")].map((name) => [name.textContent, name.nextElementSibling.textContent])));

before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  page = await open("view=overview");
});
after(async () => {
  await browser?.close();
  assert.deepEqual(wrong, []);
});

test("every view draws, in both widths and both schemes", async () => {
  for (const [width, colorScheme] of [[400, "dark"], [1280, "light"]]) {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    for (const view of views) {
      await go(`view=${view}`);
      const drawn = await page.evaluate(() => ({ wide: document.documentElement.scrollWidth, rows: document.querySelectorAll("tbody tr").length,
        charts: [...document.querySelectorAll(".chart")].map((chart) => chart.querySelectorAll("svg [aria-label=dot] path, svg [aria-label=dot] circle").length),
        text: document.getElementById("main").innerText, unnamed: [...document.querySelectorAll("input,select,button")].filter((each) => !each.labels?.length && !each.ariaLabel && !each.textContent).length }));
      assert.ok(drawn.wide <= width, `${view} is ${drawn.wide} wide at ${width}`);
      assert.equal(drawn.charts.length, { operations: 6, scenes: 6, stability: 1 }[view] ?? 0, view);
      assert.ok(drawn.charts.every((points) => points > 0), `${view}: a chart without points`);
      if (!["operations", "scenes"].includes(view)) assert.ok(drawn.rows > 5, `${view}: ${drawn.rows} rows`);
      assert.doesNotMatch(drawn.text, /undefined|NaN|\[object|\bnull\b/, view);
      assert.equal(drawn.unnamed, 0, `${view}: a control without a name`);
    }
  }
});

test("no view breaks a rule of accessibility", async () => {
  const rules = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
  await page.evaluate(rules);
  for (const colorScheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme });
    for (const state of ["view=overview&range=1000", "view=operations&operation=sqrt&pin=sqrt/q16_16/default/physics", "view=scenes&scene=pendulum", "view=stability&case=rope", "view=table&file=growth"]) {
      await go(state);
      // Only the colours differ between the schemes.
      const { violations } = await page.evaluate((dark) => axe.run({ resultTypes: ["violations"], ...(dark && { runOnly: ["color-contrast"] }) }), colorScheme === "dark");
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes[0].html]), [], `${state}, ${colorScheme}`);
    }
  }
});

test("the first paint comes within a second", async () => {
  const times = [];
  for (let run = 0; run < 3 && !(Math.min(...times) < 1000); ++run) {
    const fresh = await open("view=operations");
    await fresh.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length > 0);
    times.push(await fresh.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime));
    await fresh.close();
  }
  assert.ok(Math.min(...times) < 1000, `first paint after ${times} ms`);
});

// Points at each dot of a panel: its details must be a row of the file, and the dot must be where that row's numbers
// are on logarithmic axes.
async function pointAtAll(panel, x, y) {
  const dots = page.locator(`${panel} svg [aria-label=dot] :is(path,circle)`);
  const found = [];
  for (const box of await dots.evaluateAll((all) => all.map((dot) => { const { x, y, width, height } = dot.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2 }; }))) {
    await page.mouse.move(box.x, box.y);
    await page.waitForSelector("#tip:not([hidden])");
    const title = await page.locator("#tip strong").textContent(), facts = await told();
    const ring = await page.locator(`${panel} svg > circle`).evaluate((circle) => { const { x, y, width, height } = circle.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2 }; });
    found.push({ title, facts, ring });
  }
  const at = found.map(({ facts, ring, title }) => ({ title, ring, x: Math.log(x(facts, title)), y: Math.log(y(facts, title)) })).filter((each) => Number.isFinite(each.y));
  for (const axis of ["x", "y"]) {
    const low = at.reduce((a, b) => (b[axis] < a[axis] ? b : a)), high = at.reduce((a, b) => (b[axis] > a[axis] ? b : a));
    const scale = (high.ring[axis] - low.ring[axis]) / (high[axis] - low[axis]);
    for (const each of at) assert.ok(Math.abs(low.ring[axis] + scale * (each[axis] - low[axis]) - each.ring[axis]) < 1.5, `${each.title} stands off on ${axis}`);
  }
  return found;
}

test("pointing at an operation tells the numbers of its row", async () => {
  await go(`view=operations&operation=sqrt&format=q8_8,q16_16,q32_32,float&${own}`);
  const variants = { default: "", portable: ", portable C++", published: ", 2016 design", small: ", small tables" };
  const label = (each) => (each.format === "float" ? "avr-libc float" : each.format.replace("q", "Q").replace("_", ".") + variants[each.implementation]);
  const row = (title) => operations.find((each) => each.operation === "sqrt" && each.operands === "physics" && title === `sqrt, ${label(each)}`);
  const found = await pointAtAll("[data-operation=sqrt]", (_, title) => Number(row(title).cycles_mean), (_, title) => Number(row(title).max_error));
  assert.ok(new Set(found.map(({ title }) => title)).size >= 8);
  for (const { title, facts } of found) {
    const wanted = row(title), cycles = facts.cycles.split(" / ");
    ["cycles_min", "cycles_mean", "cycles_max"].forEach((column, index) => close(read(cycles[index]), wanted[column], `${title}, ${column}`));
    close(read(facts["largest error"]), wanted.max_ulp, title);
    assert.equal(facts.witness.match(/^raw (-?\d+) =/)[1], wanted.max_ulp_witness);
    close(read(facts["flash, stack"]), wanted.flash_bytes, title);
  }
});

test("the worst of any run stands beside a sampled one", async () => {
  const [exhaustive] = load("exhaustive").filter((row) => row.operation === "exp" && row.format === "q16_16" && row.implementation === "default");
  await go("view=operations&operation=exp&pin=exp/q16_16/default/physics");
  const facts = await told(".pinned");
  close(read(facts["worst of any run"]), exhaustive.max_ulp, "exp");
  assert.match(facts["worst of any run"], new RegExp(`exact.*raw ${exhaustive.max_ulp_witness} `));
  close(read(facts["most cycles of any run"]), exhaustive.cycles_max, "exp");
  assert.equal(await page.locator(".pinned dd code").last().getAttribute("title"), exhaustive.kernel_sha256);
  // Q8.8 saturates where the others do not, so they are not compared.
  const caption = await page.locator("[data-operation=exp] figcaption").textContent();
  assert.match(caption, /Front: (?!.*Q8\.8.*Faint).*Faint, not compared: .*Q8\.8/);
});

test("the front is that of the rows which can be compared", async () => {
  await go(`view=operations&operation=sqrt&format=q4_4,q16_16,q32_32,float,s16_15,int32&${own}`);
  const told = [...(await page.locator("[data-operation=sqrt] figcaption").textContent()).match(/Front: [^.]*(?:\.\d[^.]*)*\./)[0].matchAll(/\(([^;()]+); ([^()]+)\)/g)];
  // 20 does not fit Q4.4.
  const rows = operations.filter((row) => row.operation === "sqrt" && row.operands === "physics" && ["q16_16", "q32_32", "float"].includes(row.format));
  const front = rows.filter((row) => !rows.some((other) => Number(other.cycles_mean) <= Number(row.cycles_mean) && Number(other.max_error) <= Number(row.max_error)
    && (other.cycles_mean !== row.cycles_mean || other.max_error !== row.max_error))).sort((a, b) => a.cycles_mean - b.cycles_mean);
  assert.equal(told.length, front.length);
  told.forEach(([, cycles, error], index) => { close(read(cycles), front[index].cycles_mean, "cycles"); close(read(error), front[index].max_error, "error"); });
});

test("other libraries stand beside ours, with their origin and what they do at the edges", async () => {
  const [rival] = load("rivals").filter((row) => row.variant === "libfixmath" && row.operation === "sqrt" && row.operands === "physics");
  await go("view=operations&operation=sqrt&format=q16_16&implementation=default,libfixmath&pin=sqrt/q16_16/libfixmath/physics");
  assert.equal(await page.locator("[data-operation=sqrt] svg [aria-label=dot] :is(path,circle)").count(), 2);
  const facts = await told(".pinned");
  close(read(facts.cycles.split(" / ")[1]), rival.cycles_mean, "cycles");
  close(read(facts["largest error"]), rival.max_ulp, "error");
  close(read(facts["largest error"].split(", ")[1]), Number(rival.max_ulp) / 2 ** 16, "error in the result's unit");
  assert.ok(facts.library.includes(rival.commit) && facts.library.includes(rival.measured));
  assert.equal(facts["at the edges"], rival.edges);
});

test("a witness of 64 bits keeps all of its digits", async () => {
  const row = operations.find((each) => /^-?\d{17,}$/.test(each.max_ulp_witness) && each.implementation === "default");
  await go(`view=operations&pin=${row.operation}/${row.format}/default/${row.operands}`);
  assert.ok((await told(".pinned")).witness.startsWith(`raw ${row.max_ulp_witness} =`));
});

test("a click pins a point and shows its histogram and error along the input", async () => {
  await go("view=operations&operation=sqrt&format=q16_16&implementation=small");
  const dot = await page.locator("[data-operation=sqrt] svg [aria-label=dot] :is(path,circle)").first().boundingBox();
  await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
  await page.mouse.down();
  await page.mouse.up();
  await page.waitForSelector(".pinned [data-part=histogram] svg [aria-label=rect]");
  assert.match(page.url(), /pin=sqrt\/q16_16\/small\/physics/);
  const mine = (row) => row.operation === "sqrt" && row.format === "q16_16" && row.implementation === "small";
  const bins = load("error_histograms").filter(mine).filter((bin) => !/inf/.test(bin.low_ulp + bin.high_ulp));
  const heights = await page.locator("[data-part=histogram] svg [aria-label=rect] rect").evaluateAll((all) => all.map((rect) => rect.getBoundingClientRect().height));
  assert.equal(heights.length, bins.length);
  const highest = Math.max(...heights), most = Math.max(...bins.map((bin) => Number(bin.count)));
  heights.forEach((height, index) => assert.ok(Math.abs(height / highest - bins[index].count / most) < 0.02));
  const largest = Math.max(...load("error_along_input").filter(mine).map((part) => Number(part.max_ulp)));
  close(read((await page.locator("[data-part=along] figcaption").textContent()).match(/errs by (\S+) ulp/)[1]), largest, "along");
  assert.equal(await page.locator("[data-part=along] svg [aria-label=line] path").count(), 3);
});

test("the keyboard walks through the points, pins, and is told of", async () => {
  await go("view=operations&operation=sqrt&format=q16_16,float");
  await page.locator("[data-operation=sqrt] .chart").focus();
  const cycles = [];
  for (let step = 0; step < 4; ++step) {
    await page.keyboard.press("ArrowRight");
    cycles.push(read((await told()).cycles.split(" / ")[1]));
    assert.match(await page.locator("#live").textContent(), /sqrt, .*cycles: .*witness: raw/);
  }
  assert.deepEqual(cycles, [...cycles].sort((a, b) => a - b));
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#tip").isHidden());
  await page.keyboard.press("Enter");
  await page.waitForSelector(".pinned");
});

test("a scene's point tells its row, and the budget is the chip's clock", async () => {
  await go("view=scenes&scene=pendulum&scalar=q16_16/nearest,float/avr-libc&error=error");
  const rows = load("scenes").filter((row) => row.scene === "pendulum" && row.verdict === "held" && row.cycles_per_simulated_second);
  const methods = { "explicit Euler": "explicit_euler", "semi-implicit Euler": "semi_implicit_euler", "velocity Verlet": "velocity_verlet" };
  const row = (title) => {
    const [, scalar, method, steps] = title.match(/^pendulum: (\S+), (.*), 1\/(\d+) s$/);
    return rows.find((each) => each.scalar === scalar.replace("Q", "q").replace(".", "_") && ["nearest", "avr-libc"].includes(each.arithmetic)
      && each.integrator === methods[method] && Math.round(1 / each.dt) === Number(steps));
  };
  const found = await pointAtAll("[data-scene=pendulum]", (_, title) => Number(row(title).cycles_per_simulated_second), (_, title) => Number(row(title).error));
  for (const { title, facts } of found) {
    close(read(facts.error), row(title).error, title);
    close(read(facts["cycles per simulated second"]), row(title).cycles_per_simulated_second, title);
  }
  const [a, b] = [found[0], found.find(({ ring }) => Math.abs(ring.x - found[0].ring.x) > 50)].map(({ title, ring }) => [Math.log(row(title).cycles_per_simulated_second), ring.x]);
  const line = await page.locator("[data-scene=pendulum] svg [aria-label=rule] line").first().boundingBox();
  const clock = JSON.parse(readFileSync(`${process.env.DATA}/operations.json`, "utf8")).context.mhz_per_cpu * 1e6;
  assert.ok(Math.abs(a[1] + (b[1] - a[1]) / (b[0] - a[0]) * (Math.log(clock) - a[0]) - line.x) < 1.5);
});

test("the map of stability has every case with its first event", async () => {
  const rows = load("stability").filter((row) => row.integrator === "velocity_verlet");
  await go("view=stability&method=velocity_verlet");
  const cells = page.locator(".map td[data-verdict]");
  assert.equal(await cells.count(), rows.length);
  const verdicts = await cells.evaluateAll((all) => all.map((cell) => cell.dataset.verdict));
  assert.deepEqual(verdicts.sort(), rows.map((row) => row.verdict.split(" ")[0]).sort());
  const wanted = rows.find((row) => row.scalar === "q16_16" && row.arithmetic === "saturating" && row.first_event);
  const line = page.locator(".map tbody tr", { has: page.locator(`th:text-matches("^${wanted.case.replaceAll("_", " ")} ")`) });
  await line.locator("td").last().hover();
  const facts = await told();
  assert.equal(facts["first event"], wanted.first_event);
  assert.equal(facts["beyond it"], wanted.verdict);
  close(read(facts[`limit of ${wanted.parameter}`]), wanted.limit, wanted.case);
  await line.locator("td").first().focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await page.locator("#live").textContent(), /limit of .*beyond it: /);
  await page.locator("input[name=case]").fill("rope");
  assert.equal(await page.locator(".map tbody tr").count(), new Set(rows.filter((row) => row.case.replaceAll("_", " ").includes("rope")).map((row) => row.case)).size);
});

test("the address restores what was chosen", async () => {
  await go("view=operations");
  await page.selectOption("select[name=operands]", "full");
  await page.selectOption("select[name=error]", "rms");
  await page.selectOption("select[name=unit]", "ulp");
  await page.locator("input[value=float]").uncheck();
  await page.locator("input[value=exp]").check();
  const state = (each) => each.evaluate(() => ({ text: document.getElementById("main").innerText,
    dots: [...document.querySelectorAll("svg [aria-label=dot]")].map((mark) => mark.innerHTML) }));
  const other = await open(new URL(page.url()).hash.slice(1));
  await other.waitForSelector("[data-operation=sqrt] svg");
  assert.deepEqual(await state(other), await state(page));
  assert.equal(await other.locator("[data-operation=exp]").count(), 1);
  // Each link leads to its view, with what was selected there.
  await other.locator("nav a", { hasText: "Scenes" }).click();
  await other.waitForSelector("body[data-view=scenes]");
  await other.locator("nav a", { hasText: "Operations" }).click();
  await other.waitForSelector("[data-operation=exp] svg");
  assert.deepEqual(await state(other), await state(page));
  await other.close();
});

test("an address that makes no sense shows the defaults", async () => {
  await go("view=table&file=nothing&sort=-nothing&is.nothing=1");
  assert.match(await page.locator("[role=status]").textContent(), new RegExp(`of ${operations.length.toLocaleString("en").replace(",", "\u202f")} rows`));
  await go("view=stability&method=magic&map=treasure&verdict=guilty");
  assert.ok(await page.locator(".map td[data-verdict]").count() > 0);
  await go("view=operations&operands=none&error=none&unit=none&cost=none&pin=a/b&operation=none,sqrt");
  assert.equal(await page.locator(".chart").count(), 1);
});

test("a table is filtered, sorted and saved as it stands", async () => {
  await go("view=table&file=operations");
  await page.fill("[aria-label='filter operation']", "=sqrt");
  await page.fill("[aria-label='filter cycles mean']", "<600");
  await page.fill("[aria-label='filter implementation']", "s");
  const header = page.locator("th[data-column=cycles_mean]");
  await header.locator("button").click();
  await header.locator("button").click();
  assert.equal(await header.getAttribute("aria-sort"), "descending");
  const foot = await page.locator("main > p.soft").last().textContent();
  assert.match(foot, /^operations\.csv(, written by fixbench [a-z_]+)?\. Filters: /);
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#download")]);
  const saved = parsed(readFileSync(await download.path(), "utf8"));
  const wanted = operations.filter((row) => row.operation === "sqrt" && Number(row.cycles_mean) < 600 && row.implementation.includes("s"))
    .sort((a, b) => b.cycles_mean - a.cycles_mean);
  assert.ok(wanted.length > 3);
  assert.equal(saved.length, wanted.length);
  saved.forEach((row, index) => {
    assert.deepEqual(Object.keys(row), Object.keys(wanted[index]));
    for (const [name, cell] of Object.entries(row))
      assert.ok(cell === wanted[index][name] || (cell !== "" && Number(cell) === Number(wanted[index][name])), `${name}: ${cell}, not ${wanted[index][name]}`);
  });
  assert.equal(await page.locator("tbody tr").count(), wanted.length);
});

test("the overview says which formats hold a need, and the mean and largest cycles", async () => {
  await go("view=overview&range=20&resolution=0.0001");
  assert.equal(await page.locator("p[role=status]").textContent(), "Q8.16, Q16.16, Q8.24, Q32.32, float fit.");
  const cells = await page.locator("[data-subject='q16_16/default'] td.number").evaluateAll((all) => all.map((cell) => cell.innerText.split("\n")));
  ["add", "multiply", "divide", "sqrt", "sin", "atan2"].forEach((operation, index) => {
    const mine = (row) => row.operation === operation && row.format === "q16_16" && row.implementation === "default";
    const mean = operations.find((row) => mine(row) && row.operands === "physics").cycles_mean;
    assert.equal(read(cells[index][0]), Math.round(mean));
    const largest = Math.max(...[...operations, ...load("exhaustive")].filter(mine).map((row) => Number(row.cycles_max)));
    assert.equal(read(cells[index][1].replace("≤ ", "")), largest, operation);
  });
  // Every pair of a format of 8 bits was run: its largest error is exact, whichever run found it first.
  const whole = operations.filter((row) => row.format === "q4_4" && row.implementation === "default" && row.operands === "all" &&
    ["add", "multiply", "divide", "sqrt", "sin", "atan2"].includes(row.operation));
  const wanted = whole.reduce((best, row) => (Number(row.max_ulp) > Number(best.max_ulp) ? row : best));
  const error = (await page.locator("[data-subject='q4_4/default'] td").evaluateAll((all) => all.map((cell) => cell.innerText)))
    .find((text) => text.includes("0.01 to 20")).split("\n");
  close(read(error[0]), wanted.max_ulp, "largest error");
  assert.equal(error[1], `${wanted.operation}, exact`);
});
