// Follows a run, on a page that `trilith live` serves: asks each second for newer results, and then loads the page again
// with the same view. A page at its end stays at the end. Not a module: it comes after the other code of such a page.
(() => {
  const page = document.documentElement, shown = page.dataset.stamp, key = "trilith-live";
  let held = false;

  /** The view before the page was loaded again; null at the first time. */
  function kept() {
    try {
      return JSON.parse(sessionStorage.getItem(key));
    } catch {
      return null;  // a browser may forbid storage
    }
  }

  function keep() {
    const app = window.trilith;
    if (!app) return;
    const { home, width, height, ...camera } = app.camera, { player, run } = app;
    const view = { camera, way: app.way.id, time: player.time, follows: player.time >= run.end - 1e-9, playing: player.playing };
    try {
      sessionStorage.setItem(key, JSON.stringify(view));
    } catch { /* as above */ }
  }

  function restore() {
    const app = window.trilith, was = kept();
    if (!app || !app.run.frames) return;
    if (was && !was.camera.isHome) Object.assign(app.camera, was.camera);
    if (was && app.ways.some((way) => way.id === was.way)) app.colourBy(was.way);
    app.player.seek(!was || was.follows ? app.run.end : was.time);
    if (was?.playing && !was.follows) app.player.toggle();
  }

  function tell(text) {
    const state = document.getElementById("state");
    state.textContent = text;
    state.hidden = false;
  }

  async function look() {
    try {
      const stamp = await (await fetch("state", { cache: "no-store" })).text();
      // Loading would interrupt a drag, and close the help.
      if (stamp !== shown && !held && !document.querySelector("dialog[open]")) {
        keep();
        location.reload();
      }
    } catch {
      tell("trilith live has ended; the page shows the last results that it read");
    }
  }

  function begin() {
    if (page.dataset.ready !== "true" && window.trilith === undefined && document.getElementById("canvas")) {
      setTimeout(begin, 30);
      return;
    }
    restore();
    page.dataset.live = "true";
    setInterval(look, 1000);
  }

  addEventListener("pointerdown", () => (held = true));
  for (const name of ["pointerup", "pointercancel", "blur"]) addEventListener(name, () => (held = false));
  begin();
})();
