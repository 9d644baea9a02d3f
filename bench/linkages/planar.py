# SPDX-License-Identifier: MIT
"""Planar linkages drawn in one pose, as files with rounded numbers, and Newton's method on equations of its own.

A body has a frame (x, y, phi) in the drawing. Its points are typed in that frame, rounded. q: (k, 3 bodies), ground left out.
"""
import math

import numpy as np


def turned(phi, x, y):
    c, s = np.cos(phi), np.sin(phi)
    return c * x - s * y, s * x + c * y


class Planar:
    space = "planar"

    def __init__(self, digits, frames, rng):
        self.digits, self.own_frames, self.rng = digits, frames == "own", rng
        self.bodies, self.frames, self.points = ["ground"], [(0.0, 0.0, 0.0)], [{}]
        self.joints, self.drivers = [], []

    def typed(self, x):
        return round(float(x), self.digits) + 0.0

    def body(self, x=0.0, y=0.0):
        """A body whose frame is the drawing's, or one of its own beside (x, y)."""
        frame = (0.0, 0.0, 0.0)
        if self.own_frames:
            frame = (x, y, self.typed(self.rng.uniform(-3, 3)))
        self.bodies.append(f"b{len(self.bodies)}")
        self.frames.append(frame)
        self.points.append({})
        return len(self.bodies) - 1

    def point(self, body, x, y):
        """The name of a point of the body at (x, y) of the drawing."""
        fx, fy, phi = self.frames[body]
        local = tuple(self.typed(c) for c in turned(-phi, x - fx, y - fy))
        for name, known in self.points[body].items():
            if known == local:
                return name
        name = f"P{sum(map(len, self.points))}"
        self.points[body][name] = local
        return name

    def joint(self, kind, a, b, place, other=None, along=None, length=None):
        """place: of the first body's point in the drawing; other: of the second's; along: of the drawing."""
        other = place if other is None else other
        joint = {"type": kind, "a": a, "b": b, "P": self.point(a, *place), "Q": self.point(b, *other), "name": f"j{len(self.joints)}"}
        if along is not None:
            u = turned(-self.frames[a][2], *along)
            joint["along"] = tuple(self.typed(c) for c in u)
            if kind == "prismatic":
                joint["turn"] = self.typed(math.remainder(self.frames[b][2] - self.frames[a][2], 2 * math.pi))
        if kind in ("rod", "actuator"):
            joint["length"] = self.typed(math.dist(place, other)) if length is None else length
        self.joints.append(joint)
        return joint

    def pin(self, a, b, place):
        return self.joint("revolute", a, b, place)

    def gear(self, a, b, ratio, carrier=0):
        """Wheels that mesh as they are drawn; a driver or the ground determines the first one's angle to the carrier, or b has one tooth."""
        one, two = (self.frames[k][2] - self.frames[carrier][2] for k in (a, b))
        phase = two - ratio[0] / ratio[1] * one
        self.joints.append({"type": "gear", "a": a, "b": b, "ratio": ratio, "carrier": carrier, "phase": self.typed(phase),
                            "name": f"j{len(self.joints)}"})

    def drive_angle(self, body, add=0.0):
        self.drivers.append({"kind": "angle", "body": body, "value": self.frames[body][2] + add})

    def drive_slide(self, joint, add=0.0):
        """A slide, or an actuator, where it is drawn."""
        value = joint["length"] if joint["type"] == "actuator" else float(self.slides(self.drawn()[None], joint)[0])
        self.drivers.append({"kind": "slide", "joint": joint, "value": value + add})

    def drawn(self):
        return np.array([c for frame in self.frames[1:] for c in frame])

    def text(self, fit=None):
        lines = [f"fit = {fit!r}"] if fit else []
        for k, name in enumerate(self.bodies):
            lines.append("[ground.points]" if k == 0 else f"[body.{name}.points]")
            lines += [f"{point} = [{x!r}, {y!r}]" for point, (x, y) in self.points[k].items()]
        for j in self.joints:
            lines += ["[[joint]]", f'type = "{j["type"]}"', f'name = "{j["name"]}"']
            a, b = self.bodies[j["a"]], self.bodies[j["b"]]
            if j["type"] == "gear":
                lines += [f'bodies = ["{a}", "{b}"]', f"ratio = {list(j['ratio'])}", f"phase = {j['phase']!r}",
                          f'carrier = "{self.bodies[j["carrier"]]}"']
                continue
            lines.append(f'at = ["{a}.{j["P"]}", "{b}.{j["Q"]}"]')
            lines += [f"{key} = {list(j[key]) if key == 'along' else repr(j[key])}" for key in ("along", "turn") if key in j]
            lines += [f"length = {j['length']!r}"] if j["type"] == "rod" else []
        for d in self.drivers:
            what = f'angle = "{self.bodies[d["body"]]}"' if d["kind"] == "angle" else f'slide = "{d["joint"]["name"]}"'
            lines += ["[[driver]]", what, f"start = {d['value']!r}"]
        return "\n".join(lines) + "\n"

    # ---------------------------------------------------------------- equations of its own
    def place(self, q, body, point):
        """A point (k, 2), and its derivative by the body's angle."""
        x, y = self.points[body][point]
        if body == 0:
            zero = np.zeros(len(q))
            return np.stack([zero + x, zero + y], 1), np.zeros((len(q), 2))
        c = 3 * (body - 1)
        dx, dy = turned(q[:, c + 2], x, y)
        return np.stack([q[:, c] + dx, q[:, c + 1] + dy], 1), np.stack([-dy, dx], 1)

    def angle(self, q, body):
        return np.zeros(len(q)) if body == 0 else q[:, 3 * (body - 1) + 2]

    def slides(self, q, j):
        p, _ = self.place(q, j["a"], j["P"])
        r, _ = self.place(q, j["b"], j["Q"])
        ux, uy = turned(self.angle(q, j["a"]), *np.array(j["along"]) / math.hypot(*j["along"]))
        return (r[:, 0] - p[:, 0]) * ux + (r[:, 1] - p[:, 1]) * uy

    def equations(self, q):
        """Residuals (k, m) and their Jacobian (k, m, n)."""
        rows, grads, self.turns = [], [], []

        def row(value, *parts, turns=False):
            """parts: (body, d/dx, d/dy, d/dphi)."""
            self.turns.append(turns)
            gradient = np.zeros((len(q), q.shape[1]))
            for body, *d in parts:
                if body:
                    for k in range(3):
                        gradient[:, 3 * (body - 1) + k] += d[k]
            rows.append(value)
            grads.append(gradient)

        def line(j, sideways, value=0.0):
            p, dp = self.place(q, j["a"], j["P"])
            r, dr = self.place(q, j["b"], j["Q"])
            u = np.stack(turned(self.angle(q, j["a"]), *np.array(j["along"]) / math.hypot(*j["along"])), 1)
            n = np.stack([-u[:, 1], u[:, 0]], 1)
            way, change = (n, -u) if sideways else (u, n)
            d = r - p
            row((way * d).sum(1) - value, (j["a"], -way[:, 0], -way[:, 1], (change * d).sum(1) - (way * dp).sum(1)),
                (j["b"], way[:, 0], way[:, 1], (way * dr).sum(1)))

        def wrapped(value, period=2 * math.pi):
            return value - period * np.round(value / period)

        for j in self.joints:
            if j["type"] == "gear":
                # The driver's whole turns count.
                driven = next((d["value"] for d in self.drivers if d.get("body") == j["a"]), 0.0)
                (z1, z2), carrier = j["ratio"], self.angle(q, j["carrier"])
                a1, a2 = driven + wrapped(self.angle(q, j["a"]) - carrier - driven), self.angle(q, j["b"]) - carrier
                row(wrapped(z1 * a1 - z2 * (a2 - j["phase"]), 2 * math.pi * z2) / abs(z2), (j["a"], 0, 0, z1 / abs(z2)),
                    (j["b"], 0, 0, -z2 / abs(z2)), (j["carrier"], 0, 0, (z2 - z1) / abs(z2)), turns=True)
                continue
            p, dp = self.place(q, j["a"], j["P"])
            r, dr = self.place(q, j["b"], j["Q"])
            if j["type"] == "revolute":
                for k in range(2):
                    row(p[:, k] - r[:, k], (j["a"], k == 0, k == 1, dp[:, k]), (j["b"], -(k == 0), -(k == 1), -dr[:, k]))
            elif j["type"] in ("rod", "actuator"):
                length = next((d["value"] for d in self.drivers if d.get("joint") is j), j["length"] if j["type"] == "rod" else None)
                if length is None:
                    continue
                d = r - p
                size = max(length, 1e-3)
                row(((d * d).sum(1) - length * length) / (2 * size),
                    (j["a"], -d[:, 0] / size, -d[:, 1] / size, -(d * dp).sum(1) / size),
                    (j["b"], d[:, 0] / size, d[:, 1] / size, (d * dr).sum(1) / size))
            else:
                line(j, True)
                if j["type"] == "prismatic":
                    row(wrapped(self.angle(q, j["b"]) - self.angle(q, j["a"]) - j["turn"]), (j["a"], 0, 0, -1), (j["b"], 0, 0, 1), turns=True)
        for d in self.drivers:
            if d["kind"] == "angle":
                row(wrapped(self.angle(q, d["body"]) - d["value"]), (d["body"], 0, 0, 1), turns=True)
            elif d["joint"]["type"] != "actuator":
                line(d["joint"], False, d["value"])
        return np.stack(rows, 1), np.stack(grads, 1)

    def moved(self, q, step):
        return q + step

    def step_between(self, q, to):
        """What moved() takes from one pose to another; (n)."""
        step = to - q
        step[2::3] -= 2 * math.pi * np.round(step[2::3] / (2 * math.pi))
        return step

    def units(self):
        """Of a step's coordinates."""
        return np.tile([self.size(), self.size(), 1.0], len(self.bodies) - 1)

    def random_poses(self, count):
        n = len(self.bodies) - 1
        size = self.size()
        q = np.empty((count, 3 * n))
        r = np.random.default_rng(self.rng.randrange(1 << 30))
        q[:, 0::3], q[:, 1::3] = r.uniform(-size, size, (2, count, n))
        q[:, 2::3] = r.uniform(-math.pi, math.pi, (count, n))
        return q

    def pose_sizes(self, q):
        """Of a step's coordinates, beside the pose q (n)."""
        size = max(self.size(), np.abs(q.reshape(-1, 3)[:, :2]).max())
        return np.tile([size, size, 1.0], len(self.bodies) - 1)

    def size(self):
        return max([1.0] + [abs(c) for points in self.points for p in points.values() for c in p])

    def shape(self, q):
        """What is compared of a pose: places of points, and directions of bodies."""
        parts = []
        for body in range(1, len(self.bodies)):
            parts += [self.place(q, body, name)[0] / self.size() for name in self.points[body]]
            a = self.angle(q, body)
            parts.append(np.stack([np.cos(a), np.sin(a)], 1))
        return np.concatenate(parts, 1)

    def told(self, closure):
        c = closure["coordinates"]
        return np.array([c[f"{name}.{k}"] for name in self.bodies[1:] for k in ("x", "y", "phi")])
