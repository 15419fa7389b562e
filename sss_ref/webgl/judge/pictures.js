// Buffers as pictures, row 0 at the bottom.

const COLORS = { [RIGHT]: [47, 143, 91], [SEVERAL]: [226, 177, 60], [WRONG]: [209, 68, 47], [OPEN]: [84, 128, 190] };

// The least and the largest number of the reference where it is compared.
function rangeOf({ reference, outcome, channels }) {
  let low = Infinity, high = -Infinity;
  for (let index = 0; index < reference.length; index++) {
    if (outcome[Math.floor(index / channels)] === BESIDE || !Number.isFinite(reference[index])) continue;
    low = Math.min(low, reference[index]);
    high = Math.max(high, reference[index]);
  }
  return low > high ? [0, 1] : [low, high];
}

function srgb(linear) {
  const v = Math.min(Math.max(linear, 0), 1);
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
}

// A color of a buffer's pixel: colours as they are, numbers from black to white, triangles each in its own.
function painter(judged) {
  const [low, high] = rangeOf(judged);
  const { channels, kind } = judged;
  if (kind === "int") {
    return (values, pixel) => {
      const number = values[pixel];
      return number < 0 ? null : [(number * 97) % 200 + 40, (number * 57) % 200 + 40, (number * 23) % 200 + 40];
    };
  }
  const isColor = channels >= 3 && low >= 0 && high < 4;
  const shade = isColor ? srgb : (number) => (255 * (number - low)) / (high - low || 1);
  return (values, pixel) => {
    const parts = [0, 1, 2].map((k) => (k < channels || channels === 1 ? shade(values[pixel * channels + (channels === 1 ? 0 : k)]) : 0));
    return parts.every(Number.isFinite) ? parts : [255, 0, 255];
  };
}

function paint(canvas, { width, height }, colorOf) {
  Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const row = height - 1 - Math.floor(pixel / width);
    const color = colorOf(pixel);
    if (color) image.data.set([...color, 255], 4 * (row * width + (pixel % width)));
  }
  context.putImageData(image, 0, 0);
}

// The three pictures of a buffer; choose: called with the pixel that is clicked at.
function showPictures(holder, judged, chosen, choose) {
  const color = painter(judged);
  const pictures = [
    ["The reference", (pixel) => color(judged.reference, pixel)],
    ["Drawn here", (pixel) => color(judged.drawn, pixel)],
    ["Judged", (pixel) => COLORS[judged.outcome[pixel]] ?? null],
  ];
  holder.replaceChildren(...pictures.map(([caption, colorOf]) => {
    const canvas = make("canvas", { title: "Click a pixel to see its numbers" });
    paint(canvas, judged, colorOf);
    canvas.addEventListener("click", ({ offsetX, offsetY }) => {
      const column = Math.min(Math.floor((offsetX / canvas.clientWidth) * judged.width), judged.width - 1);
      const row = Math.min(Math.floor((offsetY / canvas.clientHeight) * judged.height), judged.height - 1);
      choose((judged.height - 1 - row) * judged.width + column);
    });
    const frame = make("div", {}, canvas, ...(chosen < 0 ? [] : [marker(judged, chosen)]));
    return make("figure", {}, frame, make("figcaption", {}, caption));
  }));
}

// A frame around a pixel of a picture.
function marker({ width, height }, pixel) {
  const [column, row] = [pixel % width, Math.floor(pixel / width)];
  const found = make("div", { className: "at" });
  const percent = (part, whole) => `${(100 * part) / whole}%`;
  Object.assign(found.style, {
    left: percent(column, width), top: percent(height - 1 - row, height), width: percent(1, width), height: percent(1, height),
  });
  return found;
}

// An element with its properties and what is in it.
function make(tag, properties, ...inner) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...inner);
  return element;
}
