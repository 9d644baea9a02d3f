#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Does the page work in a browser? Opens pages in headless Chromium, moves the slider, and looks at the drawing.
#
#   browser_test.py <moivre> <root of the tree>     exit code 77, with the reason, where there is no Chromium
import fcntl
import html
import json
import math
import os
import pathlib
import re
import select
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SKIPPED = 77
PATIENCE = 60  # seconds that the browser may be silent
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
PUMA_POSE = "0.4 -0.2 0.3 0.5 0.5 0.5 0.5"
EVIL = "</script></title><script>document.documentElement.dataset.evil = 1</script>"
# What a hand on the slider does.
MOVE_SLIDER = """<script>
const slider = document.getElementById('time');
slider.value = '0.5';
slider.dispatchEvent(new Event('input'));
</script></body>"""


# What one does who chooses every quantity after the other.
CHOOSE_EACH = """<script>
const chooser = document.getElementById('quantity');
const ticks = [];
for (const option of chooser.options) {
  chooser.value = option.value;
  chooser.dispatchEvent(new Event('change'));
  for (const plot of document.querySelectorAll('.plot')) {
    const texts = [...plot.querySelectorAll('.tick[text-anchor="end"]')].map((tick) => tick.textContent);
    ticks.push({name: option.textContent + ' ' + plot.id, hidden: plot.hidden, texts});
  }
}
document.body.dataset.ticks = JSON.stringify(ticks);
</script></body>"""


# What one does who saves the plots, hides the first branch and enlarges the second.
USE_CONTROLS = """<script>
URL.createObjectURL = (blob) => { blob.text().then((text) => { document.body.dataset.csv = text.slice(0, 3000); }); return '#'; };
document.getElementById('save').click();
document.querySelector('#legend button').click();
document.querySelectorAll('#panels figcaption')[1].click();
</script></body>"""


# What one does who hides the second branch and saves the others as an animation.
ANIMATE = """<script>
URL.createObjectURL = (blob) => { blob.text().then((text) => { document.body.dataset.svg = text; }); return '#'; };
document.querySelectorAll('#legend button')[1].click();
document.getElementById('animate').click();
</script></body>"""


# How many names cover another one, at some times of the motion. A line of text is higher than its letters by a sixth.
COVERED = """<script>
const share = (p, q) => Math.max(0, Math.min(p.right, q.right) - Math.max(p.left, q.left) - 1) *
  Math.max(0, Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) - p.height / 6 - 1);
let covered = 0;
for (let k = 0; k <= 20; ++k) {
  const slider = document.getElementById('time');
  slider.value = String(k / 20);
  slider.dispatchEvent(new Event('input'));
  for (const panel of document.querySelectorAll('#panels figure')) {
    const boxes = [...panel.querySelectorAll('text[data-label]')].map((name) => name.getBoundingClientRect());
    boxes.forEach((box, i) => boxes.slice(0, i).forEach((other) => { covered += share(box, other) > 0 ? 1 : 0; }));
  }
}
document.body.dataset.covered = String(covered);
</script></body>"""


# What one does who looks at a spatial mechanism's closures, drags one of them, and double clicks.
TURN = """<script>
const shots = () => canvases.map((canvas) => canvas.toDataURL());
const written = [];
const write = CanvasRenderingContext2D.prototype.fillText;
CanvasRenderingContext2D.prototype.fillText = function(name, x, y) {
  written.push({name, x, y, width: this.measureText(name).width, size: parseFloat(this.font)});
  write.call(this, name, x, y);
};
draw(canvases[0], data.closures[0]);
CanvasRenderingContext2D.prototype.fillText = write;
const before = shots();
canvases[0].dispatchEvent(new PointerEvent('pointermove', {buttons: 1, movementX: 60, movementY: 25}));
const after = shots();
canvases[0].dispatchEvent(new MouseEvent('dblclick'));
const captions = [...document.querySelectorAll('figcaption')];
document.body.dataset.seen = JSON.stringify({
  panels: captions.map((caption) => caption.innerText),
  shown: canvases.map((canvas) => canvas.clientWidth > 150 && canvas.clientHeight > 150),
  clipped: captions.filter((caption) => caption.scrollWidth > caption.clientWidth + 1).length,
  small: captions.filter((caption) => parseFloat(getComputedStyle(caption).fontSize) < 12).length,
  different: new Set(before).size,
  turned: after.filter((shot, k) => shot !== before[k]).length,
  back: shots().filter((shot, k) => shot === before[k]).length,
  tops: captions.map((caption) => caption.getBoundingClientRect().top),
  written, width: canvases[0].clientWidth, height: canvases[0].clientHeight});
</script></body>"""


# What one does who points at the picture of a sweep, at shares of its plot.
POINT_AT = """<script>
const picture = document.querySelector('#picture svg');
const plot = JSON.parse(document.getElementById('data').textContent).plot;
const box = picture.getBoundingClientRect();
const at = (share, from, to, pixels, all) => (from + share * (to - from)) / all * pixels;
picture.dispatchEvent(new PointerEvent('pointermove', {
  clientX: box.left + at(%s, plot[0], plot[2], box.width, picture.viewBox.baseVal.width),
  clientY: box.top + at(%s, plot[3], plot[1], box.height, picture.viewBox.baseVal.height)}));
</script></body>"""


class Browser:
    """One headless Chromium for all pages: it takes a second to start. It is spoken to over two pipes in its DevTools protocol."""

    def __init__(self, program, folder):
        heard, self.commands = os.pipe()
        self.answers, spoken = os.pipe()
        self.buffer = b""
        self.events = []
        self.asked = 0

        def connect():
            ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (heard, spoken)]
            for place, end in zip((3, 4), ends):
                os.dup2(end, place)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile", "--remote-debugging-pipe"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=connect, pass_fds=(3, 4))
        os.close(heard)
        os.close(spoken)

    def __enter__(self):
        return self

    def __exit__(self, *failure):
        try:
            if self.process.poll() is None and failure[0] is None:
                self.ask("Browser.close")
                self.process.wait(timeout=PATIENCE)
        finally:
            self.process.kill()
            self.process.wait()

    def next_message(self):
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.answers], [], [], PATIENCE)
            expect(ready, f"the browser speaks within {PATIENCE} seconds")
            part = os.read(self.answers, 1 << 16)
            expect(part, "the browser runs to the end")
            self.buffer += part
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, session=None, **parameters):
        self.asked += 1
        command = {"id": self.asked, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        os.write(self.commands, json.dumps(command).encode() + b"\0")
        while (answer := self.next_message()).get("id") != self.asked:
            self.events.append(answer)
        expect("result" in answer, f"the browser obeys: {answer}")
        return answer["result"]

    def wait_for(self, event, session):
        """Events may come before the answer to what brings them about."""
        def is_meant(message):
            return message.get("method") == event and message.get("sessionId") == session

        if any(map(is_meant, self.events)):
            return
        while not is_meant(self.next_message()):
            pass

    def dom(self, page, address=""):
        """The document after its script has run for two seconds of its own time."""
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.ask("Emulation.setDeviceMetricsOverride", session, width=1300, height=1000, deviceScaleFactor=1, mobile=False)
        self.ask("Page.enable", session)
        self.events.clear()
        self.ask("Page.navigate", session, url=f"file://{page}{address}")
        self.wait_for("Page.loadEventFired", session)
        self.events.clear()
        self.ask("Emulation.setVirtualTimePolicy", session, policy="advance", budget=2000)
        self.wait_for("Emulation.virtualTimeBudgetExpired", session)
        dom = self.ask("Runtime.evaluate", session, expression="document.documentElement.outerHTML")["result"]["value"]
        self.ask("Target.closeTarget", targetId=target)
        return dom


def transforms(dom):
    return re.findall(r'<g data-frame="\d+" transform="([^"]*)"', dom)


def readout(dom):
    found = re.search(r'<output id="readout">([^<]*)', dom)
    return html.unescape(found.group(1)) if found else ""


def expect(holds, what):
    if not holds:
        sys.exit(f"failed: {what}")


def expect_works(dom, name):
    expect('data-state="ready"' in dom, f"{name}: the script ran to its end")
    expect(re.search(r'<p id="error">\s*</p>', dom), f"{name}: no error is shown")
    expect("NaN" not in dom.split('<script type="application/json"')[0], f"{name}: every number is one")


def page_of(moivre, folder, command, mechanism, *options):
    page = folder / f"{command}-{pathlib.Path(mechanism).stem}.html"
    subprocess.run([moivre, command, mechanism, "--quiet", "--html", page, *options], check=True)
    return page


def check_motion(browser, page):
    first = browser.dom(page)
    expect_works(first, page.name)
    later = browser.dom(page, "#t=0.05&plot=1")
    expect_works(later, page.name)
    expect(readout(later).startswith("t = 0.05 s"), f"{page.name}: the address sets the time, not {readout(later)!r}")
    expect(transforms(first) and len(transforms(first)) == len(transforms(later)), f"{page.name}: as many figures")
    expect(transforms(first) != transforms(later), f"{page.name}: another time, another drawing")
    expect(first.count("class=\"curve") >= 3, f"{page.name}: three plots have curves")
    for unit in ("/s]", "/s²]"):
        expect(unit in later, f"{page.name}: an axis in {unit}")


def check_ticks(browser, page):
    """Every axis of every quantity has numbers to be read off."""
    chosen = page.with_name("ticks.html")
    chosen.write_text(page.read_text().replace("</body>", CHOOSE_EACH))
    dom = browser.dom(chosen)
    expect_works(dom, chosen.name)
    ticks = json.loads(html.unescape(re.search(r'data-ticks="([^"]*)"', dom).group(1)))
    expect(len(ticks) == 3 * page.read_text().count("<option"), f"{page.name}: three plots of every quantity")
    for plot in ticks:
        numbers = [text for text in plot["texts"] if re.fullmatch(r"-?[\d.e+-]+", text)]
        expect(len(numbers) >= 3 or plot["hidden"], f"{page.name}: {plot['name']} has three ticks, not {plot['texts']}")


def check_slider(browser, page):
    moved = page.with_name("moved.html")
    moved.write_text(page.read_text().replace("</body>", MOVE_SLIDER))
    dom = browser.dom(moved)
    expect_works(dom, moved.name)
    expect(transforms(dom) != transforms(browser.dom(page)), "a hand on the slider moves the drawing")
    expect(not readout(dom).startswith("t = 0 s"), "and the readout")


def check_names_of_parts(browser, page):
    moved = page.with_name("covered.html")
    moved.write_text(page.read_text().replace("</body>", COVERED))
    dom = browser.dom(moved)
    expect_works(dom, moved.name)
    covered = int(re.search(r'data-covered="(\d+)"', dom).group(1))
    expect(covered == 0, f"{page.name}: no name covers another one while it moves, not {covered}")


def check_controls(browser, page):
    plain = browser.dom(page, "#plot=0")
    used = page.with_name("used.html")
    used.write_text(page.read_text().replace("</body>", USE_CONTROLS))
    dom = browser.dom(used)
    expect_works(dom, used.name)
    csv = html.unescape(re.search(r'data-csv="([^"]*)"', dom).group(1)).split("\n")
    expect(csv[0].startswith("branch,t,driver crank [deg],"), f"the table's head: {csv[0][:80]!r}")
    expect("joint B.velocity [deg/s]" in csv[0] and "coupler-rocker transmission [deg]" in csv[0],
           "the table has the chosen quantities")
    expect(csv[1].startswith("A,0,40,") and csv[1].count(",") == csv[0].count(","), f"its first row: {csv[1][:80]!r}")
    expect('id="panel-0" hidden' in dom, "a click on a name in the legend hides its branch")
    expect('id="panel-1" class="large"' in dom, "a click on a panel's name enlarges it")
    curves = lambda text: text.count('class="curve')
    expect(curves(dom) == curves(plain) // 2, "the hidden branch has no curves")
    last = plain.count("<option") - 1
    alone = browser.dom(page, f"#plot={last}")
    expect('id="plot-velocity" hidden' in alone, "what has no velocity has one plot")


def check_animation(browser, page):
    """The saved animation needs no page, shows what is not hidden, and has each frame where the page's data have it."""
    used = page.with_name("animated.html")
    used.write_text(page.read_text().replace("</body>", ANIMATE))
    dom = browser.dom(used)
    expect_works(dom, used.name)
    svg = html.unescape(re.search(r'data-svg="([^"]*)"', dom).group(1))
    root = xml.etree.ElementTree.fromstring(svg)
    expect(root.tag == "{http://www.w3.org/2000/svg}svg", "the animation is an SVG document")
    expect("<script" not in svg and "NaN" not in svg and "http://" not in svg.replace("http://www.w3.org/2000/svg", ""),
           "without a script, a fault, or anything from elsewhere")
    data = json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page.read_text(), re.S).group(1))
    panels = len(root.findall("{http://www.w3.org/2000/svg}svg"))
    expect(panels == len(data["branches"]) - 1, f"a panel for every branch that is shown, not {panels}")
    figures = re.findall(r'data-frame="(\d+)"', page.read_text().split('id="panel-1"')[0])
    branch = data["branches"][0]
    for figure, frame in zip(root.find("{http://www.w3.org/2000/svg}svg").findall("{http://www.w3.org/2000/svg}g"), map(int, figures), strict=True):
        check_moves(figure, [row[4 * frame:4 * frame + 4] for row in branch["frames"]])


def check_moves(figure, frames):
    """An animated figure is where its frame is: shift, turn and stretch, a value each at each sample."""
    moves = {move.get("type"): move for move in figure.findall("{http://www.w3.org/2000/svg}animateTransform")}
    values = {kind: move.get("values").split(";") for kind, move in moves.items()}
    times = [float(time) for time in moves["translate"].get("keyTimes").split(";")]
    expect(times[0] == 0 and times[-1] == 1 and times == sorted(times), "times go from 0 to 1")
    expect(all(len(of) == len(times) for of in values.values()), "each time has a value")
    frames = frames[::-(-len(frames) // 120)]
    for k, (a, b, e, f) in enumerate(frames[:len(times)]):
        x, y = map(float, values["translate"][k].split())
        turn = math.radians(float(values["rotate"][k]))
        stretch = float(values["scale"][k]) if "scale" in values else 1
        off = max(abs(x - e), abs(y - f), 100 * abs(stretch * math.cos(turn) - a), 100 * abs(stretch * math.sin(turn) - b))
        expect(off < 0.03, f"sample {k} is {off} pixels off")
    turns = [float(turn) for turn in values["rotate"]]
    expect(all(abs(turn - before) < 180 for before, turn in zip(turns, turns[1:])), "no figure turns back at half a turn")


def check_turning(browser, page, panels, rows):
    """The panels' captions. Every closure is drawn, none like another, and a hand turns them all and brings them back."""
    handled = page.with_name("turned.html")
    handled.write_text(page.read_text().replace("</body>", TURN))
    dom = browser.dom(handled)
    expect_works(dom, page.name)
    seen = json.loads(html.unescape(re.search(r'data-seen="([^"]*)"', dom).group(1)))
    expect(len(seen["panels"]) == panels and all(seen["shown"]), f"{page.name}: {panels} panels are shown")
    lengths = [seen["tops"].count(top) for top in sorted(set(seen["tops"]))]
    expect(lengths == [panels // rows] * rows, f"{page.name}: in {rows} rows of one length, not {lengths}")
    expect(seen["clipped"] == 0 and seen["small"] == 0, f"{page.name}: captions are legible")
    expect(seen["different"] == panels, f"{page.name}: no two closures look alike")
    expect(seen["turned"] == panels, f"{page.name}: the mouse turns every panel")
    expect(seen["back"] == panels, f"{page.name}: a double click brings the view back")
    check_written(seen, page.name)
    return seen["panels"]


def check_written(seen, page):
    """Names in a picture are inside it, and none is written over another."""
    words = seen["written"]
    expect(words, f"{page}: places have names")
    for k, a in enumerate(words):
        expect(a["size"] >= 11, f"{page}: {a['name']} is large enough to be read")
        expect(0 <= a["x"] and a["x"] + a["width"] <= seen["width"] and 0 <= a["y"] <= seen["height"],
               f"{page}: {a['name']} is inside the picture")
        for b in words[:k]:
            beside = a["x"] + a["width"] <= b["x"] or b["x"] + b["width"] <= a["x"]
            expect(beside or abs(a["y"] - b["y"]) >= 9, f"{page}: {a['name']} is not written over {b['name']}")


def check_arm(browser, moivre, root, folder):
    page = page_of(moivre, folder, "closures", root / "problems/robots/puma560.urdf", "--pose", PUMA_POSE)
    captions = check_turning(browser, page, 8, 2)
    for shoulder in ("left", "right"):
        for elbow in ("up", "down"):
            for wrist in ("no flip", "flip"):
                name = f"shoulder {shoulder}, elbow {elbow}, {wrist}\n"
                expect(sum(name in caption for caption in captions) == 1, f"one posture is called {name!r}")


def seen_closures(dom):
    return len(re.findall(r"<figure>", dom.split('<div id="closures">')[1].split("<script")[0]))


def check_sweep(browser, moivre, root, folder):
    """A hand on the picture shows the closures of the sample below it, as many as it has."""
    mechanisms = root / "problems/mechanisms"
    curve = page_of(moivre, folder, "sweep", mechanisms / "four-bar.toml", "--vary", "crank.A.x=10:299:100")
    for share, closures in ((0.5, 2), (0.95, 0)):
        pointed = curve.with_name("pointed.html")
        pointed.write_text(curve.read_text().replace("</body>", POINT_AT % (share, 0.5)))
        dom = browser.dom(pointed)
        expect_works(dom, "a sweep over one number")
        expect(seen_closures(dom) == closures, f"{closures} closures at {share} of the range, not {seen_closures(dom)}")
        expect(f"2 complex closures, {closures} real" in dom, "which the page says")
    square = page_of(moivre, folder, "sweep", mechanisms / "3-rpr.toml", "--vary", "leg 1.length=8:24:17", "--vary",
                     "leg 2.length=8:24:9")
    dom = browser.dom(square, "#at=12,20")
    expect_works(dom, "a sweep over two numbers")
    expect(">12 <" in dom and ">20 <" in dom, "the address chooses the sample")
    expect(seen_closures(dom) == 4, f"a platform has 4 closures there, not {seen_closures(dom)}")
    expect(dom.split('<div id="closures">')[1].count('class="rod"') == 12, "with three legs each")


def check_names(browser, moivre, root, folder):
    text = (root / "problems/mechanisms/four-bar.toml").read_text()
    mechanism = folder / "evil.toml"
    mechanism.write_text(re.sub(r'title = ".*"', f"title = '{EVIL}'", text))
    dom = browser.dom(page_of(moivre, folder, "motion", mechanism))
    expect_works(dom, "evil names")
    expect("data-evil" not in dom, "no name runs as a script")
    expect(html.escape(EVIL, quote=False) in dom, "the title is shown as it is")


def main():
    moivre, root = sys.argv[1], pathlib.Path(sys.argv[2])
    program = next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        print("skipped: no Chromium here (scripts/install-dependencies --browser installs it)")
        sys.exit(SKIPPED)
    mechanisms = root / "problems/mechanisms"
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name, Browser(program, name) as browser:
        folder = pathlib.Path(name)
        four_bar = page_of(moivre, folder, "motion", mechanisms / "four-bar.toml")
        check_motion(browser, four_bar)
        check_ticks(browser, four_bar)
        check_slider(browser, four_bar)
        check_names_of_parts(browser, four_bar)
        check_names_of_parts(browser, page_of(moivre, folder, "motion", root / "tests/trial/files/eightbar.toml"))
        check_animation(browser, four_bar)
        check_animation(browser, page_of(moivre, folder, "motion", mechanisms / "stephenson-3.toml"))
        check_controls(browser, page_of(moivre, folder, "motion", mechanisms / "four-bar.toml", "--columns",
                                        "joints,transmission"))
        check_motion(browser, page_of(moivre, folder, "motion", mechanisms / "slider-crank-equations.toml"))
        check_motion(browser, page_of(moivre, folder, "motion", mechanisms / "rssr.toml", "--from-guess"))
        check_motion(browser, page_of(moivre, folder, "closures", mechanisms / "whitworth.toml"))
        expect_works(browser.dom(page_of(moivre, folder, "closures", mechanisms / "3-rpr.toml")), "closures that stand")
        check_arm(browser, moivre, root, folder)
        check_turning(browser, page_of(moivre, folder, "closures", mechanisms / "octahedral-3-3.toml"), 4, 2)
        postures = check_turning(browser, page_of(moivre, folder, "closures", mechanisms / "puma-560.toml"), 8, 2)
        expect(all("J6 " in caption for caption in postures), "joints' values tell postures apart that look alike")
        check_sweep(browser, moivre, root, folder)
        check_names(browser, moivre, root, folder)
    print("the pages work")


main()
