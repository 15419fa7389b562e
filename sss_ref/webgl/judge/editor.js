// A plain editor: a text, its line numbers beside it, lines that were changed and lines that a compiler refuses.

class Editor {
  constructor(source, gutter, onDraw) {
    Object.assign(this, { source, gutter, right: "", refusals: [] });
    source.addEventListener("input", () => this.refused([]));
    source.addEventListener("scroll", () => (gutter.scrollTop = source.scrollTop));
    source.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) onDraw();
    });
  }

  get text() {
    return this.source.value;
  }

  // Show a text; right: what it was before anyone changed it.
  show(text, right) {
    this.right = right;
    this.source.value = text;
    this.refused([]);
    const [changed] = this.changedLines;
    this.scrollTo(changed ?? this.start);
  }

  // The first line of the stage's own function, which is the last one before main.
  get start() {
    const lines = this.text.split("\n");
    const main = lines.findIndex((line) => line.startsWith("void main("));
    const head = lines.slice(0, main).findLastIndex((line) => /^\w+ \w+\(/.test(line));
    return Math.max(head, 0) + 1;
  }

  get changedLines() {
    const known = new Set(this.right.split("\n"));
    return this.text.split("\n").flatMap((line, k) => (known.has(line) ? [] : [k + 1]));
  }

  // Mark what a compiler refuses: [{line, told}].
  refused(refusals) {
    this.refusals = refusals;
    const bad = new Set(refusals.map(({ line }) => line)), changed = new Set(this.changedLines);
    this.gutter.replaceChildren(...this.text.split("\n").map((_, k) => {
      const className = bad.has(k + 1) ? "bad" : changed.has(k + 1) ? "changed" : "";
      return make("span", { className }, String(k + 1));
    }));
    this.gutter.scrollTop = this.source.scrollTop;
    if (refusals.length && refusals[0].line) this.scrollTo(refusals[0].line);
  }

  // Let a line stand in the upper third.
  scrollTo(line) {
    const height = parseFloat(getComputedStyle(this.source).lineHeight);
    this.source.scrollTop = Math.max(0, (line - 6) * height);
    this.gutter.scrollTop = this.source.scrollTop;
  }
}

// What a compiler says, by line: "ERROR: 0:12: 'x' : undeclared identifier".
function refusalsOf(told) {
  const found = [...told.matchAll(/^(?:ERROR|\w+ error|error): \d+:(\d+): (.*)$/gim)];
  if (!found.length) return [{ line: 0, told: told.replaceAll("\0", "").trim() }];
  return found.map(([, line, text]) => ({ line: Number(line), told: text }));
}
