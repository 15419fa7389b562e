// The page: every stage is drawn and judged, one is shown with its shader, and what is wrong is named.

const MARKS = { passed: "\u2713", failed: "\u2717", refused: "!", empty: "\u2013", waiting: "\u00b7" };

class Page {
  constructor(scene, gl) {
    Object.assign(this, { scene, gl, drawing: new Drawing(gl, scene), shown: 0 });
    this.reference = Object.fromEntries(
      Object.entries(scene.buffers).map(([name, buffer]) => [name, this.drawing.uploaded(buffer)]),
    );
    this.exams = scene.exams.map((exam) => ({
      ...exam, name: nameOf(exam, scene.exams), rightSource: exam.draws[0][exam.edit], source: exam.draws[0][exam.edit],
      buffersJudged: [], refusal: null, state: "waiting",
    }));
    this.chosen = Math.max(this.exams.findIndex(({ mistakes }) => mistakes.length > 1), 0); // one to begin with
    this.editor = new Editor(byId("source"), byId("gutter"), () => this.drawChosen());
    byId("draw").addEventListener("click", () => this.drawChosen());
    byId("restore").addEventListener("click", () => this.restore([this.chosen]));
    byId("restore-all").addEventListener("click", () => this.restore([...this.exams.keys()]));
    byId("mistakes").addEventListener("change", ({ target }) => this.plant(Number(target.value)));
    byId("copy").addEventListener("click", () => this.copy());
    this.listStages();
    this.facts();
  }

  // Draw and judge an exam with the shader as it is now.
  judge(exam) {
    const { gl, drawing } = this;
    const draws = exam.draws.map((draw) => ({ ...draw, [exam.edit]: exam.source }));
    const given = Object.entries(exam.given).map(([name, key]) => [name, this.reference[key]]);
    const textures = { ...drawing.textures, ...Object.fromEntries(given) };
    Object.assign(exam, { refusal: null, buffersJudged: [] });
    try {
      const outputs = drawing.drawn({ ...exam, draws }, textures);
      const all = exam.draws.flatMap((draw) => draw.outputs);
      const values = Object.fromEntries(all.map((output) => [output.name, drawing.read(outputs[output.name], output, exam)]));
      for (const texture of Object.values(outputs)) gl.deleteTexture(texture);
      const judge = exam.edit === "vertex" ? judgeDraw : judgeStage;
      exam.buffersJudged = judge(exam, this.scene.buffers, values);
    } catch (error) {
      exam.refusal = error instanceof Refused ? refusalsOf(error.told) : [{ line: 0, told: error.message }];
    }
    exam.state = stateOf(exam);
  }

  async judgeAll() {
    for (const [number, exam] of this.exams.entries()) {
      byId("verdict").textContent = `Drawing ${number + 1} of ${this.exams.length}: ${exam.name}`;
      await new Promise((done) => setTimeout(done)); // lets the page be seen
      this.judge(exam);
      this.mark(number);
    }
    this.conclude();
  }

  get first() {
    return this.exams.findIndex(({ state }) => state === "failed" || state === "refused");
  }

  // Draw the stage that is shown, and go to the first wrong one.
  drawChosen() {
    const exam = this.exams[this.chosen];
    exam.source = this.editor.text;
    this.judge(exam);
    this.mark(this.chosen);
    this.conclude();
    byId("verdict").scrollIntoView({ block: "nearest" });
  }

  restore(numbers) {
    for (const number of numbers) {
      const exam = this.exams[number];
      if (exam.source === exam.rightSource && exam.state === "passed" && number !== this.chosen) continue;
      exam.source = exam.rightSource;
      this.judge(exam);
      this.mark(number);
    }
    this.conclude();
  }

  // Put one of the wrong lines into the stage that has it, and show that stage.
  plant(index) {
    const [number, mistake] = this.mistakes[index] ?? [];
    if (!mistake) return;
    const exam = this.exams[number];
    const lines = exam.rightSource.split("\n");
    lines[mistake.line - 1] = mistake.text;
    exam.source = lines.join("\n");
    this.choose(number);
    byId("editor").scrollIntoView({ block: "nearest" });
    byId("told").textContent = `Planted in ${exam.name}, its line is marked. Press Draw.`;
  }

  // Say what is wrong, if anything, and show the first stage that is.
  conclude() {
    const verdict = byId("verdict");
    const exam = this.exams[this.first];
    verdict.className = `verdict ${exam ? "failed" : "passed"}`;
    verdict.replaceChildren(...(exam ? wrongText(exam) : this.rightText()));
    for (const id of ["mistakes", "restore-all", "copy"]) byId(id).disabled = false;
    byId("told").textContent = "";
    this.choose(exam ? this.first : this.chosen);
  }

  rightText() {
    const changed = this.exams.filter((one) => one.source !== one.rightSource).length;
    const empty = this.exams.filter(({ state }) => state === "empty").length;
    const judged = this.exams.length - empty;
    return [
      make("b", {}, `All ${judged} stages are right on this device.`),
      changed ? `${changed} with a shader that you have changed. ` : "Plant a mistake, and see it named. ",
      empty ? `${empty} have no pixel to judge.` : "",
    ];
  }

  // What the page tells of itself as JSON: device, browser, scene, and what became of each stage.
  report() {
    const { first, exams } = this;
    return {
      format: "sss_ref verdict of a page", format_version: 1, ...this.scene.about,
      device: deviceFacts(this.gl), browser: navigator.userAgent, passed: first < 0,
      first_wrong: first < 0 ? null : exams[first].name, stages: exams.map(reportOf),
    };
  }

  async copy() {
    const text = JSON.stringify(this.report(), null, 1);
    try {
      await navigator.clipboard.writeText(text);
      byId("told").textContent = "Copied.";
    } catch {
      this.download(text); // a page that is no secure place has no clipboard
    }
  }

  download(text) {
    const href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
    make("a", { href, download: "verdict.json" }).click();
    byId("told").textContent = "Saved as verdict.json.";
  }
}

function stateOf({ refusal, buffersJudged }) {
  if (refusal) return "refused";
  if (buffersJudged.some(({ wrong }) => wrong)) return "failed";
  return buffersJudged.some((one) => one.count(RIGHT, SEVERAL)) ? "passed" : "empty";
}

function outputsOf(exam) {
  return exam.draws.flatMap((draw) => draw.outputs.map(({ name }) => name));
}

// A stage by its pass and, where that has it several times, by what it writes.
function nameOf(exam, exams) {
  const alike = exams.filter(({ pass, stage }) => pass === exam.pass && stage === exam.stage);
  return `${exam.pass}/${exam.stage}${alike.length > 1 ? ` of ${outputsOf(exam)[0]}` : ""}`;
}

function wrongText(exam) {
  if (exam.refusal) return [make("b", {}, `This device refuses the shader of ${exam.name}.`), exam.refusal[0].told];
  const wrong = exam.buffersJudged.find((one) => one.wrong);
  const share = `${wrong.count(WRONG)} of ${wrong.compared} pixels are wrong.`;
  return [make("b", {}, `The first wrong stage is ${exam.name}.`), `${wrong.sentence(wrong.worst)}. ${share}`];
}

function reportOf(exam) {
  const buffers = exam.buffersJudged.map((one) => ({
    name: one.name, compared: one.compared, same_bits: one.sameBits, one_of_several: one.count(SEVERAL),
    nothing_said: one.count(OPEN), wrong: one.count(WRONG), ...(one.wrong && { worst: one.sentence(one.worst) }),
  }));
  const changed = exam.source !== exam.rightSource;
  return { pass: exam.pass, stage: exam.stage, state: exam.state, changed, refused: exam.refusal, buffers };
}

function deviceFacts(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const names = {
    renderer: info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER, vendor: info ? info.UNMASKED_VENDOR_WEBGL : gl.VENDOR,
    version: gl.VERSION, language: gl.SHADING_LANGUAGE_VERSION, subpixel_bits_reported: gl.SUBPIXEL_BITS,
    texture_units: gl.MAX_TEXTURE_IMAGE_UNITS, largest_texture: gl.MAX_TEXTURE_SIZE, draw_buffers: gl.MAX_DRAW_BUFFERS,
  };
  return Object.fromEntries(Object.entries(names).map(([name, parameter]) => [name, gl.getParameter(parameter)]));
}
