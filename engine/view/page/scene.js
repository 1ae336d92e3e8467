// Draws the structure at one moment.
import { bearingStates } from "./run.js";

const markOf = (palette, ink) => [ink, palette.yielded, palette.failed, palette.changed];
const crackModes = { tension: "#d03a00", shear: "#8a3ffc", compression: "#0b7a75", "": "#d03a00" };
export const crackColour = (mode, theme) => (theme.dark && mode !== "shear" ? "#ff6a3c" : crackModes[mode]);

function inside(run, body, x, y) {
  let hit = false;
  for (let i = 0, k = body.vertices - 1; i < body.vertices; k = i++) {
    const a = body.vertex + i, b = body.vertex + k;
    if (run.pointY[a] > y !== run.pointY[b] > y &&
        x < ((run.pointX[b] - run.pointX[a]) * (y - run.pointY[a])) / (run.pointY[b] - run.pointY[a]) + run.pointX[a]) hit = !hit;
  }
  return hit;
}

export class Scene {
  constructor(run, canvas, camera) {
    this.run = run;
    this.canvas = canvas;
    this.camera = camera;
    this.context = this.contextOf(canvas);
    this.show = { forces: false, cracks: true, debris: false, bearings: true, hinges: true, names: false, start: false, depth: true };
    this.order = [...run.bodies].sort((a, b) => a.free - b.free);
    this.usualForce = this.findUsualForce();
    const areas = run.bodies.filter((b) => b.free && b.area > 0).map((b) => b.area).sort((a, b) => a - b);
    this.usualSize = Math.sqrt(areas[Math.floor(areas.length / 2)] ?? 1);  // m
    if (run.frames) {
      run.pose(run.begin);
      this.startX = run.pointX.slice();
      this.startY = run.pointY.slice();
      this.startZ = run.pointZ?.slice();
    }
  }

  contextOf(canvas) { return canvas.getContext("2d"); }

  /** The body under a point on the canvas, free ones first, or null. */
  bodyAt(px, py) {
    const [x, y] = this.camera.reach(px, py);
    for (let i = this.order.length - 1; i >= 0; i--) if (this.run.isThere(this.order[i]) && inside(this.run, this.order[i], x, y)) return this.order[i];
    return null;
  }

  /** The 90 % quantile of the forces, for the length of arrows. */
  findUsualForce() {
    const { values, quantum, rows, columns } = this.run.block("contact_force");
    const sizes = [];
    for (let k = 0; k < rows; k += Math.max(1, Math.floor(rows / 5000)))
      sizes.push(quantum * Math.hypot(...values.subarray(columns * k, columns * (k + 1))));
    sizes.sort((a, b) => a - b);
    return sizes[Math.floor(0.9 * (sizes.length - 1))] || 1;
  }

  resize() {
    const ratio = window.devicePixelRatio || 1, box = this.canvas.getBoundingClientRect();
    this.canvas.width = Math.round(box.width * ratio);
    this.canvas.height = Math.round(box.height * ratio);
    this.ratio = ratio;
    this.camera.resize(box.width, box.height);
  }

  /** `colours`: BodyColours; `selection`: { body } or { bearing } or null. */
  draw(time, colours, selection) {
    const { run, context: c, camera } = this;
    const theme = colours.theme;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.fillStyle = theme.paper;
    c.fillRect(0, 0, camera.width, camera.height);
    if (!run.frames) return;
    run.pose(time);
    this.drawBodies(colours.at(run.now.frame, time), colours.cellsAt(run.now.frame), theme);
    if (run.mode) this.drawStood(theme);
    else if (this.show.start) this.drawStart(theme);
    if (this.show.cracks) this.drawCracks(time, theme);
    if (this.show.forces && !run.mode) this.drawForces(theme);
    this.drawMembers(theme);
    if (this.show.bearings) this.drawBearings(theme, selection);
    if (this.show.names) this.drawNames(theme);
    if (selection) this.drawSelection(selection, theme);
  }

  outline(body, xs = this.run.pointX, ys = this.run.pointY) {
    const { context: c, camera } = this;
    c.beginPath();
    for (let v = body.vertex; v < body.vertex + body.vertices; v++) {
      // Browsers draw badly far beyond the canvas.
      const [x, y] = camera.place(xs[v], ys[v]);
      c.lineTo(Math.max(-1e5, Math.min(1e5, x)), Math.max(-1e5, Math.min(1e5, y)));
    }
    c.closePath();
  }

  /** Finite elements, each with its colour; a thin edge of the same colour closes the seams. */
  drawElements(fills) {
    const { run, context: c, camera } = this;
    c.lineWidth = 0.7;
    run.elements.forEach((element, i) => {
      if (!run.bodies[element.body].free || !run.isThere(run.bodies[element.body])) return;
      c.fillStyle = c.strokeStyle = fills[i];
      c.beginPath();
      for (const node of element.nodes) c.lineTo(...camera.place(run.nodeX[node], run.nodeY[node]));
      c.closePath();
      c.fill();
      c.stroke();
    });
  }

  /** A frame: the lines of all its polygons, then their fills, so that only the line around all of them remains. */
  drawParts(parts, fill, theme, small) {
    const { context: c, camera } = this;
    const path = (points) => {
      c.beginPath();
      for (const p of points) c.lineTo(...camera.place(...p));
      c.closePath();
    };
    c.strokeStyle = theme.outline;
    c.lineWidth = small ? 1 : 2;
    for (const part of parts) path(part), c.stroke();
    c.fillStyle = c.strokeStyle = fill;
    c.lineWidth = 0.3;
    for (const part of parts) path(part), c.fill(), c.stroke();
  }

  /** Diagrams and hinges of members; not in a mode, which has no forces. */
  drawMembers(theme) {
    const { run } = this;
    if (!run.members.list.length || run.mode) return;
    run.members.drawDiagram(this, theme);
    if (this.show.hinges) run.members.drawHinges(this, theme);
  }

  drawBodies(fills, cells, theme) {
    const { run, context: c } = this;
    c.lineJoin = "round";
    const small = this.camera.scale * this.usualSize < 14;
    const faint = (body) => (body.leaves <= this.run.now.time ? 0.25 : 1); // out of bounds
    const shown = this.order.filter((body) => this.run.isThere(body));
    for (const body of shown) {
      c.globalAlpha = faint(body);
      c.fillStyle = fills[body.index];
      this.outline(body);
      c.fill();
    }
    c.globalAlpha = 1;
    if (cells) this.drawElements(cells);
    for (const body of shown) {
      c.globalAlpha = faint(body);
      this.outline(body);
      c.strokeStyle = body.free ? theme.outline : theme["ground-line"];
      c.lineWidth = body.free ? (small ? 0.5 : 1) : 1.2;
      c.stroke();
      if (body.free) this.drawParts(run.members.parts(body), fills[body.index], theme, small);
    }
    c.globalAlpha = 1;
  }

  /** Draws the initial position of the parts that vibrate in a mode. */
  drawStood(theme) {
    const { run } = this, swing = run.mode.share;
    run.mode.share = 0;
    run.poseMode();
    const stood = [run.pointX, run.pointY, run.pointZ].map((values) => values?.slice());
    run.mode.share = swing;
    run.poseMode();
    this.drawStart(theme, ...stood);
  }

  drawStart(theme, xs = this.startX, ys = this.startY) {
    const { context: c } = this;
    c.strokeStyle = theme.ghost;
    c.lineWidth = 1;
    c.setLineDash([4, 3]);
    for (const body of this.order) {
      if (!body.free || !this.run.isThere(body)) continue;
      this.outline(body, xs, ys);
      c.stroke();
    }
    c.setLineDash([]);
  }

  drawCracks(time, theme) {
    const { run, context: c, camera } = this;
    c.lineCap = "round";
    const thick = Math.max(0.6, Math.min(3, 0.09 * this.usualSize * camera.scale));
    for (const joint of run.joints) {
      if (joint.event.time > time) continue;
      const body = run.bodies[joint.body];
      if (!run.showsCrack(joint, this.show.debris)) continue;
      const v = body.vertex + joint.edge, w = body.vertex + ((joint.edge + 1) % body.vertices);
      const at = (s) => camera.place(run.pointX[v] + s * (run.pointX[w] - run.pointX[v]), run.pointY[v] + s * (run.pointY[w] - run.pointY[v]));
      const fresh = time - joint.event.time < 0.15;
      c.strokeStyle = crackColour(joint.mode, theme);
      c.lineWidth = (fresh ? 2 : 1) * (joint.broken ? thick : thick / 2);
      c.beginPath();
      c.moveTo(...at(joint.from));
      c.lineTo(...at(joint.to));
      c.stroke();
    }
    c.lineCap = "butt";
  }

  /** Length on the canvas of the usual force: a readable one, at most the size of small bodies. */
  get usualLength() {
    return Math.max(6, Math.min(34, 0.9 * this.usualSize * this.camera.scale));
  }

  /** Length on the canvas of a force [N]: by the square root, so that small forces remain visible with impacts. */
  forceLength(size) {
    return Math.min(160, this.usualLength * Math.sqrt(size / this.usualForce));
  }

  drawForces(theme) {
    const { run, context: c, camera } = this;
    const [first, last] = run.contactRows(run.now.frame);
    const place = run.block("contact_place"), force = run.block("contact_force"), pair = run.block("contact_pair").values;
    const bars = last - first > 60;
    c.strokeStyle = c.fillStyle = theme.force;
    c.lineWidth = bars ? 1.6 : 2;
    for (let k = first; k < last; k++) {
      let fx = force.quantum * force.values[2 * k], fy = force.quantum * force.values[2 * k + 1];
      const size = Math.hypot(fx, fy), length = this.forceLength(size);
      if (length < 1.5) continue;
      // Of the pair of forces, the one on the supported body is drawn.
      const aFree = run.bodies[pair[3 * k]]?.free, bFree = run.bodies[pair[3 * k + 1]]?.free;
      if (aFree === bFree ? fy < 0 : bFree) fx = -fx, fy = -fy;
      const [x, y] = camera.place(place.quantum * place.values[2 * k], place.quantum * place.values[2 * k + 1]);
      const dx = (fx / size) * length, dy = (-fy / size) * length;
      c.beginPath();
      if (bars) c.moveTo(x - dx / 2, y - dy / 2), c.lineTo(x + dx / 2, y + dy / 2);
      else c.moveTo(x, y), c.lineTo(x + dx, y + dy);
      c.stroke();
      if (!bars && length > 9) this.arrowHead(x + dx, y + dy, dx / length, dy / length);
    }
  }

  arrowHead(x, y, ux, uy) {
    const c = this.context;
    c.beginPath();
    c.moveTo(x + 2 * ux, y + 2 * uy);
    c.lineTo(x - 7 * ux - 3.5 * uy, y - 7 * uy + 3.5 * ux);
    c.lineTo(x - 7 * ux + 3.5 * uy, y - 7 * uy - 3.5 * ux);
    c.fill();
  }

  /** Drawing of a bearing: its ends on the canvas and its state; null while it waits for another, or is absent. */
  bearingMark(bearing) {
    const { run, camera } = this;
    const state = run.bearingState(bearing, run.now.frame, run.now.time);
    if (state === bearingStates.waiting || state === bearingStates.removed) return null;
    const [a, b] = run.bearingEnds(bearing);
    const far = Math.hypot(...a.map((v, k) => v - b[k]));
    // The mark of a changed bearing, sliding on a seat, ends when its bodies separate.
    const shown = state === bearingStates.changed && far > 1 ? bearingStates.failed : state;
    return { a: camera.place(...a), b: camera.place(...b), state: shown };
  }

  drawBearings(theme, selection) {
    const { run, context: c } = this;
    const colours = markOf(run.palette, theme.ink);
    for (const bearing of run.bearings) {
      const mark = this.bearingMark(bearing);
      if (!mark) continue;
      const chosen = selection?.bearing === bearing;
      const colour = theme.dark && mark.state === bearingStates.failed ? "#ff6a3c" : colours[mark.state];
      c.strokeStyle = colour;
      c.fillStyle = theme.paper;
      c.lineWidth = chosen ? 3 : 2;
      if (mark.state === bearingStates.failed) this.cross(mark.a, colour, theme, chosen ? 8 : 6);
      else {
        c.beginPath();
        c.moveTo(...mark.a);
        c.lineTo(...mark.b);
        c.stroke();
        c.beginPath();
        if (mark.state === bearingStates.intact) c.arc(...mark.a, chosen ? 6 : 4.5, 0, 7);
        else c.rect(mark.a[0] - 4.5, mark.a[1] - 4.5, 9, 9);
        c.fill();
        c.stroke();
      }
    }
  }

  cross([x, y], colour, theme, r) {
    const c = this.context;
    for (const [style, width] of [[theme.paper, 6], [colour, 2.6]]) {
      c.strokeStyle = style;
      c.lineWidth = width;
      c.beginPath();
      c.moveTo(x - r, y - r), c.lineTo(x + r, y + r);
      c.moveTo(x - r, y + r), c.lineTo(x + r, y - r);
      c.stroke();
    }
  }

  /** True if a point is cut away. */
  isCut() { return false; }

  drawNames(theme) {
    const { run, context: c, camera } = this;
    c.font = "12px system-ui, sans-serif";
    c.textAlign = "center";
    c.textBaseline = "middle";
    c.lineWidth = 3;
    c.strokeStyle = theme.paper;
    c.fillStyle = theme.ink;
    for (const body of this.order) {
      if (!body.free || Math.sqrt(body.area) * camera.scale < 24 || this.isCut(this.middle(body))) continue;
      const [x, y] = camera.place(...this.middle(body));
      c.strokeText(body.name, x, y);
      c.fillText(body.name, x, y);
    }
  }

  /** Mean of a body's outline points in its present position. */
  middle(body) {
    let x = 0, y = 0;
    for (let v = body.vertex; v < body.vertex + body.vertices; v++) x += this.run.pointX[v], y += this.run.pointY[v];
    return [x / body.vertices, y / body.vertices];
  }

  drawSelection(selection, theme) {
    const { run, context: c, camera } = this;
    c.strokeStyle = theme.accent;
    if (selection.body) {
      const trail = selection.trail;
      c.lineWidth = 1.5;
      c.beginPath();
      const until = run.now.frame;
      for (let f = 0; f <= until; f++) c.lineTo(...camera.place(trail.x[f], trail.y[f]));
      c.stroke();
      c.lineWidth = 3;
      this.outline(selection.body);
      c.stroke();
      return;
    }
    const mark = this.bearingMark(selection.bearing);
    if (!mark) return;
    c.lineWidth = 2.5;
    c.beginPath();
    c.arc(...mark.a, 13, 0, 7);
    c.stroke();
  }

  /** A ring around the place of a recent event; `age` from 0 (now) to 1 (over). */
  flash(place, age, colour) {
    const c = this.context;
    c.globalAlpha = 1 - age;
    c.strokeStyle = colour;
    c.lineWidth = 2.5;
    c.beginPath();
    c.arc(...this.camera.place(...place), 8 + 26 * age, 0, 7);
    c.stroke();
    c.globalAlpha = 1;
  }
}
