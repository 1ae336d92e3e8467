// Formatting of numbers and names for display.

const prefixes = [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"],
  [1e-12, "p"]];
const leastQuantity = 1e-12;  // below it is rounding noise
const scaled = new Set(["N", "J", "Pa", "N/m", "N m", "N·m", "W"]);

/** Units of the model, if they are not SI: own[unit] = [SI value, name]. */
const own = {};
export const useUnits = (units) => Object.assign(own, units);

/** { factor, unit } with which values up to `largest` are readable: kN, mm, ... */
export function readableUnit(largest, unit) {
  const size = Math.abs(largest);
  if (own[unit]) return { factor: 1 / own[unit][0], unit: own[unit][1] };
  if (unit === "m") return size > 0 && size < 0.5 ? { factor: 1e3, unit: "mm" } : { factor: 1, unit: "m" };
  if (unit === "rad") return { factor: 180 / Math.PI, unit: "°" };
  if (unit === "1") return { factor: 1, unit: "" };
  if (!scaled.has(unit) || !(size > 0)) return { factor: 1, unit };
  const [factor, prefix] = prefixes.find(([f]) => size >= f) ?? prefixes[prefixes.length - 1];
  return { factor: 1 / factor, unit: prefix + unit };
}

const raised = (_, power) => `·10${[...String(Number(power))].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻").join("")}`;

/** Three significant digits, without an exponent if possible, with a true minus sign. */
export function figures(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  let text;
  if (size === 0) text = "0";
  else if (size >= 1e5 || size < 1e-3) text = value.toExponential(digits - 1).replace(/e([+-]\d+)/, raised);
  else text = value.toFixed(Math.max(0, digits - 1 - Math.floor(Math.log10(size))));
  return text.replace(/-/g, "−");
}

/** As quantity, in the plain unit: kg, or m, without prefix. */
export function plainQuantity(value, unit) {
  const to = own[unit] ? readableUnit(value, unit) : { factor: 1, unit };
  return `${figures(value * to.factor)} ${to.unit}`;
}

/** A text whose numbers and units do not break between lines: "126 kN m". */
export const unbroken = (text) => text.replace(/(\d) ([kMGTmµ]?(?:N|Pa|J|m|s|kg)\b\S*)( mm?\b)?/g,
  (_, digit, unit, length) => `${digit}\u00a0${unit}${length ? `\u00a0${length.trim()}` : ""}`);

export function quantity(given, unit) {
  const value = Math.abs(given) < leastQuantity ? 0 : given;
  const to = readableUnit(value, unit);
  return to.unit === "°" ? `${figures(value * to.factor)}°` : `${figures(value * to.factor)} ${to.unit}`.trim();
}

/** Origin of times: `zero` [s of the run], and its text unless it is the start of the run. */
export const clock = { zero: 0, since: "" };

/** Text of an instant relative to the origin. */
export const seconds = (time) => duration(time - clock.zero);
export const duration = (time) => `${time.toFixed(2).replace("-", "−")} s`;

/** A round number near `value`: 1, 2 or 5 times a power of ten, not above it. */
export function roundBelow(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].find((k) => k * power <= value * 1.0001) * power;
}

/** Round values from `low` to `high`, about `count` of them. */
export function ticks(low, high, count) {
  if (!(high > low)) return [low];
  const step = [1, 2, 5, 10].map((k) => k * 10 ** Math.floor(Math.log10((high - low) / count)))
    .find((s) => (high - low) / s <= count) ?? high - low;
  const out = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) out.push(i * step);
  return out;
}

/** A new element: make("button", { class: "chip", onclick: f }, "text", child, ...). */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.filter((c) => c !== null && c !== undefined));
  return element;
}

export const byId = (id) => document.getElementById(id);
