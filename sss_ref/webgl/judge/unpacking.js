// The arrays of the page: deflated, and the bytes of their numbers taken apart.

async function inflated({ deflated, size }) {
  const stream = new Blob([bytesOf(deflated)]).stream().pipeThrough(new DecompressionStream("deflate"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = planes.length / size;
  const bytes = new Uint8Array(planes.length);
  for (let k = 0; k < size; k++) {
    for (let n = 0; n < count; n++) bytes[n * size + k] = planes[k * count + n];
  }
  return bytes;
}

// The same value with every array inflated.
async function unpacked(value) {
  if (typeof value !== "object" || value === null) return value;
  if ("deflated" in value) return inflated(value);
  if (Array.isArray(value)) return Promise.all(value.map(unpacked));
  const entries = Object.entries(value).map(async ([name, inner]) => [name, await unpacked(inner)]);
  return Object.fromEntries(await Promise.all(entries));
}

// What the page holds, ready to be drawn with.
async function readScene() {
  if (!("DecompressionStream" in window)) {
    throw new Error("expected a browser that inflates data, got one without DecompressionStream; use a current one");
  }
  const text = byId("scene");
  const scene = await unpacked(JSON.parse(text.textContent));
  text.remove();
  const arrays = { float: Float32Array, int: Int32Array, bool: Uint8Array };
  for (const buffer of Object.values(scene.buffers)) buffer.values = new arrays[buffer.kind](buffer.data.buffer);
  return scene;
}
