"""Opens pages of `trilith view` in headless Chromium as a user would: clicks, keys, pictures.

view_page.py FOLDER PAGE STEPS...: each step is a function of this file. Pictures go to FOLDER. Ends with 77 where
Chromium, its driver or selenium are missing; any wrong result or error on the page's console ends it with 1.
"""
import os
import shutil
import sys
import time

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.keys import Keys
except ImportError:
    sys.exit(77)


LONGEST = 400  # s for anything that is waited for; only a hang takes so long


def open_browser():
    chromium, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not chromium or not driver:
        sys.exit(77)
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for flag in ("--headless=new", "--disable-dev-shm-usage", "--hide-scrollbars", "--window-size=1440,900"):
        options.add_argument(flag)
    if os.getuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(driver), options=options)
    browser.set_script_timeout(LONGEST)
    return browser


class Page:
    def __init__(self, folder, path):
        self.folder, self.name = folder, os.path.splitext(os.path.basename(path))[0]
        self.driver = open_browser()
        self.driver.get("file://" + path)
        self.until("document.documentElement.dataset.ready === 'true'")

    def evaluate(self, code):
        return self.driver.execute_script("return " + code)

    def until(self, condition):
        end = time.time() + LONGEST
        while not self.evaluate(condition):
            assert time.time() < end, f"not in {LONGEST} s: {condition}"
            time.sleep(0.03)

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def click(self, selector):
        self.driver.find_element("css selector", selector).click()

    def click_canvas(self, x, y):
        box = self.evaluate("(({left, top}) => [left, top])(document.getElementById('canvas').getBoundingClientRect())")
        chain = ActionChains(self.driver)
        chain.w3c_actions.pointer_action.move_to_location(round(box[0] + x), round(box[1] + y)).click()
        chain.perform()

    def text(self, selector):
        return self.driver.find_element("css selector", selector).text

    def picture(self, what):
        time.sleep(0.15)
        self.driver.save_screenshot(os.path.join(self.folder, f"{self.name}_{what}.png"))

    def close(self):
        # Messages of a graphics driver about its speed do not come from the page.
        messages = [line for line in self.driver.get_log("browser")
                if line["level"] in ("SEVERE", "WARNING") and line["source"] != "rendering"]
        self.driver.quit()
        assert not messages, messages


def plays_to_the_end(page):
    """Space plays at the highest speed, to the end; the clock shows it."""
    page.keys(Keys.HOME, Keys.ARROW_UP * 8, " ")
    # A short run may end before the first check.
    page.until("trilith.player.playing || trilith.player.time > trilith.run.begin")
    page.until("!trilith.player.playing")
    end = page.evaluate("trilith.run.end")
    assert page.text("#clock") == f"{end:.2f} s", page.text("#clock")
    print(f"{page.name}: {page.evaluate('trilith.player.rate'):.0f} frames a second while playing")
    page.keys(Keys.ARROW_DOWN * 4)
    page.picture("end")


def shows_a_failed_bearing(page):
    """The first failure from the list of events, then a click on the bearing: its name, history, events."""
    page.keys(Keys.HOME)
    page.driver.find_element("id", "event-search").send_keys("failed")
    page.click("[data-type='bearing.failed']")
    event = page.evaluate("trilith.run.events.find(e => e.type === 'bearing.failed')")
    assert abs(page.evaluate("trilith.player.time") - event["time"]) < 1e-6
    assert event["text"] in page.text("#told")
    page.keys(Keys.ESCAPE)
    place = page.evaluate(f"(trilith.draw(), trilith.scene.bearingMark(trilith.run.bearings[{event['bearing']}])).a")
    page.click_canvas(*place)
    name = page.evaluate(f"trilith.run.bearings[{event['bearing']}].name")
    assert page.text("#selection-name") == name, page.text("#selection-name")
    assert len(page.driver.find_elements("css selector", "#selection canvas.plot")) == 2
    assert event["text"] in page.text("#selection")
    page.picture("failed_bearing")
    page.click("#selection canvas.plot")
    assert abs(page.evaluate("trilith.player.time - trilith.run.end / 2")) < 0.1 * page.evaluate("trilith.run.end")


def shows_a_body(page):
    """A click on the largest free body: its histories; colours, forces, dark, zoom and help by key."""
    page.keys("f", Keys.END)
    page.until("trilith.player.time === trilith.run.end && !trilith.waiting")
    index = page.evaluate("trilith.run.bodies.filter(b => b.free && b.vertices === 4).reduce((a, b) => a.area > b.area ? a : b).index")
    place = page.evaluate(f"trilith.camera.place(...trilith.scene.middle(trilith.run.bodies[{index}]))")
    page.click_canvas(*place)
    assert page.text("#selection-name") == page.evaluate(f"trilith.run.bodies[{index}].name")
    assert "displacement" in page.text("#selection .now")
    for way in page.evaluate("trilith.ways.map(w => w.id)"):
        page.evaluate(f"trilith.colourBy('{way}')")
        page.evaluate("trilith.draw()")
    page.click("#show-forces")
    page.keys("t")
    assert page.evaluate("document.documentElement.dataset.theme") == "dark"
    page.picture("dark_forces")
    page.keys("?")
    assert page.evaluate("document.getElementById('help').open")
    page.picture("help")
    page.keys(Keys.ESCAPE)
    scale = page.evaluate("trilith.camera.scale")
    page.keys("+")
    assert page.evaluate("trilith.camera.scale") > scale
    page.keys("f")
    assert abs(page.evaluate("trilith.camera.scale") - scale) < 1e-9


def shows_cracks(page):
    """Cracks are drawn at joints that broke, and only there; the share of bonds lost colours bodies."""
    assert page.evaluate("trilith.run.joints.length") > 0
    assert page.evaluate("trilith.run.events.every(e => !e.type.startsWith('bond.') || trilith.run.joints.some(j => j.event === e))")
    page.keys(Keys.END)
    page.evaluate("trilith.colourBy('damage')")
    assert page.evaluate("trilith.way.values(trilith.run.frames - 1, trilith.run.end).some(v => v > 0)")
    page.click("#tab-histories")
    assert page.driver.find_elements("css selector", "#histories canvas.plot")
    page.picture("cracks")


def shows_loops(page):
    """A history over another with the moment in it; a bearing's loop; a plot made large and put back."""
    page.click("#tab-histories")
    page.evaluate("(s => (s.value = 'displacement', s.dispatchEvent(new Event('change'))))(document.getElementById('against'))")
    assert page.evaluate("trilith.histories.plots.length") == 1 and "over displacement" in page.text("#histories figcaption")
    page.keys(Keys.END)
    page.until("!trilith.waiting")
    page.picture("loop")
    far = page.evaluate("trilith.histories.plots[0].nearestTime(...(p => { const b = p.canvas.getBoundingClientRect(), s = p.scales(b.width, b.height), "
                   "k = p.lines[0].values.length >> 1; return [s.x(p.over.values[k]), s.y(p.lines[0].values[k]), b]; })(trilith.histories.plots[0]))")
    assert abs(far - page.evaluate("trilith.histories.plots[0].lines[0].times[trilith.histories.plots[0].lines[0].values.length >> 1]")) < 0.05, far
    height = page.evaluate("trilith.histories.plots[0].canvas.getBoundingClientRect().height")
    page.click("#histories .enlarge")
    assert page.evaluate("document.getElementById('large').open")
    page.until("trilith.histories.plots[0].canvas.getBoundingClientRect().height > 4 * %f" % height)
    page.keys(Keys.ARROW_LEFT)
    assert page.evaluate("trilith.player.time < trilith.run.end")
    page.picture("large")
    page.keys(Keys.ESCAPE)
    page.until("trilith.histories.plots[0].element.closest('#histories')")
    page.evaluate("trilith.select({ bearing: trilith.run.bearings[0] })")
    assert "loop, along" in page.text("#selection"), page.text("#selection")
    page.picture("bearing_loop")


def counts_from_a_stage(page):
    """The menu of the time origin: clock, list of events and plots follow it, and durations do not change."""
    page.keys(Keys.END)
    end, begin = page.evaluate("trilith.run.end"), page.evaluate("trilith.run.stages.at(-1).begin")
    stage = page.text("#stage")
    assert page.text("#clock") == f"{end:.2f} s"
    page.evaluate("(s => (s.value = [...s.options].findLast(o => o.text.endsWith('began')).value, s.dispatchEvent(new Event('change'))))"
             "(document.getElementById('since'))")
    page.until("!trilith.waiting")
    assert page.text("#clock") == f"{end - begin:.2f} s", page.text("#clock")
    assert page.text("#stage") == stage, page.text("#stage")
    page.picture("since")


def counts_from_the_start_it_was_given(page):
    """A page made with --since begins with this origin."""
    page.keys(Keys.END)
    page.until("!trilith.waiting")
    passed = page.evaluate("trilith.run.end - trilith.run.stages.at(-1).begin")
    assert page.text("#clock") == f"{passed:.2f} s", page.text("#clock")


def shows_stress(page):
    """Finite elements have their colours, a body the history of its mean stress."""
    ways = page.evaluate("trilith.ways.map(w => w.id)")
    assert {"stress", "tension", "shear"} <= set(ways), ways
    page.evaluate("trilith.colourBy('stress')")
    cells = page.evaluate("trilith.way.cells(trilith.run.frames - 1)")
    assert len(cells) == page.evaluate("trilith.run.elements.length") and max(cells) > 0
    page.keys(Keys.END)
    page.picture("stress")
    page.evaluate("trilith.select({ body: trilith.run.bodies.find(b => b.free && b.nodes > 1) })")
    assert "mean stress" in page.text("#selection")


def shows_temperature(page):
    """Bodies and elements have the colours of their temperature at the time that is played, a body its history."""
    assert "temperature" in page.evaluate("trilith.ways.map(w => w.id)")
    page.evaluate("trilith.colourBy('temperature')")
    page.keys(Keys.HOME)
    page.until("!trilith.waiting")
    bottom, top = page.evaluate("trilith.way.bottom"), page.evaluate("trilith.way.top")
    assert 2.5 < bottom < 3.1 and 29.9 < top < 30.5, (bottom, top)
    first, last = (page.evaluate(f"trilith.way.values({frame})") for frame in ("0", "trilith.run.frames - 1"))
    names = page.evaluate("trilith.run.bodies.map(b => b.name)")
    kiln, cold = names.index("kiln"), names.index("store")
    assert abs(first[kiln] - 30) < 0.05 and last[kiln] < first[kiln] - 1, (first, last)
    assert last[names.index("bare")] is None, last
    cells = page.evaluate("trilith.way.cells?.(trilith.run.frames - 1) ?? []")
    assert not cells or max(c for c in cells if c is not None) <= top, cells
    low, high = (page.evaluate(f"trilith.colours.at({frame}, 0)[{body}]") for frame, body in
                 (("0", cold), ("0", kiln)))
    assert low != high, (low, high)
    page.picture("temperature at first")
    page.keys(Keys.END)
    page.picture("temperature")
    assert "°C" in page.text("#legend"), page.text("#legend")
    page.evaluate("trilith.select({ body: trilith.run.bodies.find(b => b.name === 'kiln') })")
    assert "temperature" in page.text("#selection")


def plays_a_mode(page):
    """The menu of modes: the first oscillates about its position, space stops it, a key selects the next; back to the run."""
    assert page.evaluate("trilith.run.modes.length") == 3
    page.keys("m")
    page.until("trilith.run.mode && trilith.run.mode.share < -0.5")
    assert page.text("#clock") == "mode 1" and "Hz" in page.text("#stage"), page.text("#stage")
    page.keys(" ")
    # The largest displacement of a node is at most 6 % of the structure's size.
    at = "(share => (trilith.run.mode.share = share, trilith.run.poseMode(), [...trilith.run.nodeX].concat([...trilith.run.nodeY])))"
    ways = [abs(a - b) for a, b in zip(page.evaluate(at + "(1)"), page.evaluate(at + "(-1)"))]
    assert 0.5 * 0.06 * 4.7 < max(ways) / 2 < 1.1 * 0.06 * 4.8, max(ways)
    page.picture("mode")
    page.keys("m")
    assert page.evaluate("trilith.run.mode.index") == 1
    page.keys(Keys.HOME)
    assert page.evaluate("trilith.run.mode === null") and page.text("#clock") == "0.00 s"


def plays_a_mode_in_space(page):
    """As in the plane; nodes move and rotate as in the mode shape, and fixed bodies do not move."""
    assert page.evaluate("trilith.run.dim === 3 && trilith.run.modes.length === 3 && !document.getElementById('modes').hidden")
    for index in range(3):
        page.keys("m")
        page.until("trilith.run.mode && trilith.run.mode.share < -0.5")
        assert page.text("#clock") == f"mode {index + 1}" and "Hz" in page.text("#stage"), page.text("#stage")
        page.keys(" ")
        posed = "(share => (trilith.run.mode.share = share, trilith.run.poseMode(), [[...trilith.run.pointX], [...trilith.run.pointY], [...trilith.run.pointZ]]))"
        one, other = page.evaluate(posed + "(1)"), page.evaluate(posed + "(-1)")
        ways = [sum((a - b) ** 2 for a, b in zip(p, q)) ** 0.5 / 2 for p, q in zip(zip(*one), zip(*other))]
        # The box of the points of free bodies has a diagonal of 5 m: the largest displacement is 6 % of it.
        assert 0.9 * 0.06 * 5 < max(ways) < 1.1 * 0.06 * 5.4, max(ways)
        ground = page.evaluate("trilith.run.bodies.findIndex(b => b.name === 'ground')")
        first, count = page.evaluate(f"[trilith.run.bodies[{ground}].vertex, trilith.run.bodies[{ground}].vertices]")
        assert max(ways[first:first + count]) == 0
        # Points move with their nodes rigidly: the rotation quaternion of a node has length 1, and half of its rotation
        # angle.
        assert page.evaluate("Math.max(...Array.from({ length: trilith.run.nodes }, (_, n) => "
                        "Math.abs(Math.hypot(...trilith.run.quaternion.slice(4 * n, 4 * n + 4)) - 1)))") < 1e-12
        page.evaluate("trilith.draw()")
        page.picture(f"mode_{index + 1}")
    page.keys(Keys.HOME)
    assert page.evaluate("trilith.run.mode === null") and page.text("#clock") == "0.00 s"


def shows_solids(page):
    """A model in space: bodies are where they should be, drawn, turned by a drag, chosen by a click."""
    assert page.evaluate("trilith.run.dim") == 3
    page.evaluate("trilith.run.pose(0.55)")
    found = page.evaluate("[0, 1, 2].map(k => trilith.run.place[3 + k])")
    assert all(abs(a - b) < 2e-4 for a, b in zip(found, (-0.345, 0.11, 0.665))), found
    assert abs(page.evaluate("trilith.run.rotation(trilith.run.bodies[1], 10)") - (1 + 4 + 2.25) ** 0.5) < 2e-3
    page.keys(Keys.END)
    page.until("trilith.player.time === trilith.run.end && !trilith.waiting")
    place = page.evaluate("trilith.camera.place(...trilith.scene.middle(trilith.run.bodies[1]))")
    colour = page.evaluate("""(() => {
      const { gl, canvas, camera } = trilith.scene, pixel = new Uint8Array(4), ratio = canvas.width / camera.width;
      trilith.draw();
      gl.readPixels(%f * ratio, canvas.height - %f * ratio, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return [...pixel];
    })()""" % tuple(place))
    assert colour[0] < 240, colour  # no paper, but a stone in some light
    page.click_canvas(*place)
    assert page.text("#selection-name") == "stone 1", page.text("#selection-name")
    assert page.evaluate("Object.keys(trilith.selection.trail).join()") == "x,y,z"
    for way in page.evaluate("trilith.ways.map(w => w.id)"):
        page.evaluate(f"trilith.colourBy('{way}')")
        page.evaluate("trilith.draw()")
    page.click("#show-forces")
    page.click("#show-start")
    azimuth = page.evaluate("trilith.camera.azimuth")
    chain = ActionChains(page.driver)
    chain.click_and_hold(page.driver.find_element("id", "canvas")).move_by_offset(100, 30).release().perform()
    assert abs(page.evaluate("trilith.camera.azimuth") - (azimuth - 40)) < 1, page.evaluate("trilith.camera.azimuth")
    page.picture("turned")
    page.keys("v")
    assert page.evaluate("trilith.camera.azimuth === -60 && trilith.camera.elevation === 20")
    page.keys("v")
    assert page.evaluate("trilith.camera.azimuth === -90 && trilith.camera.elevation === 0")
    page.picture("front")


def shades_depth(page):
    """Surfaces that others hide from the sky are darker, with a chip; nothing gets lighter, and paper stays."""
    # In a view along an axis, faces are seen edge-on, and rounding decides which of them is in front.
    page.evaluate("trilith.camera.look(-60, 20)")
    lighter, darker, same = page.evaluate("""(() => {
      const { scene } = trilith, { gl, canvas, depthShading } = scene, darken = depthShading.darken;
      scene.show.depth = true;
      // Surfaces alone: a renderer without a graphics card draws lines in another way from picture to picture.
      scene.drawList = (kind, ...rest) => kind === gl.LINES || Object.getPrototypeOf(scene).drawList.call(scene, kind, ...rest);
      const picture = (isDark) => {
        depthShading.darken = (how) => darken.call(depthShading, isDark ? how : { ...how, strength: 0 });
        scene.lastDraw = -Infinity;  // the view rests
        trilith.draw();
        const all = new Uint8Array(4 * canvas.width * canvas.height);
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
        return all;
      };
      const flat = picture(false), deep = picture(true), count = [0, 0, 0];
      depthShading.darken = darken;
      delete scene.drawList;
      for (let i = 0; i < flat.length; i += 4) count[deep[i] > flat[i] + 1 ? 0 : deep[i] < flat[i] - 10 ? 1 : 2]++;
      return count;
    })()""")
    assert lighter < 1e-4 * same and darker > 500 and same > 10 * darker, (lighter, darker, same)
    page.picture("depth")
    page.click("#show-depth")
    assert not page.evaluate("trilith.scene.show.depth")
    page.click("#show-depth")


def cuts_solids(page):
    """A cut across x removes the part in front of it from any view direction; sections are shown and can be clicked."""
    page.keys(Keys.HOME, "x")
    page.until("trilith.player.time === trilith.run.begin && !trilith.waiting")
    page.evaluate("(s => (s.value = '0', s.dispatchEvent(new Event('input'))))(document.getElementById('cut-place'))")
    assert page.text("#cut-told") == "x = 0 m", page.text("#cut-told")
    # The slab alone has a section: four sides.
    assert page.evaluate("trilith.scene.cut.outlines(trilith.run).length") == 4 * 2 * 3
    at = "trilith.scene.bodyAt(...trilith.camera.place(%s))?.index ?? -1"
    stone = "...trilith.scene.middle(trilith.run.bodies[%d])"
    for azimuth, there, gone in ((-60, 1, 2), (120, 2, 1)):
        page.evaluate(f"(trilith.camera.look({azimuth}, 20), trilith.draw())")
        assert page.evaluate(at % (stone % there)) == there
        assert page.evaluate(at % (stone % gone)) != gone
        place = page.evaluate("trilith.camera.place(0, 0, -0.1)")
        assert page.evaluate(at % "0, 0, -0.1") == 0
        assert page.evaluate("trilith.scene.cut.takes([0.01, 0, 0])") == (azimuth == -60)
        # A row of pixels of the section: fill and stripes, both darker than paper.
        shades = page.evaluate("""(() => {
          const { gl, canvas, camera } = trilith.scene, row = new Uint8Array(4 * 16), ratio = canvas.width / camera.width;
          trilith.draw();
          gl.readPixels(%f * ratio, canvas.height - %f * ratio, 16, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
          return [...row].filter((v, i) => i %% 4 === 0);
        })()""" % tuple(place))
        assert max(shades) < 220 and min(shades) < 0.8 * max(shades), shades
    page.picture("cut")
    page.keys("xxx")
    assert not page.evaluate("trilith.scene.cut.isThere") and page.evaluate("document.getElementById('cut-place').hidden")


def shows_cracks_of_solids(page):
    """Joints that have lost their bond are drawn in the colour of their mode, where a solid does not hide them, once they have."""
    colours = page.evaluate("[...new Set(trilith.run.joints.map(j => j.mode))].map(m => ({ tension: [208, 58, 0], shear: [138, 63, 252] })[m])")
    assert colours and all(colours), colours
    count = """(colours => {
      trilith.draw();
      const { gl, canvas } = trilith.scene, all = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
      let found = 0;
      for (let i = 0; i < all.length; i += 4) if (colours.some(c => c.every((v, k) => Math.abs(v - all[i + k]) < 3))) found++;
      return found;
    })(%s)""" % colours
    page.keys(Keys.HOME)
    page.until("trilith.player.time === trilith.run.begin && !trilith.waiting")
    assert page.evaluate(count) == 0
    page.keys(Keys.END)
    page.until("trilith.player.time === trilith.run.end && !trilith.waiting")
    shown = page.evaluate(count)
    assert shown > 100, shown
    assert "crack" in page.text("#legend"), page.text("#legend")
    page.picture("cracks")
    page.click("#show-cracks")
    assert page.evaluate(count) == 0


def shows_where_it_goes(page):
    for key in (Keys.HOME, Keys.END):
        page.keys(key)
        page.until("!trilith.waiting && !trilith.player.playing")
        page.evaluate("trilith.draw()")
        places = page.evaluate("trilith.run.bodies.map(b => trilith.camera.place(...trilith.scene.middle(b)))")
        wide, tall = page.evaluate("[trilith.camera.width, trilith.camera.height]")
        inside = sum(0 < x < wide and 0 < y < tall for x, y in places)
        assert inside >= 0.9 * len(places), (key, inside)


def shows_a_run_in_progress(page):
    assert "still in progress" in page.text("#state")
    page.picture("running")


def shows_a_stopped_run(page):
    assert "stopped before its end" in page.text("#state")


def shows_that_there_is_no_frame(page):
    assert "no frame yet" in page.text("#state")
    page.keys(" ", Keys.END, Keys.ARROW_LEFT, "n", "c", "f")


if __name__ == "__main__":
    opened = Page(sys.argv[1], sys.argv[2])
    for step in sys.argv[3:]:
        globals()[step](opened)
    opened.close()
