// Draws the elements of an animation: positions lie in textures, and the shader moves them from one frame to the next.
// SPDX-License-Identifier: MIT

const kTextureWidth = 2048;

const kPlace = `
uniform highp usampler2D before, after;
uniform vec3 spacing_before, origin_before, spacing_after, origin_after;
uniform float fraction;
uniform mat3 turn;
uniform vec3 move;
uniform vec2 size;
vec3 seen(uint vertex) {
  ivec2 at = ivec2(int(vertex) % 2048, int(vertex) / 2048);
  vec3 a = vec3(texelFetch(before, at, 0).xyz) * spacing_before + origin_before;
  vec3 b = vec3(texelFetch(after, at, 0).xyz) * spacing_after + origin_after;
  return turn * mix(a, b, fraction) + move;
}
vec4 clipped(vec3 p) { return vec4(p.xy * 2.0 / size, clamp(-p.z / 8000.0, -0.99, 0.99), 1.0); }
`;

const kFaceVertex = `#version 300 es
precision highp float;
${kPlace}
in uint vertex;
out vec3 at;
void main() {
  at = seen(vertex);
  gl_Position = clipped(at);
}`;

const kFaceFragment = `#version 300 es
precision highp float;
in vec3 at;
uniform vec3 tint;
out vec4 colour;
void main() {
  vec3 normal = cross(dFdx(at), dFdy(at));
  float facing = abs(normal.z) / max(length(normal), 1e-20);
  colour = vec4(tint * (0.45 + 0.55 * facing), 1.0);
}`;

// One instance an edge or point; a point is an edge of one vertex.
const kEdgeVertex = `#version 300 es
precision highp float;
${kPlace}
in uvec2 edge;
uniform float width, lift;
out vec2 rim;
void main() {
  vec3 a = seen(edge.x), b = seen(edge.y);
  vec2 along = b.xy - a.xy;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float end = float(gl_VertexID & 1), side = float(gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 p = mix(a, b, end);
  p.xy += (across * side + along * (end * 2.0 - 1.0)) * width * 0.5;
  p.z += lift;
  rim = vec2(0.0, side);
  gl_Position = clipped(p);
}`;

const kEdgeFragment = `#version 300 es
precision highp float;
uniform vec4 tint;
out vec4 colour;
void main() { colour = vec4(tint.rgb * tint.a, tint.a); }`;

class MeshCanvas {
  /** Draws into the context of a canvas for shapes. */
  constructor(shapes, elements, data) {
    const gl = this.gl = shapes.gl;
    this.shapes = shapes;
    this.elements = elements;
    this.data = data;
    this.facesProgram = programOf(gl, kFaceVertex, kFaceFragment);
    this.edgesProgram = programOf(gl, kEdgeVertex, kEdgeFragment);
    this.textures = [this.texture(), this.texture()];
    this.inTexture = [-1, -1];
    this.faceArray = this.facesOf();
    const edges = (numbers) => numbers.flatMap((i) => [elements.edges[2 * i], elements.edges[2 * i + 1]]);
    this.bare = this.edgesOf(edges(elements.bareEdges));
    // The borders of faces are lines too as long as lines can be told apart.
    const count = elements.edges.length / 2, bordered = count - elements.bareEdges.length;
    const isBare = new Set(elements.bareEdges);
    const borders = bordered > 30000 ? [] : Array.from({length: count}, (_, i) => i).filter((i) => !isBare.has(i));
    this.borders = this.edgesOf(edges(borders));
    this.points = this.edgesOf(Array.from(elements.points).flatMap((i) => [i, i]));
  }

  texture() {
    const gl = this.gl, texture = gl.createTexture();
    const height = Math.max(1, Math.ceil(this.data.vertices / kTextureWidth));
    if (height > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error('too many vertices for this browser');
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGB16UI, kTextureWidth, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  /** Puts a frame into one of the two textures, unless it is there. Returns which. */
  load(i, other, frames) {
    const known = this.inTexture.indexOf(i);
    if (known >= 0) return known;
    const slot = this.inTexture[0] === other ? 1 : 0;
    const gl = this.gl, steps = frames.at(i).steps, row = 3 * kTextureWidth;
    const rows = Math.floor(steps.length / row);
    gl.bindTexture(gl.TEXTURE_2D, this.textures[slot]);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const send = (y, width, height, from) => gl.texSubImage2D(
        gl.TEXTURE_2D, 0, 0, y, width, height, gl.RGB_INTEGER, gl.UNSIGNED_SHORT,
        steps.subarray(from, from + 3 * width * height));
    if (rows > 0) send(0, kTextureWidth, rows, 0);
    const rest = (steps.length - rows * row) / 3;
    if (rest > 0) send(rows, rest, 1, rows * row);
    this.inTexture[slot] = i;
    return slot;
  }

  facesOf() {
    const gl = this.gl, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    // Corners one by one, as some drivers do not number vertices of indexed drawing.
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, this.elements.faces, gl.STATIC_DRAW);
    const vertex = gl.getAttribLocation(this.facesProgram, 'vertex');
    gl.enableVertexAttribArray(vertex);
    gl.vertexAttribIPointer(vertex, 1, gl.UNSIGNED_INT, 0, 0);
    return array;
  }

  edgesOf(corners) {
    const gl = this.gl, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Uint32Array(corners), gl.STATIC_DRAW);
    const edge = gl.getAttribLocation(this.edgesProgram, 'edge');
    gl.enableVertexAttribArray(edge);
    gl.vertexAttribIPointer(edge, 2, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(edge, 1);
    return {array, count: corners.length / 2};
  }

  /** view: pixels (a unit of length), centre, basis, pan. colours: cloth, ink, soft. */
  draw(frames, {frame, fraction}, view, colours) {
    const gl = this.gl, next = fraction > 0 ? frame + 1 : frame;
    const before = this.load(frame, next, frames), after = this.load(next, frame, frames);
    gl.viewport(0, 0, this.shapes.canvas.width, this.shapes.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const use = (program) => {
      gl.useProgram(program);
      const at = (name) => gl.getUniformLocation(program, name);
      [['before', before, frame], ['after', after, next]].forEach(([name, slot, i], unit) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, this.textures[slot]);
        gl.uniform1i(at(name), unit);
        const f = frames.at(i), spacing = f.spacing * view.pixels;
        gl.uniform3f(at('spacing_' + name), spacing, spacing, spacing);
        gl.uniform3fv(at('origin_' + name), f.origin.map((x, k) => (x - view.centre[k]) * view.pixels));
      });
      gl.activeTexture(gl.TEXTURE0);
      gl.uniform1f(at('fraction'), fraction);
      gl.uniformMatrix3fv(at('turn'), true, view.basis.flat());
      gl.uniform3f(at('move'), view.pan[0], view.pan[1], 0);
      gl.uniform2f(at('size'), this.shapes.width, this.shapes.height);
      return at;
    };
    let at = use(this.facesProgram);
    gl.bindVertexArray(this.faceArray);
    let first = 0;
    this.data.parts.forEach((part, i) => {
      // Neighbouring bodies differ in brightness.
      gl.uniform3fv(at('tint'), colours.cloth.map((x) => Math.min(1, x * [1, 1.18, 0.82][i % 3])));
      if (part.faces > 0) gl.drawArrays(gl.TRIANGLES, 3 * first, 3 * part.faces);
      first += part.faces;
    });
    at = use(this.edgesProgram);
    const lines = ({array, count}, width, lift, colour, alpha) => {
      if (count === 0) return;
      gl.bindVertexArray(array);
      gl.uniform1f(at('width'), width);
      gl.uniform1f(at('lift'), lift);
      gl.uniform4f(at('tint'), ...colour, alpha);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    };
    lines(this.borders, 1, 2, colours.ink, 0.25);
    lines(this.bare, 2, 3, colours.ink, 0.9);
    lines(this.points, 5, 3, colours.ink, 0.9);
  }
}
