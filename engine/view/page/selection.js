// The selected body or bearing: its name, description, present state, histories and events.
import { stateNames } from "./run.js";
import { Plot } from "./plots.js";
import { byId, make, plainQuantity, quantity, seconds } from "./words.js";

const facts = (rows) => make("dl", { class: "facts" }, ...rows.flatMap(([k, v]) => (v || v === 0 ? [make("dt", {}, k), make("dd", {}, v)] : [])));

export class SelectionPanel {
  /** `app`: { run, seek(time), select(choice) }. */
  constructor(app) {
    this.app = app;
    this.plots = [];
    this.panel = byId("selection");
    this.show(null);
  }

  show(choice) {
    this.choice = choice;
    this.plots = [];
    this.now = null;
    if (!choice) return this.panel.replaceChildren(make("p", { class: "hint" }, "Click a body or a bearing to see its history and its events."));
    return choice.body ? this.showBody(choice) : this.showBearing(choice.bearing);
  }

  head(kind, name) {
    const close = make("button", { class: "icon", "aria-label": "clear the selection", title: "clear (Esc)", onclick: () => this.app.select(null) }, "✕");
    return make("header", {}, make("div", {}, make("span", { class: "quiet" }, kind), make("h2", { id: "selection-name" }, name)), close);
  }

  plot(title, unit, lines, over = null) {
    const { run, seek } = this.app;
    const plot = new Plot({ title, unit, lines, over, window: [run.begin, run.end], seek, colours: this.app.lineColours });
    this.plots.push(plot);
    return plot.element;
  }

  showBody(choice) {
    const { run } = this.app, body = choice.body, times = run.times;
    const column = (f) => Float64Array.from({ length: run.frames }, (_, i) => f(i));
    const axes = Object.entries(choice.trail);  // x, y and, in space, z over the frames
    this.now = make("p", { class: "now" });
    const chips = run.bearings.filter((b) => b.a === body.index || b.b === body.index)
      .map((b) => make("button", { class: "chip", onclick: () => this.app.select({ bearing: b }) }, b.name));
    this.panel.replaceChildren(
      this.head(`${body.kind} body`, body.name), this.now,
      facts([["material", body.material], ["groups", body.groups.replaceAll(" ", ", ")], ["support", body.support],
        ["mass", body.mass ? plainQuantity(body.mass, "kg") : ""], ["bonds at the start", body.bonds || ""]]),
      chips.length ? make("p", { class: "chips" }, "bearings ", ...chips) : "",
      this.plot("displacement of its centre", "m", axes.map(([name, v]) => ({ name, times, values: v.map((at) => at - v[0]) }))),
      this.plot("speed", "m/s", [{ name: "speed", times, values: column((i) => run.speed(body, i)) }]),
      ...(body.nodes === 1 ? [this.plot("rotation", "rad", [{ name: "rotation", times, values: column((i) => run.rotation(body, i)) }])] : []),
      ...this.stressPlot(body),
      ...this.temperaturePlot(body),
      this.events((e) => e.a === body.index || e.b === body.index));
    this.tell = (frame) => `displacement ${quantity(Math.hypot(...axes.map(([, v]) => v[frame] - v[0])), "m")}, speed ${quantity(run.speed(body, frame), "m/s")}`;
  }

  temperaturePlot(body) {
    const { run } = this.app, nodes = Array.from({ length: body.nodes }, (_, i) => body.node + i);
    if (!run.block("temperature").rows || run.meanTemperature(nodes, run.frames - 1) === null) return [];
    return [this.plot("temperature", "°C", [{ name: "mean", times: run.times,
      values: Float64Array.from({ length: run.frames }, (_, f) => run.meanTemperature(nodes, f) ?? NaN) }])];
  }

  /** Mean stress over the elements of a body. */
  stressPlot(body) {
    const { run } = this.app;
    const own = run.elements.flatMap((e, i) => (e.body === body.index ? [i] : []));
    if (!own.length || !run.block("stress").rows) return [];
    const line = (name, axis) => ({ name, times: run.times, values: Float64Array.from({ length: run.frames },
      (_, f) => own.reduce((sum, i) => sum + run.stress(i, f)[axis], 0) / own.length) });
    return [this.plot("mean stress", "Pa", [line("xx", 0), line("yy", 1), line("xy", 2)])];
  }

  showBearing(bearing) {
    const { run } = this.app, times = run.times;
    const line = (name, block, axis) => ({ name, times, values: run.bearingColumn(bearing, block, axis) });
    const body = (i) => make("button", { class: "chip", onclick: () => this.app.select({ body: run.bodies[i] }) }, run.bodies[i].name);
    this.now = make("p", { class: "now" });
    this.panel.replaceChildren(
      this.head("bearing", bearing.name), this.now,
      make("p", { class: "chips" }, "between ", body(bearing.a), body(bearing.b)),
      facts([["law", bearing.law]]),
      this.plot("force", "N", ["x", "y", "z"].slice(0, run.dim).map((name, k) => line(name, "bearing_force", k))),
      this.plot("displacement", "m", (run.dim === 3 ? ["along", "across", "axial"] : ["along", "across"]).map((name, k) => line(name, "bearing_displacement", k))),
      ...this.loops(bearing),
      this.events((e) => e.bearing === bearing.index));
    this.tell = (frame, time) => {
      const state = run.bearingState(bearing, frame, time), mark = this.app.scene.bearingMark(bearing);
      return `now ${stateNames[state]}${mark && mark.state !== state ? ", its bodies are separated" : ""}`;
    };
  }

  /** Force over displacement in one direction, if the run has histories of both. */
  loops(bearing) {
    const mine = new Map(this.app.run.series.flatMap((s) => (s.text.endsWith(` of bearing '${bearing.name}'`) ? [[s.text.split(" of bearing")[0], s]] : [])));
    return [...mine].flatMap(([what, force]) => {
      const direction = what.match(/^force(?: of the law)? (.+)$/)?.[1], over = mine.get(`displacement ${direction}`);
      return over ? [this.plot(`loop, ${direction}`, force.unit, [force], over)] : [];
    });
  }

  events(filter) {
    const all = this.app.run.events.filter(filter);
    // Contacts made and lost would fill an endless list; if there are many, only important events are shown.
    const rows = all.length > 60 ? all.filter((e) => e.note).slice(0, 200) : all;
    const items = rows.map((e) => make("li", {}, make("button", { class: "event-link", onclick: () => this.app.seek(e.time) },
      make("time", {}, seconds(e.time)), e.text)));
    return make("section", {}, make("h3", {}, rows.length < all.length ? `Important events (${rows.length} of ${all.length})` : `Events (${all.length})`),
      rows.length ? make("ul", { class: "plain" }, ...items) : make("p", { class: "hint" }, "none"));
  }

  draw(time, theme) {
    for (const plot of this.plots) plot.draw(time, theme);
    if (this.now) this.now.textContent = this.tell(this.app.run.locate(time).frame, time);
  }
}

/** All histories and the energy, grouped by unit; over time, or histories over one of them. */
export class HistoriesPanel {
  constructor(app) {
    this.app = app;
    // A ledger contains terms that are zero throughout this run.
    this.series = app.run.series.filter((s) => s.times.length && (s.group !== "energy" || s.values.some((v) => v !== 0)));
    const histories = this.series.filter((s) => s.group !== "energy");
    this.menu = make("select", { id: "against" }, make("option", { value: "" }, "time"), ...histories.map((s) => make("option", { value: s.name }, s.name)));
    this.menu.addEventListener("change", () => this.show(this.menu.value));
    this.list = make("div", {});
    byId("histories").append(histories.length > 1 ? make("label", { class: "quiet" }, "over ", this.menu) : "", this.list);
    this.show("");
  }

  show(against) {
    const over = against ? this.series.find((s) => s.name === against && s.group !== "energy") : null;
    const panels = new Map();
    for (const s of this.series) {
      if (over && (s.group === "energy" || s === over)) continue;
      const key = `${s.group} ${s.unit}`;
      if (!panels.has(key)) panels.set(key, []);
      panels.get(key).push(s);
    }
    const perPlot = over ? 1 : 7;
    this.plots = [...panels.values()].flatMap((all) => Array.from({ length: Math.ceil(all.length / perPlot) }, (_, i) => this.plot(all.slice(i * perPlot, (i + 1) * perPlot), over)));
    this.list.replaceChildren(...this.plots.map((p) => p.element), ...(this.plots.length ? [] : [make("p", { class: "hint" }, "This run recorded no histories and no energy.")]));
    this.app.redraw();
  }

  plot(lines, over) {
    const { run, seek, lineColours } = this.app;
    const title = lines[0].group === "energy" ? "energy" : lines.length === 1 ? lines[0].name : "histories";
    return new Plot({ title, unit: lines[0].unit, lines, over, window: [run.begin, run.end], seek, colours: lineColours });
  }

  draw(time, theme) {
    for (const plot of this.plots) plot.draw(time, theme);
  }
}
