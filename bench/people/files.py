# SPDX-License-Identifier: MIT
"""What is the truth of each mechanism and polynomial system that people typed, and is an answer right?"""
import json
import math
import pathlib
import tempfile
from decimal import Decimal

from answers import RIGHT, UNDECIDED, WRONG, Verdict, whole, worst

CASES = {}


def case(file, truth):
    """Of a file: its truth in words, and a judge that asks the program and compares."""
    def keep(judge):
        CASES[file] = (truth, judge)
        return judge
    return keep


def compare(answer, *facts):
    """Facts are pairs: whether it is so, and what is said if it is not."""
    unsound = whole(answer)
    if unsound:
        return unsound
    failed = [said for holds, said in facts if not holds]
    return Verdict(WRONG, "; ".join(failed)) if failed else Verdict(RIGHT, "")


def counted(answer, complex_count, real_count, moves=False):
    counts = (answer.json or {}).get("counts", {})
    return [((counts.get("complex"), counts.get("real")) == (complex_count, real_count), f"counts {counts}"),
            (bool((answer.json or {}).get("moves")) == moves, "moves" if not moves else "does not move")]


# A drawing's lengths are rounded: its closure, in radians and the unit of length, is so near the coordinates 0 of the drawing.
DRAWN = 0.05


def is_drawn(closures):
    return len(closures) == 1 and all(abs(x) < DRAWN for x in closures[0]["coordinates"].values())


def near(a, b, within=1e-6):
    return abs(a - b) <= within * max(1, abs(b))


@case("actuator-coefficients.toml", "d boom.phi/d lift = 1.4368424 at L = 2, d lift/d lift = 1; 2 branches")
def actuator(ask, file):
    answer = ask("motion", file, "--columns", "coefficients,advantage")
    branches = (answer.json or {}).get("branches", [])
    first = sorted(b["samples"][0]["columns"] for b in branches)
    return compare(answer, (len(branches) == 2, f"{len(branches)} branches"),
                   (len(first) == 2 and all(near(c[0], s * 1.4368424) and near(c[2], 1) and near(c[4], 1 / 1.4368424)
                                             for s, c in zip((-1, 1), first)), f"columns {first}"))


def only_counted(name, truth, *counts, **more):
    """A mechanism of which nothing but the counts of its closures is asked."""
    @case(name, truth)
    def closures(ask, file):
        answer = ask("closures", file)
        return compare(answer, *counted(answer, *counts, **more))


only_counted("burmester-5-moves.toml", "4 closures, all real; nothing moves", 4, 4)
only_counted("cardan-single.toml", "2 closures", 2, 2)
only_counted("scissor-6-undecided.toml", "256 isolated closures, 128 real, and a set that moves", 256, 128, moves=True)


# A leg whose four-bar is a parallelogram turns the plate about its own motor's axis alone: three such legs leave it parallel, at the two points where three
# spheres meet, and each leg has two ways to each. A leg whose four-bar is crossed leaves the plate's pose too many equations: their ideal is 1 (Singular,
# modulo 2147483647, all seven choices).
only_counted("delta-maryland.toml", "16 closures, all real: 2 places of the plate, 2 ways of each leg", 16, 16)


@case("fit-not-assembled.toml", "with a fit of 0.05 the drawn pose closes to 0.0043 mm; motion follows it")
def fit(ask, file):
    verdicts = []
    for time in ("0", "0.1", "0.2"):
        answer = ask("closures", file, "--fit", "0.05", "--at", time)
        closures = [c for c in (answer.json or {}).get("closures", []) if c["fitted"] and c["misfit"] <= 0.05]
        drawn = [c for c in closures if c["drawn"] and near(c["misfit"], 0.0043, 1e-4)]
        verdicts.append(compare(answer, (closures, f"none at {time}"), (drawn or time != "0", "not the drawn one")))
    motion = ask("motion", file, "--fit", "0.05", "--to", "0.3")
    branches = (motion.json or {}).get("branches", [])
    verdicts.append(compare(motion, (any(b["begins"] == 0 for b in branches), "motion has no branch from there")))
    return worst(verdicts)


@case("guess-not-drawn-pose.toml", "all coordinates 0 is a closure, the default guess, and where motion starts")
def guess(ask, file):
    answer, motion = ask("newton", file), ask("motion", file, "--from-guess")
    values = (answer.json or {}).get("coordinates", {"": math.inf}).values()
    first = (motion.json or {}).get("branches", [{}])[0].get("samples", [{"coordinates": {"": math.inf}}])[0]["coordinates"].values()
    return worst([compare(answer, (max(map(abs, values)) < 1e-9, "Newton's method ends elsewhere")),
                  compare(motion, (max(map(abs, first)) < 1e-9, "motion starts elsewhere"))])


@case("hexapod-ups.toml", "2304 complex closures, 1024 real")
def hexapod(ask, file):
    answer = ask("closures", file)
    verdict = compare(answer, *counted(answer, 2304, 1024))
    if verdict.kind == UNDECIDED:
        counts = answer.json["counts"]
        verdict.note += f" ({counts['complex']} complex, {counts['real']} real are told)"
    return verdict


@case("letters-collide-jansen-double.toml", "8 x 8 real closures; the drawn one has one name everywhere, E.H or AT")
def jansen(ask, file):
    answer = ask("closures", file)
    drawn = [c for c in (answer.json or {}).get("closures", []) if c["drawn"]]
    verdicts = [compare(answer, *counted(answer, 64, 64), (is_drawn(drawn), "the drawn pose is not listed"))]
    for name in ("drawn", *(n for c in drawn for n in (c["id"], ".".join(c["of"])))):
        motion = ask("motion", file, "--closure", name, "--steps", "4")
        first = [s["samples"][0]["coordinates"] for s in branches_of(motion.json)]
        verdicts.append(compare(motion, (first and max(abs(x) for c in first for x in c.values()) < DRAWN, f"--closure {name} is another pose")))
    return worst(verdicts)


def branches_of(told):
    told = told or {}
    return [b for chain in told.get("sub_chains") or [told] for b in chain.get("motion", chain).get("branches", [])]


@case("mistyped-shared-point-silent.toml", "coupler.B is 99 mm from rocker.B, and a warning says so")
def mistyped(ask, file):
    answer = ask("closures", file)
    warnings = " ".join((answer.json or {}).get("warnings", []))
    return compare(answer, ("coupler.B = [11, 70]" in warnings and "99 mm" in warnings, "no warning"), *counted(answer, 4, 4))


@case("strandbeest-4-drawn-pose-not-listed.toml", "3072 real closures; the drawn one is listed, and motion answers to its name")
def strandbeest(ask, file):
    answer = ask("closures", file)
    drawn = [c for c in (answer.json or {}).get("closures", []) if c["drawn"]]
    verdicts = [compare(answer, *counted(answer, 4096, 3072), (is_drawn(drawn), "the drawn pose is not listed"))]
    for one in drawn:
        motion = ask("motion", file, "--closure", ".".join(one["of"]), "--steps", "4")
        first = [b["samples"][0]["coordinates"].values() for b in branches_of(motion.json)]
        verdicts.append(compare(motion, (first and all(abs(x) < DRAWN for values in first for x in values), "its name is another pose")))
    return worst(verdicts)


@case("synthesis-5-points-given-pivots.toml", "36 complex, 22 real (Morgan and Wampler 1990)")
def synthesis(ask, file):
    answer = ask("closures", file)
    return compare(answer, *counted(answer, 36, 22), ((answer.json or {}).get("completeness") in ("proved", "shown"), "not shown to be complete"))


@case("third-bar-way-is-determined.toml", "one branch goes through the flat poses, 126.87 and 306.87 degrees, in one way")
def third_bar(ask, file):
    answer = ask("motion", file)
    told = answer.json or {}
    events = [math.degrees(e["drivers"][0]) for e in told.get("events", [])]
    circuits = told.get("circuits", [])
    return compare(answer, (len(events) == 2 and near(events[0], 126.8698976) and near(events[1], 306.8698976), f"events {events}"),
                   (len(circuits) == 1 and circuits[0]["driver"] == "turns", "not one circuit that turns fully"),
                   ("in one way" in answer.text and "not determined" not in answer.text, "the way on is not told"),
                   (all(c["counts"]["real"] == 1 for c in told.get("checkpoints", [])), "not one closure everywhere"))


@case("vpp-shock-undecided.toml", "4 branches on one circuit, dead points at 92.4231 and 92.6326 mm")
def shock(ask, file):
    answer = ask("motion", file)
    told = answer.json or {}
    events = sorted(e["drivers"][0] for e in told.get("events", []))
    return compare(answer, (len(told.get("branches", [])) == 4 and len(told.get("circuits", [])) == 1, "branches, circuits"),
                   (len(events) == 3 and all(near(a, b, 1e-6) for a, b in zip(events, (92.4230893, 92.4230893, 92.6326165))), f"events {events}"))


@case("walschaerts-motion-slow.toml", "10 real of 72 closures at the start, 18 branches")
def walschaerts(ask, file):
    closures, motion = ask("closures", file), ask("motion", file)
    branches = (motion.json or {}).get("branches", [])
    verdict = worst([compare(closures, *counted(closures, 72, 10)), compare(motion, (len(branches) == 18, f"{len(branches)} branches"))])
    verdict.note = verdict.note or f"motion {motion.seconds:.1f} s"
    return verdict


def solved(answer, simple, real=None, multiple=None):
    """Facts of roots: how many are simple, how many of those are real, and how many have which multiplicity."""
    told = answer.json or {"solutions": []}
    roots = told["solutions"]
    regular = [r for r in roots if not r["singular"]]
    seen = {}
    for r in roots:
        if r["singular"]:
            seen[r["multiplicity"]] = seen.get(r["multiplicity"], 0) + 1
    facts = [(len(regular) == simple, f"{len(regular)} simple roots"), (seen == (multiple or {}), f"multiplicities {seen}")]
    if real is not None:
        facts.append((sum(r["real"] for r in regular) == real, "real ones"))
    return facts


def only_solved(name, truth, *counts, **more):
    """A system of which nothing but the counts of its roots is asked."""
    @case(name, truth)
    def solve(ask, file):
        answer = ask("solve", file)
        return compare(answer, *solved(answer, *counts, **more))


only_solved("near-pair-exact.phc", "two simple real roots, 1e-68 apart", 2, 2)
only_solved("slow-powerflow9-rect.phc", "768 roots, 8 of them real", 768, 8)
only_solved("too-slow-hc492-a1.1.phc", "9 simple roots", 9)
only_solved("undecided-hc574.phc", "456 roots: 348 simple, 96 triple, 12 fourfold", 348, multiple={3: 96, 4: 12})
only_solved("undecided-quadratic.phc", "two simple real roots, 5e-23 apart", 2, 2)


@case("check-denies-true-proof-hc492-a0.9.phc", "9 simple roots, proved, and `check` agrees")
def denied(ask, file):
    answer = ask("solve", file)
    with tempfile.TemporaryDirectory() as folder:
        result = pathlib.Path(folder) / "result.json"
        result.write_text(json.dumps(answer.json), encoding="utf-8")
        check = ask("check", file, result)
    return worst([compare(answer, *solved(answer, 9), ((answer.json or {}).get("completeness") == "proved", "not proved")), compare(check)])


@case("family-hc492.phc", "a generic member has 9 roots")
def family(ask, file):
    with tempfile.TemporaryDirectory() as folder:
        answer = ask("family", "learn", file, "--parameters", "a", "-o", pathlib.Path(folder) / "family")
    roots = [f["roots"] for f in (answer.json or {}).get("families", [])]
    verdict = compare(answer, (roots == [9], f"{roots} roots"))
    return Verdict(verdict.kind, f"{roots} roots are told") if verdict.kind == UNDECIDED else verdict


@case("refused-msolve358.phc", "three simple real roots, 1.144, -0.437 and 7e-211")
def refused(ask, file):
    answer = ask("solve", file)
    values = sorted(r["x"][0][0] for r in (answer.json or {}).get("solutions", []))
    truth = (-0.437, 7e-211, 1.144)
    return compare(answer, *solved(answer, 3, 3), (len(values) == 3 and all(abs(a / b - 1) < 0.1 for a, b in zip(values, truth)), f"roots {values}"))


@case("usability-line-not-told-hc408.phc", "54 isolated roots, and a line that is told")
def line(ask, file):
    answer = ask("solve", file)
    return compare(answer, *solved(answer, 54), ((answer.json or {}).get("planes") == [{"zero": ["s", "x2"], "dimension": 1}], "the line is not told"))


@case("usability-no-point-hc406.phc", "no isolated root; a curve, points of which are told")
def curve(ask, file):
    answer = ask("solve", file)
    return compare(answer, *solved(answer, 0), ((answer.json or {}).get("on_sets"), "no point"))


@case("usability-two-roots-one-text.phc", "two real roots, 70 -+ 2.6e-18, which the text tells apart")
def one_text(ask, file):
    answer, long = ask("solve", file), ask("solve", file, "--digits", "40")
    values = {word for word in long.text.split() if word.startswith(("70.", "69."))}
    apart = len(values) == 2 and near(max(map(Decimal, values)) - min(map(Decimal, values)), Decimal("5.2915e-18"), Decimal("1e-20"))
    texts = [line for line in answer.text.splitlines() if line.strip().startswith("u =")]
    return worst([compare(answer, *solved(answer, 2, 2), (len(set(texts)) == 2, "one text for both")), compare(long, (apart, "--digits 40 does not part them"))])
