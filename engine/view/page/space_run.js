// A run in space: nodes rotate by quaternions, bodies have faces.
import { Run } from "./run.js";

/** Rotates [x, y, z] by the unit quaternion w, u. */
export function turned(w, ux, uy, uz, x, y, z) {
  const tx = 2 * (uy * z - uz * y), ty = 2 * (uz * x - ux * z), tz = 2 * (ux * y - uy * x);
  return [x + w * tx + uy * tz - uz * ty, y + w * ty + uz * tx - ux * tz, z + w * tz + ux * ty - uy * tx];
}

/** Applies a rotation vector to the unit quaternion [w, x, y, z]. */
export function turnedOn([w, x, y, z], [a, b, c]) {
  const angle = Math.hypot(a, b, c), half = Math.cos(angle / 2), f = angle > 0 ? Math.sin(angle / 2) / angle : 0.5;
  const [i, j, k] = [f * a, f * b, f * c];
  return [half * w - i * x - j * y - k * z, half * x + i * w + j * z - k * y, half * y + j * w + k * x - i * z,
    half * z + k * w + i * y - j * x];
}

export class SpaceRun extends Run {
  takeVertices(head) {
    const count = head.vertices.length / 4;
    this.vertexNode = new Int32Array(count);
    for (const name of ["vertexX", "vertexY", "vertexZ", "pointX", "pointY", "pointZ"]) this[name] = new Float64Array(count);
    for (let v = 0; v < count; v++)
      [this.vertexNode[v], this.vertexX[v], this.vertexY[v], this.vertexZ[v]] = head.vertices.slice(4 * v, 4 * v + 4);
    /** Faces of each body, each a list of rows of the points. */
    this.faces = head.faces.map((row) => {
      const faces = [];
      for (let at = 0; at < row.length; at += row[at] + 1) faces.push(row.slice(at + 1, at + 1 + row[at]));
      return faces;
    });
    /** Rows of the points that are centres of spheres, and the radius about each point, 0 without a sphere. */
    this.spheres = [];
    this.radius = new Float32Array(count);
    for (let s = 0; s < (head.spheres ?? []).length; s += 2) {
      this.spheres.push(head.spheres[s]);
      this.radius[head.spheres[s]] = head.spheres[s + 1];
    }
    this.nodes = this.block("rotation").columns / 4;
    this.place = new Float64Array(3 * this.nodes);
    this.quaternion = new Float64Array(4 * this.nodes);
  }

  /** Linear between frames; quaternions along the shorter arc, normalised. */
  pose(time) {
    if (!this.frames) return;
    if (this.mode) return void this.poseMode();
    const { frame, next, share } = this.locate(time);
    this.now = { time, frame, next, share };
    const position = this.block("position"), p = position.values, q = this.block("rotation").values;
    for (let i = 0; i < 3 * this.nodes; i++) {
      const a = p[3 * frame * this.nodes + i], b = p[3 * next * this.nodes + i];
      this.place[i] = position.quantum * (a + share * (b - a));
    }
    for (let n = 0; n < this.nodes; n++) {
      const a = 4 * (frame * this.nodes + n), b = 4 * (next * this.nodes + n);
      const dot = q[a] * q[b] + q[a + 1] * q[b + 1] + q[a + 2] * q[b + 2] + q[a + 3] * q[b + 3];
      let square = 0;
      for (let k = 0; k < 4; k++) {
        const v = (1 - share) * q[a + k] + (dot < 0 ? -share : share) * q[b + k];
        this.quaternion[4 * n + k] = v;
        square += v * v;
      }
      for (let k = 0; k < 4; k++) this.quaternion[4 * n + k] /= Math.sqrt(square) || 1;
    }
    this.posePoints();
  }

  /** In `this.mode`, { index, share }: each node in its initial position, moved and rotated by this share of the mode. */
  poseMode() {
    const { index, share } = this.mode;
    this.now = { ...this.locate(this.modes[index].time), time: this.modes[index].time, share: 0 };
    const row = (name) => {
      const { values, columns, quantum } = this.block(name);
      return (i) => quantum * values[index * columns + i];
    };
    const position = row("mode_position"), rotation = row("mode_rotation"), way = row("mode_displacement"), turn = row("mode_turn");
    for (let i = 0; i < 3 * this.nodes; i++) this.place[i] = position(i) + share * way(i);
    for (let n = 0; n < this.nodes; n++) {
      const stood = [0, 1, 2, 3].map((k) => rotation(4 * n + k)), size = Math.hypot(...stood) || 1;
      const by = [0, 1, 2].map((k) => share * turn(3 * n + k));
      this.quaternion.set(turnedOn(stood.map((v) => v / size), by), 4 * n);
    }
    this.posePoints();
  }

  /** The points of the bodies, from the nodes. */
  posePoints() {
    for (let v = 0; v < this.vertexNode.length; v++)
      [this.pointX[v], this.pointY[v], this.pointZ[v]] = this.placed(this.vertexNode[v], this.vertexX[v], this.vertexY[v], this.vertexZ[v]);
  }

  /** Present position of a point in the axes of a node. */
  placed(n, x, y, z) {
    const q = this.quaternion, [a, b, c] = turned(q[4 * n], q[4 * n + 1], q[4 * n + 2], q[4 * n + 3], x, y, z);
    return [this.place[3 * n] + a, this.place[3 * n + 1] + b, this.place[3 * n + 2] + c];
  }

  /** `corner`: the points that carry the joint; `share`: of each corner of its outline, coordinates along the sides to the
   *  second and third of them. */
  jointOf([event, body, corner, share, mode]) { return { event: this.events[event], body, corner, share, mode }; }

  /** Present corners of a joint's outline. */
  outlineOf({ corner, share }) {
    const [a, b, c] = corner.map((v) => this.point(v)), outline = [];
    for (let i = 0; i < share.length; i += 2) outline.push(a.map((x, k) => x + share[i] * (b[k] - x) + share[i + 1] * (c[k] - x)));
    return outline;
  }

  point(v) { return [this.pointX[v], this.pointY[v], this.pointZ[v]]; }

  /** Approximate visible area of a body: a sixth of its box's surface. */
  areaOf(body) {
    const span = (values) => {
      const own = values.subarray(body.vertex, body.vertex + body.vertices);
      return own.length ? Math.max(...own) - Math.min(...own) + 2 * this.radius[body.vertex] : 0;
    };
    const a = span(this.vertexX), b = span(this.vertexY), c = span(this.vertexZ);
    return (a * b + b * c + c * a) / 3;
  }

  /** Volume of a body from its outer faces and spheres [m3]; computed once. */
  volumeOf(body) {
    if (body.volume !== undefined) return body.volume;
    const corner = (v) => [this.vertexX[v], this.vertexY[v], this.vertexZ[v]];
    body.volume = 0;
    for (const face of this.faces[body.index])
      for (let i = 1; i + 1 < face.length; i++) {
        const [a, b, c] = [face[0], face[i], face[i + 1]].map(corner);
        body.volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
      }
    for (let v = body.vertex; v < body.vertex + body.vertices; v++) body.volume += (4 / 3) * Math.PI * this.radius[v] ** 3;
    return body.volume;
  }

  centre(body, frame) {
    const { values, quantum } = this.block("position"), at = 3 * (frame * this.nodes + body.node);
    return [quantum * values[at], quantum * values[at + 1], quantum * values[at + 2]];
  }

  /** Rotation angle of a body from the start [rad], at most pi. */
  rotation(body, frame) {
    const { values: q } = this.block("rotation"), a = 4 * body.node, b = 4 * (frame * this.nodes + body.node);
    const size = (at) => Math.hypot(q[at], q[at + 1], q[at + 2], q[at + 3]);
    // Scalar part of the relative quaternion, and the length of its vector part.
    const w = q[a] * q[b] + q[a + 1] * q[b + 1] + q[a + 2] * q[b + 2] + q[a + 3] * q[b + 3];
    const all = size(a) * size(b);
    return 2 * Math.atan2(Math.sqrt(Math.max(0, all * all - w * w)), Math.abs(w));
  }

  bearingEnds(bearing) {
    return [this.placed(bearing.an, bearing.ax, bearing.ay, bearing.az), this.placed(bearing.bn, bearing.bx, bearing.by, bearing.bz)];
  }
}
