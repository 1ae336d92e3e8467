// Draws a model in space: polyhedra with WebGL; marks, forces and the selection on a canvas over it.
import { Cut } from "./cut.js";
import { Scene, crackColour } from "./scene.js";
import { DepthShading } from "./space_depth.js";
import { ballPixelCode, ballVertexCode, compiled, pixelCode, vertexCode } from "./space_shaders.js";

/** #rrggbb, or rgb(r, g, b) from style sheets, to three numbers up to 1. */
function shares(colour) {
  if (colour.startsWith("#")) return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255);
  return (colour.match(/[\d.]+/g) ?? [0, 0, 0]).slice(0, 3).map((v) => Number(v) / 255);
}

export class SpaceScene extends Scene {
  /** Polyhedra are drawn on the canvas itself, everything else on one over it. */
  contextOf(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: false, stencil: true });
    if (!gl) throw new Error("This browser shows no models in space: it lacks WebGL 2.");
    this.gl = gl;
    this.cut = new Cut(this.camera);
    this.over = document.createElement("canvas");
    this.over.id = "over";
    this.over.style.cssText = "position:absolute;inset:0;width:100%;height:100%;pointer-events:none";
    canvas.after(this.over);
    canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    this.solids = compiled(gl, vertexCode, pixelCode);
    if (this.run.spheres.length) this.balls = compiled(gl, ballVertexCode, ballPixelCode);
    this.depthShading = new DepthShading(gl);
    this.program = this.solids;
    gl.useProgram(this.program);
    this.at = (name) => gl.getUniformLocation(this.program, name);
    this.takeFaces();
    return this.over.getContext("2d");
  }

  /** Triangles of all faces, and each edge once; both index the points of the run. */
  takeFaces() {
    const { gl, run } = this, triangles = [], edges = [];
    run.faces.forEach((faces) => {
      const seen = new Set();
      for (const face of faces)
        face.forEach((a, i) => {
          const b = face[(i + 1) % face.length], key = a < b ? `${a} ${b}` : `${b} ${a}`;
          if (i > 0 && i + 1 < face.length) triangles.push(face[0], a, b);
          if (!seen.has(key)) seen.add(key), edges.push(a, b);
        });
    });
    const list = (values) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from(values), gl.STATIC_DRAW);
      return { buffer, count: values.length };
    };
    [this.triangles, this.edges, this.centres] = [list(triangles), list(edges), list(run.spheres)];
    this.points = new Float32Array(3 * run.vertexNode.length);
    this.fills = new Uint8Array(this.points.length);
    const numbers = (place, width, type, normalised) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, width, type, normalised, 0, 0);
      return buffer;
    };
    this.pointBuffer = numbers(0, 3, gl.FLOAT, false);
    this.fillBuffer = numbers(1, 3, gl.UNSIGNED_BYTE, true);
    numbers(2, 1, gl.FLOAT, false);
    gl.bufferData(gl.ARRAY_BUFFER, run.radius, gl.STATIC_DRAW);
    this.sectionBuffer = gl.createBuffer();
    this.bodyLength = this.findBodyLength();
  }

  /** The median over the bodies of the shortest extent along an axis [m]. */
  findBodyLength() {
    const { run } = this;
    if (!run.frames) return 1;
    run.pose(run.begin);
    const lengths = run.bodies.map((body) => Math.min(...[run.pointX, run.pointY, run.pointZ].map((values) => {
      const own = values.subarray(body.vertex, body.vertex + body.vertices), radius = run.radius[body.vertex] || 0;
      return 2 * radius + own.reduce((a, b) => Math.max(a, b), -Infinity) - own.reduce((a, b) => Math.min(a, b), Infinity);
    }))).filter((length) => length > 0).sort((a, b) => a - b);
    return lengths[Math.floor(lengths.length / 2)] ?? 1;
  }

  resize() {
    super.resize();
    this.over.width = this.canvas.width;
    this.over.height = this.canvas.height;
    // Rendered at twice the displayed resolution: some machines compute wrong depths for lines with their own
    // smoothing.
    if (this.ratio < 2) {
      this.canvas.width *= 2;
      this.canvas.height *= 2;
    }
    this.gl.viewport(0, 0, this.canvas.width, this.canvas.height);
  }

  draw(time, colours, selection) {
    const { run, gl, context: c, camera } = this, theme = colours.theme;
    const { depthShading } = this, deepens = this.hasTimeToDeepen(() => this.draw(time, colours, selection));
    gl.clearColor(...shares(theme.paper), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, camera.width, camera.height);
    if (!run.frames) return deepens ? depthShading.finish() : undefined;
    run.pose(time);
    this.measure();
    this.shade = colours.groups ? 0.56 : 0.85;  // shading would change the colour of a value
    this.aim();
    this.fill(colours.at(run.now.frame, time));
    this.upload(run.pointX, run.pointY, run.pointZ);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(2, 2);
    this.drawFaces();
    this.drawSpheres();
    if (deepens) this.deepen(colours);
    this.drawList(gl.LINES, this.edges, [...shares(theme.outline), 1]);
    this.drawSectionOutlines(theme);
    if (this.show.cracks) this.drawSolidCracks(time, theme);
    if (run.mode) this.drawStood(theme);
    else if (this.show.start) this.drawStart(theme);
    if (deepens) depthShading.finish();
    if (this.show.forces && !run.mode) this.drawForces(theme);
    this.drawMembers(theme);
    if (this.show.bearings) this.drawBearings(theme, selection);
    if (this.show.names) this.drawNames(theme);
    if (selection) this.drawSelection(selection, theme);
    this.drawAxes(theme);
    return undefined;
  }

  /** Begins the picture that is darkened. A slow machine does so only once the view rests, and draws `again` then. The view
   * counts as at rest after twice the duration of this pass, so a run that plays slowly does not count as at rest. */
  hasTimeToDeepen(again) {
    const { depthShading } = this, now = performance.now(), rest = Math.max(200, 2 * depthShading.milliseconds);
    const moves = now - (this.lastDraw ?? -Infinity) < rest;
    clearTimeout(this.later);
    this.lastDraw = now;
    if (!this.show.depth) return false;
    if (!moves || !depthShading.isSlow) return depthShading.begin(this.canvas.width, this.canvas.height);
    this.later = setTimeout(() => {
      this.lastDraw = -Infinity;
      again();
    }, rest);
    return false;
  }

  /** Darkens surfaces that their surroundings hide: less where colours are values, which darkening changes. */
  deepen(colours) {
    const { camera, gl } = this;
    this.depthShading.darken({ height: 2 * this.depthRange(), pixel: camera.width / (camera.scale * this.canvas.width),
      reach: 1.5 * this.bodyLength, strength: colours.groups ? 0.6 : 0.3 });
    gl.useProgram(this.program);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.pointBuffer);
  }

  /** The picture holds points this far in front of and behind the origin of the view [m]. */
  depthRange() { return this.farthest + Math.hypot(this.camera.x, this.camera.y, this.camera.z); }

  drawStart(theme, xs = this.startX, ys = this.startY, zs = this.startZ) {
    this.upload(xs, ys, zs);
    // The edges of bodies that have not moved stay in front: rounding would choose one of both lines at each draw.
    this.drawList(this.gl.LINES, this.edges, [...shares(theme.ghost), 1], 0.5);
  }

  /** Largest distance of any point from the origin [m]: the range of the depth buffer. */
  measure() {
    const { run } = this;
    this.farthest = 1e-3;
    for (let v = 0; v < run.vertexNode.length; v++) this.farthest = Math.max(this.farthest, Math.hypot(run.pointX[v], run.pointY[v], run.pointZ[v]));
  }

  aim() {
    const { gl, camera } = this;
    for (const name of ["right", "up", "toward"]) gl.uniform3fv(this.at(name), camera[name]);
    gl.uniform3f(this.at("middle"), camera.x, camera.y, camera.z);
    const deep = 1 / this.depthRange();
    gl.uniform3f(this.at("scale"), (2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height, deep);
    gl.uniform4fv(this.at("cut"), this.cut.plane());
    gl.uniform1i(this.at("isCut"), this.cut.isThere);
    gl.uniform1f(this.at("shade"), this.shade);
  }

  /** A body's colour for each of its points. */
  fill(colours) {
    const { run, gl } = this;
    for (const body of run.bodies) {
      const colour = shares(colours[body.index]).map((v) => Math.round(255 * v));
      for (let v = body.vertex; v < body.vertex + body.vertices; v++) this.fills.set(colour, 3 * v);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.fillBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, this.fills, gl.DYNAMIC_DRAW);
  }

  /** Bodies out of bounds, or absent, shrink to zero size. */
  upload(xs, ys, zs) {
    const { run, gl } = this;
    for (const body of run.bodies) {
      const gone = body.leaves <= run.now.time || !run.isThere(body);
      for (let v = body.vertex; v < body.vertex + body.vertices; v++) {
        const from = gone ? body.vertex : v;
        this.points[3 * v] = xs[from];
        this.points[3 * v + 1] = ys[from];
        this.points[3 * v + 2] = zs[from];
      }
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.pointBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, this.points, gl.DYNAMIC_DRAW);
  }

  /** Edges are drawn slightly nearer than their faces, by a share of the usual distance. */
  setLine(line, share = 1) {
    this.gl.uniform4fv(this.at("line"), line);
    this.gl.uniform1f(this.at("nearer"), line[3] > 0 ? share * Math.min(4 / this.camera.scale, 0.12 * this.usualSize) : 0);
  }

  /** All faces. Where a face is seen from behind, a section is visible, and later objects are behind it if they are behind
   *  the plane of the cut. */
  drawFaces() {
    const { gl, cut } = this;
    if (!cut.isThere) return this.drawList(gl.TRIANGLES, this.triangles, [0, 0, 0, 0]);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.ALWAYS, 1, 1);
    gl.stencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.ZERO);
    gl.stencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.REPLACE);
    this.drawList(gl.TRIANGLES, this.triangles, [0, 0, 0, 0]);
    gl.stencilFunc(gl.EQUAL, 1, 1);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
    gl.depthFunc(gl.ALWAYS);
    gl.colorMask(false, false, false, false);
    this.drawPoints(gl.TRIANGLE_STRIP, cut.corners(this.farthest), [0, 0, 0, 0]);
    gl.colorMask(true, true, true, true);
    gl.depthFunc(gl.LESS);
    return gl.disable(gl.STENCIL_TEST);
  }

  drawSectionOutlines(theme) {
    this.drawPoints(this.gl.LINES, this.cut.outlines(this.run), [...shares(theme.outline), 1]);
  }

  /** The outlines of joints that have lost their bond, over the edges of polyhedra. */
  drawSolidCracks(time, theme) {
    for (const mode of new Set(this.run.joints.map((joint) => joint.mode)))
      this.drawPoints(this.gl.TRIANGLES, this.ribbons(time, mode), [...shares(crackColour(mode, theme)), 1], this.cut.plane());
  }

  /** Both triangles of each side of those joints, with constant width on the canvas. */
  ribbons(time, mode) {
    const { run, camera } = this, points = [], nearer = 1 / camera.scale;
    for (const joint of run.joints) {
      if (joint.mode !== mode || joint.event.time > time || !run.showsCrack(joint, this.show.debris)) continue;
      const half = (joint.broken ? 1.3 : 0.7) / camera.scale, outline = run.outlineOf(joint);
      outline.forEach((b, i) => {
        const a = outline[(i || outline.length) - 1], way = b.map((v, k) => v - a[k]);
        const right = way.reduce((s, v, k) => s + v * camera.right[k], 0), up = way.reduce((s, v, k) => s + v * camera.up[k], 0);
        const long = Math.hypot(right, up) || 1;
        const aside = way.map((_, k) => (half * (right * camera.up[k] - up * camera.right[k])) / long);
        const at = (p, s) => p.map((v, k) => v + s * aside[k] + nearer * camera.toward[k]);
        points.push(...at(a, -1), ...at(b, -1), ...at(b, 1), ...at(a, -1), ...at(b, 1), ...at(a, 1));
      });
    }
    return points;
  }

  /** Draws separate points. Points in the plane of the cut must not be removed by it: no plane then. */
  drawPoints(kind, points, line, plane = [0, 0, 0, 0]) {
    const { gl, cut } = this;
    if (!points.length) return;
    gl.uniform4fv(this.at("cut"), plane);
    this.setLine(line);
    for (const place of [1, 2]) gl.disableVertexAttribArray(place);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.sectionBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(points), gl.DYNAMIC_DRAW);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.drawArrays(kind, 0, points.length / 3);
    for (const place of [1, 2]) gl.enableVertexAttribArray(place);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.pointBuffer);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.uniform4fv(this.at("cut"), cut.plane());
  }

  drawList(kind, list, line, share = 1) {
    const { gl } = this;
    this.setLine(line, share);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, list.buffer);
    gl.drawElements(kind, list.count, gl.UNSIGNED_INT, 0);
  }

  drawSpheres() {
    const { gl, run } = this;
    if (!run.spheres.length) return;
    this.program = this.balls;
    gl.useProgram(this.program);
    this.aim();
    gl.uniform1f(this.at("pixels"), (this.camera.scale * this.canvas.width) / this.camera.width);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.centres.buffer);
    gl.drawElements(gl.POINTS, this.centres.count, gl.UNSIGNED_INT, 0);
    this.program = this.solids;
    gl.useProgram(this.program);
  }

  drawForces(theme) {
    const { run, context: c, camera } = this;
    const [first, last] = run.contactRows(run.now.frame);
    const place = run.block("contact_place"), force = run.block("contact_force"), pair = run.block("contact_pair").values;
    c.strokeStyle = c.fillStyle = theme.force;
    c.lineWidth = 1.6;
    for (let k = first; k < last; k++) {
      const row = (block) => [0, 1, 2].map((i) => block.quantum * block.values[3 * k + i]);
      const at = row(place), f = row(force), size = Math.hypot(...f);
      if (this.forceLength(size) < 1.5 || this.isCut(at)) continue;
      // Of the pair of forces, the one on the supported body is drawn.
      const aFree = run.bodies[pair[3 * k]]?.free, bFree = run.bodies[pair[3 * k + 1]]?.free;
      const metres = ((aFree === bFree ? f[2] < 0 : bFree) ? -1 : 1) * this.forceLength(size) / camera.scale / size;
      const [x, y] = camera.place(...at), [ex, ey] = camera.place(...at.map((v, i) => v + metres * f[i]));
      const length = Math.hypot(ex - x, ey - y);
      c.beginPath();
      c.moveTo(x, y);
      c.lineTo(ex, ey);
      c.stroke();
      if (length > 9) this.arrowHead(ex, ey, (ex - x) / length, (ey - y) / length);
    }
  }

  /** True if a point is on the removed side of the cut. */
  isCut(place) { return this.cut.takes(place); }

  bearingMark(bearing) {
    return this.isCut(this.run.bearingEnds(bearing)[0]) ? null : super.bearingMark(bearing);
  }

  middle(body) {
    const sum = [0, 0, 0];
    for (let v = body.vertex; v < body.vertex + body.vertices; v++) this.run.point(v).forEach((value, k) => (sum[k] += value / body.vertices));
    return sum;
  }

  /** The edges of the selected body, and the path of its centre. */
  drawSelection(selection, theme) {
    if (!selection.body) return super.drawSelection(selection, theme);
    const { run, context: c, camera } = this, { x, y, z } = selection.trail;
    c.strokeStyle = theme.accent;
    c.lineWidth = 1.5;
    c.beginPath();
    for (let f = 0; f <= run.now.frame; f++) c.lineTo(...camera.place(x[f], y[f], z[f]));
    c.stroke();
    c.lineWidth = 2;
    for (const [x, y, , r] of this.discs(selection.body)) {
      c.beginPath();
      c.arc(x, y, r, 0, 2 * Math.PI);
      c.stroke();
    }
    for (const face of run.faces[selection.body.index]) {
      c.beginPath();
      for (const v of face) c.lineTo(...camera.place(...run.point(v)));
      c.closePath();
      c.stroke();
    }
    return undefined;
  }

  drawAxes(theme) {
    const { context: c, camera } = this, [x, y] = [camera.width - 60, camera.height - 90], length = 24;
    c.strokeStyle = c.fillStyle = theme.quiet;
    c.lineWidth = 1.5;
    c.font = "12px system-ui, sans-serif";
    c.textAlign = "center";
    c.textBaseline = "middle";
    ["x", "y", "z"].forEach((name, k) => {
      const dx = length * camera.right[k], dy = -length * camera.up[k];
      c.beginPath();
      c.moveTo(x, y);
      c.lineTo(x + dx, y + dy);
      c.stroke();
      if (Math.hypot(dx, dy) > 6) c.fillText(name, x + 1.35 * dx, y + 1.35 * dy);
    });
  }

  /** The visible spheres of a body: position, depth of the centre [m], and radius on the canvas. */
  discs(body) {
    const { run, camera } = this, discs = [];
    for (let v = body.vertex; v < body.vertex + body.vertices; v++)
      if (run.radius[v] > 0) discs.push([...camera.place(...run.point(v)), camera.depth(...run.point(v)), run.radius[v] * camera.scale, this.isCut(run.point(v))]);
    return discs;
  }

  /** The body whose face is nearest to the eye at a point on the canvas, or null. */
  bodyAt(px, py) {
    const { run, camera } = this;
    let best = null, nearest = -Infinity;
    for (const body of this.order.filter((b) => run.isThere(b))) {
      for (const [x, y, deep, r, isCut] of this.discs(body)) {
        if (isCut) continue;
        const square = (r * r - (px - x) ** 2 - (py - y) ** 2) / camera.scale ** 2;
        if (square > 0 && deep + Math.sqrt(square) > nearest) [best, nearest] = [body, deep + Math.sqrt(square)];
      }
      for (const face of run.faces[body.index]) {
        const corners = face.map((v) => run.point(v)), flat = corners.map((p) => camera.place(...p));
        let hit = false;
        for (let i = 0, k = flat.length - 1; i < flat.length; k = i++)
          if (flat[i][1] > py !== flat[k][1] > py && px < ((flat[k][0] - flat[i][0]) * (py - flat[i][1])) / (flat[k][1] - flat[i][1]) + flat[i][0]) hit = !hit;
        if (!hit) continue;
        const depth = depthAt(flat, corners.map((p) => camera.depth(...p)), px, py);
        if (depth > nearest && !this.isCut(camera.pointAt(px, py, depth))) [best, nearest] = [body, depth];
      }
    }
    return best;
  }
}

/** Depth of the plane of a face at a point on the canvas, from the face's first corner that is not edge-on. */
function depthAt(flat, depth, px, py) {
  const [x, y] = flat[0];
  for (let i = 1; i + 1 < flat.length; i++) {
    const ax = flat[i][0] - x, ay = flat[i][1] - y, bx = flat[i + 1][0] - x, by = flat[i + 1][1] - y, area = ax * by - ay * bx;
    if (Math.abs(area) < 1e-6) continue;
    const s = ((px - x) * by - (py - y) * bx) / area, t = (ax * (py - y) - ay * (px - x)) / area;
    return depth[0] + s * (depth[i] - depth[0]) + t * (depth[i + 1] - depth[0]);
  }
  return -Infinity;
}
