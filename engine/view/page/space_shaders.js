// Shaders for a model in space.

export const vertexCode = `#version 300 es
uniform vec3 right, up, toward, middle;
uniform vec3 scale;   // clip units per metre: to the right, upwards, into the depth
uniform float nearer;  // m towards the eye, so that edges lie on their faces
uniform vec4 cut;  // normal towards the eye, offset; zeros: no cut
in vec3 point;
in vec3 colour;
out vec3 fill, seen;
out float above;  // the cut, m
void main() {
  vec3 p = point - middle;
  above = dot(cut.xyz, point) - cut.w;
  seen = vec3(dot(right, p), dot(up, p), dot(toward, p));
  fill = colour;
  gl_Position = vec4(seen.xy * scale.xy, -(seen.z + nearer) * scale.z, 1.0);
}`;
// The normal of a face follows from the derivatives of its points between pixels. Light comes from the upper left. A
// face seen from behind means that the cut opens its solid: the section is shown there, hatched.
export const pixelCode = `#version 300 es
precision highp float;
uniform vec4 line;  // of edges: their colour; opacity 0 where faces are drawn
uniform bool isCut;
uniform float shade;  // brightness of a face without light
in vec3 fill, seen;
in float above;
out vec4 shown;
void main() {
  if (above > 0.0) discard;
  if (isCut && line.a == 0.0 && !gl_FrontFacing) {
    bool isStripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 1.5;
    shown = vec4(fill * (isStripe ? 0.5 : 0.78), 1.0);
    return;
  }
  vec3 n = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.5 + 0.5 * dot(n, normalize(vec3(-0.5, 0.8, 0.6)));
  shown = line.a > 0.0 ? vec4(line.rgb, 1.0) : vec4(fill * (shade + (1.0 - shade) * light), 1.0);
}`;

// A sphere is a square of pixels about its centre: the disc within it, with the depth and the light of the sphere at
// each pixel.
export const ballVertexCode = `#version 300 es
uniform vec3 right, up, toward, middle;
uniform vec3 scale;
uniform float pixels;  // of the canvas per metre
uniform vec4 cut;
in vec3 point;
in vec3 colour;
in float radius;
out vec3 fill;
out vec2 deep;  // depth of the centre, and of the radius
void main() {
  vec3 p = point - middle;
  fill = colour;
  deep = vec2(-dot(toward, p) * scale.z, radius * scale.z);
  gl_Position = vec4(dot(right, p) * scale.x, dot(up, p) * scale.y, deep.x, 1.0);
  gl_PointSize = 2.0 * radius * pixels;
  if (dot(cut.xyz, point) > cut.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
}`;
export const ballPixelCode = `#version 300 es
precision highp float;
in vec3 fill;
in vec2 deep;
out vec4 shown;
void main() {
  vec2 at = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
  float square = dot(at, at);
  if (square > 1.0) discard;
  vec3 n = vec3(at, sqrt(1.0 - square));
  float light = 0.5 + 0.5 * dot(n, normalize(vec3(-0.5, 0.8, 0.6)));
  shown = vec4(fill * (0.42 + 0.58 * light), 1.0);
  gl_FragDepth = 0.5 + 0.5 * (deep.x - deep.y * n.z);
}`;

/** A program of WebGL. Fixed attribute locations, so that all programs read the same buffers. */
export function compiled(gl, ofVertices, ofPixels) {
  const program = gl.createProgram();
  ["point", "colour", "radius"].forEach((name, place) => gl.bindAttribLocation(program, place, name));
  for (const [kind, code] of [[gl.VERTEX_SHADER, ofVertices], [gl.FRAGMENT_SHADER, ofPixels]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, code);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`WebGL: ${gl.getProgramInfoLog(program)}`);
  return program;
}
