#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Does the page work in a browser? Opens pages in headless Chromium, moves the slider, and looks at the drawing.
#
#   browser_test.py <moivre> <root of the tree>     exit code 77, with the reason, where there is no Chromium
import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
EVIL = "</script></title><script>document.documentElement.dataset.evil = 1</script>"
# What a hand on the slider does.
MOVE_SLIDER = """<script>
const slider = document.getElementById('time');
slider.value = '0.5';
slider.dispatchEvent(new Event('input'));
</script></body>"""


# What one does who saves the plots, hides the first branch and enlarges the second.
USE_CONTROLS = """<script>
URL.createObjectURL = (blob) => { blob.text().then((text) => { document.body.dataset.csv = text.slice(0, 3000); }); return '#'; };
document.getElementById('save').click();
document.querySelector('#legend button').click();
document.querySelectorAll('#panels figcaption')[1].click();
</script></body>"""


class Browser:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def dom(self, page, address=""):
        """The document after its script has run."""
        done = subprocess.run(
            [self.program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={self.folder}/profile",
             "--virtual-time-budget=2000", "--dump-dom", f"file://{page}{address}"],
            capture_output=True, text=True, timeout=60)
        return done.stdout


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


def check_slider(browser, page):
    moved = page.with_name("moved.html")
    moved.write_text(page.read_text().replace("</body>", MOVE_SLIDER))
    dom = browser.dom(moved)
    expect_works(dom, moved.name)
    expect(transforms(dom) != transforms(browser.dom(page)), "a hand on the slider moves the drawing")
    expect(not readout(dom).startswith("t = 0 s"), "and the readout")


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
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        browser = Browser(program, folder)
        four_bar = page_of(moivre, folder, "motion", mechanisms / "four-bar.toml")
        check_motion(browser, four_bar)
        check_slider(browser, four_bar)
        check_controls(browser, page_of(moivre, folder, "motion", mechanisms / "four-bar.toml", "--columns",
                                        "joints,transmission"))
        check_motion(browser, page_of(moivre, folder, "motion", mechanisms / "slider-crank-equations.toml"))
        check_motion(browser, page_of(moivre, folder, "motion", mechanisms / "rssr.toml", "--from-guess"))
        check_motion(browser, page_of(moivre, folder, "closures", mechanisms / "whitworth.toml"))
        expect_works(browser.dom(page_of(moivre, folder, "closures", mechanisms / "3-rpr.toml")), "closures that stand")
        expect_works(browser.dom(page_of(moivre, folder, "closures", root / "problems/robots/puma560.urdf",
                                         "--pose", "0.4 -0.2 0.3 0.5 0.5 0.5 0.5")), "a robot's postures")
        check_names(browser, moivre, root, folder)
    print("the pages work")


main()
