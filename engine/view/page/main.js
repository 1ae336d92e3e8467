// Assembles the page.
import { decode } from "./decode.js";
import { Run } from "./run.js";
import { Camera, allBox, homeBox } from "./camera.js";
import { BodyColours, colourings, themeColours } from "./colours.js";
import { Scene } from "./scene.js";
import { SpaceRun } from "./space_run.js";
import { SpaceCamera, allSpace, homeSpace, viewsAround } from "./space_camera.js";
import { SpaceScene } from "./space_scene.js";
import { CutTool } from "./cut.js";
import { listen } from "./picking.js";
import { HistoriesPanel, SelectionPanel } from "./selection.js";
import { EventsPanel, eventColour } from "./events.js";
import { Player } from "./player.js";
import { Legend } from "./legend.js";
import { Modes } from "./modes.js";
import { byId, clock, make, seconds } from "./words.js";

const toggles = [["forces", "forces", "contact_pair"], ["cracks", "cracks", null], ["debris", "cracks in debris", null], ["bearings", "bearings", "bearing_state"],
  ["hinges", "hinges", "member_state"], ["names", "names", null], ["start", "start", null], ["depth", "depth shading", null]];
const states = { finished: "", running: "still in progress when this page was made", stopped: "stopped before its end: the page shows the part up to the last flush" };

class App {
  constructor(run) {
    this.run = run;
    this.seek = (time) => this.player.seek(time);
    this.lineColours = ["#2b8cd6", "#e0712c", "#18a67c", "#cc79a7", "#9aa3ad", "#e0a200", "#8a63d2"];
    const space = run.dim === 3;
    this.camera = space ? new SpaceCamera() : new Camera();
    this.camera.home = space ? homeSpace(run) : homeBox(run);
    this.scene = new (space ? SpaceScene : Scene)(run, byId("canvas"), this.camera);
    for (const element of document.querySelectorAll("[data-space]")) element.hidden = !space;
    this.camera.fit();
    this.theme = themeColours();
    this.ways = colourings(run);
    this.selection = null;
    this.countFrom(run.origin ?? { zero: 0, since: "" });
    const shaking = run.stages.find((s) => s.kind !== "consolidation");
    this.player = new Player(this, shaking && shaking.begin <= run.end ? shaking.begin : run.begin);
    this.modes = new Modes(this);
    this.events = new EventsPanel(this);
    this.selectionPanel = new SelectionPanel(this);
    this.histories = new HistoriesPanel(this);
    this.legend = new Legend(this);
    this.wireView();
    this.wireTabs();
    this.wireTheme();
    this.wireClock();
    this.tellAbout();
    document.addEventListener("keydown", (e) => this.key(e));
    new ResizeObserver(() => this.resize()).observe(byId("canvas").parentElement);
    this.colourBy(this.ways[0].id);
    this.resize();
  }

  resize() {
    const tools = byId("tools");
    this.camera.covered = tools.offsetTop + tools.offsetHeight;
    this.scene.resize();
    this.redraw();
  }

  wireView() {
    const by = byId("colour-by");
    by.append(...this.ways.map((w) => make("option", { value: w.id }, w.label)));
    by.addEventListener("change", () => this.colourBy(by.value));
    for (const [name, label, block] of toggles) {
      if (name === "depth" && this.run.dim !== 3) continue;
      const there = name === "cracks" || name === "debris" ? this.run.joints.length : block ? this.run.block(block).rows : this.run.frames;
      if (!there) {
        this.scene.show[name] = false;
        continue;
      }
      byId("shown").append(make("button", { class: "chip", id: `show-${name}`, "aria-pressed": String(this.scene.show[name]), onclick: () => this.toggle(name) }, label));
    }
    this.wireDiagram();
    if (this.scene.cut) this.cutTool = new CutTool(this.scene.cut, () => this.redraw());
    byId("fit").addEventListener("click", () => this.fit());
    byId("fit-all").addEventListener("click", () => this.fitAll());
    byId("zoom-in").addEventListener("click", () => this.zoom(1.4));
    byId("zoom-out").addEventListener("click", () => this.zoom(1 / 1.4));
    const tip = byId("tip");
    listen(byId("canvas"), this.scene, {
      changed: () => this.redraw(),
      chosen: (hit) => this.select(hit),
      hovered: (hit, x, y) => {
        tip.hidden = !hit;
        byId("canvas").style.cursor = hit ? "pointer" : "grab";
        if (!hit) return;
        tip.textContent = hit.body ? hit.body.name : `bearing ${hit.bearing.name}`;
        tip.style.transform = `translate(${Math.round(x + 14)}px, ${Math.round(y + 14)}px)`;
      },
    });
  }

  /** The choice of a section force of members, at each time or as envelope of the run. */
  wireDiagram() {
    const { members } = this.run, menu = byId("diagram");
    menu.parentElement.hidden = !members.quantities.length;
    const choices = members.quantities.flatMap((quantity) => [{ quantity, envelope: false }, { quantity, envelope: true }]);
    menu.append(make("option", { value: "-1" }, "none"),
      ...choices.map((c, i) => make("option", { value: String(i) }, c.envelope ? `${c.quantity.label}, envelope` : c.quantity.label)));
    menu.addEventListener("change", () => {
      members.shown = choices[Number(menu.value)] ?? null;
      this.makeRoom(members.shown);
      this.legend.build(this.colours, this.scene.show);
      this.redraw();
    });
  }

  /** While a diagram is shown, the fitted view has space for it around the structure. */
  makeRoom(diagram) {
    const { camera, run } = this, wasHome = camera.isHome;
    camera.home = run.dim === 3 ? homeSpace(run) : homeBox(run);
    const room = diagram ? 0.13 * camera.extent : 0, { home } = camera;
    camera.extentShown = camera.extent;
    if (run.dim === 3) camera.home = { low: home.low.map((v) => v - room), high: home.high.map((v) => v + room) };
    else camera.home = { x0: home.x0 - room, y0: home.y0 - room, x1: home.x1 + room, y1: home.y1 + room };
    if (wasHome) camera.fit();
  }

  toggle(name) {
    this.scene.show[name] = !this.scene.show[name];
    byId(`show-${name}`)?.setAttribute("aria-pressed", String(this.scene.show[name]));
    this.legend.build(this.colours, this.scene.show);
    this.redraw();
  }

  colourBy(id) {
    this.way = this.ways.find((w) => w.id === id);
    byId("colour-by").value = id;
    this.colours = new BodyColours(this.run, this.way, this.theme);
    this.legend.build(this.colours, this.scene.show);
    this.redraw();
  }

  wireTabs() {
    const tabs = [...document.querySelectorAll("[role=tab]")];
    const open = (tab) => {
      for (const t of tabs) {
        t.setAttribute("aria-selected", String(t === tab));
        t.tabIndex = t === tab ? 0 : -1;
        byId(t.getAttribute("aria-controls")).hidden = t !== tab;
      }
      this.redraw();
    };
    tabs.forEach((tab, i) => {
      tab.addEventListener("click", () => open(tab));
      tab.addEventListener("keydown", (e) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
        // A click on the tab leaves the arrow keys to the frames; keyboard focus gives them to the tabs.
        if (!step || !tab.matches(":focus-visible")) return;
        e.stopPropagation();
        const to = tabs[(i + step + tabs.length) % tabs.length];
        to.focus();
        open(to);
      });
    });
    this.openTab = (id) => open(byId(id));
  }

  wireTheme() {
    const system = matchMedia("(prefers-color-scheme: dark)");
    const set = (name) => {
      document.documentElement.dataset.theme = name;
      this.theme = themeColours();
      if (this.colours) this.colourBy(this.way.id);
      this.events.fill();
    };
    let kept = null;
    try {
      kept = localStorage.getItem("trilith-theme");
    } catch { /* a page from a file may have no storage */ }
    set(kept ?? (system.matches ? "dark" : "light"));
    system.addEventListener("change", () => kept || set(system.matches ? "dark" : "light"));
    this.switchTheme = () => {
      kept = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
      set(kept);
      try {
        localStorage.setItem("trilith-theme", kept);
      } catch { /* as above */ }
    };
    byId("theme").addEventListener("click", this.switchTheme);
  }

  countFrom({ zero, since }) {
    clock.zero = zero;
    clock.since = since;
    byId("clock").title = `time since ${since || "the start of the run"}`;
  }

  /** The menu of the origin of times: the start, the stages, the first event of each important type. */
  wireClock() {
    const { run } = this, firsts = new Map();
    for (const e of run.events) if (e.note && !e.type.startsWith("stage.") && !firsts.has(e.type)) firsts.set(e.type, e.time);
    const origins = [{ zero: 0, since: "" }, ...run.stages.map((s) => ({ zero: s.begin, since: `'${s.name}' began` })),
      ...[...firsts].map(([type, zero]) => ({ zero, since: `the first ${type}` }))];
    const at = origins.findIndex((o) => o.since === clock.since);
    if (at < 0) origins.push({ ...clock });
    const menu = byId("since");
    menu.append(...origins.map((o, i) => make("option", { value: i }, o.since || "the start")));
    menu.value = String(at < 0 ? origins.length - 1 : at);
    menu.addEventListener("change", () => {
      this.countFrom(origins[Number(menu.value)]);
      this.player.tellStages();
      this.modes.tellModes();
      this.events.fill();
      this.selectionPanel.show(this.selectionPanel.choice);
      this.tellAbout();
      byId("told").textContent = "";
      this.redraw();
    });
    const help = byId("help");
    byId("help-open").addEventListener("click", () => help.showModal());
    for (const dialog of [help, byId("large")]) dialog.addEventListener("click", (e) => e.target === dialog && dialog.close());
  }

  tellAbout() {
    const { about } = this.run;
    byId("title").textContent = about.name;
    const state = this.run.frames ? states[about.state] : `no frame yet: ${states[about.state] || "nothing to play"}`;
    byId("state").textContent = [state, about.verdict].filter(Boolean).join("; ");
    byId("state").hidden = !byId("state").textContent;
    const row = (k, v) => (v ? [make("dt", {}, k), make("dd", {}, v)] : []);
    const thinned = [];
    if (about.frame_stride > 1) thinned.push(`one frame in ${about.frame_stride} is kept`);
    if (about.contact_stride > 1) thinned.push(`contact forces of one frame in ${about.contact_stride}`);
    if (about.events_left_out) thinned.push(`${about.events_left_out} minor events left out`);
    byId("about").replaceChildren(
      make("dl", { class: "facts" }, ...row("command", about.command), ...row("program", `trilith ${about.program} ${about.commit}`), ...row("started", about.started),
        ...row("bodies", String(this.run.bodies.length)), ...row("frames", `${this.run.frames}, to ${seconds(this.run.end)}${clock.since ? ` since ${clock.since}` : ""}`), ...row("this page", thinned.join("; ")),
        ...(about.seal || []).flatMap(([state, text]) => row(state === "failed" ? "seal: FAILED" : "seal", text)),
        ...about.parameters.flatMap(([name, value, unit, , text]) => row(name, `${value} ${unit}${text ? ` (${text})` : ""}`)), ...about.motions.flatMap((m) => row("motion", m))),
      ...about.notes.map(([time, text]) => make("p", { class: "hint" }, `${seconds(time)}: ${text}`)),
      about.script ? make("details", {}, make("summary", {}, "script"), make("pre", { tabindex: 0 }, about.script)) : "");
  }

  /** Selects { body } or { bearing }, or nothing. */
  select(hit) {
    if (hit?.body && this.run.frames) {
      const points = Array.from({ length: this.run.frames }, (_, f) => this.run.centre(hit.body, f));
      const trail = Object.fromEntries(["x", "y", "z"].slice(0, this.run.dim).map((name, k) => [name, Float64Array.from(points, (p) => p[k])]));
      hit = { body: hit.body, trail };
    }
    this.selection = hit;
    this.selectionPanel.show(hit);
    if (hit) this.openTab("tab-selection");
    this.redraw();
  }

  /** Seeks to an event and selects its bodies, without leaving the list. */
  chooseEvent(event) {
    this.player.pause();
    this.player.seek(event.time);
    const place = this.placeOf(event);
    if (place) this.camera.show(...place);
    this.flashed = { event, at: performance.now() };
    byId("told").textContent = `${seconds(event.time)}: ${event.text}`;
    this.redraw();
  }

  placeOf(event) {
    if (event.x !== null && event.x !== undefined) return [event.x, event.y, event.z].slice(0, this.run.dim);
    if (event.bearing >= 0) return this.run.bearingEnds(this.run.bearings[event.bearing])[0];
    if (event.a >= 0 && this.run.bodies[event.a].free) return this.scene.middle(this.run.bodies[event.a]);
    return null;
  }

  fit() {
    this.camera.fit();
    this.redraw();
  }

  /** Shows all free bodies where they are now, also debris. */
  fitAll() {
    this.camera.fit((this.run.dim === 3 ? allSpace : allBox)(this.run));
    this.redraw();
  }

  zoom(factor) {
    this.camera.zoom(factor);
    this.redraw();
  }

  redraw() {
    if (this.waiting || this.player?.playing) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.draw();
    });
  }

  draw() {
    if (!this.colours || !this.player) return;
    const time = this.player.time;
    this.scene.draw(time, this.colours, this.selection);
    this.drawFlashes(time);
    this.player.draw();
    this.modes.draw();
    this.legend.draw();
    this.events.draw(time);
    if (!byId("selection").hidden) this.selectionPanel.draw(time, this.theme);
    if (!byId("histories").hidden) this.histories.draw(time, this.theme);
  }

  drawFlashes(time) {
    const colour = (e) => eventColour(e, this.theme, this.run.palette);
    const long = 0.5 * this.player.speed;  // [s] of the run
    if (this.player.playing)
      for (const e of this.player.notes) {
        if (e.time > time) break;
        if (e.time < time - long || e.type.startsWith("stage.") || e.type.startsWith("bond.")) continue;
        const place = this.placeOf(e);
        if (place) this.scene.flash(place, (time - e.time) / long, colour(e));
      }
    if (!this.flashed) return;
    const age = (performance.now() - this.flashed.at) / 900, place = this.placeOf(this.flashed.event);
    if (age < 1 && place) {
      this.scene.flash(place, age, colour(this.flashed.event));
      this.redraw();
    } else this.flashed = null;
  }

  /** Left and right step frames, except in fields that use these keys themselves. */
  stepsFrames(e) {
    if (!["ArrowLeft", "ArrowRight"].includes(e.key)) return false;
    const { tagName, type, id } = e.target;
    return tagName === "SELECT" || (tagName === "INPUT" && (id === "time" || ["checkbox", "radio", "button"].includes(type)));
  }

  key(e) {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    if (!this.stepsFrames(e) && /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && !(e.target.id === "time" && e.key === " ")) {
      if (e.target.id !== "time" || !["Home", "End"].includes(e.key)) return;
    }
    if (e.target.tagName === "BUTTON" && (e.key === " " || e.key === "Enter")) return;
    const far = e.shiftKey;
    const does = {
      " ": () => this.player.toggle(), Home: () => this.player.seek(this.run.begin), End: () => this.player.seek(this.run.end),
      ArrowRight: () => (far ? this.player.seek(this.player.time + 1) : this.player.step(1)),
      ArrowLeft: () => (far ? this.player.seek(this.player.time - 1) : this.player.step(-1)),
      ArrowUp: () => this.player.faster(1), ArrowDown: () => this.player.faster(-1),
      "+": () => this.zoom(1.4), "=": () => this.zoom(1.4), "-": () => this.zoom(1 / 1.4), f: () => this.fit(), F: () => this.fitAll(),
      n: () => this.player.toEvent(1), p: () => this.player.toEvent(-1), c: () => this.nextColour(), t: () => this.switchTheme(), v: () => this.nextView(),
      x: () => this.cutTool?.next(),
      "?": () => byId("help").showModal(), m: () => this.nextMode(), Escape: () => this.select(null),
    }[e.key];
    if (!does || byId("help").open || (byId("large").open && e.key === "Escape")) return;
    e.preventDefault();
    does();
  }

  /** For a model in space: the next view direction. */
  nextView() {
    if (this.run.dim !== 3) return;
    const at = viewsAround.findIndex(([azimuth, elevation]) => azimuth === this.camera.azimuth && elevation === this.camera.elevation);
    this.camera.look(...viewsAround[(at + 1) % viewsAround.length]);
    this.redraw();
  }

  nextMode() {
    const { modes, mode } = this.run, next = mode ? mode.index + 1 : 0;
    if (!modes.length || !this.run.frames) return;
    byId("mode").value = String(next < modes.length ? next : -1);
    this.modes.choose(next < modes.length ? next : -1);
  }

  nextColour() {
    this.colourBy(this.ways[(this.ways.indexOf(this.way) + 1) % this.ways.length].id);
  }
}

async function begin() {
  try {
    const element = byId("data");
    const data = await decode(element.textContent);
    element.remove();
    window.trilith = new App(new (data.head.run.dim === 3 ? SpaceRun : Run)(data));
    document.documentElement.dataset.ready = "true";
  } catch (error) {
    byId("state").textContent = error.message;
    byId("state").hidden = false;
    throw error;
  }
}

begin();
