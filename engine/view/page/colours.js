// Quantities for colouring bodies, and the colours of the theme.
import { upperBound } from "./run.js";
import { readableUnit, figures } from "./words.js";

const channels = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
/** Linear interpolation from one #rrggbb to another. */
export function blend(from, to, share) {
  const a = channels(from), b = channels(to);
  return "#" + a.map((v, i) => Math.round(v + share * (b[i] - v)).toString(16).padStart(2, "0")).join("");
}

/** Present colours of the style sheet, by theme. */
export function themeColours() {
  const style = getComputedStyle(document.documentElement);
  const names = ["paper", "ink", "quiet", "line", "accent", "ground", "ground-line", "outline", "ghost", "force"];
  const out = Object.fromEntries(names.map((n) => [n, style.getPropertyValue(`--${n}`).trim()]));
  out.dark = document.documentElement.dataset.theme === "dark";
  return out;
}

const few = 3;
/** The word that determines a body's colour: its first group or material; few grounds use their names. */
function groupsOf(run) {
  const named = run.bodies.filter((b) => !b.free).length <= few;
  return run.bodies.map((b) => (!b.free && named ? b.name : b.groups.split(" ")[0] || b.material));
}

/** Mean compression in each body from its contact forces [N/m], per metre of thickness: the lower principal value of
 *  the sum of arm times force over the area (Love 1892, Weber 1966). */
function compressions(run, frame) {
  const sum = new Float64Array(4 * run.bodies.length);
  const [first, last] = run.contactRows(frame);
  const place = run.block("contact_place"), force = run.block("contact_force"), pair = run.block("contact_pair").values;
  const at = run.block("position"), here = run.contactFrames.length ? frame : 0;
  for (let k = first; k < last; k++) {
    const fx = force.quantum * force.values[2 * k], fy = force.quantum * force.values[2 * k + 1];
    for (const side of [0, 1]) {
      const index = pair[3 * k + side], body = run.bodies[index];
      if (!body) continue;
      const node = 2 * (here * run.nodes + body.node), sign = side ? -1 : 1;
      const x = place.quantum * place.values[2 * k] - at.quantum * at.values[node];
      const y = place.quantum * place.values[2 * k + 1] - at.quantum * at.values[node + 1];
      sum[4 * index] += sign * x * fx;
      sum[4 * index + 1] += sign * y * fy;
      sum[4 * index + 2] += (sign * (x * fy + y * fx)) / 2;
    }
  }
  return run.bodies.map((body, i) => {
    if (!body.free || !body.area || body.nodes > 1) return null;
    const xx = sum[4 * i] / body.area, yy = sum[4 * i + 1] / body.area, xy = sum[4 * i + 2] / body.area;
    return Math.max(0, Math.hypot((xx - yy) / 2, xy) - (xx + yy) / 2);
  });
}

/** Smallest principal value of a symmetric tensor [xx, yy, zz, xy, yz, zx] (O. K. Smith, Comm. ACM 4(4), 1961). */
function least([xx, yy, zz, xy, yz, zx]) {
  const mean = (xx + yy + zz) / 3, a = xx - mean, b = yy - mean, c = zz - mean;
  const p = Math.sqrt((a * a + b * b + c * c + 2 * (xy * xy + yz * yz + zx * zx)) / 6);
  if (!(p > 0)) return mean;
  const half = (a * (b * c - yz * yz) - xy * (xy * c - yz * zx) + zx * (xy * yz - b * zx)) / (2 * p * p * p);
  return mean + 2 * p * Math.cos(Math.acos(Math.max(-1, Math.min(1, half))) / 3 + (2 * Math.PI) / 3);
}

/** Mean compression of rigid bodies in space from their contact forces [Pa]; see compressions(). */
function spaceCompressions(run, frame) {
  const sum = new Float64Array(6 * run.bodies.length), [first, last] = run.contactRows(frame);
  const place = run.block("contact_place"), force = run.block("contact_force"), pair = run.block("contact_pair").values;
  for (let k = first; k < last; k++) {
    const row = (block) => [0, 1, 2].map((i) => block.quantum * block.values[3 * k + i]), at = row(place), f = row(force);
    for (const side of [0, 1]) {
      const index = pair[3 * k + side], body = run.bodies[index];
      if (!body) continue;
      const centre = run.centre(body, frame), sign = side ? -1 : 1, [x, y, z] = at.map((v, i) => sign * (v - centre[i]));
      [x * f[0], y * f[1], z * f[2], (x * f[1] + y * f[0]) / 2, (y * f[2] + z * f[1]) / 2, (z * f[0] + x * f[2]) / 2]
        .forEach((v, i) => (sum[6 * index + i] += v));
    }
  }
  return run.bodies.map((body, i) => {
    const volume = body.free && body.nodes === 1 ? run.volumeOf(body) : 0;
    return volume > 0 ? Math.max(0, -least(Array.from(sum.subarray(6 * i, 6 * i + 6), (v) => v / volume))) : null;
  });
}

/** Largest and smallest principal value of [xx, yy, xy]. */
function principal([xx, yy, xy]) {
  const mean = (xx + yy) / 2, radius = Math.hypot((xx - yy) / 2, xy);
  return [mean + radius, mean - radius];
}

/** Options to colour finite elements by their mean stress; `cells(frame)`: one number for each element. */
function elementColourings(run) {
  if (!run.block("stress").rows) return [];
  const each = (f) => (frame) => run.elements.map((_, i) => f(i, frame));
  const plastic = run.block("plastic");
  const out = [
    { id: "stress", label: "compression in elements (principal)", unit: "Pa", cells: each((i, f) => Math.max(0, -principal(run.stress(i, f))[1])) },
    { id: "tension", label: "tension in elements (principal)", unit: "Pa", cells: each((i, f) => Math.max(0, principal(run.stress(i, f))[0])) },
    { id: "shear", label: "largest shear stress in elements", unit: "Pa", cells: each((i, f) => {
      const [high, low] = principal(run.stress(i, f));
      return (high - low) / 2;
    }) }];
  if (plastic.values.some((v) => v !== 0))
    out.push({ id: "plastic", label: "plastic strain in elements", unit: "1", cells: each((i, f) => plastic.quantum * plastic.values[f * plastic.columns + i]) });
  return out;
}

/** The option to colour bodies and finite elements by their temperature, with fixed bodies. */
function temperatureColourings(run) {
  if (!run.block("temperature").rows) return [];
  const own = run.bodies.map((b) => Array.from({ length: b.nodes }, (_, i) => b.node + i));
  const values = (frame) => own.map((nodes) => run.meanTemperature(nodes, frame));
  const cells = run.elements?.length ? (frame) => run.elements.map((e) => run.meanTemperature(e.nodes, frame)) : undefined;
  let low = Infinity, high = -Infinity;
  const step = Math.max(1, Math.floor(run.frames / 100));
  for (let frame = (run.frames - 1) % step; frame < run.frames; frame += step)
    for (let node = 0; node < run.nodes; node++) {
      const t = run.temperature(node, frame);
      if (t !== null) [low, high] = [Math.min(low, t), Math.max(high, t)];
    }
  if (!(high > low)) [low, high] = [low - 1, low + 1];
  return [{ id: "temperature", label: "temperature", unit: "°C", bottom: low, top: high, all: true, values, cells }];
}

/** All colour options for which this run has data. `values(frame, time)`: one number or null for each body. */
export function colourings(run) {
  const free = (f) => (frame, time) => run.bodies.map((b) => (b.free ? f(b, frame, time) : null));
  const start = run.frames ? run.bodies.map((b) => run.centre(b, 0)) : [];
  const out = [{ id: "group", label: "group", groups: groupsOf(run) }];
  if (!run.frames) return out;
  out.push({ id: "speed", label: "speed", unit: "m/s", values: free((b, f) => run.speed(b, f)) });
  out.push({ id: "displacement", label: "displacement from the start", unit: "m", values: free((b, f) => {
    return Math.hypot(...run.centre(b, f).map((v, k) => v - start[b.index][k]));
  }) });
  const rigid = run.bodies.some((b) => b.free && b.nodes === 1);
  if (rigid)
    out.push({ id: "rotation", label: "rotation from the start", unit: "rad", signed: run.dim === 2, values: free((b, f) => (b.nodes === 1 ? run.rotation(b, f) : null)) });
  out.push(...elementColourings(run));
  if (rigid && run.dim === 2 && run.block("contact_pair").rows)
    out.push({ id: run.block("stress").rows ? "compression" : "stress", label: "mean compression, from contact forces", unit: "N/m", values: (f) => compressions(run, f) });
  if (rigid && run.dim === 3 && run.block("contact_pair").rows)
    out.push({ id: "stress", label: "mean compression, from contact forces", unit: "Pa", values: (f) => spaceCompressions(run, f) });
  if (run.bodies.some((b) => b.bonds))
    out.push({ id: "damage", label: "damage: share of bonds lost", unit: "1", top: 1, values: free((b, f, t) => run.damage(b, t)) });
  out.push(...temperatureColourings(run));
  for (const c of out) if ((c.values || c.cells) && !c.top) c.top = usualTop(run, c);
  return out;
}

/** 98 % quantile of the values over the run, rounded up, so that one fast fragment does not use up the colours. */
function usualTop(run, colouring) {
  const sizes = [];
  for (let i = 0; i < Math.min(20, run.frames); i++) {
    const frame = Math.round((i * (run.frames - 1)) / Math.max(1, Math.min(20, run.frames) - 1));
    for (const v of (colouring.cells ?? colouring.values)(frame, run.times[frame])) if (v !== null) sizes.push(Math.abs(v));
  }
  sizes.sort((a, b) => a - b);
  const top = sizes[Math.floor(0.98 * (sizes.length - 1))] || sizes[sizes.length - 1] || 1;
  const power = 10 ** Math.floor(Math.log10(top));
  return [1, 2, 5, 10].find((k) => k * power >= top) * power;
}

export class BodyColours {
  constructor(run, colouring, theme) {
    this.run = run;
    this.colouring = colouring;
    this.theme = theme;
    if (colouring.groups) this.takeGroups();
    else this.ramp = colouring.signed ? run.palette.diverging : theme.dark ? [...run.palette.sequential].reverse() : run.palette.sequential;
  }

  takeGroups() {
    const { run, colouring, theme } = this;
    const tint = new Map();
    run.bodies.forEach((b, i) => {
      const name = colouring.groups[i];
      if (b.free && !tint.has(name)) {
        const colour = run.palette.tints[tint.size % run.palette.tints.length];
        tint.set(name, theme.dark ? blend(colour, "#1a2027", 0.22) : colour);
      }
    });
    this.groups = tint;
    this.fixed = run.bodies.map((b, i) => (b.free ? tint.get(colouring.groups[i]) : theme.ground));
  }

  /** A colour for each body in `frame` at `time`. */
  at(frame, time) {
    if (this.fixed) return this.fixed;
    const values = this.colouring.values?.(frame, time);
    return this.run.bodies.map((body, i) => {
      const value = values?.[i] ?? null;
      if (!body.free && !(this.colouring.all && value !== null)) return this.theme.ground;
      return value === null ? this.theme.line : this.colourOf(value);
    });
  }

  /** A colour for each element in `frame`, or null if elements have no own colours. */
  cellsAt(frame) {
    return this.colouring.cells?.(frame).map((value) => (value === null ? this.theme.line : this.colourOf(value))) ?? null;
  }

  colourOf(value) {
    const { top, bottom = 0, signed } = this.colouring;
    const share = signed ? 0.5 + 0.5 * (value / top) : (value - bottom) / (top - bottom);
    return this.ramp[Math.round((this.ramp.length - 1) * Math.max(0, Math.min(1, share)))];
  }

  /** Ends of the colour bar as text. */
  ends() {
    const { top, bottom, signed, unit } = this.colouring;
    const to = readableUnit(top, unit);
    const high = `${figures(top * to.factor, 2)} ${to.unit}`;
    if (bottom !== undefined) return [`${figures(bottom * to.factor)} ${to.unit}`, `${figures(top * to.factor)} ${to.unit}`];
    return signed ? [`−${high}`, high] : ["0", high];
  }
}

/** Last of `events` (sorted by time) at or before `time`, or -1. */
export function lastBefore(events, time) {
  return upperBound(events.map((e) => e.time), time + 1e-9) - 1;
}
