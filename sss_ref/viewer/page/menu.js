// The panel: a folding section for each table of the scene file, a row for each key.

import { control } from "./controls.js";
import { cssColor } from "./picture.js";

const OPEN = new Set(["Scene", "Light 1", "Translucency", "Blur"]);
const at = (tables, path) => path.reduce((table, key) => table?.[key], tables);
const spoken = (key) => key.replaceAll("_", " ");
const titled = (name) => spoken(name)[0].toUpperCase() + spoken(name).slice(1);

export class Menu {
  // tables: what the server says of the scene file. change(key, value): called with a dotted key.
  constructor(tables, change) {
    this.tables = tables;
    this.change = change;
    this.box = document.getElementById("tables");
    this.rows = [];
    this.shape = "";
  }

  // values: every key's value; given: those that the scene itself has.
  show(values, given) {
    const sections = [...this.sections(values)];
    const shape = JSON.stringify(sections.map(([title, path, table]) => [title, path, table.path]));
    if (shape !== this.shape) this.build(sections);
    this.shape = shape;
    for (const { path, row, show } of this.rows) {
      const value = at(values, path) ?? null;
      show(value);
      row.classList.toggle("given", at(given, path) !== undefined);
      row.classList.toggle("unset", value === null);
      row.classList.remove("wrong");
    }
    this.box.querySelectorAll("summary i").forEach((dot, number) => {
      dot.style.background = cssColor(values.lights[number].color);
    });
  }

  // What is wrong is marked: lines of the server, each with its key.
  mark(lines) {
    for (const { path, row } of this.rows) {
      const named = path.map((part, number) => (typeof part === "number" ? `[${part}]` : number ? `.${part}` : part)).join("");
      row.classList.toggle("wrong", lines.some((line) => line.includes(` ${named}:`)));
    }
  }

  *sections(values) {
    for (const table of this.tables) {
      const [name, inner] = table.path;
      if (name === undefined) yield ["Scene", [], table];
      else if (name === "camera") {
        if (values.camera.type === inner) yield ["Camera", ["camera"], table];
      } else if (name === "lights") {
        for (const [number, light] of values.lights.entries()) {
          if (light.type === inner) yield [`Light ${number + 1}`, ["lights", number], table];
        }
      } else if (name === "layers") {
        for (const number of values.layers.keys()) {
          yield [inner ? `Layer ${spoken(inner)}` : "Layer", ["layers", number, ...(inner ? [inner] : [])], table];
        }
      } else yield [titled(name), [name], table];
    }
  }

  build(sections) {
    const open = this.shape ? new Set([...this.box.querySelectorAll("details[open]")].map((each) => each.dataset.title)) : OPEN;
    this.rows = [];
    const lights = sections.filter(([, path]) => path[0] === "lights").sort((a, b) => a[1][1] - b[1][1]);
    const first = sections.findIndex(([, path]) => path[0] === "lights");
    const others = sections.filter(([, path]) => path[0] !== "lights");
    const ordered = [...others.slice(0, first), ...lights, ...others.slice(first)];
    this.box.replaceChildren(...ordered.map(([title, path, table]) => this.section(title, path, table, open.has(title))));
  }

  section(title, path, table, open) {
    const details = document.createElement("details");
    details.open = open;
    details.dataset.title = title;
    const summary = document.createElement("summary");
    summary.append(title);
    if (path[0] === "lights") summary.append(document.createElement("i"));
    const rows = document.createElement("div");
    rows.className = "rows";
    rows.append(...table.controls.map((spec) => this.row([...path, spec.key], spec)));
    details.append(summary, rows);
    return details;
  }

  row(path, spec) {
    const row = document.createElement("div");
    row.className = "row";
    row.dataset.key = path.join(".");
    const label = document.createElement("span");
    label.className = "label";
    label.textContent = spoken(spec.key);
    label.title = `${row.dataset.key}: ${spec.help}\n\nA dot: the scene gives it. Click here to leave it to the preset.`;
    label.addEventListener("click", () => {
      if (row.classList.contains("given")) this.change(row.dataset.key, null);
    });
    const made = control(spec, (value) => this.change(row.dataset.key, value));
    const input = made.element.matches("input, select") ? made.element : made.element.querySelector("input[type=text]");
    input?.setAttribute("aria-label", row.dataset.key);
    const holder = made.element.classList.contains("control") ? made.element : Object.assign(document.createElement("div"), { className: "control" });
    if (holder !== made.element) holder.append(made.element);
    row.append(label, holder);
    this.rows.push({ path, row, show: made.show });
    return row;
  }
}
