// Draws passes of a scene with WebGL 2, and reads what they have drawn.

const byId = (id) => document.getElementById(id);

// The bytes of an array of the page: text in base 64, or unpacked already.
function bytesOf(packed) {
  return typeof packed === "string" ? Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0)) : packed;
}

// A shader that the device's compiler refuses: which one, "vertex", "fragment" or "program", and what it says.
class Refused extends Error {
  constructor(name, what, told) {
    super(`${name}: expected shaders that ${what === "program" ? "link" : "compile"}, got ${told}`);
    Object.assign(this, { what, told });
  }
}

// The context, with what makes float textures something to draw into.
function openContext() {
  const gl = document.createElement("canvas").getContext("webgl2", { antialias: false });
  if (!gl) throw new Error("expected WebGL 2, got none; use a current browser");
  if (!gl.getExtension("EXT_color_buffer_float")) {
    throw new Error("expected EXT_color_buffer_float, got none; this device cannot draw into floats");
  }
  gl.disable(gl.DITHER);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
  return gl;
}

function deviceName(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return `${name}, ${gl.getParameter(gl.SUBPIXEL_BITS)} subpixel bits`;
}

// What holds numbers of a kind: the array for uploads, for read-back, and WebGL's names by channels.
function kindsOf(gl) {
  return {
    float: {
      array: Float32Array, read: Float32Array, type: gl.FLOAT, readType: gl.FLOAT, readFormat: gl.RGBA,
      formats: { 1: [gl.R32F, gl.RED], 2: [gl.RG32F, gl.RG], 3: [gl.RGB32F, gl.RGB], 4: [gl.RGBA32F, gl.RGBA] },
      clear: (index, value) => gl.clearBufferfv(gl.COLOR, index, value),
    },
    int: {
      array: Int32Array, read: Int32Array, type: gl.INT, readType: gl.INT, readFormat: gl.RGBA_INTEGER,
      formats: { 1: [gl.R32I, gl.RED_INTEGER] },
      clear: (index, value) => gl.clearBufferiv(gl.COLOR, index, value),
    },
    bool: {
      array: Uint8Array, read: Uint32Array, type: gl.UNSIGNED_BYTE, readType: gl.UNSIGNED_INT,
      readFormat: gl.RGBA_INTEGER, formats: { 1: [gl.R8UI, gl.RED_INTEGER] },
      clear: (index, value) => gl.clearBufferuiv(gl.COLOR, index, value),
    },
  };
}

class Drawing {
  constructor(gl, scene) {
    Object.assign(this, { gl, scene, kinds: kindsOf(gl), textures: {} });
    for (const [name, picture] of Object.entries(scene.textures)) this.textures[name] = this.uploaded(picture);
    this.meshes = {};
    for (const [name, mesh] of Object.entries(scene.meshes)) this.meshes[name] = this.meshOf(mesh);
  }

  // What is drawn of a mesh.
  meshOf({ triangles, attributes }) {
    const corners = new Uint32Array(bytesOf(triangles).buffer);
    const expanded = Object.entries(attributes).map(([name, { channels, data }]) => [
      name, this.perCorner(corners, channels, data),
    ]);
    return { count: corners.length, attributes: Object.fromEntries(expanded) };
  }

  // A texture without filter; without data, one to draw into, where three channels are stored as four.
  texture({ kind, channels, width, height }, data) {
    const { gl } = this;
    const texture = gl.createTexture();
    const { formats, type } = this.kinds[kind];
    const [stored, given] = formats[channels];
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, stored, width, height, 0, given, type, data);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    }
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) {
      gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    }
    return texture;
  }

  uploaded(picture) {
    return this.texture(picture, new this.kinds[picture.kind].array(bytesOf(picture.data).buffer));
  }

  // An attribute for every corner of every triangle: drawn without indices, a vertex knows its triangle.
  perCorner(corners, channels, data) {
    const { gl } = this;
    const values = new Float32Array(bytesOf(data).buffer);
    const expanded = new Float32Array(corners.length * channels);
    corners.forEach((vertex, corner) => {
      for (let k = 0; k < channels; k++) expanded[corner * channels + k] = values[vertex * channels + k];
    });
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, expanded, gl.STATIC_DRAW);
    return { buffer, channels };
  }

  program({ name, vertex, fragment }) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
        throw new Refused(name, type === gl.VERTEX_SHADER ? "vertex" : "fragment", gl.getShaderInfoLog(shader));
      }
      gl.attachShader(program, shader);
      gl.deleteShader(shader); // goes with the program
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      throw new Refused(name, "program", gl.getProgramInfoLog(program));
    }
    return program;
  }

  // Give a program what it reads: textures by unit, else uniforms; the scene has matrices row after row.
  handOver(program, textures) {
    const { gl } = this;
    let unit = 0;
    for (let k = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); k++) {
      const { name, type } = gl.getActiveUniform(program, k);
      const place = gl.getUniformLocation(program, name);
      const own = this.scene.names[name.replace("[0]", "")];
      if (own in textures) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, textures[own]);
        gl.uniform1i(place, unit++);
      } else if (own in this.scene.uniforms) {
        this.write(type, place, this.scene.uniforms[own]);
      } else {
        throw new Refused("uniforms", "program", `${name}, which the scene has no value for`);
      }
    }
  }

  write(type, place, value) {
    const { gl } = this;
    const writers = {
      [gl.FLOAT]: () => gl.uniform1fv(place, value),
      [gl.FLOAT_VEC2]: () => gl.uniform2fv(place, value),
      [gl.FLOAT_VEC3]: () => gl.uniform3fv(place, value),
      [gl.FLOAT_VEC4]: () => gl.uniform4fv(place, value),
      [gl.INT]: () => gl.uniform1iv(place, value),
      [gl.FLOAT_MAT3]: () => gl.uniformMatrix3fv(place, true, value),
      [gl.FLOAT_MAT4]: () => gl.uniformMatrix4fv(place, true, value),
    };
    writers[type]();
  }

  // Draw a pass as often as it has rounds: the textures of what it writes, by name, from those that it reads.
  drawn(pass, textures) {
    const programs = pass.draws.map((draw) => [draw, this.program(draw)]);
    const fed = Object.entries(pass.feedback);
    let outputs = Object.fromEntries(fed.map(([name, own]) => [own, textures[name]]));
    for (let round = 0; round < pass.rounds; round++) {
      const read = { ...textures, ...Object.fromEntries(fed.map(([name, own]) => [name, outputs[own]])) };
      outputs = {};
      for (const [draw, program] of programs) {
        this.gl.useProgram(program);
        this.handOver(program, read);
        Object.assign(outputs, this.draw(pass, draw, program));
      }
    }
    for (const [, program] of programs) this.gl.deleteProgram(program);
    return outputs;
  }

  // One draw into fresh textures.
  draw({ width, height, mesh, laterWins }, { outputs }, program) {
    const { gl } = this;
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.viewport(0, 0, width, height);
    gl.activeTexture(gl.TEXTURE0 + gl.getParameter(gl.MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1); // one that none reads
    const written = {};
    outputs.forEach(({ name, kind, channels }, index) => {
      const stored = channels === 3 ? 4 : channels;
      written[name] = this.texture({ kind, channels: stored, width, height }, null);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + index, gl.TEXTURE_2D, written[name], 0);
    });
    gl.drawBuffers(outputs.map((_, index) => gl.COLOR_ATTACHMENT0 + index));
    outputs.forEach(({ kind, background }, index) => this.kinds[kind].clear(index, background));
    if (mesh) this.triangles(this.meshes[mesh], program, width, height, laterWins);
    else gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.deleteFramebuffer(framebuffer);
    const problem = gl.getError();
    if (problem) throw new Error(`expected a draw without error, got WebGL error ${problem}`);
    return written;
  }

  // A mesh in its order, nearest first; of two triangles at one depth the earlier counts, or the later if told so.
  triangles(mesh, program, width, height, laterWins) {
    const { gl } = this;
    const depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    gl.clearBufferfv(gl.DEPTH, 0, [1]);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(laterWins ? gl.LEQUAL : gl.LESS);
    const corners = gl.createVertexArray();
    gl.bindVertexArray(corners);
    for (const [name, { buffer, channels }] of Object.entries(mesh.attributes)) {
      const place = gl.getAttribLocation(program, name);
      if (place < 0) continue;
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.vertexAttribPointer(place, channels, gl.FLOAT, false, 0, 0);
      gl.enableVertexAttribArray(place);
    }
    gl.drawArrays(gl.TRIANGLES, 0, mesh.count);
    gl.bindVertexArray(null);
    gl.deleteVertexArray(corners);
    gl.deleteRenderbuffer(depth); // the framebuffer keeps it as long as it is there
    gl.disable(gl.DEPTH_TEST);
  }

  // The numbers of a texture that was drawn: read with four channels, as WebGL promises, kept with its own.
  read(texture, { kind, channels }, { width, height }) {
    const { gl } = this;
    const { array, read, readType, readFormat } = this.kinds[kind];
    const texels = new read(width * height * 4);
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.readBuffer(gl.COLOR_ATTACHMENT0);
    gl.readPixels(0, 0, width, height, readFormat, readType, texels);
    gl.deleteFramebuffer(framebuffer);
    const values = new array(width * height * channels);
    for (let k = 0; k < values.length; k++) values[k] = texels[Math.floor(k / channels) * 4 + (k % channels)];
    return values;
  }
}
