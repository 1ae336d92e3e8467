// Legend of colours and marks, and the scale bar.
import { hingeColours, hingeNames, signColours } from "./members.js";
import { crackColour } from "./scene.js";
import { byId, figures, make, quantity, readableUnit, roundBelow } from "./words.js";

const mostGroups = 9;

/** A solid in space shows its colour from full light to shade. */
const shaded = (colour) => `linear-gradient(90deg, ${colour}, color-mix(in srgb, ${colour} 66%, black))`;

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
      parts.push(make("ul", {}, ...all.slice(0, mostGroups).map(([name, colour]) => swatch(run.dim === 3 ? shaded(colour) : colour, name || "bodies")),
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
    marks.push(...this.ofMembers(colours.theme, show));
    if (show.cracks)
      for (const mode of new Set(run.joints.map((j) => j.mode)))
        marks.push(swatch(crackColour(mode, colours.theme), mode ? `crack, ${mode}` : "crack: bond lost", "line"));
    if (show.forces) marks.push(swatch(colours.theme.force, `contact force; this long: ${quantity(this.app.scene.usualForce * (26 / this.app.scene.usualLength) ** 2, "N")}`, "line"));
    if (marks.length) parts.push(make("ul", {}, ...marks));
    this.element.replaceChildren(...parts);
  }

  /** Entries of hinges by their state, and of the diagram. */
  ofMembers(theme, show) {
    const { members, palette } = this.app.run, block = this.app.run.block("member_state"), out = [];
    if (show.hinges && block.rows && members.list.some((m) => m.yields !== "elastic")) {
      const states = new Set(block.values), fibres = members.list.some((m) => m.yields === "fibres");
      if (members.list.some((m) => m.yields === "hinges"))
        for (const s of [0, 1, 2, 3]) if (states.has(s)) out.push(swatch(hingeColours(theme, palette)[s], hingeNames[s], s === 3 ? "cross" : "dot"));
      if (fibres && states.has(1)) out.push(swatch(palette.yielded, "fibres yielded", "dot small"));
    }
    if (!members.shown) return out;
    const { quantity: q, envelope } = members.shown, [above, below] = signColours(theme);
    const name = `${q.label}${envelope ? ", envelope" : ""}, largest ${quantity(members.extremes(q).largest, q.unit)}`;
    out.push(swatch(above, `+ ${name}`, "line"), swatch(below, "−", "line"));
    return out;
  }

  draw() {
    const { camera } = this.app.scene;
    if (this.scale === camera.scale) return;
    this.scale = camera.scale;
    if (this.app.scene.show.forces) this.build(this.app.colours, this.app.scene.show);
    const plain = readableUnit(1, "m"), length = roundBelow(120 / camera.scale * plain.factor) / plain.factor;
    this.bar.firstElementChild.style.width = `${length * camera.scale}px`;
    this.bar.lastElementChild.textContent = plain.unit !== "m" || length >= 1 ? `${figures(length * plain.factor, 1)} ${plain.unit}` : length >= 0.01 ? `${Math.round(length * 1000)} mm` : quantity(length, "m");
  }
}
