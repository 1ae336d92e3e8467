// The visible part of the world, in the plane.

export class Camera {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.scale = 50;  // CSS pixels per metre
    this.width = 1;
    this.height = 1;
    this.covered = 0;  // height that the tools cover at the top [CSS px]
    this.home = { x0: -1, y0: -1, x1: 1, y1: 1 };
  }

  /** Resizes the canvas; the point in its middle remains there. */
  resize(width, height) {
    const fits = this.isHome;
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    if (fits) this.fit();
  }

  /** Shows the whole of `home`, or of another box. */
  fit(box = this.home) {
    const { x0, y0, x1, y1 } = box;
    const below = 55, above = Math.max(below, this.covered);
    const left = 24, right = this.width < 500 ? 56 : left;  // on a narrow view the zoom buttons are on the right
    const room = { width: Math.max(50, this.width - left - right), height: Math.max(50, this.height - above - below) };
    this.scale = Math.min(room.width / Math.max(1e-6, x1 - x0), room.height / Math.max(1e-6, y1 - y0));
    this.x = (x0 + x1) / 2 + (right - left) / 2 / this.scale;
    this.y = (y0 + y1) / 2 + (above - below) / 2 / this.scale;
    this.isHome = box === this.home;
  }

  /** Larger side of the home view [m]. */
  get extent() { return Math.max(this.home.x1 - this.home.x0, this.home.y1 - this.home.y0); }

  /** From the world [m] to the canvas [CSS px]. */
  place(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  /** From the canvas to the world. */
  reach(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  /** Zooms by `factor`; the point at (px, py) remains in place. */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.reach(px, py);
    const home = Math.min(this.width, this.height) / Math.max(this.home.x1 - this.home.x0, this.home.y1 - this.home.y0);
    this.scale = Math.max(home / 20, Math.min(home * 5000, this.scale * factor));
    const [nx, ny] = this.reach(px, py);
    this.x += x - nx;
    this.y += y - ny;
    this.isHome = false;
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.isHome = false;
  }

  /** Handles a drag of the pointer. */
  drag(dx, dy) { this.pan(dx, dy); }

  /** Moves a point into view, if necessary. */
  show(x, y) {
    const [px, py] = this.place(x, y);
    if (px > 40 && py > 40 && px < this.width - 40 && py < this.height - 40) return;
    this.x = x;
    this.y = y;
    this.isHome = false;
  }
}

/** AABB of all free bodies in their present position. */
export function allBox(run) {
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  for (const body of run.bodies) {
    if (!run.isThere(body) || (!body.free && run.bodies.some((b) => b.free))) continue;
    for (let v = body.vertex; v < body.vertex + body.vertices; v++) {
      box.x0 = Math.min(box.x0, run.pointX[v]);
      box.x1 = Math.max(box.x1, run.pointX[v]);
      box.y0 = Math.min(box.y0, run.pointY[v]);
      box.y1 = Math.max(box.y1, run.pointY[v]);
    }
  }
  return box.x1 > box.x0 ? box : homeBox(run);
}

/** AABB of all free bodies at the start and, if near, over the run; of all bodies if none is free.
 *  Parts that fly or fall far away do not reduce the scale. */
export function homeBox(run) {
  const some = run.bodies.some((b) => b.free) ? run.bodies.filter((b) => b.free) : run.bodies;
  const nothing = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  const grow = (box, body) => {
    for (let v = body.vertex; v < body.vertex + body.vertices; v++) {
      box.x0 = Math.min(box.x0, run.pointX[v]);
      box.x1 = Math.max(box.x1, run.pointX[v]);
      box.y0 = Math.min(box.y0, run.pointY[v]);
      box.y1 = Math.max(box.y1, run.pointY[v]);
    }
  };
  const box = { ...nothing };
  for (const body of some) grow(box, body);
  if (!(box.x1 > box.x0)) return { x0: -1, y0: -1, x1: 1, y1: 1 };
  const w = 0.35 * (box.x1 - box.x0), h = 0.35 * (box.y1 - box.y0), reach = Math.max(w, h);
  const far = { x0: box.x0 - reach, x1: box.x1 + reach, y0: box.y0 - h, y1: box.y1 + h };
  const steps = Math.min(run.frames, 24);
  for (let i = 0; i < steps; i++) {
    run.pose(run.times[Math.round((i * (run.frames - 1)) / Math.max(1, steps - 1))]);
    for (const body of some) {
      const own = { ...nothing };
      grow(own, body);
      if (own.x0 > far.x0 && own.x1 < far.x1 && own.y0 > far.y0 && own.y1 < far.y1) grow(box, body);
    }
  }
  const margin = 0.03 * Math.max(box.x1 - box.x0, box.y1 - box.y0);
  return { x0: box.x0 - margin, x1: box.x1 + margin, y0: box.y0 - 2 * margin, y1: box.y1 + margin };
}
