// SPDX-License-Identifier: GPL-3.0-or-later
// Elements, and the controls that choose what a view shows.

// An element with attributes, listeners (`onclick`) and children; null and false are left out.
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat(3).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

export function facts(pairs) {
  return h("dl", { class: "facts" },
    pairs.filter((pair) => pair).map(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
}

// options: [value, label, disabled].
export function select(state, name, label, options) {
  if (!options.some(([value]) => value === state.get(name))) state.chosen.delete(name);
  return h("label", {}, label,
    h("select", { name, onchange: (event) => state.set(name, event.target.value) },
      options.map(([value, text, disabled]) => h("option",
        { value, disabled, selected: state.get(name) === value }, text))));
}

// Check boxes; the summary names those that are checked. options: [value, label, ornament].
export function choice(state, name, label, options) {
  const chosen = () => {
    const labels = options.filter(([value]) => state.list(name).includes(value)).map(([, text]) => text);
    return labels.length === options.length ? "all" : labels.join(", ") || "none";
  };
  const told = h("b", {}, chosen());
  const box = h("fieldset", {}, h("legend", { class: "unseen" }, label),
    options.map(([value, text, ornament]) => h("label", {},
      h("input", { type: "checkbox", name, value, checked: state.list(name).includes(value) }), ornament, text)));
  box.addEventListener("change", () => {
    state.set(name, [...box.querySelectorAll("input:checked")].map((input) => input.value).join(","));
    told.textContent = chosen();
  });
  return h("details", { class: "choice", open: state.wide }, h("summary", {}, label, ": ", told), box);
}
