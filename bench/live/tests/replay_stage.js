// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the page's script at a time with elements that keep what is set on them, and prints that.
"use strict";
const vm = require("vm");
const given = JSON.parse(require("fs").readFileSync(0, "utf8"));

class Element {
  constructor() {
    Object.assign(this, {set: {}, children: [], textContent: "", value: "1", clientWidth: 800, clientHeight: 170});
  }
  setAttribute(name, value) { this.set[name] = value; }
  append(...children) { this.children.push(...children); }
  replaceChildren(...children) { this.children = children; }
  addEventListener() {}
}
const elements = {};
for (const identifier of given.identifiers) elements[identifier] = new Element();
elements.recording.textContent = given.scripts[0];
elements.arm.append(new Element(), new Element(), new Element());
vm.runInNewContext(given.scripts[1], {
  document: {
    getElementById: identifier => elements[identifier],
    querySelector: () => new Element(),
    createElement: () => new Element(),
    createElementNS: () => new Element(),
  },
  location: {hash: `#t=${given.time}`},
  addEventListener() {},
  ResizeObserver: class { observe() {} },
  requestAnimationFrame() {},
  matchMedia: () => ({matches: true}),
});
const shown = {};
for (const [identifier, element] of Object.entries(elements)) {
  shown[identifier] = {...element.set, text: element.textContent};
  element.children.forEach((child, k) => { if (identifier === "arm") shown[`arm/${k}`] = child.set; });
}
shown.moments.buttons = elements.moments.children.map(
  button => [button.textContent, parseFloat(button.children[0].textContent)]);
console.log(JSON.stringify(shown));
