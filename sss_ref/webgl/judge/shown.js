// What the page shows of a stage: its place in the list, its shader, its buffers, the numbers of a pixel.

Object.assign(Page.prototype, {
  facts() {
    const { scene, method, rules } = this.scene.about;
    const [width, height] = [this.exams.at(-1).width, this.exams.at(-1).height];
    const told = [deviceName(this.gl), `${scene}, ${method}`, `${width} x ${height} pixels`, `rules ${rules}`];
    byId("facts").replaceChildren(...told.map((text) => make("span", {}, text)));
  },

  listStages() {
    const passes = [...new Set(this.exams.map((exam) => exam.pass))];
    byId("stages").replaceChildren(...passes.flatMap((pass) => [
      make("h3", {}, `pass ${pass}`),
      ...this.exams.flatMap((exam, number) => (exam.pass === pass ? [this.entry(exam, number)] : [])),
    ]));
    this.mistakes = this.exams.flatMap((exam, number) => exam.mistakes.map((mistake) => [number, mistake]));
    const options = this.mistakes.map(([number, { about }], index) =>
      make("option", { value: index }, `${this.exams[number].name}: ${about.replaceAll("`", "")}`));
    byId("mistakes").replaceChildren(make("option", { value: -1 }, "Plant a mistake ..."), ...options);
  },

  entry(exam, number) {
    const names = make("span", {}, exam.stage, make("small", {}, outputsOf(exam).join(", ")));
    const button = make("button", { className: exam.state, id: `exam-${number}` }, make("i", {}, MARKS[exam.state]), names);
    button.addEventListener("click", () => this.choose(number));
    return button;
  },

  mark(number) {
    const { state } = this.exams[number];
    const button = byId(`exam-${number}`);
    button.className = state;
    button.firstChild.textContent = MARKS[state];
  },

  // Show a stage, and of it the first wrong buffer at its worst pixel.
  choose(number) {
    const exam = this.exams[number];
    const kept = this.exams[this.chosen];
    if (!byId("stage").hidden && number !== this.chosen) kept.source = this.editor.text;
    byId(`exam-${this.chosen}`).removeAttribute("aria-current");
    const entry = byId(`exam-${number}`);
    entry.setAttribute("aria-current", "true");
    byId("stages").scrollTop = entry.offsetTop - byId("stages").clientHeight / 2;
    this.chosen = number;
    byId("stage").hidden = false;
    byId("name").textContent = exam.name;
    byId("about").textContent = `${exam.about} Source: ${exam.source_of}.`;
    byId("mistakes").value = -1;
    this.editor.show(exam.source, exam.rightSource);
    this.editor.refused(exam.refusal ?? []);
    const refusals = (exam.refusal ?? []).map(({ line, told }) => make("li", {}, line ? `line ${line}: ${told}` : told));
    byId("refused").replaceChildren(...refusals);
    const wrong = exam.buffersJudged.findIndex((one) => one.wrong);
    this.show(Math.max(wrong, 0));
  },

  // Show one of the buffers of the stage.
  show(index) {
    const { buffersJudged } = this.exams[this.chosen];
    const judged = buffersJudged[index];
    byId("buffers").replaceChildren(...buffersJudged.map((one, k) => {
      const text = one.wrong ? `${one.name}: ${one.count(WRONG)} wrong` : one.name;
      const button = make("button", { className: one.wrong ? "wrong" : "" }, text);
      button.setAttribute("aria-pressed", k === index);
      button.addEventListener("click", () => this.show(k));
      return button;
    }));
    this.shown = index;
    if (judged) this.look(judged.wrong ? judged.worst : judged.outcome.findIndex((outcome) => outcome !== BESIDE));
    else for (const id of ["pictures", "pixel"]) byId(id).replaceChildren();
  },

  // Show the numbers of a pixel.
  look(pixel) {
    const exam = this.exams[this.chosen];
    const judged = exam.buffersJudged[this.shown];
    showPictures(byId("pictures"), judged, pixel, (chosen) => this.look(chosen));
    byId("pixel").replaceChildren(...(pixel < 0 ? ["No pixel of it is compared."] : [
      this.outputTable(exam, pixel), this.inputTable(exam, pixel),
    ]));
  },

  outputTable(exam, pixel) {
    const rows = exam.buffersJudged.flatMap((one) => Array.from({ length: one.channels }, (_, channel) => {
      const name = one.channels > 1 ? `${one.name}.${"xyzw"[channel]}` : one.name;
      const at = pixel * one.channels + channel;
      const cells = [one.drawn[at], one.reference[at]].map(textOf);
      const right = one.outcome[pixel] === BESIDE ? "not compared" : one.rightText(pixel, channel);
      const isWrong = one.outcome[pixel] === WRONG && isBeyond(one, pixel, channel);
      return row([name, cells[0], right, cells[1]], isWrong ? "wrong" : "");
    }));
    const [column, line] = exam.buffersJudged[0].place(pixel);
    return table(`Pixel ${column},${line}`, ["writes", "drawn here", "right is", "the reference"], rows);
  },

  inputTable(exam, pixel) {
    const rows = exam.reads.map(({ own, name, type, whole }) => row([own, type, this.valueText(exam, name, whole, pixel)]));
    return table("What it reads there, as in the reference", ["reads", "type", "value"], rows);
  },

  valueText(exam, name, whole, pixel) {
    const key = exam.given[name];
    const buffer = this.scene.buffers[key] ?? this.scene.textures[name];
    if (name === "pixel") return `${pixel % exam.width}, ${Math.floor(pixel / exam.width)}`;
    if (key && !whole) return tupleText(Array.from(buffer.values.subarray(pixel * buffer.channels, (pixel + 1) * buffer.channels)));
    if (buffer) return `a picture of ${buffer.width} x ${buffer.height}`;
    const uniform = this.scene.uniforms[name];
    if (!uniform) return "of each vertex";
    return uniform.length > 16 ? `${uniform.length} numbers` : uniform.map(textOf).join(", ");
  },
});

function isBeyond(judged, pixel, channel) {
  const ends = judged.right(pixel, channel);
  return judged.kind === "int" || distanceBeyond(judged.drawn[pixel * judged.channels + channel], ends) > 0;
}

function row(cells, className = "") {
  return make("tr", { className }, ...cells.map((text) => make("td", {}, text)));
}

function table(caption, heads, rows) {
  const head = make("thead", {}, make("tr", {}, ...heads.map((text) => make("th", {}, text))));
  return make("table", {}, make("caption", {}, caption), head, make("tbody", {}, ...rows));
}

try {
  const page = new Page(await readScene(), openContext());
  window.judge = page; // for scripts that drive the page
  await page.judgeAll();
} catch (error) {
  byId("verdict").className = "verdict failed";
  byId("verdict").textContent = error.message;
}
