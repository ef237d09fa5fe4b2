// SPDX-License-Identifier: GPL-3.0-or-later
// The selection, kept in the address after #. Defaults are not included.
export class State {
  // `changed` is called with the name of what was selected.
  constructor(hash, changed) {
    this.chosen = new URLSearchParams(hash.slice(1));
    this.defaults = {};
    this.changed = changed;
    this.wide = window.innerWidth > 700;
  }
  get view() { return this.chosen.get("view"); }
  get(name) { return this.chosen.get(name) ?? this.defaults[name] ?? ""; }
  list(name) { return this.get(name).split(",").filter((entry) => entry); }
  set(name, value) {
    if (value === (this.defaults[name] ?? "")) this.chosen.delete(name);
    else this.chosen.set(name, value);
    this.save();
    this.changed(name);
  }
  // Without a new entry in the history, and without the event hashchange.
  save() {
    const address = `#${this.chosen.toString().replaceAll("%2C", ",").replaceAll("%2F", "/")}`;
    history.replaceState(null, "", address);
    this.saved?.(address);
  }
  // The selected names that start with the prefix.
  names(prefix) { return [...this.chosen.keys()].filter((name) => name.startsWith(prefix)); }
}
