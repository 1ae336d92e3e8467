// Progress of time: play, pause, speed, and the strip with stages and event marks.
import { eventColour, isLoss } from "./events.js";
import { byId, duration, make, seconds } from "./words.js";

export const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 8, 16];

export class Player {
  /** `app`: { run, theme, redraw(), status }. */
  constructor(app, start) {
    this.app = app;
    this.time = start;
    this.playing = false;
    this.speed = 1;
    this.frameTimes = [];
    const { run } = app;
    this.range = byId("time");
    this.range.max = String(Math.max(1, Math.round((run.end - run.begin) * 1000)));
    this.range.disabled = !run.frames;
    this.strip = byId("strip");
    this.notes = run.events.filter((e) => e.note);
    this.range.addEventListener("input", () => this.seek(run.begin + Number(this.range.value) / 1000));
    byId("play").addEventListener("click", () => this.toggle());
    byId("to-begin").addEventListener("click", () => this.seek(run.begin));
    byId("to-end").addEventListener("click", () => this.seek(run.end));
    byId("before").addEventListener("click", () => this.toEvent(-1));
    byId("after").addEventListener("click", () => this.toEvent(1));
    this.select = byId("speed");
    this.select.append(...speeds.map((s) => make("option", { value: s, selected: s === 1 }, `${s}×`)));
    this.select.addEventListener("change", () => (this.speed = Number(this.select.value)));
    this.tellStages();
  }

  tellStages() {
    byId("stage-jumps").replaceChildren(...this.app.run.stages.map((s) => make("button", { class: "chip", title: `from ${seconds(s.begin)}: ${s.why || "not ended"}`,
      onclick: () => this.seek(s.begin) }, s.name)));
  }

  toggle() {
    if (this.app.modes.on) return this.app.modes.toggle();
    if (this.playing) return this.pause();
    if (!this.app.run.frames) return undefined;
    if (this.time >= this.app.run.end - 1e-9) this.time = this.app.run.begin;
    this.playing = true;
    this.last = null;
    this.showState();
    return requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    this.playing = false;
    this.showState();
    this.app.redraw();
  }

  showState(goes = this.playing) {
    byId("play").setAttribute("aria-label", goes ? "pause" : "play");
    byId("play").classList.toggle("playing", goes);
  }

  tick(now) {
    if (!this.playing) return;
    if (this.last !== null) {
      // A page that was hidden continues at its last time.
      const passed = Math.min(0.25, (now - this.last) / 1000);
      this.time = Math.min(this.app.run.end, this.time + passed * this.speed);
      this.frameTimes.push(now - this.last);
      if (this.frameTimes.length > 240) this.frameTimes.shift();
    }
    this.last = now;
    this.app.draw();
    if (this.time >= this.app.run.end) return void this.pause();
    requestAnimationFrame((next) => this.tick(next));
  }

  seek(time) {
    const { run } = this.app;
    this.app.modes?.leave();
    this.time = Math.max(run.begin, Math.min(run.end, time));
    this.app.redraw();
  }

  step(frames) {
    const { run } = this.app;
    if (!run.frames) return;
    this.playing = false;
    this.showState();
    const { frame, share } = run.locate(this.time);
    const to = frames < 0 && share > 0 ? frame + frames + 1 : frame + frames;
    this.seek(run.times[Math.max(0, Math.min(run.frames - 1, to))]);
  }

  faster(step) {
    const at = Math.max(0, Math.min(speeds.length - 1, speeds.indexOf(this.speed) + step));
    this.speed = speeds[at];
    this.select.value = String(this.speed);
  }

  toEvent(direction) {
    const found = direction > 0 ? this.notes.find((e) => e.time > this.time + 1e-6) : this.notes.findLast((e) => e.time < this.time - 1e-6);
    if (found) this.app.chooseEvent(found);
  }

  /** Frames per second over the last ones drawn while playing. */
  get rate() {
    if (!this.frameTimes.length) return 0;
    return (1000 * this.frameTimes.length) / this.frameTimes.reduce((a, b) => a + b, 0);
  }

  draw() {
    const { run } = this.app, stage = run.stageAt(this.time);
    this.range.value = String(Math.round((this.time - run.begin) * 1000));
    this.range.setAttribute("aria-valuetext", seconds(this.time));
    byId("clock").textContent = seconds(this.time);
    byId("stage").textContent = stage ? `${stage.name}, ${duration(Math.max(0, this.time - stage.begin))} of ${duration((stage.ended ? stage.end : run.end) - stage.begin)}` : "";
    this.drawStrip();
  }

  drawStrip() {
    const { run, theme } = this.app;
    const box = this.strip.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    const key = `${box.width} ${ratio} ${theme.paper}`;
    if (key === this.stripKey) return;
    this.stripKey = key;
    this.strip.width = Math.round(box.width * ratio);
    this.strip.height = Math.round(box.height * ratio);
    const c = this.strip.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    const inset = 8;  // half of the slider's thumb, so that marks and thumb align
    const x = (t) => inset + ((box.width - 2 * inset) * (t - run.begin)) / (run.end - run.begin || 1);
    run.stages.forEach((s, i) => {
      c.fillStyle = theme.line;
      c.globalAlpha = i % 2 ? 0.6 : 1;
      c.fillRect(x(s.begin), box.height - 9, x(s.ended ? s.end : run.end) - x(s.begin), 4);
    });
    for (const e of [...this.notes].sort((a, b) => isLoss(a) - isLoss(b))) {
      if (e.type.startsWith("stage.")) continue;
      c.globalAlpha = isLoss(e) ? 1 : this.notes.length > 300 ? 0.3 : 0.75;
      c.fillStyle = eventColour(e, theme, run.palette);
      const high = (box.height - 20) * (isLoss(e) ? 1 : 0.6);
      c.fillRect(x(e.time) - (isLoss(e) ? 1 : 0.5), box.height - 12 - high, isLoss(e) ? 2 : 1, high);
    }
    c.globalAlpha = 1;
  }
}
