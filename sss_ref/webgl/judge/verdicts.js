// What was drawn in an exam, pixel by pixel, beside what is right.

const BESIDE = 0, RIGHT = 1, SEVERAL = 2, WRONG = 3, OPEN = 4; // what becomes of a pixel
const NOT_COMPARED = 0, MAY_BE_SEVERAL = 2, UNDEFINED = 3; // states of a pixel as the page holds them
const MUST = 2; // be covered

// One buffer, judged. outcome: of each pixel. right: pixel, channel -> the ends of what is right there.
class Judged {
  constructor(name, { kind, channels }, exam, drawn, reference, right) {
    Object.assign(this, { name, kind, channels, drawn, reference, right, width: exam.width, height: exam.height });
    this.outcome = new Uint8Array(exam.width * exam.height);
    Object.assign(this, { first: -1, worst: -1, beyond: -1, sameBits: 0 });
  }

  // Note what became of a pixel; beyond: how far it is from what is right.
  note(pixel, outcome, beyond = 0) {
    this.outcome[pixel] = outcome;
    if (outcome !== WRONG) return;
    if (this.first < 0) this.first = pixel;
    if (beyond > this.beyond) Object.assign(this, { worst: pixel, beyond });
  }

  count(...outcomes) {
    return this.outcome.reduce((sum, outcome) => sum + outcomes.includes(outcome), 0);
  }

  get compared() {
    return this.count(RIGHT, SEVERAL, WRONG, OPEN);
  }

  get wrong() {
    return this.first >= 0;
  }

  at(array, pixel) {
    return Array.from(array.subarray(pixel * this.channels, (pixel + 1) * this.channels));
  }

  place(pixel) {
    return [pixel % this.width, Math.floor(pixel / this.width)];
  }

  // What is right in a channel of a pixel, in words.
  rightText(pixel, channel) {
    return intervalText(this.right(pixel, channel));
  }

  // What is wrong at a pixel, as a sentence.
  sentence(pixel) {
    const ends = Array.from({ length: this.channels }, (_, channel) => this.rightText(pixel, channel));
    const right = ends.length === 1 ? ends[0] : `(${ends.join(", ")})`;
    return `${this.name} at pixel ${this.place(pixel).join(",")}: drawn ${tupleText(this.at(this.drawn, pixel))}, right is ${right}`;
  }
}

// How far a number is from an interval; 0 inside, infinite where it is none.
function distanceBeyond(number, [low, high]) {
  if (low === -Infinity && high === Infinity) return 0;
  return Number.isNaN(number) ? Infinity : Math.max(low - number, number - high, 0);
}

// The buffers of a stage. drawn: name -> values.
function judgeStage(exam, buffers, drawn) {
  return exam.draws.flatMap((draw) => draw.outputs).map((output) => {
    const { name, kind, channels } = output;
    const { below, above, state } = exam.right[name];
    const steps = { below: new Uint32Array(below.buffer), above: new Uint32Array(above.buffer) };
    const reference = buffers[name].values;
    const right = (pixel, channel) => {
      if (state[pixel] === UNDEFINED) return [-Infinity, Infinity];
      const index = pixel * channels + channel;
      const middle = ordered(reference[index], kind);
      return [numberAt(middle - steps.below[index], kind), numberAt(middle + steps.above[index], kind)];
    };
    const judged = new Judged(name, output, exam, drawn[name], reference, right);
    for (let pixel = 0; pixel < state.length; pixel++) {
      if (state[pixel] !== NOT_COMPARED) judgePixel(judged, pixel, state[pixel] === MAY_BE_SEVERAL);
    }
    return judged;
  });
}

function judgePixel(judged, pixel, several) {
  const { channels } = judged;
  let beyond = 0, open = false, same = true;
  for (let channel = 0; channel < channels; channel++) {
    const ends = judged.right(pixel, channel);
    const index = pixel * channels + channel;
    open ||= ends[0] === -Infinity && ends[1] === Infinity;
    beyond = Math.max(beyond, distanceBeyond(judged.drawn[index], ends));
    same &&= Object.is(judged.drawn[index], judged.reference[index]);
  }
  judged.sameBits += same;
  judged.note(pixel, beyond > 0 ? WRONG : open ? OPEN : several ? SEVERAL : RIGHT, beyond);
}

// What a draw of a mesh shows: the triangle of each pixel, its depth, and what is interpolated on it.
function judgeDraw(exam, buffers, drawn) {
  const { covered, first, triangle, low, high } = exam.candidates;
  const lists = {
    covered, first: new Int32Array(first.buffer), triangle: new Int32Array(triangle.buffer),
    low: new Float32Array(low.buffer), high: new Float32Array(high.buffer),
  };
  const columns = 1 + Object.values(exam.varyings).reduce((sum, { channels }) => sum + channels, 0);
  return exam.draws.flatMap(({ outputs }) => {
    const shown = drawn[outputs[0].name]; // each draw writes its triangle first
    return outputs.map((output) => {
      const reference = buffers[exam.shown[output.name] ?? exam.shown.triangle].values;
      if (output.kind === "int") return judgeTriangle(exam, output, shown, reference, lists);
      const place = exam.varyings[output.name] ?? { first: 0, channels: 1 }; // the depth is the first column
      return judgeOnTriangle(exam, output, { shown, drawn: drawn[output.name], reference }, lists, { ...place, columns });
    });
  });
}

// The candidates of a pixel that are a triangle's.
function candidatesOf({ first, triangle }, pixel, shown) {
  const found = [];
  for (let k = first[pixel]; k < first[pixel + 1]; k++) if (triangle[k] === shown) found.push(k);
  return found;
}

function judgeTriangle(exam, output, shown, reference, lists) {
  const allowed = (pixel) => {
    const candidates = lists.triangle.subarray(lists.first[pixel], lists.first[pixel + 1]);
    return [...new Set([...(lists.covered[pixel] === MUST ? [] : [-1]), ...candidates])];
  };
  const judged = new Judged(output.name, output, exam, shown, reference, (pixel) => [allowed(pixel)[0], allowed(pixel).at(-1)]);
  judged.rightText = (pixel) => allowed(pixel).join(" or ");
  for (let pixel = 0; pixel < shown.length; pixel++) {
    const choices = allowed(pixel);
    judged.sameBits += shown[pixel] === reference[pixel];
    judged.note(pixel, choices.includes(Math.max(shown[pixel], -1)) ? (choices.length > 1 ? SEVERAL : RIGHT) : WRONG);
  }
  return judged;
}

// What lies on the triangle that a pixel shows; where that triangle is wrong already, it is not compared.
function judgeOnTriangle(exam, output, { shown, drawn, reference }, lists, { first, columns }) {
  const { channels } = output;
  const ends = (candidate, channel) => {
    const index = candidate * columns + first + channel;
    return [lists.low[index], lists.high[index]];
  };
  const right = (pixel, channel) => {
    const all = candidatesOf(lists, pixel, shown[pixel]).map((candidate) => ends(candidate, channel));
    return all.length ? [Math.min(...all.map(([low]) => low)), Math.max(...all.map(([, high]) => high))] : beside(output);
  };
  const judged = new Judged(output.name, output, exam, drawn, reference, right);
  for (let pixel = 0; pixel < shown.length; pixel++) {
    const found = candidatesOf(lists, pixel, shown[pixel]);
    if (!found.length) continue;
    let least = Infinity, same = true;
    for (const candidate of found) {
      let beyond = 0;
      for (let channel = 0; channel < channels; channel++) {
        beyond = Math.max(beyond, distanceBeyond(drawn[pixel * channels + channel], ends(candidate, channel)));
      }
      least = Math.min(least, beyond);
    }
    for (let index = pixel * channels; index < (pixel + 1) * channels; index++) same &&= Object.is(drawn[index], reference[index]);
    judged.sameBits += same;
    judged.note(pixel, least > 0 ? WRONG : RIGHT, least);
  }
  return judged;
}

function beside({ background }) {
  return [background[0], background[0]];
}
