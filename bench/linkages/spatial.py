# SPDX-License-Identifier: MIT
"""Spatial linkages drawn in one pose, as files with rounded numbers, and Newton's method on equations of its own.

A body has a frame (R, p) in the drawing; its points and axes are typed in that frame, rounded. A pose is (k, 12 bodies), R row by row and p,
and a step (k, 6 bodies): a turn about the axes of the drawing, then a displacement.
"""
import math

import numpy as np


def rotation_of(vectors):
    """Rotation matrices (k, 3, 3) of rotation vectors (k, 3)."""
    angle = np.linalg.norm(vectors, axis=1)
    x, y, z = (vectors / np.maximum(angle, 1e-300)[:, None]).T
    zero = np.zeros_like(x)
    k = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], 1).reshape(-1, 3, 3)
    return np.eye(3) + np.sin(angle)[:, None, None] * k + (1 - np.cos(angle))[:, None, None] * (k @ k)


def vector_of(r):
    """The rotation vector of a rotation matrix."""
    angle = math.acos(max(-1.0, min(1.0, (np.trace(r) - 1) / 2)))
    if angle < math.pi - 1e-3:
        v = np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]) / 2
        return v * (angle / math.sin(angle) if angle > 1e-9 else 1.0)
    axis = np.linalg.eigh(r + r.T)[1][:, 2]
    turn = max((1, -1), key=lambda sign: np.trace(r.T @ rotation_of(sign * angle * axis[None])[0]))
    return turn * angle * axis


def of_quaternion(w, x, y, z):
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def frame_of_axis(z):
    """x = e x z, e the coordinate axis along which the axis has its smallest component; y = z x x."""
    z = np.asarray(z, float) / np.linalg.norm(z)
    e = np.eye(3)[int(np.argmin(np.abs(z)))]
    x = np.cross(e, z)
    x /= np.linalg.norm(x)
    return x, np.cross(z, x), z


def skew_rows(v):
    """d(w x v) by w: (k, 3, 3)."""
    x, y, z = v.T
    zero = np.zeros_like(x)
    return np.stack([zero, z, -y, -z, zero, x, y, -x, zero], 1).reshape(-1, 3, 3)


class Spatial:
    space = "spatial"

    def __init__(self, digits, frames, rng):
        self.digits, self.own_frames, self.rng = digits, frames == "own", rng
        self.bodies, self.frames, self.points = ["ground"], [(np.eye(3), np.zeros(3))], [{}]
        self.joints, self.drivers = [], []

    def typed(self, x):
        return round(float(x), self.digits) + 0.0

    def body(self):
        r, p = np.eye(3), np.zeros(3)
        if self.own_frames:
            r = rotation_of(np.array([[self.rng.uniform(-2, 2) for _ in range(3)]]))[0]
            p = np.array([self.rng.uniform(-2, 2) for _ in range(3)])
        self.bodies.append(f"b{len(self.bodies)}")
        self.frames.append((r, p))
        self.points.append({})
        return len(self.bodies) - 1

    def point(self, body, place):
        r, p = self.frames[body]
        local = tuple(self.typed(c) for c in r.T @ (np.asarray(place, float) - p))
        for name, known in self.points[body].items():
            if known == local:
                return name
        name = f"P{sum(map(len, self.points))}"
        self.points[body][name] = local
        return name

    def axis(self, body, direction):
        return tuple(self.typed(c) for c in self.frames[body][0].T @ np.asarray(direction, float))

    def joint(self, kind, a, b, place, other=None, axis=None, second=None):
        """place, axis: of the drawing; second: the second axis of a universal joint."""
        other = place if other is None else other
        joint = {"type": kind, "a": a, "b": b, "P": self.point(a, place), "Q": self.point(b, other), "name": f"j{len(self.joints)}"}
        if axis is not None:
            joint["axes"] = (self.axis(a, axis), self.axis(b, axis if second is None else second))
            if kind == "prismatic":
                joint["turn"] = self.typed(self.turn_between(joint))
        if kind in ("rod", "actuator"):
            joint["length"] = self.typed(math.dist(place, other))
        self.joints.append(joint)
        return joint

    def marks(self, joint):
        """The joint's frames in both bodies, by rows x, y, z; where both axes are typed alike, one frame."""
        return frame_of_axis(joint["axes"][0]), frame_of_axis(joint["axes"][1])

    def turn_between(self, joint):
        (xa, ya, _), (xb, _, _) = self.marks(joint)
        x = self.frames[joint["b"]][0] @ xb
        ra = self.frames[joint["a"]][0]
        return math.atan2(x @ (ra @ ya), x @ (ra @ xa))

    def drive_angle(self, joint, add=0.0):
        self.drivers.append({"kind": "angle", "joint": joint, "value": self.turn_between(joint) + add})

    def drive_slide(self, joint, add=0.0):
        if joint["type"] == "actuator":
            value = joint["length"]
        else:
            q = self.drawn()[None]
            r, _, _ = self.state(q, joint["a"])
            z = r[0] @ frame_of_axis(joint["axes"][0])[2]
            value = float(z @ (self.place(q, joint["b"], joint["Q"]) - self.place(q, joint["a"], joint["P"]))[0])
        self.drivers.append({"kind": "slide", "joint": joint, "value": value + add})

    def drawn(self):
        return np.concatenate([np.concatenate([r.ravel(), p]) for r, p in self.frames[1:]])

    def text(self, fit=None):
        lines = ['space = "spatial"'] + ([f"fit = {fit!r}"] if fit else [])
        for k, name in enumerate(self.bodies):
            lines.append("[ground.points]" if k == 0 else f"[body.{name}.points]")
            lines += [f"{point} = {list(p)}" for point, p in self.points[k].items()]
        for j in self.joints:
            a, b = self.bodies[j["a"]], self.bodies[j["b"]]
            lines += ["[[joint]]", f'type = "{j["type"]}"', f'name = "{j["name"]}"', f'at = ["{a}.{j["P"]}", "{b}.{j["Q"]}"]']
            if "axes" in j:
                one = j["axes"][0] == j["axes"][1] and j["type"] != "universal"
                lines.append(f"axis = {list(j['axes'][0]) if one else [list(axis) for axis in j['axes']]}")
            lines += [f"turn = {j['turn']!r}"] if "turn" in j else []
            lines += [f"length = {j['length']!r}"] if j["type"] == "rod" else []
        for d in self.drivers:
            lines += ["[[driver]]", f'{d["kind"]} = "{d["joint"]["name"]}"', f"start = {d['value']!r}"]
        return "\n".join(lines) + "\n"

    # ---------------------------------------------------------------- equations of its own
    def state(self, q, body):
        if body == 0:
            return np.broadcast_to(np.eye(3), (len(q), 3, 3)), np.zeros((len(q), 3)), None
        c = 12 * (body - 1)
        return q[:, c:c + 9].reshape(-1, 3, 3), q[:, c + 9:c + 12], 6 * (body - 1)

    def place(self, q, body, point):
        r, p, _ = self.state(q, body)
        return r @ np.array(self.points[body][point]) + p

    def equations(self, q):
        count, n = len(q), 6 * (len(self.bodies) - 1)
        rows, grads, self.turns = [], [], []

        def gradient(parts, width):
            """parts: (body, d by turn (k, width, 3), d by displacement)."""
            g = np.zeros((count, width, n))
            for body, turn, shift in parts:
                if body:
                    c = 6 * (body - 1)
                    g[:, :, c:c + 3] += turn
                    g[:, :, c + 3:c + 6] += shift
            return g

        def add(value, parts, turns=False):
            self.turns += [turns] * value.shape[1]
            rows.append(value)
            grads.append(gradient(parts, value.shape[1]))

        def arm(body, point):
            return self.state(q, body)[0] @ np.array(self.points[body][point])

        def vector(body, v):
            return self.state(q, body)[0] @ np.asarray(v)

        def alike(a, va, b, vb):
            """Directions that are one."""
            u, v = vector(a, va), vector(b, vb)
            add(u - v, [(a, skew_rows(u), 0), (b, -skew_rows(v), 0)], turns=True)

        def along(a, va, b, pa, pb, value=0.0):
            """v . (B - A) = value, v of the first body."""
            v, d = vector(a, va), self.place(q, b, pb) - self.place(q, a, pa)
            ra, rb = arm(a, pa), arm(b, pb)
            add(((v * d).sum(1) - value)[:, None],
                [(a, (np.cross(v, d) - np.cross(ra, v))[:, None], -v[:, None]), (b, np.cross(rb, v)[:, None], v[:, None])])

        eye = np.eye(3)[None]
        for j in self.joints:
            a, b = j["a"], j["b"]
            pa, pb = self.place(q, a, j["P"]), self.place(q, b, j["Q"])
            ra, rb = arm(a, j["P"]), arm(b, j["Q"])
            if j["type"] in ("spherical", "revolute", "universal"):
                add(pa - pb, [(a, skew_rows(ra), eye), (b, -skew_rows(rb), -eye)])
            if j["type"] in ("revolute", "cylindrical", "prismatic"):
                (xa, ya, za), (xb, _, zb) = self.marks(j)
                alike(a, za, b, zb)
                if j["type"] != "revolute":
                    along(a, xa, b, j["P"], j["Q"])
                    along(a, ya, b, j["P"], j["Q"])
                if j["type"] == "prismatic":
                    alike(a, math.cos(j["turn"]) * xa + math.sin(j["turn"]) * ya, b, xb)
            if j["type"] == "universal":
                u, v = (vector(body, np.array(w) / np.linalg.norm(w)) for body, w in zip((a, b), j["axes"]))
                add((u * v).sum(1)[:, None], [(a, np.cross(u, v)[:, None], 0), (b, np.cross(v, u)[:, None], 0)], turns=True)
            if j["type"] in ("rod", "actuator"):
                length = next((d["value"] for d in self.drivers if d["joint"] is j), j["length"] if j["type"] == "rod" else None)
                if length is None:
                    continue
                d = pb - pa
                add((((d * d).sum(1) - length * length) / (2 * length))[:, None],
                    [(a, (-np.cross(ra, d) / length)[:, None], (-d / length)[:, None]),
                     (b, (np.cross(rb, d) / length)[:, None], (d / length)[:, None])])
        for driver in self.drivers:
            j, value = driver["joint"], driver["value"]
            if driver["kind"] == "angle":
                (xa, ya, _), (xb, _, _) = self.marks(j)
                alike(j["a"], math.cos(value) * xa + math.sin(value) * ya, j["b"], xb)
            elif j["type"] != "actuator":
                along(j["a"], self.marks(j)[0][2], j["b"], j["P"], j["Q"], value)
        return np.concatenate(rows, 1), np.concatenate(grads, 1)

    def moved(self, q, step):
        q = q.copy()
        for body in range(1, len(self.bodies)):
            c, s = 12 * (body - 1), 6 * (body - 1)
            r = rotation_of(step[:, s:s + 3]) @ q[:, c:c + 9].reshape(-1, 3, 3)
            q[:, c:c + 9] = r.reshape(-1, 9)
            q[:, c + 9:c + 12] += step[:, s + 3:s + 6]
        return q

    def step_between(self, q, to):
        """What moved() takes from one pose to another; (6 bodies)."""
        parts = []
        for c in range(0, len(q), 12):
            r = to[c:c + 9].reshape(3, 3) @ q[c:c + 9].reshape(3, 3).T
            parts += [vector_of(r), to[c + 9:c + 12] - q[c + 9:c + 12]]
        return np.concatenate(parts)

    def units(self):
        """Of a step's coordinates."""
        return np.tile([1.0] * 3 + [self.size()] * 3, len(self.bodies) - 1)

    def random_poses(self, count):
        r = np.random.default_rng(self.rng.randrange(1 << 30))
        q = np.empty((count, 12 * (len(self.bodies) - 1)))
        for body in range(1, len(self.bodies)):
            c = 12 * (body - 1)
            axis = r.normal(size=(count, 3))
            axis *= (r.uniform(0, math.pi, count) / np.linalg.norm(axis, axis=1))[:, None]
            q[:, c:c + 9] = rotation_of(axis).reshape(-1, 9)
            q[:, c + 9:c + 12] = r.uniform(-self.size(), self.size(), (count, 3))
        return q

    def pose_sizes(self, q):
        """Of a step's coordinates, beside the pose q (n)."""
        size = max(self.size(), np.abs(q.reshape(-1, 12)[:, 9:]).max())
        return np.tile([1.0] * 3 + [size] * 3, len(self.bodies) - 1)

    def size(self):
        return max([1.0] + [abs(c) for points in self.points for p in points.values() for c in p])

    def shape(self, q):
        parts = []
        for body in range(1, len(self.bodies)):
            parts += [self.place(q, body, name) / self.size() for name in self.points[body]]
            parts.append(self.state(q, body)[0].reshape(len(q), 9))
        return np.concatenate(parts, 1)

    def told(self, closure):
        parts = []
        for name in self.bodies[1:]:
            b = closure["bodies"][name]
            parts += [of_quaternion(*b["q"]).ravel(), np.array([b["x"], b["y"], b["z"]])]
        return np.concatenate(parts)
