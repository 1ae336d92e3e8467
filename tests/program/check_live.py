"""trilith live: serves a run on this machine alone while it is computed, and its page follows to the end.

usage: check_live.py PROGRAM FOLDER
"""
import os
import re
import shutil
import socket
import subprocess
import sys
import time
import urllib.request

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
program, folder = (os.path.abspath(a) for a in sys.argv[1:3])
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
for pipe in ("go_on", "end"):
    os.mkfifo(os.path.join(folder, pipe))
LONGEST = 400  # s for anything that is waited for, which ends the wait when it happens; only a hang takes so long

# The script waits after the first part of the run until its pipe is opened, so each state is seen. It takes no processor
# time meanwhile.
SCRIPT = """
local trilith = require "trilith"
local m = trilith.model { name = "falling block" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
m:block { name = "block", width = 0.5, height = 0.3, at = { 0, 0.2 }, material = "stone", floating = true }
m:results { file = "live.h5", frames = 0.01 }
local function wait(name) io.open(name):close() end
m:run { duration = 0.1 }
wait "go_on"
m:run { duration = 0.1 }
wait "end"
"""


def get(url, host=None, method="GET"):
    request = urllib.request.Request(url, method=method)
    if host:
        request.add_header("Host", host)
    try:
        with urllib.request.urlopen(request, timeout=LONGEST) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def until(what, condition):
    end = time.time() + LONGEST
    while not condition():
        assert time.time() < end, f"not in {LONGEST} s: {what}"
        time.sleep(0.1)


def frames(base):
    found = re.match(r"\S+ (\d+) (\w+)$", get(base + "state")[1])
    return (int(found[1]), found[2]) if found else (0, "waiting")


def release(name):
    """The script that waits for this pipe goes on."""
    with open(os.path.join(folder, name), "w", encoding="utf-8"):
        pass


def refuses(base, port):
    """Other hosts, methods and paths; other addresses of this machine."""
    assert get(base, host="evil.example")[0] == 403
    assert get(base, host=f"evil.example:{port}")[0] == 403
    assert get(base, host=f"localhost:{port}")[0] == 200
    assert get(base, method="POST")[0] == 405
    assert get(base + "../etc/passwd")[0] == 404 and get(base + "live.h5")[0] == 404
    with socket.create_connection(("127.0.0.1", port)) as slow:  # others are answered, and its own request when it comes
        assert get(base + "state")[0] == 200
        slow.sendall(b"GET /state HTTP/1.1\r\n")
        time.sleep(1)
        assert get(base + "state")[0] == 200
        slow.sendall(f"Host: 127.0.0.1:{port}\r\n\r\n".encode())
        assert slow.recv(100).startswith(b"HTTP/1.1 200")
    with socket.create_connection(("127.0.0.1", port)) as damaged:
        damaged.sendall(b"\x00\xff\r\n\r\n")
        assert damaged.recv(100).startswith(b"HTTP/1.1 400")
    # Every address 127.x.y.z is this machine, but only 127.0.0.1 is listened on.
    with socket.socket() as other:
        assert other.connect_ex(("127.0.0.2", port)) != 0


def open_page(base):
    """The page in a browser; None where there is none."""
    try:
        import view_page
        browser = view_page.open_browser()
    except (SystemExit, ImportError):
        print("the page was not opened: there is no Chromium with its driver and python3-selenium")
        return None
    browser.get(base)
    return browser


def follows(browser, count):
    """The page shows all frames, at the end."""
    ready = ("return document.documentElement.dataset.live === 'true' && window.trilith !== undefined && "
             f"trilith.run.frames >= {count} && trilith.player.time === trilith.run.end")
    until(f"the page shows {count} frames at their end", lambda: browser.execute_script(ready))


def keeps_its_view(browser):
    """A page that was zoomed, and set to an earlier time, stays there."""
    browser.execute_script("trilith.camera.scale *= 1.5; trilith.camera.isHome = false; trilith.player.seek(0.05)")
    return browser.execute_script("return trilith.camera.scale")


def main():
    with open(os.path.join(folder, "live.lua"), "w", encoding="utf-8") as file:
        file.write(SCRIPT)
    server = subprocess.Popen([program, "live", "live.h5"], cwd=folder, stdout=subprocess.PIPE, text=True)
    run, browser = None, None
    try:
        line = server.stdout.readline()
        base, port = re.match(r"(http://127\.0\.0\.1:(\d+)/) follows live\.h5; Ctrl-C ends it$", line.strip()).groups()
        port = int(port)
        status, page = get(base)
        assert status == 200 and "Waiting for results in live.h5" in page and 'data-stamp="waiting' in page
        refuses(base, port)
        again = subprocess.run([program, "live", "live.h5", "--port", str(port)], cwd=folder, capture_output=True, text=True,
                               timeout=LONGEST)
        assert again.returncode == 1 and f"port {port} cannot be used" in again.stderr, again.stderr
        browser = open_page(base)
        run = subprocess.Popen([program, "run", "--trust", "--quiet", "live.lua"], cwd=folder)
        until("11 frames while the run waits", lambda: frames(base) == (11, "running") or run.poll() is not None)
        assert run.poll() is None, "the run ended early"
        if browser:
            follows(browser, 11)
            scale = keeps_its_view(browser)
        release("go_on")
        until("more frames", lambda: frames(base)[0] >= 20)
        if browser:
            until("the page was loaded again", lambda: browser.execute_script(
                "return document.documentElement.dataset.live === 'true' && trilith.run.frames >= 20"))
            kept = browser.execute_script("return [trilith.player.time, trilith.camera.scale]")
            assert abs(kept[0] - 0.05) < 1e-9 and abs(kept[1] - scale) < 1e-9 * scale, kept
            browser.save_screenshot(os.path.join(folder, "live.png"))
        release("end")
        assert run.wait(LONGEST) == 0
        until("the end", lambda: frames(base)[1] == "ended")
        page = get(base)[1]
        assert "</html>" in page and "falling block" in page and page.count("data-stamp=") == 1
        # The page of trilith view is not a live one.
        subprocess.run([program, "view", "live.h5"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "live.html"), encoding="utf-8") as file:
            assert "trilith-live" not in file.read()
    finally:
        if browser:
            browser.quit()
        for process in (server, run):
            if process and process.poll() is None:
                process.kill()
                process.wait()


main()
