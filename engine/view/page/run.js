// The run in the page: positions at a time, and the history of each body and bearing.
import { Members } from "./members.js";
import { useUnits } from "./words.js";

const empty = { rows: 0, columns: 1, quantum: 1, values: new Int32Array(0) };
export const isFree = (body) => body.support === "" || body.support.startsWith("free");
export const stateNames = ["intact", "yielded", "failed", "changed", "waiting", "removed"];
export const bearingStates = { intact: 0, yielded: 1, failed: 2, changed: 3, waiting: 4, removed: 5 };

function eventOf(row, index, types) {
  const [id, time, type, note, a, b, bearing, cause, x, y, text, figures, z] = row;
  const values = [];
  for (let i = 0; i + 2 < figures.length; i += 3) values.push({ name: figures[i], value: figures[i + 1], unit: figures[i + 2] });
  const [name, heading, severity] = types[type];
  return { index, id, time, type: name, heading, severity, note, a, b, bearing, cause, x, y, z, text, values };
}

/** First index whose value is above `time`. */
export function upperBound(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] > time) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Marks a missing sample (engine/view/bytes.hpp). */
const noSample = -2147483648;
const floats = (block) => Float64Array.from(block.values, (v) => (v === noSample ? NaN : v * block.quantum));

export class Run {
  constructor({ head, blocks }) {
    useUnits(head.units ?? {});
    this.about = head.run;
    this.dim = head.run.dim;
    this.bodies = head.bodies.map((body, index) => ({ ...body, index, free: isFree(body) }));
    this.bearings = head.bearings.map((bearing, index) => ({ ...bearing, index }));
    this.stages = head.stages;
    this.modes = head.modes ?? [];
    this.mode = null;
    this.origin = head.origin;
    this.palette = head.palette;
    this.types = head.types;
    this.events = head.events.map((row, index) => eventOf(row, index, head.types));
    for (const bearing of this.bearings) bearing.events = this.events.filter((e) => e.bearing === bearing.index);
    this.block = (name) => blocks[name] ?? empty;
    this.times = floats(this.block("time"));
    this.contactFrames = this.block("contact_frame").values;
    this.series = head.series.map((s) => ({
      ...s, times: this.samples(`${s.group}.time`), values: this.samples(s.block) }));
    this.elements = Array.from({ length: head.elements.length / 5 }, (_, i) => ({
      body: head.elements[5 * i], nodes: head.elements.slice(5 * i + 1, 5 * i + 5).filter((n) => n >= 0) }));
    this.members = new Members(this, head);
    this.takeVertices(head);
    this.takeJoints(head.joints);
    this.pose(this.begin);
    for (const body of this.bodies) body.area = this.areaOf(body);
  }

  /** Outline points, and buffers for their positions and the positions of the nodes. */
  takeVertices(head) {
    this.vertexNode = new Int32Array(head.vertices.length / 3);
    this.vertexX = new Float64Array(this.vertexNode.length);
    this.vertexY = new Float64Array(this.vertexNode.length);
    this.vertexNode.forEach((_, v) => {
      this.vertexNode[v] = head.vertices[3 * v];
      this.vertexX[v] = head.vertices[3 * v + 1];
      this.vertexY[v] = head.vertices[3 * v + 2];
    });
    this.nodes = this.block("rotation").columns;
    this.nodeX = new Float64Array(this.nodes);
    this.nodeY = new Float64Array(this.nodes);
    this.turn = new Float64Array(this.nodes);
    this.pointX = new Float64Array(this.vertexNode.length);
    this.pointY = new Float64Array(this.vertexNode.length);
  }

  /** A column of samples as numbers; computed once. */
  samples(name) {
    this.made ??= new Map();
    if (!this.made.has(name)) this.made.set(name, floats(this.block(name)));
    return this.made.get(name);
  }

  jointOf([event, body, edge, from, to, mode]) { return { event: this.events[event], body, edge, from, to, mode }; }

  takeJoints(rows) {
    this.joints = rows.map((row) => this.jointOf(row));
    for (const joint of this.joints) joint.broken = joint.event.type === "bond.broken";
    for (const body of this.bodies) body.lost = [];
    for (const event of this.events) if (event.type === "body.left") this.bodies[event.a].leaves = event.time;
    for (const body of this.bodies)
      body.changes = this.events.filter((e) => e.a === body.index && (e.type === "body.added" || e.type === "body.removed"));
    const seen = new Set();
    for (const event of this.events) {
      // For a joint that breaks in two halves the first one counts.
      const pair = `${Math.min(event.a, event.b)} ${Math.max(event.a, event.b)}`;
      if (event.type !== "bond.broken" || seen.has(pair)) continue;
      seen.add(pair);
      for (const index of [event.a, event.b]) this.bodies[index]?.lost.push(event.time);
    }
  }

  /** True if a body is in the model at `time`: a body that is added first was absent before. */
  isThere(body, time = this.now.time) {
    let there = body.changes[0]?.type !== "body.added";
    for (const change of body.changes) if (change.time <= time + 1e-9) there = change.type === "body.added";
    return there;
  }

  get frames() { return this.times.length; }
  get begin() { return this.frames ? this.times[0] : 0; }
  get end() { return this.frames ? this.times[this.frames - 1] : 0; }

  /** The frame at or before `time`, the next one, and the fraction between them. */
  locate(time) {
    const frame = Math.max(0, Math.min(this.frames - 1, upperBound(this.times, time) - 1));
    const next = Math.min(frame + 1, this.frames - 1);
    const span = this.times[next] - this.times[frame];
    return { frame, next, share: span > 0 ? Math.max(0, Math.min(1, (time - this.times[frame]) / span)) : 0 };
  }

  /** Moves all nodes and outline points to their positions at `time`; in a mode, to its positions. */
  pose(time) {
    if (!this.frames) return;
    if (this.mode) return void this.poseMode();
    const { frame, next, share } = this.locate(time);
    this.now = { time, frame, next, share };
    const position = this.block("position"), rotation = this.block("rotation"), n = this.nodes;
    const p = position.values, r = rotation.values, a = frame * n, b = next * n;
    for (let i = 0; i < n; i++) {
      this.nodeX[i] = position.quantum * (p[2 * (a + i)] + share * (p[2 * (b + i)] - p[2 * (a + i)]));
      this.nodeY[i] = position.quantum * (p[2 * (a + i) + 1] + share * (p[2 * (b + i) + 1] - p[2 * (a + i) + 1]));
      this.turn[i] = rotation.quantum * (r[a + i] + share * (r[b + i] - r[a + i]));
    }
    this.posePoints();
  }

  /** In `this.mode`, { index, share }: the initial positions plus this share of the mode. */
  poseMode() {
    const { index, share } = this.mode, n = this.nodes;
    this.now = { ...this.locate(this.modes[index].time), time: this.modes[index].time, share: 0 };
    const at = (name, i) => {
      const block = this.block(name);
      return block.quantum * block.values[index * block.columns + i];
    };
    for (let i = 0; i < n; i++) {
      this.nodeX[i] = at("mode_position", 2 * i) + share * at("mode_displacement", 2 * i);
      this.nodeY[i] = at("mode_position", 2 * i + 1) + share * at("mode_displacement", 2 * i + 1);
      this.turn[i] = at("mode_rotation", i) + share * at("mode_turn", i);
    }
    this.posePoints();
  }

  /** Outline points, from the nodes. */
  posePoints() {
    let node = -1, c = 1, s = 0;
    for (let v = 0; v < this.vertexNode.length; v++) {
      if (this.vertexNode[v] !== node) {
        node = this.vertexNode[v];
        c = Math.cos(this.turn[node]);
        s = Math.sin(this.turn[node]);
      }
      this.pointX[v] = this.nodeX[node] + c * this.vertexX[v] - s * this.vertexY[v];
      this.pointY[v] = this.nodeY[node] + s * this.vertexX[v] + c * this.vertexY[v];
    }
  }

  /** The area inside the outline in its present position. */
  areaOf(body) {
    let twice = 0;
    for (let i = 0; i < body.vertices; i++) {
      const a = body.vertex + i, b = body.vertex + ((i + 1) % body.vertices);
      twice += this.pointX[a] * this.pointY[b] - this.pointX[b] * this.pointY[a];
    }
    return Math.abs(twice) / 2;
  }

  /** Mean position of a body's nodes in a frame. */
  centre(body, frame) {
    const { values, quantum } = this.block("position");
    let x = 0, y = 0;
    for (let i = 0; i < body.nodes; i++) {
      x += values[2 * (frame * this.nodes + body.node + i)];
      y += values[2 * (frame * this.nodes + body.node + i) + 1];
    }
    return [x * quantum / body.nodes, y * quantum / body.nodes];
  }

  /** Speed of a body's centre between the frames around `frame` [m/s]. */
  speed(body, frame) {
    let a = frame, b = Math.min(frame + 1, this.frames - 1);
    while (a > 0 && this.times[b] - this.times[a] < 1e-4) a--;
    const span = this.times[b] - this.times[a];
    if (span <= 0) return 0;
    const from = this.centre(body, a), to = this.centre(body, b);
    return Math.hypot(...to.map((v, k) => v - from[k])) / span;
  }

  /** Rotation of a rigid body from the start [rad]; 0 for a body of many nodes. */
  rotation(body, frame) {
    const { values, quantum } = this.block("rotation");
    return quantum * (values[frame * this.nodes + body.node] - values[body.node]);
  }

  /** Mean stress of an element in a frame: [xx, yy, xy] [Pa]. */
  stress(element, frame) {
    const { values, quantum, columns } = this.block("stress"), at = frame * columns + 3 * element;
    return [quantum * values[at], quantum * values[at + 1], quantum * values[at + 2]];
  }

  /** Temperature of a node in a frame [°C]; null: none. */
  temperature(node, frame) {
    const { values, quantum, columns } = this.block("temperature"), t = quantum * values[frame * columns + node];
    return t > -273.1 ? t : null;
  }

  /** Mean temperature of nodes that have one [°C]; null: none has. */
  meanTemperature(nodes, frame) {
    const known = nodes.map((n) => this.temperature(n, frame)).filter((t) => t !== null);
    return known.length ? known.reduce((sum, t) => sum + t, 0) / known.length : null;
  }

  /** Present positions of the points a and b of a bearing. */
  bearingEnds(bearing) {
    const end = (node, x, y) => {
      const c = Math.cos(this.turn[node]), s = Math.sin(this.turn[node]);
      return [this.nodeX[node] + c * x - s * y, this.nodeY[node] + s * x + c * y];
    };
    return [end(bearing.an, bearing.ax, bearing.ay), end(bearing.bn, bearing.bx, bearing.by)];
  }

  /** State of a bearing: from the frame, or from an event between that frame and `time`. */
  bearingState(bearing, frame, time = this.times[frame]) {
    let state = this.block("bearing_state").values[frame * this.bearings.length + bearing.index] ?? 0;
    for (const e of bearing.events)
      if (e.time > this.times[frame] && e.time <= time + 1e-9) state = bearingStates[e.type.split(".")[1]] ?? state;
    return state;
  }

  /** A column of a bearing over all frames: block "bearing_force" [N] or "bearing_displacement" [m], axis 0, 1 or, in space, 2. */
  bearingColumn(bearing, name, axis) {
    const { values, quantum, columns } = this.block(name);
    return Float64Array.from({ length: this.frames }, (_, f) => quantum * values[f * columns + this.dim * bearing.index + axis]);
  }

  /** Rows [first, last) of the contact forces that are nearest to frame `frame`. */
  contactRows(frame) {
    if (!this.contactFrames.length) return [0, 0];
    let at = Math.max(0, upperBound(this.contactFrames, frame) - 1);
    const next = at + 1;
    if (next < this.contactFrames.length && this.contactFrames[next] - frame < frame - this.contactFrames[at]) at = next;
    const first = this.block("contact_first").values;
    return [first[at], first[at + 1]];
  }

  /** Share of a body's bonds that are lost at `time`. */
  damage(body, time) {
    if (!body.bonds) return null;
    return Math.min(1, upperBound(body.lost, time) / body.bonds);
  }

  /** For each body 1 if it has moved, relative to the ground, by more than its own size since the start. */
  displaced(frame) {
    if (this.displacedAt?.frame === frame) return this.displacedAt.list;
    this.sizes ??= this.bodies.map((body) => this.sizeOf(body));
    const way = (body) => this.centre(body, frame).map((v, k) => v - this.centre(body, 0)[k]);
    const held = this.bodies.filter((b) => !b.free), ground = Array(this.dim).fill(0);
    for (const body of held) way(body).forEach((v, k) => (ground[k] += v / held.length));
    const list = this.bodies.map((body, i) => (body.free && Math.hypot(...way(body).map((v, k) => v - ground[k])) > this.sizes[i] ? 1 : 0));
    this.displacedAt = { frame, list };
    return list;
  }

  /** Diagonal of the box of a body's points in its axes [m]. */
  sizeOf(body) {
    const span = (values) => {
      const own = values ? values.subarray(body.vertex, body.vertex + body.vertices) : [];
      return own.length ? Math.max(...own) - Math.min(...own) : 0;
    };
    const around = this.radius ? 2 * this.radius[body.vertex] : 0;
    return body.nodes > 1 ? Infinity : around + Math.hypot(span(this.vertexX), span(this.vertexY), span(this.vertexZ));
  }

  /** True if a crack is shown: its bodies are still in place, or all cracks are wanted. */
  showsCrack(joint, all) {
    if (!this.isThere(this.bodies[joint.body])) return false;
    if (all) return true;
    const moved = this.displaced(this.now.frame);
    return !moved[joint.event.a] && !moved[joint.event.b];
  }

  stageAt(time) {
    let found = null;
    for (const stage of this.stages) if (stage.begin <= time + 1e-6) found = stage;
    return found;
  }
}
