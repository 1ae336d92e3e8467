// Orbit camera for a model in space. Orthographic: lengths across the line of sight have one scale.
import { Camera } from "./camera.js";

export const viewsAround = [[-60, 20], [-90, 0], [0, 0], [-90, 90], [-45, 35.264]];  // azimuth, elevation

export class SpaceCamera extends Camera {
  constructor() {
    super();
    this.z = 0;
    this.look(...viewsAround[0]);
  }

  /** View direction: azimuth from the x axis, anticlockwise from above, and elevation, in degrees. */
  look(azimuth, elevation) {
    this.azimuth = azimuth;
    this.elevation = Math.max(-90, Math.min(90, elevation));
    const a = (this.azimuth * Math.PI) / 180, e = (this.elevation * Math.PI) / 180;
    const ca = Math.cos(a), sa = Math.sin(a), ce = Math.cos(e), se = Math.sin(e);
    this.right = [-sa, ca, 0];
    this.up = [-se * ca, -se * sa, ce];
    this.toward = [ce * ca, ce * sa, se];
  }

  /** Shows all of `home`, or of another box, in this direction. */
  fit(box = this.home) {
    const { low = [-1, -1, -1], high = [1, 1, 1] } = box;
    [this.x, this.y, this.z] = low.map((v, k) => (v + high[k]) / 2);
    let across = 0, upright = 0;
    for (let corner = 0; corner < 8; corner++) {
      const p = [0, 1, 2].map((k) => ((corner >> k) & 1 ? high[k] : low[k]));
      across = Math.max(across, Math.abs(this.along(this.right, ...p)));
      upright = Math.max(upright, Math.abs(this.along(this.up, ...p)));
    }
    const below = 75, above = Math.max(below, this.covered);
    const wide = Math.max(50, this.width - 96), tall = Math.max(50, this.height - above - below);
    this.scale = Math.min(wide / Math.max(1e-6, 2 * across), tall / Math.max(1e-6, 2 * upright));
    this.move(0, (above - below) / 2 / this.scale);
    this.isHome = box === this.home;
  }

  /** Half of the diagonal of the home box [m]. */
  get radius() {
    const { low, high } = this.home;
    return low ? 0.5 * Math.hypot(...high.map((v, k) => v - low[k])) : 1;
  }

  get extent() { return 1.4 * this.radius; }

  along(axis, x, y, z) { return axis[0] * (x - this.x) + axis[1] * (y - this.y) + axis[2] * (z - this.z); }
  place(x, y, z) {
    return [this.width / 2 + this.scale * this.along(this.right, x, y, z), this.height / 2 - this.scale * this.along(this.up, x, y, z)];
  }
  /** Coordinate towards the eye [m]. */
  depth(x, y, z) { return this.along(this.toward, x, y, z); }

  /** The point at a point on the canvas, `depth` [m] towards the eye. */
  pointAt(px, py, depth) {
    const right = (px - this.width / 2) / this.scale, up = (this.height / 2 - py) / this.scale;
    return [this.x, this.y, this.z].map((v, k) => v + right * this.right[k] + up * this.up[k] + depth * this.toward[k]);
  }

  move(right, up) {
    this.x += right * this.right[0] + up * this.up[0];
    this.y += right * this.right[1] + up * this.up[1];
    this.z += right * this.right[2] + up * this.up[2];
    this.isHome = false;
  }

  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const before = this.scale, home = Math.min(this.width, this.height) / (2 * this.radius);
    this.scale = Math.max(home / 20, Math.min(home * 5000, before * factor));
    const gained = 1 / before - 1 / this.scale;
    this.move((px - this.width / 2) * gained, (this.height / 2 - py) * gained);
  }

  pan(dx, dy) { this.move(-dx / this.scale, dy / this.scale); }

  /** A drag rotates the model; with shift or another button than the first it moves it. */
  drag(dx, dy, e) {
    if (e.shiftKey || e.buttons > 1) this.pan(dx, dy);
    else this.look(this.azimuth - 0.4 * dx, this.elevation + 0.4 * dy);
  }

  show(x, y, z) {
    const [px, py] = this.place(x, y, z);
    if (px > 40 && py > 40 && px < this.width - 40 && py < this.height - 40) return;
    [this.x, this.y, this.z] = [x, y, z];
    this.isHome = false;
  }
}

/** AABB of all free bodies at the start and, if near, over the run, and of most of them wherever they
 *  go. */
export function homeSpace(run) {
  const some = run.bodies.some((b) => b.free) ? run.bodies.filter((b) => b.free) : run.bodies;
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const centreOf = (body) => [0, 1, 2].map((k) => run.place[3 * body.node + k]);
  const grow = (p) => p.forEach((v, k) => ([low[k], high[k]] = [Math.min(low[k], v), Math.max(high[k], v)]));
  run.pose(run.begin);
  for (const body of some) for (let v = body.vertex; v < body.vertex + body.vertices; v++) {
    const p = run.point(v), r = run.radius[v];
    grow(p.map((x) => x - r));
    grow(p.map((x) => x + r));
  }
  const reach = 0.35 * Math.hypot(...high.map((v, k) => v - low[k]));
  if (!(reach > 0)) return { low: [-1, -1, -1], high: [1, 1, 1] };
  const far = [low.map((v) => v - reach), high.map((v) => v + reach)];
  const steps = Math.min(run.frames, 24);
  for (let i = 0; i < steps; i++) {
    run.pose(run.times[Math.round((i * (run.frames - 1)) / Math.max(1, steps - 1))]);
    const centres = some.map(centreOf);
    for (const p of centres) if (p.every((v, k) => v > far[0][k] && v < far[1][k])) grow(p);
    // Debris does not count, but a model that moves as a whole is followed.
    const away = centres.filter((p) => !p.every((v, k) => v > far[0][k] && v < far[1][k])).length;
    if (2 * away <= centres.length) continue;
    const along = [0, 1, 2].map((k) => centres.map((p) => p[k]).sort((a, b) => a - b));
    for (const share of [0.1, 0.9]) grow(along.map((values) => values[Math.round(share * (values.length - 1))]));
  }
  return { low, high };
}

/** AABB of all free bodies in their present position. */
export function allSpace(run) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const body of run.bodies) {
    if (!run.isThere(body) || (!body.free && run.bodies.some((b) => b.free))) continue;
    for (let v = body.vertex; v < body.vertex + body.vertices; v++)
      run.point(v).forEach((x, k) => ([low[k], high[k]] = [Math.min(low[k], x - run.radius[v]), Math.max(high[k], x + run.radius[v])]));
  }
  return high[0] > low[0] ? { low, high } : homeSpace(run);
}
