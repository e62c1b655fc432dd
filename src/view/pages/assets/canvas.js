// A WebGL 2 canvas for a few shapes in view coordinates: x and y in pixels from the middle, z towards the reader.
// SPDX-License-Identifier: MIT

const kVertexShader = `#version 300 es
in vec4 place;
in vec4 colour;
in vec2 edge;
out vec4 shade;
out vec2 rim;
void main() {
  gl_Position = place;
  shade = colour;
  rim = edge;
}`;

const kFragmentShader = `#version 300 es
precision highp float;
in vec4 shade;
in vec2 rim;
out vec4 colour;
void main() {
  float distance = length(rim);
  float alpha = shade.a * clamp((1.0 - distance) / max(fwidth(distance), 1e-6) + 0.5, 0.0, 1.0);
  if (alpha < 0.01) discard;
  colour = vec4(shade.rgb * alpha, alpha);
}`;

function programOf(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

class ShapeCanvas {
  /** Throws where the browser has no WebGL 2. */
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', {antialias: true, alpha: true, preserveDrawingBuffer: true});
    if (!this.gl) throw new Error('this browser has no WebGL 2');
    const gl = this.gl;
    this.program = programOf(gl, kVertexShader, kFragmentShader);
    this.array = gl.createVertexArray();
    this.buffer = gl.createBuffer();
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    [['place', 4, 0], ['colour', 4, 16], ['edge', 2, 32]].forEach(([name, size, offset]) => {
      const location = gl.getAttribLocation(this.program, name);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, 40, offset);
    });
    this.solid = [];
    this.clear = [];
  }

  /** Fits the drawing to the canvas. Returns whether there is anything to see. */
  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const box = this.canvas.getBoundingClientRect();
    this.width = Math.max(1, box.width);
    this.height = Math.max(1, box.height);
    const width = Math.round(this.width * ratio), height = Math.round(this.height * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    return box.width > 0 && box.height > 0;
  }

  begin() {
    this.solid = [];
    this.clear = [];
  }

  vertex(p, lift, colour, alpha, edgeX, edgeY) {
    const depth = Math.max(-0.99, Math.min(0.99, -p[2] / 8000 - lift));
    (alpha < 0.99 && edgeX === 0 && edgeY === 0 ? this.clear : this.solid)
        .push(p[0] * 2 / this.width, p[1] * 2 / this.height, depth, 1, ...colour, alpha, edgeX, edgeY);
  }

  triangle(a, b, c, colour, alpha, lift = 0) {
    for (const p of [a, b, c]) this.vertex(p, lift, colour, alpha, 0, 0);
  }

  /** A line of a width in pixels; lift brings it before what is at its depth. */
  line(a, b, width, colour, alpha = 1, lift = 0.001) {
    const dx = b[0] - a[0], dy = b[1] - a[1], size = Math.hypot(dx, dy);
    if (!(size > 0)) return;
    const nx = -dy / size * width / 2, ny = dx / size * width / 2;
    const corner = (p, side) =>
        this.vertex([p[0] + side * nx, p[1] + side * ny, p[2]], lift, colour, alpha, 1e-6, side);
    corner(a, -1);
    corner(a, 1);
    corner(b, 1);
    corner(a, -1);
    corner(b, 1);
    corner(b, -1);
  }

  /** A round dot of a radius in pixels. */
  dot(p, radius, colour, alpha = 1, lift = 0.003) {
    const r = radius * 1.5;
    const corner = (x, y) => this.vertex([p[0] + x * r, p[1] + y * r, p[2]], lift, colour, alpha, x * 1.5, y * 1.5);
    corner(-1, -1);
    corner(1, -1);
    corner(1, 1);
    corner(-1, -1);
    corner(1, 1);
    corner(-1, 1);
  }

  /** Draws the shapes, over what is there if `clear` is false. */
  end(clear = true) {
    const gl = this.gl;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.depthMask(true);
    if (clear) gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.useProgram(this.program);
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    for (const vertices of [this.solid, this.clear]) {
      gl.depthMask(vertices === this.solid);
      if (vertices.length === 0) continue;
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(vertices), gl.STREAM_DRAW);
      gl.drawArrays(gl.TRIANGLES, 0, vertices.length / 10);
    }
    gl.depthMask(true);
  }
}
