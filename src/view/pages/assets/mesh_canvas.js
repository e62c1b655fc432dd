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
uniform mediump usampler2D hues;
uniform vec3 palette[8];
vec3 hue(uint vertex) { return palette[texelFetch(hues, ivec2(int(vertex) % 2048, int(vertex) / 2048), 0).x]; }
vec3 seen(uint vertex) {
  ivec2 at = ivec2(int(vertex) % 2048, int(vertex) / 2048);
  vec3 a = vec3(texelFetch(before, at, 0).xyz) * spacing_before + origin_before;
  vec3 b = vec3(texelFetch(after, at, 0).xyz) * spacing_after + origin_after;
  return turn * mix(a, b, fraction) + move;
}
vec4 clipped(vec3 p) { return vec4(p.xy * 2.0 / size, clamp(-p.z / 8000.0, -0.99, 0.99), 1.0); }
`;

// Light from the sky, less from the ground, and some from a lamp beside the reader, as in view/frame_svg.cpp.
const kLight = `
uniform vec3 sky;
float light_on(vec3 normal) {
  return min(1.0, 0.65 + 0.1 * dot(normal, sky) + 0.35 * max(0.0, dot(normal, vec3(-0.3, 0.5, 0.81))));
}
`;

const kFaceVertex = `#version 300 es
precision highp float;
${kPlace}
in uint vertex;
out vec3 at;
flat out vec3 tint;
void main() {
  at = seen(vertex);
  tint = hue(vertex);
  gl_Position = clipped(at);
}`;

const kFaceFragment = `#version 300 es
precision highp float;
in vec3 at;
flat in vec3 tint;
out vec4 colour;
${kLight}
void main() {
  vec3 normal = cross(dFdx(at), dFdy(at));
  normal *= (normal.z < 0.0 ? -1.0 : 1.0) / max(length(normal), 1e-20);
  colour = vec4(tint * light_on(normal), 1.0);
}`;

// One instance an edge or point; a point is an edge of one vertex. One with a radius is as thick as that, and round.
const kEdgeVertex = `#version 300 es
precision highp float;
${kPlace}
in uvec2 edge;
uniform float width, lift, own, pixels;
uniform highp sampler2D radii;
out vec2 along_and_across;
flat out vec3 tint;
flat out vec2 direction;
flat out float span, half_width;
uniform vec3 ink;
float radius(uint vertex) { return texelFetch(radii, ivec2(int(vertex) % 2048, int(vertex) / 2048), 0).x; }
void main() {
  vec3 a = seen(edge.x), b = seen(edge.y);
  vec2 along = b.xy - a.xy;
  span = length(along);
  along = span > 1e-6 ? along / span : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  half_width = max(0.5 * width, own * pixels * min(radius(edge.x), radius(edge.y)));
  float end = float(gl_VertexID & 1), side = float(gl_VertexID >> 1) * 2.0 - 1.0, beyond = end * 2.0 - 1.0;
  vec3 p = mix(a, b, end);
  p.xy += (across * side + along * beyond) * half_width;
  p.z += lift;
  along_and_across = vec2(end * span + beyond * half_width, side * half_width);
  direction = along;
  tint = mix(ink, hue(edge.x), own);
  gl_Position = clipped(p);
}`;

const kEdgeFragment = `#version 300 es
precision highp float;
in vec2 along_and_across;
flat in vec3 tint;
flat in vec2 direction;
flat in float span, half_width;
uniform float alpha, own;
out vec4 colour;
${kLight}
void main() {
  if (half_width < 2.0) {
    colour = vec4(tint * mix(1.0, 0.8, own) * alpha, alpha);
    return;
  }
  vec2 from_axis = vec2(along_and_across.x - clamp(along_and_across.x, 0.0, span), along_and_across.y) / half_width;
  float distance = length(from_axis);
  float cover = alpha * clamp((1.0 - distance) * half_width + 0.5, 0.0, 1.0);
  if (cover < 0.01) discard;
  vec2 flat_normal = from_axis.x * direction + from_axis.y * vec2(-direction.y, direction.x);
  vec3 normal = vec3(flat_normal, sqrt(max(0.0, 1.0 - distance * distance)));
  colour = vec4(tint * light_on(normal) * cover, cover);
}`;

class MeshCanvas {
  /** Draws into the context of a canvas for shapes. */
  constructor(shapes, elements, data) {
    const gl = this.gl = shapes.gl;
    this.shapes = shapes;
    this.elements = elements;
    this.data = data;
    this.facesProgram = programOf(gl, kFaceVertex, kFaceFragment);
    this.edgesProgram = programOf(gl, kEdgeVertex, kEdgeFragment);
    this.textures = [this.texture(gl.RGB16UI), this.texture(gl.RGB16UI)];
    this.inTexture = [-1, -1];
    this.hues = this.texture(gl.R8UI);
    this.send(elements.hues, 1, gl.RED_INTEGER, gl.UNSIGNED_BYTE);
    this.radii = this.texture(gl.R32F);
    if (elements.radii.length > 0) this.send(elements.radii, 1, gl.RED, gl.FLOAT);
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

  texture(format) {
    const gl = this.gl, texture = gl.createTexture();
    const height = Math.max(1, Math.ceil(this.data.vertices / kTextureWidth));
    if (height > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error('too many vertices for this browser');
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, kTextureWidth, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  /** Puts a frame into one of the two textures, unless it is there. Returns which. */
  load(i, other, frames) {
    const known = this.inTexture.indexOf(i);
    if (known >= 0) return known;
    const slot = this.inTexture[0] === other ? 1 : 0;
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D, this.textures[slot]);
    this.send(frames.at(i).steps, 3, gl.RGB_INTEGER, gl.UNSIGNED_SHORT);
    this.inTexture[slot] = i;
    return slot;
  }

  /** Puts the numbers of all vertices into the bound texture. */
  send(numbers, channels, format, type) {
    const gl = this.gl, row = channels * kTextureWidth, rows = Math.floor(numbers.length / row);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const put = (y, width, height, from) => gl.texSubImage2D(
        gl.TEXTURE_2D, 0, 0, y, width, height, format, type, numbers.subarray(from, from + channels * width * height));
    if (rows > 0) put(0, kTextureWidth, rows, 0);
    const rest = (numbers.length - rows * row) / channels;
    if (rest > 0) put(rows, rest, 1, rows * row);
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

  /** view: pixels (a unit of length), centre, basis, pan. colours: ink, and rest for what is at rest. */
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
      gl.activeTexture(gl.TEXTURE2);
      gl.bindTexture(gl.TEXTURE_2D, this.hues);
      gl.uniform1i(at('hues'), 2);
      gl.activeTexture(gl.TEXTURE3);
      gl.bindTexture(gl.TEXTURE_2D, this.radii);
      gl.uniform1i(at('radii'), 3);
      gl.uniform1f(at('pixels'), view.pixels);
      gl.uniform3fv(at('palette'), [...colours.rest, ...this.data.hues.slice(1).flat().map((x) => x / 255)]);
      gl.uniform3fv(at('sky'), view.basis.map((axis) => axis[2]));
      gl.activeTexture(gl.TEXTURE0);
      gl.uniform1f(at('fraction'), fraction);
      gl.uniformMatrix3fv(at('turn'), true, view.basis.flat());
      gl.uniform3f(at('move'), view.pan[0], view.pan[1], 0);
      gl.uniform2f(at('size'), this.shapes.width, this.shapes.height);
      return at;
    };
    use(this.facesProgram);
    gl.bindVertexArray(this.faceArray);
    if (this.elements.faces.length > 0) gl.drawArrays(gl.TRIANGLES, 0, this.elements.faces.length);
    const at = use(this.edgesProgram);
    gl.uniform3fv(at('ink'), colours.ink);
    const lines = ({array, count}, width, lift, own, alpha) => {
      if (count === 0) return;
      gl.bindVertexArray(array);
      gl.uniform1f(at('width'), width);
      gl.uniform1f(at('lift'), lift);
      gl.uniform1f(at('own'), own);
      gl.uniform1f(at('alpha'), alpha);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
    };
    lines(this.borders, 1, 2, 0, 0.15);
    lines(this.bare, 3, 3, 1, 1);
    lines(this.points, 6, 3, 1, 1);
  }
}
