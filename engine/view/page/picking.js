// Selection of the object under the pointer; drag to pan, wheel or two fingers to zoom, click to select.

/** { bearing } or { body } at a point on the canvas, or null; bearings come first, then free bodies. */
export function pick(scene, px, py) {
  const { run } = scene;
  if (!run.frames) return null;
  let best = null, least = 12;
  if (scene.show.bearings)
    for (const bearing of run.bearings) {
      const mark = scene.bearingMark(bearing);
      if (!mark) continue;
      const far = Math.hypot(mark.a[0] - px, mark.a[1] - py);
      if (far < least) best = bearing, least = far;
    }
  if (best) return { bearing: best };
  const body = scene.bodyAt(px, py);
  return body ? { body } : null;
}

/** Adds the event handlers of the canvas. `on`: { changed(), chosen(hit), hovered(hit, x, y) }. */
export function listen(canvas, scene, on) {
  const { camera } = scene;
  const down = new Map();
  let moved = 0;
  const local = (e) => {
    const box = canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  };
  canvas.addEventListener("wheel", (e) => {
    e.preventDefault();
    camera.zoom(Math.exp(-e.deltaY * (e.deltaMode ? 0.05 : 0.0016)), ...local(e));
    on.changed();
  }, { passive: false });
  canvas.addEventListener("pointerdown", (e) => {
    canvas.setPointerCapture(e.pointerId);
    down.set(e.pointerId, local(e));
    moved = 0;
  });
  canvas.addEventListener("pointermove", (e) => {
    const at = local(e), before = down.get(e.pointerId);
    if (!before) return on.hovered(pick(scene, ...at), ...at);
    const dx = at[0] - before[0], dy = at[1] - before[1];
    moved += Math.hypot(dx, dy);
    if (moved < 4 && down.size === 1) return undefined;
    if (down.size === 1) camera.drag(dx, dy, e);
    else pinch(camera, down, e.pointerId, at);
    down.set(e.pointerId, at);
    return on.changed();
  });
  const up = (e) => {
    const alone = down.size === 1 && down.delete(e.pointerId);
    down.delete(e.pointerId);
    if (alone && moved < 4 && e.type === "pointerup") on.chosen(pick(scene, ...local(e)));
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("pointerleave", () => on.hovered(null, 0, 0));
  canvas.addEventListener("dblclick", () => {
    camera.fit();
    on.changed();
  });
}

function pinch(camera, down, id, at) {
  const other = [...down].find(([key]) => key !== id)[1], before = down.get(id);
  const grown = Math.hypot(at[0] - other[0], at[1] - other[1]) / Math.max(1, Math.hypot(before[0] - other[0], before[1] - other[1]));
  camera.zoom(grown, (at[0] + other[0]) / 2, (at[1] + other[1]) / 2);
}
