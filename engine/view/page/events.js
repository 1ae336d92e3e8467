// The list of events: filtered by kind and text, drawn only where visible, synchronised with the replay.
import { upperBound } from "./run.js";
import { byId, make, seconds, unbroken } from "./words.js";

const leastHeight = 32, lineHeight = 17;  // of a row, and of a line of its text [CSS px]
const aside = 118;  // time, mark and margins, in addition to the text

/** The colour of an event's mark, by its severity; impacts have their own. */
export function eventColour(event, theme, palette) {
  if (isLoss(event)) return theme.dark ? "#ff6a3c" : palette.failed;
  if (event.severity === "failure") return theme.dark ? "#ff8f6b" : "#d9653b";
  if (event.severity === "damage") return palette.yielded;
  if (event.severity === "change") return palette.changed;
  return event.type === "impact" ? theme.accent : theme.quiet;
}

/** Something that carries is lost, or the run is not valid from here. */
export const isLoss = (event) => event.severity === "loss" || event.severity === "invalid";

export class EventsPanel {
  /** `app`: { run, seek, chooseEvent(event), theme }. */
  constructor(app) {
    this.app = app;
    this.list = byId("event-list");
    this.inner = make("div", { class: "rows" });
    this.list.append(this.inner);
    this.off = new Set();
    this.onlyNote = app.run.events.some((e) => e.note);
    this.makeFilters();
    byId("event-search").addEventListener("input", () => this.filter());
    this.list.addEventListener("scroll", () => this.fill());
    this.list.addEventListener("pointerenter", () => (this.held = true));
    this.list.addEventListener("pointerleave", () => (this.held = false));
    this.list.addEventListener("keydown", (e) => this.walk(e));
    this.filter();
  }

  makeFilters() {
    const counts = new Map();
    for (const e of this.app.run.events) counts.set(e.type, (counts.get(e.type) ?? 0) + 1);
    const chip = (label, count, pressed, press) => make("button", { class: "chip", "aria-pressed": String(pressed), onclick: (e) => {
      const on = e.currentTarget.getAttribute("aria-pressed") !== "true";
      e.currentTarget.setAttribute("aria-pressed", String(on));
      press(on);
      this.filter();
    } }, `${label} `, make("small", {}, String(count)));
    const note = this.app.run.events.filter((e) => e.note).length;
    byId("event-kinds").append(
      chip("important only", note, this.onlyNote, (on) => (this.onlyNote = on)),
      ...this.app.run.types.map(([type, heading]) => chip(heading, counts.get(type), true, (on) => (on ? this.off.delete(type) : this.off.add(type)))));
  }

  filter() {
    const words = byId("event-search").value.toLowerCase().split(" ").filter(Boolean);
    this.rows = this.app.run.events.filter((e) => (!this.onlyNote || e.note) && !this.off.has(e.type) &&
      words.every((w) => `${e.text} ${e.type} ${e.heading}`.toLowerCase().includes(w)));
    this.times = this.rows.map((e) => e.time);
    this.place();
    byId("event-count").textContent = `${this.rows.length} of ${this.app.run.events.length}`;
    this.current = -2;
    this.fill();
  }

  /** Tops of all rows, for the present width of the list: each is as tall as its wrapped text. */
  place() {
    this.width = this.list.clientWidth || 360;
    this.pen ??= document.createElement("canvas").getContext("2d");
    this.pen.font = "13px system-ui, sans-serif";
    const room = Math.max(80, this.width - aside);
    this.tops = new Float64Array(this.rows.length + 1);
    this.rows.forEach((e, i) => {
      e.wide ??= this.pen.measureText(e.text).width;
      const lines = Math.ceil((1.12 * e.wide) / room) || 1;  // words do not fill their lines
      this.tops[i + 1] = this.tops[i] + Math.max(leastHeight, lines * lineHeight + 10);
    });
    this.inner.style.height = `${this.tops[this.rows.length]}px`;
  }

  /** Creates the visible rows. */
  fill() {
    if (this.list.clientWidth && this.list.clientWidth !== this.width) this.place();
    const first = Math.max(0, upperBound(this.tops, this.list.scrollTop) - 5);
    const last = Math.min(this.rows.length, upperBound(this.tops, this.list.scrollTop + (this.list.clientHeight || 600)) + 4);
    const focused = this.inner.contains(document.activeElement) ? Number(document.activeElement.dataset.row) : -1;
    this.inner.replaceChildren(...this.rows.slice(first, last).map((e, i) => this.row(e, first + i)));
    if (focused >= 0) this.inner.querySelector(`[data-row="${focused}"]`)?.focus({ preventScroll: true });
  }

  row(event, index) {
    const colour = eventColour(event, this.app.theme, this.app.run.palette);
    return make("button", { class: "event-row", style: `top:${this.tops[index]}px;min-height:${this.tops[index + 1] - this.tops[index] - 2}px`, "data-row": index, "data-event": event.id,
      "data-type": event.type, "aria-current": index === this.current ? "true" : false, title: event.text, onclick: () => this.app.chooseEvent(event) },
    make("time", {}, seconds(event.time)), make("i", { style: `background:${colour}` }), make("span", {}, unbroken(event.text)));
  }

  walk(e) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[e.key];
    if (!step) return;
    e.preventDefault();
    e.stopPropagation();
    const to = Math.max(0, Math.min(this.rows.length - 1, (Number(document.activeElement?.dataset?.row) || 0) + step));
    this.reveal(to);
    this.inner.querySelector(`[data-row="${to}"]`)?.focus({ preventScroll: true });
  }

  reveal(index) {
    const top = this.tops[index], height = this.list.clientHeight;
    if (top < this.list.scrollTop || this.tops[index + 1] > this.list.scrollTop + height)
      this.list.scrollTop = Math.max(0, top - height / 2);
    this.fill();
  }

  /** Marks the last event before the present time, and keeps it visible unless the user scrolls elsewhere. */
  draw(time) {
    const current = upperBound(this.times, time + 1e-6) - 1;
    if (current === this.current) return;
    this.current = current;
    if (!this.held && current >= 0 && this.list.clientHeight) this.reveal(current);
    else this.fill();
  }
}
