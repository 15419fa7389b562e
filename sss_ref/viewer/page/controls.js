// One control for each kind of key. Each has an element, and show(value), which puts a value into it.

import { decoded, encoded } from "./picture.js";

const make = (tag, facts = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), facts);
  element.append(...children);
  return element;
};
const text = (value) => (typeof value === "number" ? String(+value.toPrecision(6)) : JSON.stringify(value));
const isHeld = (element) => document.activeElement === element;

// spec: what the server says of a key. change(value): called with a new one, null for none.
export function control(spec, change) {
  const kinds = { choice, mesh: choice, switch: toggle, number, channels, color, vector, text: line, value: json };
  return kinds[spec.kind](spec, change);
}

function choice(spec, change) {
  const select = make("select");
  select.addEventListener("change", () => change(select.value || null));
  const show = (value) => {
    const own = typeof value === "string" ? value : value === null ? "" : "own rows";
    const names = [...(spec.optional ? [""] : []), ...spec.choices];
    const all = names.includes(own) ? names : [...names, own];
    if (select.options.length !== all.length || !all.every((name, at) => select.options[at].value === name)) {
      select.replaceChildren(...all.map((name) => make("option", { value: name, textContent: name.replaceAll("_", " ") || "none" })));
    }
    select.value = own;
  };
  return { element: select, show };
}

function toggle(_, change) {
  const box = make("input", { type: "checkbox" });
  box.addEventListener("change", () => change(box.checked));
  return { element: box, show: (value) => { box.checked = value; } };
}

function entry(change, parse, placeholder = "") {
  const input = make("input", { type: "text", placeholder, spellcheck: false, autocomplete: "off" });
  input.addEventListener("change", () => change(input.value.trim() ? parse(input.value.trim()) : null));
  input.addEventListener("keydown", (event) => { if (event.key === "Enter") input.blur(); });
  return input;
}

const line = (spec, change) => {
  const input = entry(change, (typed) => typed, "none");
  return { element: input, show: (value) => { if (!isHeld(input)) input.value = value ?? ""; } };
};

const parsed = (typed) => {
  try {
    return JSON.parse(typed);
  } catch {
    return typed; // the server says what is wrong with it
  }
};

const json = (_, change) => {
  const input = entry(change, parsed);
  return { element: input, show: (value) => { if (!isHeld(input)) input.value = value === null ? "" : text(value); } };
};

const vector = (_, change) => {
  const input = entry(change, (typed) => typed.replace(/[[\]]/g, "").split(/[\s,]+/).filter(Boolean).map(parsed), "x, y, z");
  return { element: input, show: (value) => { if (!isHeld(input)) input.value = value ? value.map(text).join(", ") : ""; } };
};

// Where a number has no end, the slider goes as far as twice what it was when it was last let go.
function span([least, largest], value, whole) {
  const reach = 2 * Math.abs(value) || 1;
  const [low, high] = [least ?? -reach, largest !== null && largest <= 180 ? largest : reach];
  return { min: low, max: high, step: whole ? 1 : (high - low) / 400 };
}

function number(spec, change) {
  const slider = make("input", { type: "range", tabIndex: -1 });
  const input = entry(change, parsed, "not set");
  slider.addEventListener("input", () => {
    input.value = text(+slider.value);
    change(+(+slider.value).toPrecision(6));
  });
  let shown = null;
  const show = (value) => {
    shown = value;
    if (!isHeld(input)) input.value = value === null ? "" : text(value);
    slider.hidden = value === null || typeof value !== "number";
    if (slider.hidden || slider.matches(":active")) return;
    Object.assign(slider, span(spec.range, value, spec.whole));
    slider.value = value;
  };
  slider.addEventListener("change", () => show(shown));
  return { element: make("div", { className: "control" }, slider, input), show };
}

// One number for all channels, or three.
function channels(spec, change) {
  const one = number(spec, change);
  const three = vector(spec, change);
  const both = make("button", { className: "small", title: "One number, or one for red, green and blue" });
  let shown = null;
  both.addEventListener("click", () => change(Array.isArray(shown) ? shown[1] : [shown, shown, shown]));
  const show = (value) => {
    shown = value;
    const many = Array.isArray(value);
    both.textContent = many ? "rgb" : "1";
    one.element.hidden = many;
    three.element.hidden = !many;
    (many ? three : one).show(value);
  };
  one.element.style.flex = "1";
  return { element: make("div", { className: "control" }, one.element, three.element, both), show };
}

function color(spec, change) {
  const swatch = make("input", { type: "color" });
  const input = entry(change, (typed) => (spec.names?.includes(typed) ? typed : typed.replace(/[[\]]/g, "").split(/[\s,]+/).filter(Boolean).map(parsed)));
  swatch.addEventListener("input", () => {
    const codes = swatch.value.match(/[0-9a-f]{2}/g).map((code) => parseInt(code, 16) / 255);
    change(codes.map((code) => +decoded(code).toPrecision(4)));
  });
  const show = (value) => {
    if (!isHeld(input)) input.value = Array.isArray(value) ? value.map(text).join(", ") : value;
    if (Array.isArray(value) && !isHeld(swatch)) {
      const codes = value.map((part) => Math.round(255 * Math.min(encoded(Math.max(part, 0)), 1)));
      swatch.value = `#${codes.map((code) => code.toString(16).padStart(2, "0")).join("")}`;
    }
  };
  return { element: make("div", { className: "control" }, swatch, input), show };
}
