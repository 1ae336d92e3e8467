// Small plots against time, or of one quantity against another, with the current time of the replay. A click or a drag
// seeks to that time; a button enlarges them.
import { upperBound } from "./run.js";
import { byId, clock, figures, make, readableUnit, ticks } from "./words.js";

const pad = { left: 46, right: 8, top: 6, bottom: 18 };

/** Lowest and highest value of some lists; widened if they are equal. */
function rangeOf(lists) {
  let low = Infinity, high = -Infinity;
  for (const values of lists)
    for (const v of values) {
      if (v < low) low = v;
      if (v > high) high = v;
    }
  if (!(high >= low)) return [0, 1];
  const margin = high > low ? 0.06 * (high - low) : Math.max(1e-12, Math.abs(high) * 0.1, 1e-9);
  return [low - margin, high + margin];
}

const largestOf = (values) => values.reduce((m, v) => (Math.abs(v) > m ? Math.abs(v) : m), 0);
const scaledBy = (values, factor) => Float64Array.from(values, (v) => v * factor);

/** Lowest and highest value for each pixel column, so that no peak is lost; lines as [x, y] on the canvas. A missing
 * sample (NaN) is a gap, [NaN, NaN]. */
function path(times, values, xOf, yOf) {
  const out = [];
  let column = NaN, low = 0, high = 0;
  const flush = () => {
    if (!Number.isNaN(column)) out.push([column, yOf(low)], [column, yOf(high)]);
  };
  for (let i = 0; i < times.length; i++) {
    if (Number.isNaN(values[i])) {
      flush();
      column = NaN;
      out.push([NaN, NaN]);
      continue;
    }
    const x = Math.round(2 * xOf(times[i])) / 2;
    if (x !== column) {
      flush();
      column = x;
      low = high = values[i];
    } else {
      low = Math.min(low, values[i]);
      high = Math.max(high, values[i]);
    }
  }
  flush();
  return out;
}

/** Draws points as lines, interrupted at gaps. */
function trace(c, points) {
  let down = false;
  for (const [x, y] of points) {
    const gap = Number.isNaN(x) || Number.isNaN(y);
    if (!gap) down ? c.lineTo(x, y) : c.moveTo(x, y);
    down = !gap;
  }
}

/** Enlarges a plot to the window, and restores it when that is closed. */
function enlarge(figure, changed) {
  const dialog = byId("large"), place = make("span", {});
  if (dialog.open) return dialog.close();
  figure.replaceWith(place);
  byId("large-plot").replaceChildren(figure);
  dialog.showModal();
  dialog.addEventListener("close", () => {
    place.replaceWith(figure);
    changed();
  }, { once: true });
  return changed();
}

export class Plot {
  /** `lines`: [{ name, times, values }] of one `unit`; `window`: [begin, end] of the time axis; `seek(time)`. Over another
   * quantity instead of time: `over` is { name, unit, values }, of the same samples as the first line. */
  constructor({ title, unit, lines, window: span, seek, colours, over = null }) {
    this.span = span;
    this.colours = colours;
    this.to = readableUnit(Math.max(...lines.map((l) => largestOf(l.values)), 0), unit);
    this.lines = lines.map((l) => ({ ...l, values: scaledBy(l.values, this.to.factor) }));
    this.range = rangeOf(this.lines.map((l) => l.values));
    this.takeOver(over);
    this.readings = this.lines.map(() => make("output", {}, ""));
    const across = this.over ? `${this.over.name}, ${this.over.to.unit}` : "time";
    this.canvas = make("canvas", { class: "plot", role: "img", "aria-label": `${title} over ${across}, ${this.to.unit}` });
    const keys = this.lines.map((l, i) => make("span", { class: "key" },
      make("i", { style: `background:${colours[i % colours.length]}` }), lines.length > 1 ? `${l.name.replaceAll("_", " ")} ` : "", this.readings[i]));
    const large = make("button", { class: "icon enlarge", title: "enlarge or reduce", "aria-label": `${title}: enlarge or reduce`,
      onclick: () => enlarge(this.element, () => window.trilith.redraw()) }, "⤢");
    this.element = make("figure", {}, make("figcaption", {}, make("b", {}, title), make("span", { class: "quiet" },
      this.over ? `${this.to.unit} over ${across}` : this.to.unit), ...keys, large), this.canvas);
    const go = (e) => {
      const box = this.canvas.getBoundingClientRect();
      seek(this.over ? this.nearestTime(e.clientX - box.left, e.clientY - box.top, box) : this.timeAt(e.clientX - box.left, box.width));
    };
    this.canvas.addEventListener("pointerdown", (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      go(e);
    });
    this.canvas.addEventListener("pointermove", (e) => e.buttons && go(e));
  }

  takeOver(over) {
    if (!over) return;
    const to = readableUnit(largestOf(over.values), over.unit);
    this.over = { name: over.name.replaceAll("_", " "), to, values: scaledBy(over.values, to.factor) };
    this.span = rangeOf([this.over.values]);
  }

  timeAt(x, width) {
    const share = (x - pad.left) / (width - pad.left - pad.right);
    return this.span[0] + Math.max(0, Math.min(1, share)) * (this.span[1] - this.span[0]);
  }

  /** For a loop: the time at which it is nearest to a point on the canvas. */
  nearestTime(px, py, box) {
    const { x, y } = this.scales(box.width, box.height);
    let least = Infinity, time = 0;
    for (const line of this.lines)
      this.over.values.forEach((v, i) => {
        const far = (x(v) - px) ** 2 + (y(line.values[i]) - py) ** 2;
        if (far < least) [least, time] = [far, line.times[i]];
      });
    return time;
  }

  /** Draws lines and axes after a change of size or theme, then the present time over them. */
  draw(time, theme) {
    const box = this.canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    if (!box.width) return;
    const key = `${box.width} ${box.height} ${ratio} ${theme.paper} ${clock.zero}`;
    if (key !== this.key) {
      this.key = key;
      this.canvas.width = Math.round(box.width * ratio);
      this.canvas.height = Math.round(box.height * ratio);
      this.still = new OffscreenCanvas(this.canvas.width, this.canvas.height);
      this.drawStill(this.still.getContext("2d"), box.width, box.height, ratio, theme);
    }
    const c = this.canvas.getContext("2d");
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
    c.drawImage(this.still, 0, 0);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.drawMoment(c, time, box.width, box.height, theme);
  }

  scales(width, height) {
    const [t0, t1] = this.span, [low, high] = this.range;
    const w = width - pad.left - pad.right, h = height - pad.top - pad.bottom;
    return { x: (t) => pad.left + (w * (t - t0)) / (t1 - t0 || 1), y: (v) => pad.top + h * (1 - (v - low) / (high - low)) };
  }

  drawStill(c, width, height, ratio, theme) {
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { x, y } = this.scales(width, height);
    c.font = "10.5px system-ui, sans-serif";
    c.fillStyle = theme.quiet;
    c.strokeStyle = theme.line;
    c.lineWidth = 1;
    c.textBaseline = "middle";
    c.textAlign = "right";
    const level = (v) => {
      c.beginPath();
      c.moveTo(pad.left, Math.round(y(v)) + 0.5), c.lineTo(width - pad.right, Math.round(y(v)) + 0.5);
      c.stroke();
      c.fillText(figures(v, 2), pad.left - 5, y(v));
    };
    ticks(this.range[0], this.range[1], height > 300 ? 8 : 4).forEach(level);
    c.textBaseline = "bottom";
    c.textAlign = "center";
    // Round numbers refer to the displayed times, with their origin.
    const zero = this.over ? 0 : clock.zero;
    for (const t of ticks(this.span[0] - zero, this.span[1] - zero, width > 700 ? 10 : 5))
      c.fillText(figures(t, 2), Math.min(width - 14, x(t + zero)), height - 2);
    c.save();
    c.beginPath();
    c.rect(pad.left, 0, width - pad.left - pad.right, height - pad.bottom + 2);
    c.clip();
    this.lines.forEach((line, i) => {
      c.strokeStyle = this.colours[i % this.colours.length];
      c.lineWidth = 1.3;
      c.lineJoin = "round";
      c.beginPath();
      trace(c, this.over ? Array.from(this.over.values, (v, k) => [x(v), y(line.values[k])]) : path(line.times, line.values, x, y));
      c.stroke();
    });
    c.restore();
  }

  drawMoment(c, time, width, height, theme) {
    const { x, y } = this.scales(width, height);
    const at = Math.max(pad.left, Math.min(width - pad.right, x(time)));
    if (!this.over) {
      c.strokeStyle = theme.ink;
      c.globalAlpha = 0.6;
      c.beginPath();
      c.moveTo(at, pad.top), c.lineTo(at, height - pad.bottom);
      c.stroke();
      c.globalAlpha = 1;
    }
    this.lines.forEach((line, i) => {
      const k = Math.max(0, upperBound(line.times, time + 1e-9) - 1), value = line.values[k];
      if (value === undefined) return;
      if (Number.isNaN(value)) return void (this.readings[i].textContent = "\u2013");
      c.fillStyle = this.over ? theme.ink : this.colours[i % this.colours.length];
      c.beginPath();
      c.arc(this.over ? x(this.over.values[k]) : at, y(value), this.over ? 4 : 3, 0, 7);
      c.fill();
      this.readings[i].textContent = figures(value);
    });
  }
}
