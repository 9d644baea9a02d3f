# SPDX-License-Identifier: MIT
# Which six-bars turn an output link by psi_j where the input link turns by phi_j, j = 0 .. n - 1? For problems/generate.
#
# Watt II, Stephenson II and III, and a form of which Watt II and Stephenson III are members, each a family in Bertini's form, in
# isotropic coordinates [Wampler96]: a vector is a complex number v and vc, an unknown of its own that is the conjugate of v in a real
# linkage. A link that has turned by phi since position 0 has turned its vectors by f = e^(i phi), and their conjugates by 1/f.
#
#   fj, gj      parameters: how far input and output have turned in position j; f0 = g0 = 1
#   tj          unknowns: the direction of the link that is neither, in position j (its angle, from where its own vectors are told)
#   others      vectors at position 0, unknowns or parameters
#
# A bar that joins two links keeps its length: with p = sum of vectors from one of its ends to the other, p pc is what it was in
# position 0. That is a bar's equation, times its denominators: two for each position, and no angle of a bar is an unknown.
# Lengths are in units of the ground link (Watt II: of each of both four-bars, see there). The literature holds as many numbers as
# leave eight positions [PlecnikMcCarthy14]: three vectors and tj are unknown. For fewer positions vectors become parameters, the
# last ones first, and where n is odd t0 = 1. Python's standard library only.
import cmath
import math

# Each bar: (vector, sign, what it turns with). "1" is the ground link along x or a vector of length 1.
LINKAGES = {
    "watt-2": {
        "title": "Watt II: a four-bar from the input crank to a ternary rocker, another from there to the output crank.",
        "about": ("The rocker turns about 0. First four-bar: ground pivot 1, crank w, the rocker's point r t. Second one, in units of its "
                  "own rocker's", "arm, t long: ground pivot d, crank v."),
        "bars": ((("1", 1, ""), ("w", 1, "f"), ("r", -1, "t")), (("d", 1, ""), ("v", 1, "g"), ("1", -1, "t"))),
        "vectors": ("w", "v", "d"),
        "given": ("r",),        # real
    },
    "stephenson-2": {
        "title": "Stephenson II: two bars join the output link to a coupler on the input crank.",
        "about": ("The input crank w turns about 0 and carries the coupler, whose other joints are z t and y t from there. The output link",
                  "turns about 1; its joints are v and x."),
        "bars": ((("w", 1, "f"), ("z", 1, "t"), ("1", -1, ""), ("v", -1, "g")), (("w", 1, "f"), ("y", 1, "t"), ("1", -1, ""), ("x", -1, "g"))),
        "vectors": ("w", "v", "x"),
        "given": ("z", "zc", "y", "yc"),
    },
    "stephenson-3": {
        "title": "Stephenson III: a four-bar, and a bar from its coupler to the output crank.",
        "about": ("The input crank w turns about 0 and carries the coupler, whose other joints are z t and y t from there. A bar joins the",
                  "first to the ground pivot b, another the second to the output crank v, which turns about 1."),
        "bars": ((("w", 1, "f"), ("z", 1, "t"), ("b", -1, "")), (("w", 1, "f"), ("y", 1, "t"), ("1", -1, ""), ("v", -1, "g"))),
        "vectors": ("w", "v", "b"),
        "given": ("z", "zc", "y", "yc"),
    },
    "function-generator": {
        "title": "General form: two bars, each across a vector of every kind.",
        "about": ("Bar k keeps the length of pk w f + z t + qk b + rk v g + sk, the second bar with y for z. Watt II: p1 = s1 = q2 = r2 = 1,",
                  "z = -r, y = -1, b is d; Stephenson III: p1 = p2 = 1, q1 = r2 = s2 = -1; all others 0."),
        "bars": ((("p1*w", 1, "f"), ("z", 1, "t"), ("q1*b", 1, ""), ("r1*v", 1, "g"), ("s1", 1, "")),
                 (("p2*w", 1, "f"), ("y", 1, "t"), ("q2*b", 1, ""), ("r2*v", 1, "g"), ("s2", 1, ""))),
        "vectors": ("w", "v", "b"),
        "given": ("z", "zc", "y", "yc", *(f"{x}{k}{c}" for k in (1, 2) for x in "pqrs" for c in ("", "c"))),
    },
}
FEWEST_POSITIONS, MOST_POSITIONS = 3, 8


def vectors_of(kind, positions):
    """Those that are unknown, and those that are given."""
    vectors = LINKAGES[kind]["vectors"]
    unknown = (positions - 1) // 2
    return vectors[:unknown], vectors[unknown:]


def conjugate(vector):
    """Of a product too."""
    return "*".join(name if name in ("1", "r") else name + "c" for name in vector.split("*"))


def equation(bar, j, direction):
    """p pc of position j less that of position 0, times fj gj tj t0 as far as they occur; direction(j): the name of tj, or 1."""
    turning = [x for x in "fgt" if any(with_ == x for _, _, with_ in bar)]

    def name(x, position):
        return direction(position) if x == "t" else f"{x}{position}" if position else "1"

    def product(factors):
        return "*".join(x for x in factors if x != "1") or "1"

    def total(position, is_conjugate):
        text = ""
        for vector, sign, with_ in bar:
            if is_conjugate:
                factors = [conjugate(vector), *(name(x, position) for x in turning if x != with_)]
            else:
                factors = [vector, *([name(with_, position)] if with_ else [])]
            text += (" - " if sign < 0 else " + " if text else "") + product(factors)
        return text.removeprefix(" ")

    here, there = (product([f"({total(k, False)})", f"({total(k, True)})"]) for k in (j, 0))
    return product([here, direction(0)]) + " - " + product([*(name(x, j) for x in turning), there])


def family(kind, positions):
    """The text of a family in Bertini's form."""
    linkage = LINKAGES[kind]
    unknown, given = vectors_of(kind, positions)
    is_turned = positions % 2 == 0

    def direction(j):
        return f"t{j}" if j or is_turned else "1"

    def pairs(vectors):
        return [name for v in vectors for name in (v, conjugate(v))]

    later = range(1, positions)
    unknowns = pairs(unknown) + [direction(j) for j in range(positions) if direction(j) != "1"]
    parameters = [*linkage["given"], *pairs(given), *(f"f{j}" for j in later), *(f"g{j}" for j in later)]
    equations = [(f"{which}{j}", equation(bar, j, direction)) for j in later for which, bar in zip(("one", "two"), linkage["bars"])]
    about = [linkage["title"], f"Function generators of {positions} positions [PlecnikMcCarthy14]; written by problems/generate, explained in",
             "problems/function_generators.py.", *linkage["about"]]
    return "".join([
        *(f"% {line}\n" for line in about), "CONFIG\nEND;\nINPUT\n", f"  variable_group {', '.join(unknowns)};\n",
        f"  parameter {', '.join(parameters)};\n", f"  function {', '.join(name for name, _ in equations)};\n",
        *(f"  {name} = {text};\n" for name, text in equations), "END;\n"])


# The turns of the input and output link of a logarithm, in degrees, between x = 1 and x = 10, and the rocker's arm.
INPUT_DEG, OUTPUT_DEG, ARM = 100, 100, "0.8"


def logarithm(positions):
    """A member of Watt II as a table: y = log10 x at Chebyshev's points of 1 <= x <= 10, both turned in proportion."""
    points = [5.5 - 4.5 * math.cos(math.pi * (2 * k + 1) / (2 * positions)) for k in range(positions)]
    turns = [[cmath.exp(1j * math.radians(degrees) * (value - values[0])) for value in values[1:]]
             for degrees, values in ((INPUT_DEG / 9, points), (OUTPUT_DEG, [math.log10(x) for x in points]))]
    names = ["r", *(f"{x}{j}" for x in "fg" for j in range(1, positions))]
    values = [ARM, *(f"{z.real:.15f}{z.imag:+.15f}*i" for of_link in turns for z in of_link)]
    return ",".join(names) + "\n" + ",".join(values) + "\n"
