# SPDX-License-Identifier: MIT
"""What is the truth of an arm's file: the postures in its head, and is an answer to their poses right?"""
import importlib.machinery
import importlib.util
import pathlib
import random
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

import numpy as np

from answers import RIGHT, WRONG, Verdict, whole, worst

_PATH = str(pathlib.Path(__file__).resolve().parent.parent / "robots" / "trial")
_LOADER = importlib.machinery.SourceFileLoader("robots_trial", _PATH)
robots = importlib.util.module_from_spec(importlib.util.spec_from_loader("robots_trial", _LOADER))
_LOADER.exec_module(robots)

STARTS = 100
ABSENT = dict.fromkeys(["right", "set", "merged", "undecided", "LOST", "wrong", "missing", "hidden", "exit 2"], 0)


@dataclass
class Posture:
    """A line `name: q = [...] on a set of dimension 1` of a file's head."""
    q: np.ndarray
    dimension: int  # of the self-motion through it, 0 where it stands alone


def numbers(text):
    return [float(x) for x in text.split()]


def to_axis(axis):
    """A rotation that takes z to the axis."""
    z = np.array(axis) / np.linalg.norm(axis)
    x = np.cross(z, np.eye(3)[int(np.argmin(np.abs(z)))])
    m = np.eye(4)
    m[:3, 0], m[:3, 2] = x / np.linalg.norm(x), z
    m[:3, 1] = np.cross(m[:3, 2], m[:3, 0])
    return m


class UrdfArm(robots.Arm):
    """The chain from the root to the only leaf, as the robots' trial has it: every axis is a z axis."""

    def __init__(self, path, held):
        root = ElementTree.parse(path).getroot()
        above = {j.find("child").get("link"): j for j in root.findall("joint")}
        links = [link.get("name") for link in root.findall("link")]
        parents = {j.find("parent").get("link") for j in above.values()}
        link = next(name for name in links if name not in parents)
        chain = []
        while link in above:
            chain.insert(0, above[link])
            link = above[link].find("parent").get("link")
        self.fixed, self.slides, self.names = [np.eye(4)], [], []
        texts = []
        for joint in chain:
            texts += self.add(joint, held)
        self.free = list(range(len(self.slides)))
        self.held = [False] * len(self.slides)
        self.reach = 1 + sum(np.linalg.norm(m[:3, 3]) for m in self.fixed)
        self.rounding = 1e-9 + self.reach * sum(robots.half_unit(x) for x in texts)

    def add(self, joint, held):
        origin, axis = joint.find("origin"), joint.find("axis")
        texts = [(origin.get(key) if origin is not None else None) or "0 0 0" for key in ("xyz", "rpy")]
        self.fixed[-1] = self.fixed[-1] @ robots.displacement(*(numbers(text) for text in texts))
        texts = " ".join(texts).split()
        if joint.get("type") == "fixed":
            return texts
        turn = to_axis(numbers(axis.get("xyz") if axis is not None else "1 0 0"))
        slides = joint.get("type") == "prismatic"
        self.fixed[-1] = self.fixed[-1] @ turn
        if joint.get("name") in held:
            value = held[joint.get("name")]
            still = ((0, 0, value), (0, 0, 0)) if slides else ((0, 0, 0), (0, 0, value))
            self.fixed[-1] = self.fixed[-1] @ robots.displacement(*still) @ turn.T
            return texts
        self.slides.append(slides)
        self.names.append(joint.get("name"))
        self.fixed.append(turn.T)
        return texts


class ArmCase:
    def __init__(self, path):
        self.name = path.name
        self.path = path
        head = re.search(r"<!--(.*?)-->", path.read_text(encoding="utf-8"), re.DOTALL).group(1)
        self.truth = " ".join(re.search(r"Truth: (.*?)\n", head).group(1).split())
        self.holds = re.findall(r"^\s*hold (\S+)", head, re.MULTILINE)
        counted = re.search(r"(\d+) complex closures", self.truth)
        self.complex_count = int(counted.group(1)) if counted else None
        self.arm = UrdfArm(path, {name: float(x) for name, x in (hold.split("=") for hold in self.holds)})
        self.rounding = self.arm.rounding
        self.postures = [Posture(np.array([float(x) for x in q.split(",")]), int(dimension or 0)) for q, dimension in
                         re.findall(r": q = \[([^\]]*)\](?: on a set of dimension (\d))?", head)]
        self.targets = self.arm.tips(np.array([p.q for p in self.postures]), 0)[0]

    def run(self, ask):
        verdicts = []
        for posture, target in zip(self.postures, self.targets):
            pose = " ".join(repr(float(x)) for x in list(target[:3, 3]) + robots.quaternion(target[:3, :3]))
            holds = [part for hold in self.holds for part in ("--hold", hold)]
            verdicts.append(self.judge_pose(posture, target, ask("closures", self.path, *holds, "--pose", pose)))
        return worst(verdicts)

    def judge_pose(self, posture, target, answer):
        unsound = whole(answer)
        if unsound:
            return unsound
        # A pose typed to few decimals is known to 2 units of the last: places of a set may miss it by so much.
        accuracy = answer.json["accuracy"]
        self.arm.rounding = self.rounding + accuracy
        seen = dict(ABSENT)
        robots.look(self.arm, answer.json, posture.q, target, 0, STARTS, random.Random(self.name), seen)
        if seen["LOST"] or seen["wrong"] or seen["missing"]:
            return Verdict(WRONG, ", ".join(f"{key} {seen[key]}" for key in ("LOST", "wrong", "missing") if seen[key]))
        counts = answer.json["counts"]
        if self.complex_count not in (None, counts["complex"]):
            return Verdict(WRONG, f"{counts['complex']} complex closures, not {self.complex_count}")
        # What moves within the digits alone is no self-motion of the file's model.
        moves = [m for m in answer.json["moves"] or [] if not m["within_digits"] or m["misfit"] <= accuracy]
        here = [m["dimension"] for m in moves if robots.on_sets(self.arm, {"moves": [m]}, posture.q[None], target, 0)[0]]
        if max(here, default=0) != posture.dimension or (moves and posture.dimension == 0):
            return Verdict(WRONG, f"its own posture on sets of dimensions {here}, not {posture.dimension}")
        return Verdict(RIGHT, "")
