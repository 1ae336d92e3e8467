// Natural modes: a menu of modes, and the animation of the selected one.
import { byId, make, seconds } from "./words.js";

const period = 2;  // [s] of wall clock, independent of the mode's period

export class Modes {
  /** `app`: { run, player, redraw(), draw() }. */
  constructor(app) {
    this.app = app;
    const { modes } = app.run, several = new Set(modes.map((m) => m.time)).size > 1;
    byId("modes").hidden = !modes.length || !app.run.frames;
    this.menu = byId("mode");
    this.several = several;
    this.menu.addEventListener("change", () => this.choose(Number(this.menu.value)));
    this.tellModes();
  }

  tellModes() {
    const { modes } = this.app.run, { several } = this, chosen = this.menu.value || "-1";
    const label = (m) => `mode ${m.number}, ${m.frequency.toPrecision(4)} Hz${several ? ` at ${seconds(m.time)}` : ""}`;
    this.menu.replaceChildren(make("option", { value: -1 }, "the run"), ...modes.map((m, i) => make("option", { value: i }, label(m))));
    this.menu.value = chosen;
  }

  get on() { return this.app.run.mode !== null; }

  choose(index) {
    if (index < 0) return this.leave();
    const { app } = this;
    app.player.pause();
    app.run.mode = { index, share: 1 };
    this.swinging = true;
    this.phase = 0.25;
    this.last = null;
    app.player.showState(true);
    return requestAnimationFrame((now) => this.tick(now));
  }

  toggle() {
    this.swinging = !this.swinging;
    this.last = null;
    this.app.player.showState(this.swinging);
    if (this.swinging) requestAnimationFrame((now) => this.tick(now));
  }

  /** Returns to the run. */
  leave() {
    if (!this.on) return;
    this.app.run.mode = null;
    this.menu.value = "-1";
    this.app.player.showState();
    this.app.redraw();
  }

  tick(now) {
    if (!this.on || !this.swinging) return;
    if (this.last !== null) this.phase += Math.min(0.1, (now - this.last) / 1000) / period;
    this.last = now;
    this.app.run.mode.share = Math.sin(2 * Math.PI * this.phase);
    this.app.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  /** Text in place of the clock and the stage. */
  draw() {
    if (!this.on) return;
    const mode = this.app.run.modes[this.app.run.mode.index];
    byId("clock").textContent = `mode ${mode.number}`;
    byId("stage").textContent = mode.frequency > 0
      ? `${mode.frequency.toPrecision(4)} Hz, damping ${(100 * mode.damping).toPrecision(2)} %, computed at ${seconds(mode.time)}; slowed down and magnified`
      : "does not oscillate";
  }
}
