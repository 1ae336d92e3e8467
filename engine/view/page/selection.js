// The chosen body or bearing: its name, what it is, how it stands now, its histories and its events.
import { stateNames } from "./run.js";
import { Plot } from "./plots.js";
import { byId, figures, make, quantity, seconds } from "./words.js";

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
    const close = make("button", { class: "icon", "aria-label": "let go of the selection", title: "let go (Esc)", onclick: () => this.app.select(null) }, "✕");
    return make("header", {}, make("div", {}, make("span", { class: "quiet" }, kind), make("h2", { id: "selection-name" }, name)), close);
  }

  plot(title, unit, lines) {
    const { run, seek } = this.app;
    const plot = new Plot({ title, unit, lines, window: [run.begin, run.end], seek, colours: this.app.lineColours });
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
        ["mass", body.mass ? `${figures(body.mass)} kg` : ""], ["bonds at the start", body.bonds || ""]]),
      chips.length ? make("p", { class: "chips" }, "bearings ", ...chips) : "",
      this.plot("displacement of its centre", "m", axes.map(([name, v]) => ({ name, times, values: v.map((at) => at - v[0]) }))),
      this.plot("speed", "m/s", [{ name: "speed", times, values: column((i) => run.speed(body, i)) }]),
      ...(body.nodes === 1 ? [this.plot("rotation", "rad", [{ name: "rotation", times, values: column((i) => run.rotation(body, i)) }])] : []),
      ...this.stressPlot(body),
      this.events((e) => e.a === body.index || e.b === body.index));
    this.tell = (frame) => `displacement ${quantity(Math.hypot(...axes.map(([, v]) => v[frame] - v[0])), "m")}, speed ${quantity(run.speed(body, frame), "m/s")}`;
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
      this.events((e) => e.bearing === bearing.index));
    this.tell = (frame, time) => {
      const state = run.bearingState(bearing, frame, time), mark = this.app.scene.bearingMark(bearing);
      return `now ${stateNames[state]}${mark && mark.state !== state ? ", its bodies apart" : ""}`;
    };
  }

  events(filter) {
    const all = this.app.run.events.filter(filter);
    // Contacts made and lost fill a list without end; where there are many, what is of note comes alone.
    const rows = all.length > 60 ? all.filter((e) => e.note).slice(0, 200) : all;
    const items = rows.map((e) => make("li", {}, make("button", { class: "event-link", onclick: () => this.app.seek(e.time) },
      make("time", {}, seconds(e.time)), e.text)));
    return make("section", {}, make("h3", {}, rows.length < all.length ? `Events of note (${rows.length} of ${all.length})` : `Events (${all.length})`),
      rows.length ? make("ul", { class: "plain" }, ...items) : make("p", { class: "hint" }, "none"));
  }

  draw(time, theme) {
    for (const plot of this.plots) plot.draw(time, theme);
    if (this.now) this.now.textContent = this.tell(this.app.run.locate(time).frame, time);
  }
}

/** All histories and the energy, those of one unit and group together. */
export class HistoriesPanel {
  constructor(app) {
    this.plots = [];
    const panels = new Map();
    for (const s of app.run.series) {
      // A ledger has terms for what this run does not have.
      if (!s.times.length || (s.group === "energy" && s.values.every((v) => v === 0))) continue;
      const key = `${s.group} ${s.unit}`;
      if (!panels.has(key)) panels.set(key, []);
      panels.get(key).push(s);
    }
    const root = byId("histories");
    const perPlot = 7;
    for (const [, all] of panels)
      for (let i = 0; i < all.length; i += perPlot) {
        const some = all.slice(i, i + perPlot);
        const title = some[0].group === "energy" ? "energy" : some.length === 1 ? some[0].name : "histories";
        const plot = new Plot({ title, unit: some[0].unit, lines: some, window: [app.run.begin, app.run.end], seek: app.seek, colours: app.lineColours });
        this.plots.push(plot);
        root.append(plot.element);
      }
    if (!this.plots.length) root.append(make("p", { class: "hint" }, "This run recorded no histories and no energy."));
  }

  draw(time, theme) {
    for (const plot of this.plots) plot.draw(time, theme);
  }
}
