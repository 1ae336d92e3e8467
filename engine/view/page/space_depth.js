// Ambient occlusion: points that their surroundings hide from the sky are darker, so that corners, joints and openings read
// as deep. It follows from the depth of the picture alone: at each pixel, the heights of its neighbours over its own
// tangent plane. Sources: Mittring, "Finding next gen: CryEngine 2", SIGGRAPH 2007 course notes. For the tangent plane:
// Bavoil, Sainz and Dimitrov, "Image-space horizon-based ambient occlusion", SIGGRAPH 2008.
import { compiled } from "./space_shaders.js";

const wholeVertexCode = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;
const occlusionCode = `#version 300 es
precision highp float;
uniform highp sampler2D depth;
uniform float height;    // m per unit of the depth
uniform float pixel;     // m per pixel
uniform float reach;     // pixels
uniform float strength;  // of the darkest point
out vec4 shown;
bool isInside(ivec2 at) { return all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(depth, 0))); }
float heightAt(ivec2 at) { return -height * texelFetch(depth, clamp(at, ivec2(0), textureSize(depth, 0) - 1), 0).r; }
/** Slope along one axis, from the side on which the surface goes on. */
float slope(float before, float here, float after) {
  return abs(after - here) < abs(here - before) ? after - here : here - before;
}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float here = heightAt(at);
  if (here <= -height) discard;  // background
  vec2 plane = vec2(slope(heightAt(at - ivec2(1, 0)), here, heightAt(at + ivec2(1, 0))),
                    slope(heightAt(at - ivec2(0, 1)), here, heightAt(at + ivec2(0, 1))));
  // Each pixel has its own directions, which the eye averages (interleaved gradient noise, Jimenez 2014).
  float turn = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float hidden = 0.0;
  const int count = 20;
  for (int i = 0; i < count; i++) {
    float angle = turn + 2.39996 * float(i), radius = reach * sqrt((float(i) + 0.5) / float(count));
    ivec2 way = ivec2(round(radius * vec2(cos(angle), sin(angle))));
    if (way == ivec2(0) || !isInside(at + way)) continue;
    float rise = heightAt(at + way) - here - dot(plane, vec2(way)), far = pixel * length(vec2(way));
    // Something much nearer to the eye than the reach is another part of the scene, which hides little.
    float near = clamp(2.0 - rise / (pixel * reach), 0.0, 1.0);
    hidden += near * clamp(rise / far - 0.08, 0.0, 1.0);
  }
  shown = vec4(vec3(1.0 - strength * min(1.0, 1.7 * hidden / float(count))), 1.0);
}`;

const slow = 40;  // ms: above, the pass is left out while a run plays

/** Draws the scene into a picture of its own, darkens it, and shows it on the canvas. */
export class DepthShading {
  constructor(gl) {
    this.gl = gl;
    this.program = compiled(gl, wholeVertexCode, occlusionCode);
    [this.whole, this.colourOnly, this.colour, this.depth] = [gl.createFramebuffer(), gl.createFramebuffer(), gl.createRenderbuffer(), gl.createTexture()];
    this.empty = gl.createVertexArray();
    this.milliseconds = 0;
  }

  /** Everything is drawn into the picture from now on; false where the browser cannot. */
  begin(width, height) {
    const { gl } = this;
    if (this.width !== width || this.height !== height) this.make(width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.works ? this.whole : null);
    return this.works;
  }

  make(width, height) {
    const { gl } = this;
    [this.width, this.height] = [width, height];
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.colour);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, width, height);
    gl.bindTexture(gl.TEXTURE_2D, this.depth);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH24_STENCIL8, width, height, 0, gl.DEPTH_STENCIL, gl.UNSIGNED_INT_24_8, null);
    for (const [name, value] of [["MIN_FILTER", "NEAREST"], ["MAG_FILTER", "NEAREST"], ["WRAP_S", "CLAMP_TO_EDGE"], ["WRAP_T", "CLAMP_TO_EDGE"]])
      gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.whole);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, this.colour);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_STENCIL_ATTACHMENT, gl.TEXTURE_2D, this.depth, 0);
    this.works = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.colourOnly);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, this.colour);
  }

  /** Darkens the surfaces drawn so far. `height`: m per unit of the depth, `pixel`: m, `reach`: m. */
  darken({ height, pixel, reach, strength }) {
    const { gl, program } = this, began = performance.now(), at = (name) => gl.getUniformLocation(program, name);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.colourOnly);  // the depth is read now
    gl.useProgram(program);
    gl.bindVertexArray(this.empty);
    gl.bindTexture(gl.TEXTURE_2D, this.depth);
    gl.uniform1f(at("height"), height);
    gl.uniform1f(at("pixel"), pixel);
    gl.uniform1f(at("reach"), Math.max(4, Math.min(64, reach / pixel)));
    gl.uniform1f(at("strength"), strength);
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ZERO, gl.SRC_COLOR);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.bindVertexArray(null);
    if (!this.milliseconds) {  // measured once; reading a pixel waits for the picture
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.milliseconds = performance.now() - began;
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.whole);
  }

  get isSlow() { return this.milliseconds > slow; }

  finish() {
    const { gl, width, height } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.whole);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}
