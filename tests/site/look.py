#!/usr/bin/env python3
"""Opens the site in headless Chromium: look.py SITE PICTURES

Light and dark, 1440 and 420 pixels wide: no error on the console, no page wider than the window, formulas set, terms found by the
search. Ends with 77 and a line where Chromium, its driver or selenium are missing."""
import os
import re
import shutil
import sys
import time

from searches import SEARCHES

SKIPPED = 77
PAGES = ["index", "docs/README", "docs/guide/bridges", "docs/guide/restart", "docs/guide/space", "docs/gallery/index", "docs/gallery/wall",
         "docs/theory/contact", "docs/theory/time", "docs/reference/laws", "docs/glossary", "docs/changelog", "docs/verification",
         "docs/verification/bearings", "genindex", "scripts/bridge"]


def skipped(reason):
    print(f"skipped: {reason}; ./dev deps installs it")
    sys.exit(SKIPPED)


try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    skipped("python3-selenium is not installed")


def browser(width):
    chromium, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not chromium or not driver:
        skipped("chromium or chromium-driver is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for flag in ("--headless=new", "--disable-dev-shm-usage", "--hide-scrollbars", f"--window-size={max(width, 500)},1000"):
        options.add_argument(flag)
    if os.getuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    page = webdriver.Chrome(service=Service(driver), options=options)
    page.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": False})
    return page


def choose(page, theme):
    """Clicks the button for light and dark until the page has the theme."""
    for _ in range(3):
        if page.execute_script("return document.body.dataset.theme") == theme:
            break
        page.execute_script("document.querySelector('.theme-toggle').click()")
    ground = page.execute_script("return getComputedStyle(document.body).backgroundColor")
    light = sum(int(part) for part in re.findall(r"\d+", ground)[:3]) / 3
    return [] if (light < 100) == (theme == "dark") else [f"the ground of theme {theme} is {ground}"]


def until(page, condition, seconds=15):
    end = time.time() + seconds
    while not page.execute_script("return " + condition):
        if time.time() > end:
            return False
        time.sleep(0.05)
    return True


def errors_of(page, name, width):
    found = [f"{name}: {entry['message']}" for entry in page.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]
    wide = page.execute_script("return document.documentElement.scrollWidth")
    if wide > width:
        found.append(f"{name}: {wide} pixels wide in a window of {width}")
    unset = page.execute_script("return [...document.querySelectorAll('.formula')].filter(f => !f.querySelector('.katex')).length")
    formula_errors = page.execute_script("return [...document.querySelectorAll('.katex-error')].map(e => e.title).join('; ')")
    broken = page.execute_script("return [...document.images].filter(i => i.complete && !i.naturalWidth).map(i => i.src).join(' ')")
    found += [f"{name}: {unset} formulas are not set"] if unset else []
    found += [f"{name}: {formula_errors}"] if formula_errors else []
    found += [f"{name}: no picture at {broken}"] if broken else []
    return found


def look(site, pictures, width, dark):
    page, found, kind = browser(width), [], f"{width}-{'dark' if dark else 'light'}"
    theory = sorted("docs/theory/" + name[:-5] for name in os.listdir(os.path.join(site, "docs/theory")) if name.endswith(".html"))
    for name in PAGES + [each for each in theory if each not in PAGES]:
        page.get(f"file://{site}/{name}.html")
        until(page, "document.readyState === 'complete'")
        if name == PAGES[0]:
            found += choose(page, "dark" if dark else "light")
        time.sleep(0.3 if name in PAGES else 0)
        found += errors_of(page, f"{name} ({kind})", width)
        if name in PAGES:
            page.save_screenshot(os.path.join(pictures, f"{name.replace('/', '_')}-{kind}.png"))
    page.quit()
    return found


def search(site, pictures):
    page, found = browser(1440), []
    for term, wanted in SEARCHES.items():
        page.get(f"file://{site}/search.html?q={term.replace(' ', '+')}")
        if not until(page, "document.querySelectorAll('#search-results li').length > 0"):
            found.append(f"the search finds nothing for '{term}'")
            continue
        time.sleep(1.5)
        links = page.execute_script("return [...document.querySelectorAll('#search-results li a')].map(a => a.href)")
        if wanted + ".html" not in links[0]:
            found.append(f"{wanted} is not the first result for '{term}': " + " ".join(link.split("/")[-1] for link in links[:5]))
        page.save_screenshot(os.path.join(pictures, f"search_{term.replace(' ', '_')}.png"))
        found += errors_of(page, f"search for '{term}'", 1440)
    page.quit()
    return found


def main(site, pictures):
    site = os.path.abspath(site)
    if not os.path.exists(os.path.join(site, "index.html")):
        print(f"skipped: {site} is not built; ./dev docs installs the tools for it")
        return SKIPPED
    os.makedirs(pictures, exist_ok=True)
    found = []
    for width, dark in ((1440, False), (1440, True), (420, False), (420, True)):
        found += look(site, pictures, width, dark)
    found += search(site, pictures)
    print("".join(line + "\n" for line in found), end="")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
