// Members of frames: their shapes with clean corners, marks of hinges, and diagrams of section forces.
import { quantity } from "./words.js";

const plane = [
  { id: "moment", label: "bending moment", unit: "N m", at: [2, 3], side: -1 },
  { id: "shear", label: "shear force", unit: "N", at: [1, 1], side: 1 },
  { id: "normal", label: "normal force", unit: "N", at: [0, 0], side: 1 }];
const space = [
  { id: "moment_z", label: "bending moment about z", unit: "N m", at: [5, 7], side: -1 },
  { id: "moment_y", label: "bending moment about y", unit: "N m", at: [4, 6], side: 1, across: true },
  { id: "shear_y", label: "shear force along y", unit: "N", at: [1, 1], side: 1 },
  { id: "shear_z", label: "shear force along z", unit: "N", at: [2, 2], side: 1, across: true },
  { id: "torque", label: "torque", unit: "N m", at: [3, 3], side: 1 },
  { id: "normal", label: "normal force", unit: "N", at: [0, 0], side: 1 }];

export const hingeNames = ["hinge elastic", "hinge yielded", "hinge without moment", "member removed"];
export const hingeColours = (theme, palette) => [theme.paper, palette.yielded, theme.dark ? "#ff6a3c" : palette.failed, theme.dark ? "#ff6a3c" : palette.failed];
/** Colours of diagrams: values above 0, and below. */
export const signColours = (theme) => [theme.force, theme.dark ? "#f0a070" : "#b4541b"];

const minus = (a, b) => a.map((v, k) => v - b[k]);
const dot = (a, b) => a.reduce((s, v, k) => s + v * b[k], 0);
const cross2 = (a, b) => a[0] * b[1] - a[1] * b[0];
const unit = (a) => {
  const size = Math.hypot(...a) || 1;
  return a.map((v) => v / size);
};

/** The outer corner between two members at a joint: where their outer edges meet, but at most three depths away. */
function corner(joint, a, b) {
  const turn = cross2(a.along, b.along), depth = Math.max(Math.hypot(...minus(a.left, joint)), Math.hypot(...minus(b.right, joint)));
  const out = [joint, a.left];
  if (Math.abs(turn) > 1e-3) {
    const s = cross2(minus(b.right, a.left), b.along) / turn, tip = [a.left[0] + s * a.along[0], a.left[1] + s * a.along[1]];
    if (Math.hypot(...minus(tip, joint)) < 3 * depth) out.push(tip);
  }
  return [...out, b.right];
}

export class Members {
  constructor(run, head) {
    this.run = run;
    this.list = head.members ?? [];
    const width = 2 + 3 * run.dim, rows = head.beams ?? [];
    this.beams = Array.from({ length: rows.length / width }, (_, i) => {
      const row = rows.slice(width * i, width * (i + 1)), part = (k) => row.slice(2 + k * run.dim, 2 + (k + 1) * run.dim);
      return { nodes: row.slice(0, 2), arms: [part(0), part(1)], up: part(2) };
    });
    this.quantities = run.block("member_force").rows ? (run.dim === 2 ? plane : space) : [];
    this.shown = null;  // { quantity, envelope }
    this.kept = new Map();
    this.byBody = new Map();
    for (const member of this.list) this.byBody.set(member.body, [...(this.byBody.get(member.body) ?? []), member]);
  }

  /** Present position of a point in the axes of a node. */
  at(node, point) {
    const { run } = this;
    if (run.dim === 3) return run.placed(node, ...point);
    const c = Math.cos(run.turn[node]), s = Math.sin(run.turn[node]);
    return [run.nodeX[node] + c * point[0] - s * point[1], run.nodeY[node] + s * point[0] + c * point[1]];
  }
  end(beam, side) { return this.at(beam.nodes[side], beam.arms[side]); }
  along(beam) { return unit(minus(this.end(beam, 1), this.end(beam, 0))); }

  /** Unit vector to the top of a section, or across it. */
  aside(beam, across) {
    const along = this.along(beam);
    if (this.run.dim === 2) return [-along[1], along[0]];
    const raw = minus(this.at(beam.nodes[0], beam.up), this.at(beam.nodes[0], [0, 0, 0])), part = dot(raw, along);
    const up = unit(raw.map((v, k) => v - part * along[k]));
    if (!across) return up;
    return [along[1] * up[2] - along[2] * up[1], along[2] * up[0] - along[0] * up[2], along[0] * up[1] - along[1] * up[0]];
  }

  beamsOf(member) { return this.beams.slice(member.first, member.first + member.count); }

  /** Axis of a member with its edges, in the plane. */
  strip(member) {
    const beams = this.beamsOf(member), normals = beams.map((b) => this.aside(b));
    const axis = [this.end(beams[0], 0), ...beams.map((b) => this.end(b, 1))], left = [], right = [];
    axis.forEach((p, i) => {
      const a = normals[Math.max(0, i - 1)], b = normals[Math.min(i, normals.length - 1)], n = unit([a[0] + b[0], a[1] + b[1]]);
      left.push([p[0] + member.above * n[0], p[1] + member.above * n[1]]);
      right.push([p[0] - member.below * n[0], p[1] - member.below * n[1]]);
    });
    return { axis, left, right };
  }

  /** Polygons of the members of a body in the plane, and of the corners where they meet; empty for other bodies. */
  parts(body) {
    const parts = [], joints = new Map();
    for (const member of this.byBody.get(body.index) ?? []) {
      if (!(member.above > 0 && member.below > 0)) continue;
      const s = this.strip(member), last = s.axis.length - 1, beams = this.beamsOf(member);
      parts.push([...s.right, ...s.left.slice().reverse()]);
      const add = (name, node, along, left, right) => {
        if (!joints.has(name)) joints.set(name, { place: this.at(node, [0, 0]), ends: [] });
        joints.get(name).ends.push({ along, left, right, angle: Math.atan2(along[1], along[0]) });
      };
      add(member.from, beams[0].nodes[0], unit(minus(s.axis[1], s.axis[0])), s.left[0], s.right[0]);
      add(member.to, beams[beams.length - 1].nodes[1], unit(minus(s.axis[last - 1], s.axis[last])), s.right[last], s.left[last]);
    }
    for (const { place, ends } of joints.values()) {
      if (ends.length < 2) continue;
      ends.sort((a, b) => a.angle - b.angle);
      ends.forEach((a, i) => {
        const b = ends[(i + 1) % ends.length], gap = b.angle - a.angle + (i + 1 === ends.length ? 2 * Math.PI : 0);
        if (gap > Math.PI + 0.01) parts.push(corner(place, a, b));
      });
    }
    return parts;
  }

  value(frame, beam, column) {
    const { values, quantum, columns } = this.run.block("member_force");
    return quantum * values[frame * columns + (this.run.dim === 2 ? 4 : 8) * beam + column];
  }

  /** Extreme values of a quantity at both ends of each beam over all frames, and the largest magnitude. */
  extremes(q) {
    if (this.kept.has(q.id)) return this.kept.get(q.id);
    const low = new Float64Array(2 * this.beams.length), high = new Float64Array(low.length);
    let largest = 0;
    for (let f = 0; f < this.run.frames; f++)
      for (let i = 0; i < low.length; i++) {
        const v = this.value(f, i >> 1, q.at[i & 1]);
        low[i] = Math.min(low[i], v);
        high[i] = Math.max(high[i], v);
        largest = Math.max(largest, Math.abs(v));
      }
    const found = { low, high, largest };
    this.kept.set(q.id, found);
    return found;
  }

  /** Draws the chosen diagram over `scene`. */
  drawDiagram(scene, theme) {
    if (!this.shown || !this.list.length) return;
    const { quantity: q, envelope } = this.shown, found = this.extremes(q), { run } = this;
    if (!(found.largest > 0)) return;
    const scale = (0.11 * scene.camera.extentShown) / found.largest, labels = [];
    for (const member of this.list) {
      if (!run.isThere(run.bodies[member.body])) continue;
      const lines = envelope ? [found.high, found.low].map((values) => (i, e) => values[2 * i + e]) : [(i, e) => this.value(run.now.frame, i, q.at[e])];
      for (const line of lines) this.drawMember(scene, theme, member, q, scale, line, labels);
    }
    this.drawLabels(scene, theme, labels, q, found.largest);
  }

  drawMember(scene, theme, member, q, scale, valueOf, labels) {
    const c = scene.context, [above, below] = signColours(theme);
    let most = null;
    this.beamsOf(member).forEach((beam, k) => {
      const side = this.aside(beam, q.across), i = member.first + k;
      const ends = [0, 1].map((e) => {
        const p = this.end(beam, e), value = valueOf(i, e);
        const tip = p.map((v, d) => v + scale * q.side * value * side[d]);
        return { value, p: scene.camera.place(...p), tip: scene.camera.place(...tip) };
      });
      for (const end of ends) if (!most || Math.abs(end.value) > Math.abs(most.value)) most = end;
      const strip = (a, b) => {
        c.fillStyle = c.strokeStyle = a.value + b.value >= 0 ? above : below;
        c.globalAlpha = 0.28;
        c.beginPath();
        for (const p of [a.p, a.tip, b.tip, b.p]) c.lineTo(...p);
        c.fill();
        c.globalAlpha = 1;
        c.lineWidth = 1.4;
        c.beginPath();
        c.moveTo(...a.tip);
        c.lineTo(...b.tip);
        c.stroke();
      };
      const [a, b] = ends;
      if (a.value * b.value >= 0) return strip(a, b);
      const s = a.value / (a.value - b.value), zero = { value: 0, p: a.p.map((v, d) => v + s * (b.p[d] - v)) };
      zero.tip = zero.p;
      strip(a, zero);
      return strip(zero, b);
    });
    if (most) labels.push(most);
  }

  /** The largest value of each member, the largest first; texts do not overlap. */
  drawLabels(scene, theme, labels, q, largest) {
    const c = scene.context, taken = [];
    c.font = "12px system-ui, sans-serif";
    c.textAlign = "center";
    c.textBaseline = "middle";
    c.lineWidth = 3;
    c.strokeStyle = theme.paper;
    c.fillStyle = theme.ink;
    labels.sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
    for (const { value, p, tip } of labels.slice(0, 40)) {
      if (Math.abs(value) < 0.03 * largest) continue;
      const way = unit(minus(tip, p)), text = quantity(value, q.unit), wide = c.measureText(text).width / 2 + 3;
      const reach = Math.min(wide / Math.max(1e-9, Math.abs(way[0])), 9 / Math.max(1e-9, Math.abs(way[1]))) + 2;
      const [x, y] = tip.map((v, k) => v + reach * way[k]);
      if (taken.some((o) => Math.abs(o.x - x) < o.wide + wide && Math.abs(o.y - y) < 16)) continue;
      taken.push({ x, y, wide });
      c.strokeText(text, x, y);
      c.fillText(text, x, y);
    }
  }

  /** Marks of hinges at the ends of members, and of beams of fibres that have yielded. */
  drawHinges(scene, theme) {
    const { run } = this, block = run.block("member_state");
    if (!block.rows) return;
    const state = (beam, end) => block.values[run.now.frame * block.columns + 2 * beam + end];
    for (const member of this.list) {
      if (member.yields === "elastic" || !run.isThere(run.bodies[member.body])) continue;
      const last = member.first + member.count - 1;
      if (member.yields === "hinges")
        [0, 1].forEach((e) => member.hinges[e] && this.mark(scene, theme, this.beams[e ? last : member.first], e, state(e ? last : member.first, e)));
      else
        for (let i = member.first; i <= last; i++) if (state(i, 0)) this.dotAt(scene, theme, this.beams[i]);
    }
  }

  mark(scene, theme, beam, end, state) {
    const c = scene.context, p = scene.camera.place(...this.end(beam, end)), q = scene.camera.place(...this.end(beam, 1 - end));
    const way = unit(minus(q, p)), [x, y] = p.map((v, k) => v + 8 * way[k]);
    if (state === 3) return scene.cross([x, y], hingeColours(theme, this.run.palette)[3], theme, 5);
    c.lineWidth = 1.5;
    c.fillStyle = hingeColours(theme, this.run.palette)[state];
    c.strokeStyle = theme.ink;
    c.beginPath();
    c.arc(x, y, 4.5, 0, 7);
    c.fill();
    return c.stroke();
  }

  dotAt(scene, theme, beam) {
    const c = scene.context, a = scene.camera.place(...this.end(beam, 0)), b = scene.camera.place(...this.end(beam, 1));
    c.lineWidth = 1;
    c.fillStyle = this.run.palette.yielded;
    c.strokeStyle = theme.ink;
    c.beginPath();
    c.arc((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 3, 0, 7);
    c.fill();
    c.stroke();
  }
}
