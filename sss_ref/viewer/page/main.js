// The page: what comes from the server goes to its place, and what is done here goes to the server.

import { Link } from "./link.js";
import { Menu } from "./menu.js";
import { Picture } from "./picture.js";

const find = (id) => document.getElementById(id);
const PATIENCE = 500; // milliseconds after a small picture, after which it is said that the whole one is drawn
const MENU_REST = 150; // milliseconds for which the menu stays as it is while pictures come fast
const PART = 2 ** 18; // bytes of a dropped file that go at once
const MESHES = /\.(obj|ply|stl|off|glb|gltf)$/i;
const state = { facts: null, size: [1, 1], lost: false, dropped: new Map(), times: [], menuShown: 0 };
let menu = null;

const link = new Link({ hello, picture: shown, problems, refused, explanation, file, received }, linked);
const say = (kind, facts) => link.say(kind, facts);
const picture = new Picture(say, explain);

function linked(holds) {
  find("link").textContent = holds ? "" : "server not reached, trying again";
  find("link").classList.toggle("lost", !holds);
  if (!holds) state.lost = state.facts !== null;
}

function hello(facts) {
  find("source").textContent = facts.source.split("/").at(-1);
  document.title = `${find("source").textContent} · sss_ref`;
  state.limit = facts.limit;
  menu ??= new Menu(facts.menu, change);
  find("size").textContent = "drawing …";
  if (!state.lost) return;
  state.lost = false;
  for (const each of state.dropped.values()) upload(each, false);
  say("restore", { data: state.facts.given });
  say("show", { buffer: find("buffer").value || "image" });
}

function shown(facts, data, offset) {
  say("drawn");
  picture.draw(facts, data, offset);
  Object.assign(state, { facts, size: facts.size });
  find("problems").hidden = true;
  if (!facts.draft || performance.now() - state.menuShown > MENU_REST) {
    menu.show(facts.values, facts.given);
    state.menuShown = performance.now();
  }
  picture.showHandles(facts.handles, facts.values.lights, facts.ofCamera);
  for (const [id, type] of [["orbit", "orbit"], ["fly", "free"]]) {
    find(id).setAttribute("aria-pressed", String(facts.values.camera.type === type));
  }
  showBuffers(facts);
  showStatus(facts);
  if (!facts.draft) lines(find("notes"), facts.notes);
}

function showBuffers({ passes, buffer }) {
  const select = find("buffer");
  const shape = JSON.stringify(passes);
  if (select.dataset.shape !== shape) {
    select.dataset.shape = shape;
    const groups = passes.map(({ name, buffers }) => {
      const group = Object.assign(document.createElement("optgroup"), { label: name });
      group.append(...buffers.map((each) => new Option(each, each)));
      return group;
    });
    select.replaceChildren(...groups);
  }
  if (document.activeElement !== select || !select.value) select.value = buffer;
}

function showStatus(facts) {
  const now = performance.now();
  state.times = [...state.times.filter((time) => now - time < 1000), now];
  const rate = facts.draft ? `${state.times.length} pictures/s` : `${facts.ms} ms`;
  find("size").textContent = `${facts.width} × ${facts.height} · ${rate}`;
  clearTimeout(state.waiting);
  if (facts.draft) state.waiting = setTimeout(() => { find("size").textContent = `drawing ${facts.size.join(" × ")} …`; }, PATIENCE);
  find("hash").textContent = facts.hash ? `${facts.buffer} ${facts.hash}` : "";
  find("scale").hidden = facts.low === null;
  find("low").textContent = facts.low ?? "";
  find("high").textContent = facts.high ?? "";
  find("unit").textContent = facts.unit;
  find("ramp").hidden = !facts.ramp;
  if (facts.ramp) find("ramp").style.background = `linear-gradient(90deg, ${facts.ramp})`;
  document.body.dataset.pictures = Number(document.body.dataset.pictures ?? 0) + 1;
  document.body.dataset.still = String(!facts.draft);
}

function lines(box, texts) {
  box.hidden = !texts.length;
  box.replaceChildren(...texts.map((text) => Object.assign(document.createElement("p"), { textContent: text })));
}

function problems({ lines: texts, given }) {
  lines(find("problems"), texts);
  const back = Object.assign(document.createElement("button"), { textContent: "Go back" });
  back.addEventListener("click", () => say("back"));
  find("problems").append(back);
  find("hash").textContent = "";
  menu.mark(texts);
  if (state.facts) state.facts.given = given;
}

function refused({ lines: texts }) {
  lines(find("problems"), texts);
}

// Sliders say more than can be drawn: of each key the last value, once a frame.
const waiting = new Map();
function change(key, value) {
  if (key === "camera.type") {
    say("camera", { type: value });
    return;
  }
  if (!waiting.size) requestAnimationFrame(() => {
    for (const [each, last] of waiting) say("set", { key: each, value: last });
    waiting.clear();
  });
  waiting.set(key, value);
}

function explain(x, y) {
  if (!state.facts?.ofCamera) return;
  const [width, height] = state.size;
  const [column, fromTop] = [Math.floor(x * width), Math.floor(y * height)];
  Object.assign(find("pixel").style, { left: `${(100 * (column + 0.5)) / width}%`, top: `${(100 * (fromTop + 0.5)) / height}%` });
  find("pixel").hidden = false;
  find("explained").textContent = "explaining …";
  find("told").replaceChildren();
  find("explanation").hidden = false;
  say("explain", { column, row: height - 1 - fromTop });
}

function explanation({ pixel, html }) {
  find("explained").textContent = `Pixel ${pixel.join(", ")}`;
  find("told").innerHTML = html; // of our own server, which escapes what is in it
  find("told").querySelectorAll("details").forEach((each) => { each.open = false; });
}

function closeExplanation() {
  find("explanation").hidden = true;
  find("pixel").hidden = true;
}

function file({ name, type }, data, offset) {
  const address = URL.createObjectURL(new Blob([new Uint8Array(data, offset)], { type }));
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

async function take(files) {
  const meshes = [...files].filter((each) => MESHES.test(each.name));
  const beside = [...files].filter((each) => !MESHES.test(each.name));
  for (const each of beside) await upload(each, false);
  for (const each of meshes) await upload(each, true);
}

async function upload(dropped, adopt) {
  if (dropped.size > state.limit) {
    refused({ lines: [`${dropped.name}: expected at most ${state.limit} bytes, got ${dropped.size}; simplify the mesh`] });
    return;
  }
  state.dropped.set(dropped.name, dropped);
  say("upload", { name: dropped.name, size: dropped.size, adopt });
  for (let start = 0; start < dropped.size; start += PART) link.bytes(await dropped.slice(start, start + PART).arrayBuffer());
}

function received() {}

find("orbit").addEventListener("click", () => say("camera", { type: "orbit" }));
find("fly").addEventListener("click", () => { say("camera", { type: "free" }); find("stage").focus(); });
find("whole").addEventListener("click", () => say("frame"));
find("buffer").addEventListener("change", (event) => { say("show", { buffer: event.target.value }); event.target.blur(); });
find("fold").addEventListener("click", fold);
find("close").addEventListener("click", closeExplanation);
find("file").addEventListener("change", (event) => { take(event.target.files); event.target.value = ""; });
document.querySelectorAll("[data-save]").forEach((button) => {
  button.addEventListener("click", () => say("save", { what: button.dataset.save }));
});

function fold() {
  const folded = document.body.classList.toggle("folded");
  find("fold").setAttribute("aria-expanded", String(!folded));
}

addEventListener("keydown", (event) => {
  if (event.key === "Escape") closeExplanation();
  if (event.target.matches("input, select") || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "f") say("frame");
  if (event.key === "p") fold();
});
addEventListener("dragover", (event) => { event.preventDefault(); find("veil").hidden = false; });
addEventListener("dragleave", (event) => { if (!event.relatedTarget) find("veil").hidden = true; });
addEventListener("drop", (event) => {
  event.preventDefault();
  find("veil").hidden = true;
  take(event.dataTransfer.files);
});
