// Draws the scene of this page, pass after pass, and lists what each buffer holds as a file for NumPy.

const NUMPY = { float: "<f4", int: "<i4", bool: "|u1" };

function base64Of(bytes) {
  const step = 0x8000; // a call takes only so many arguments
  let text = "";
  for (let first = 0; first < bytes.length; first += step) {
    text += String.fromCharCode(...bytes.subarray(first, first + step));
  }
  return btoa(text);
}

// The file of a buffer.
function npy(values, { kind, channels }, { width, height }) {
  const shape = channels === 1 ? `${height}, ${width}` : `${height}, ${width}, ${channels}`;
  const text = `{'descr': '${NUMPY[kind]}', 'fortran_order': False, 'shape': (${shape}), }`;
  const head = text.padEnd(Math.ceil((text.length + 11) / 64) * 64 - 11) + "\n"; // 10 bytes stand before it
  const magic = [0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0, head.length & 255, head.length >> 8]; // \x93NUMPY 1.0
  const file = new Uint8Array(magic.length + head.length + values.byteLength);
  file.set(magic);
  file.set(new TextEncoder().encode(head), magic.length);
  file.set(new Uint8Array(values.buffer), magic.length + head.length);
  return file;
}

// Draw all passes; the files of the buffers to keep, by name.
function filesOf(drawing) {
  const { scene, textures } = drawing;
  const files = {};
  for (const pass of scene.passes) {
    Object.assign(textures, drawing.drawn(pass, textures));
    for (const output of pass.draws.flatMap((draw) => draw.outputs)) {
      if (!scene.kept.includes(output.name)) continue;
      files[output.name] = npy(drawing.read(textures[output.name], output, pass), output, pass);
    }
  }
  return files;
}

// A link to a file; at the address ...#inline the page itself holds it, for a browser that prints the page.
function listed(name, file) {
  const link = document.createElement("a");
  link.download = link.textContent = `${name}.npy`;
  link.href = location.hash === "#inline"
    ? `data:application/octet-stream;base64,${base64Of(file)}`
    : URL.createObjectURL(new Blob([file]));
  const item = document.createElement("li");
  item.append(link);
  byId("buffers").append(item);
}

try {
  const scene = JSON.parse(byId("scene").textContent);
  byId("scene").remove();
  const gl = openContext();
  const files = filesOf(new Drawing(gl, scene));
  for (const name of scene.kept) listed(name, files[name]);
  byId("device").textContent = deviceName(gl);
} catch (error) {
  byId("error").textContent = error.message;
}
