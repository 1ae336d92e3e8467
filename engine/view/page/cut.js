// A cutting plane across an axis of a model in space: the part on the eye's side is not drawn.
import { byId, make, plainQuantity, roundBelow } from "./words.js";

const axes = ["x", "y", "z"];

export class Cut {
  constructor(camera) {
    this.camera = camera;
    this.axis = -1;  // 0 to 2; -1: none
    this.place = 0;  // along the axis [m]
  }

  get isThere() { return this.axis >= 0; }

  /** 1 if the removed side is at larger coordinates, -1 if at smaller ones. */
  get side() { return this.camera.toward[this.axis] < -1e-9 ? -1 : 1; }

  /** True if a point is removed. */
  takes(point) { return this.isThere && this.side * (point[this.axis] - this.place) > 0; }

  /** Unit normal towards the eye, and offset [m]; zeros without a cut. */
  plane() {
    const plane = [0, 0, 0, 0];
    if (this.isThere) [plane[this.axis], plane[3]] = [this.side, this.side * this.place];
    return plane;
  }

  /** Corners of a square in the plane that extends to `far` from the origin [m], as a strip of two triangles. */
  corners(far) {
    const [u, v] = [(this.axis + 1) % 3, (this.axis + 2) % 3], out = [];
    for (const [s, t] of [[-1, -1], [1, -1], [-1, 1], [1, 1]]) {
      const p = [0, 0, 0];
      [p[this.axis], p[u], p[v]] = [this.place, s * far, t * far];
      out.push(...p);
    }
    return out;
  }

  /** Outlines of the sections of all present bodies, as points, two for each line, in a flat array. */
  outlines(run) {
    const lines = [];
    if (!this.isThere) return lines;
    for (const body of run.bodies) {
      if (body.leaves <= run.now.time || !run.isThere(body)) continue;
      for (const face of run.faces[body.index]) for (const p of this.crossings(face.map((v) => run.point(v)))) lines.push(...p);
    }
    return lines;
  }

  /** Intersections of the sides of a face with the plane, in pairs, sorted along their line. */
  crossings(corners) {
    const found = [];
    corners.forEach((b, i) => {
      const a = corners[(i || corners.length) - 1], from = a[this.axis] - this.place, to = b[this.axis] - this.place;
      if (from < 0 !== to < 0) found.push(a.map((v, k) => v + (from / (from - to)) * (b[k] - v)));
    });
    if (found.length > 2) found.sort((p, q) => p[0] - q[0] || p[1] - q[1] || p[2] - q[2]);
    return found;
  }
}

/** The menu of axes and the slider of the position. */
export class CutTool {
  constructor(cut, changed) {
    [this.cut, this.changed] = [cut, changed];
    this.menu = byId("cut-axis");
    this.slider = byId("cut-place");
    this.menu.append(make("option", { value: -1 }, "none"), ...axes.map((name, k) => make("option", { value: k }, name)));
    this.menu.addEventListener("change", () => this.choose(Number(this.menu.value)));
    this.slider.addEventListener("input", () => this.move(Number(this.slider.value)));
    this.choose(-1);
  }

  /** Cuts across an axis through the middle of the home view; -1: no cut. */
  choose(axis) {
    const { cut, slider } = this, { low = [-1, -1, -1], high = [1, 1, 1] } = cut.camera.home;
    cut.axis = axis;
    this.menu.value = String(axis);
    slider.hidden = byId("cut-told").hidden = axis < 0;
    if (axis < 0) return this.changed();
    const step = roundBelow((high[axis] - low[axis]) / 100), round = (x) => step * Math.round(x / step);
    [slider.min, slider.max, slider.step] = [round(low[axis]) - step, round(high[axis]) + step, step];
    return this.move(round((low[axis] + high[axis]) / 2));
  }

  next() { this.choose(this.cut.axis < 2 ? this.cut.axis + 1 : -1); }

  move(place) {
    this.cut.place = place;
    this.slider.value = String(place);
    byId("cut-told").textContent = `${axes[this.cut.axis]} = ${plainQuantity(place, "m")}`;
    this.changed();
  }
}
