// The picture, and what the mouse and the keys do in it. Ways are told in heights of the picture, once a frame.

const CLICK = 4; // pixels: what moves less was no drag
const SPEED = 0.9; // radii of the mesh a second, by keys
const KEYS = {
  KeyW: [0, 0, 1], KeyS: [0, 0, -1], KeyA: [-1, 0, 0], KeyD: [1, 0, 0], KeyE: [0, 1, 0], KeyQ: [0, -1, 0],
  ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1], ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0],
};
const find = (id) => document.getElementById(id);

export class Picture {
  // say(kind, facts): to the server. onClick(x, y): a place in the picture, shares from the left and from the top.
  constructor(say, onClick) {
    this.say = say;
    this.onClick = onClick;
    this.stage = find("stage");
    this.frame = find("frame");
    this.canvas = find("picture");
    this.context = this.canvas.getContext("2d", { alpha: false });
    this.size = [1, 1];
    this.held = new Set();
    this.pending = null;
    this.steerPicture();
    this.steerByKeys();
    new ResizeObserver(() => this.fit()).observe(this.stage);
  }

  draw(facts, data, offset) {
    const { width, height } = facts;
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    this.context.putImageData(new ImageData(new Uint8ClampedArray(data, offset, 4 * width * height), width, height), 0, 0);
    this.size = facts.draft ? this.size : [width, height];
    this.fit();
    this.canvas.classList.toggle("coarse", !facts.draft && this.frame.clientWidth >= 2 * width);
  }

  fit() {
    const [width, height] = [this.canvas.width, this.canvas.height];
    const scale = Math.min(this.stage.clientWidth / width, this.stage.clientHeight / height);
    this.frame.style.width = `${Math.floor(scale * width)}px`;
    this.frame.style.height = `${Math.floor(scale * height)}px`;
  }

  showHandles(places, lights, labelled) {
    const box = find("handles");
    while (box.children.length > places.length) box.lastChild.remove();
    while (box.children.length < places.length) box.append(this.newHandle(box.children.length));
    places.forEach((place, number) => {
      const handle = box.children[number];
      handle.hidden = !labelled || !place;
      if (!place) return;
      handle.style.left = `${100 * Math.min(Math.max(place.x, 0.02), 0.98)}%`;
      handle.style.top = `${100 * Math.min(Math.max(place.y, 0.02), 0.98)}%`;
      handle.style.setProperty("--glow", cssColor(lights[number].color));
      handle.classList.toggle("behind", place.behind);
    });
  }

  newHandle(number) {
    const handle = document.createElement("button");
    handle.className = "handle";
    handle.textContent = number + 1;
    handle.title = `Light ${number + 1}: drag it around, wheel for its distance`;
    handle.setAttribute("aria-label", handle.title);
    let behind = false;
    this.dragged(handle, {
      start: () => { behind = handle.classList.contains("behind"); },
      move: (right, up) => this.later("move_light", { light: number, right, up, behind }),
    });
    handle.addEventListener("wheel", (event) => {
      event.preventDefault();
      event.stopPropagation();
      const factor = Math.exp(clamp(event.deltaY, 100) / 600);
      this.say("move_light", { light: number, right: 0, up: 0, behind: false, factor });
    }, { passive: false });
    return handle;
  }

  steerPicture() {
    this.dragged(this.stage, {
      move: (right, up, event) => this.later(event.shiftKey || event.buttons > 1 ? "slide" : "turn", { right, up }),
      click: (event) => {
        const box = this.canvas.getBoundingClientRect();
        const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
        if (x >= 0 && x < 1 && y >= 0 && y < 1) this.onClick(x, y);
      },
    });
    this.stage.addEventListener("contextmenu", (event) => event.preventDefault());
    this.stage.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.later("zoom", { factor: Math.exp(clamp(event.deltaY, 200) / 700) });
    }, { passive: false });
  }

  // What a pointer does that is held down on an element; ways are shares of the picture's height.
  dragged(element, { start = () => {}, move, click = () => {} }) {
    let from = null;
    let way = 0;
    element.addEventListener("pointerdown", (event) => {
      if (event.target !== element && event.target.closest(".handle")) return;
      event.stopPropagation();
      element.setPointerCapture(event.pointerId);
      [from, way] = [[event.clientX, event.clientY], 0];
      this.stage.focus({ preventScroll: true });
      start();
    });
    element.addEventListener("pointermove", (event) => {
      if (!from) return;
      const [x, y] = [event.clientX - from[0], event.clientY - from[1]];
      from = [event.clientX, event.clientY];
      way += Math.hypot(x, y);
      const height = this.frame.clientHeight || 1;
      if (way > CLICK) {
        this.stage.classList.add("dragging");
        move(x / height, -y / height, event);
      }
    });
    const end = (event) => {
      if (from && way <= CLICK && event.type === "pointerup" && event.button === 0) click(event);
      from = null;
      this.stage.classList.remove("dragging");
    };
    element.addEventListener("pointerup", end);
    element.addEventListener("pointercancel", end);
  }

  // Tell the server once a frame; ways of the same kind add up until then, factors multiply.
  later(kind, facts) {
    const same = this.pending && this.pending.kind === kind && this.pending.facts.light === facts.light;
    if (this.pending && !same) this.flush();
    if (!this.pending) {
      this.pending = { kind, facts: { ...facts } };
      requestAnimationFrame(() => this.flush());
      return;
    }
    const sum = this.pending.facts;
    for (const key of ["right", "up", "ahead"]) if (key in facts) sum[key] += facts[key];
    if ("factor" in facts) sum.factor = clamp(sum.factor * facts.factor, 20);
  }

  flush() {
    if (this.pending) this.say(this.pending.kind, this.pending.facts);
    this.pending = null;
  }

  steerByKeys() {
    let last = 0;
    const step = (now) => {
      if (!this.held.size) return;
      const way = (SPEED * Math.min(now - last, 100)) / 1000;
      last = now;
      const faster = this.held.has("ShiftLeft") || this.held.has("ShiftRight") ? 3 : 1;
      const sum = [0, 0, 0];
      for (const code of this.held) (KEYS[code] ?? [0, 0, 0]).forEach((part, axis) => { sum[axis] += part * way * faster; });
      if (sum.some(Boolean)) this.say("fly", { right: sum[0], up: sum[1], ahead: sum[2] });
      requestAnimationFrame(step);
    };
    this.stage.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const shift = event.code.startsWith("Shift");
      if (!shift && !(event.code in KEYS)) return;
      if (!shift) event.preventDefault();
      const idle = !this.held.size;
      this.held.add(event.code);
      if (idle) {
        last = performance.now();
        requestAnimationFrame(step);
      }
    });
    this.stage.addEventListener("keyup", (event) => this.held.delete(event.code));
    this.stage.addEventListener("blur", () => this.held.clear());
  }
}

const clamp = (value, most) => Math.min(Math.max(value, -most), most);

// A linear colour, made as bright as it can be, for the screen.
export function cssColor(linear) {
  const most = Math.max(...linear, 1e-9);
  const codes = linear.map((value) => Math.round(255 * encoded(value / most)));
  return `rgb(${codes.join(" ")})`;
}

export const encoded = (value) => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
export const decoded = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
