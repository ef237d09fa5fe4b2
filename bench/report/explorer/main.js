// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the view named in the address.
import { views as available } from "./data.js";
import { h } from "./dom.js";
import { hide } from "./chart.js";
import { State } from "./state.js";
import * as operations from "./operations.js";
import * as overview from "./overview.js";
import * as scenes from "./scenes.js";
import * as stability from "./stability.js";
import * as table from "./table.js";

const known = { overview, operations, scenes, stability, table };
const root = document.getElementById("main"), nav = document.getElementById("views");
const links = Object.fromEntries(available.map((name) => [name, h("a", { href: `#view=${name}` }, known[name].title)]));
nav.append(...Object.values(links));
document.querySelector(".skip").addEventListener("click", (event) => { event.preventDefault(); root.focus(); });

let state, draw;
function show() {
  hide();
  state = new State(location.hash, (name) => draw?.(name));
  const name = available.includes(state.view) ? state.view : available[0];
  state.defaults = known[name].defaults;
  for (const [each, link] of Object.entries(links))
    if (each === name) link.setAttribute("aria-current", "page"); else link.removeAttribute("aria-current");
  // A link leads back to what was selected in its view.
  if (name === state.view) links[name].href = location.hash;
  state.saved = (address) => { links[name].href = address; };
  root.replaceChildren();
  document.body.dataset.view = name;
  draw = known[name].build(root, state);
}
window.addEventListener("hashchange", show);
show();
document.body.dataset.ready = "yes";
