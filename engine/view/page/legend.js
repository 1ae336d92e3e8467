// Legend of colours and marks, and the scale bar.
import { crackColour } from "./scene.js";
import { byId, make, quantity, roundBelow } from "./words.js";

const mostGroups = 9;

function swatch(colour, text, shape = "") {
  return make("li", {}, make("i", { class: shape, style: `--swatch:${colour}` }), text);
}

export class Legend {
  constructor(app) {
    this.app = app;
    this.element = byId("legend");
    this.bar = byId("scale-bar");
  }

  /** Rebuilds the legend after a change of colours or contents. */
  build(colours, show) {
    const { run } = this.app;
    const parts = [];
    if (colours.groups) {
      const all = [...colours.groups];
      parts.push(make("ul", {}, ...all.slice(0, mostGroups).map(([name, colour]) => swatch(colour, name || "bodies")),
        all.length > mostGroups ? make("li", { class: "quiet" }, `and ${all.length - mostGroups} more`) : ""));
    } else {
      const [low, high] = colours.ends();
      parts.push(make("div", { class: "ramp" }, make("span", {}, colours.colouring.label),
        make("i", { style: `background:linear-gradient(90deg,${colours.ramp.join(",")})` }), make("div", {}, make("span", {}, low), make("span", {}, high))));
    }
    const marks = [];
    const palette = run.palette, dark = colours.theme.dark;
    if (show.bearings && run.bearings.length) {
      const states = new Set(run.block("bearing_state").values);
      marks.push(swatch(colours.theme.ink, "bearing", "ring"));
      if (states.has(1)) marks.push(swatch(palette.yielded, "yielded", "box"));
      if (states.has(3)) marks.push(swatch(palette.changed, "changed", "box"));
      if (states.has(2) || states.has(3)) marks.push(swatch(dark ? "#ff6a3c" : palette.failed, "failed", "cross"));
    }
    if (show.cracks)
      for (const mode of new Set(run.joints.map((j) => j.mode)))
        marks.push(swatch(crackColour(mode, colours.theme), mode ? `crack, ${mode}` : "crack: bond lost", "line"));
    if (show.forces) marks.push(swatch(colours.theme.force, `contact force; this long: ${quantity(this.app.scene.usualForce * (26 / this.app.scene.usualLength) ** 2, "N")}`, "line"));
    if (marks.length) parts.push(make("ul", {}, ...marks));
    this.element.replaceChildren(...parts);
  }

  draw() {
    const { camera } = this.app.scene;
    if (this.scale === camera.scale) return;
    this.scale = camera.scale;
    if (this.app.scene.show.forces) this.build(this.app.colours, this.app.scene.show);
    const length = roundBelow(120 / camera.scale);
    this.bar.firstElementChild.style.width = `${length * camera.scale}px`;
    this.bar.lastElementChild.textContent = length >= 1 ? `${length} m` : length >= 0.01 ? `${Math.round(length * 1000)} mm` : quantity(length, "m");
  }
}
