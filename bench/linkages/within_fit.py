# SPDX-License-Identifier: MIT
"""Which poses miss by no more than a fit, and do two of them hang together? By damped least squares on equations of the trial's own.

Rows that compare directions or angles are taken at a lever arm of the linkage's size, as docs/mechanism-file.md has it.
"""
import math

import numpy as np


class WithinFit:
    # Many rings of linkages with several links go round in a hundred steps, some only in thousands.
    WALK = 3000

    def __init__(self, m, fit):
        self.m, self.fit = m, fit
        m.equations(m.drawn()[None])
        self.weight = np.where(m.turns, m.size(), 1.0) / m.size()
        self.units = m.units()
        self.share = fit / m.size()

    def rows(self, q):
        f, j = self.m.equations(q)
        return f * self.weight, j * self.weight[:, None] * self.units

    def misfit(self, q):
        return np.abs(self.rows(q)[0]).max(axis=1) * self.m.size()

    def least_squares(self, q, rounds=120):
        """From poses (k, n)."""
        damping = np.full(len(q), 1e-3)
        f, j = self.rows(q)
        for _ in range(rounds):
            least = 1e-15 * (1 + (j * j).sum((1, 2)))
            normal = np.einsum("kij,kil->kjl", j, j) + np.maximum(damping, least)[:, None, None] * np.eye(j.shape[2])
            step = np.linalg.solve(normal, -np.einsum("kij,ki->kj", j, f)[..., None])[..., 0]
            after = self.m.moved(q, step * self.units)
            g, h = self.rows(after)
            better = (g * g).sum(1) < (f * f).sum(1)
            q = np.where(better[:, None], after, q)
            f, j = np.where(better[:, None], g, f), np.where(better[:, None, None], h, j)
            damping = np.clip(np.where(better, damping / 10, damping * 10), 1e-15, 1e12)
        return q

    def corrected(self, q, way):
        """A pose within the fit beside q, across the way; None where there is none.

        Rows that least squares leave beyond the fit count for more, until it is shared out.
        """
        weight = np.ones(len(self.weight))
        for k in range(25):
            f, j = (x[0] for x in self.rows(q[None]))
            misses = np.abs(f) / self.share
            if misses.max() <= 1:
                return q
            if k == 8 and np.linalg.norm(misses) > math.sqrt(len(f)):
                return None
            if k >= 4:
                weight *= np.maximum(misses, 1)
            f, j = f * weight, j * weight[:, None]
            normal = j.T @ j + np.outer(way, way) + self.share * np.eye(j.shape[1])
            # What is far off has weights beyond all bounds.
            if not np.isfinite(normal).all() or np.linalg.cond(normal) > 1e18:
                return None
            step = np.linalg.solve(normal, -j.T @ f)
            step -= way @ step * way
            q = self.m.moved(q[None], (step * self.units)[None])[0]
        return None

    def next_length(self, q, way, length, correction):
        """Of a step from q: bends allow 0.1, a straight way 0.1 of the pose's size."""
        longest = 0.1
        if correction < 0.01 * length:
            longest = max(longest, 0.1 / np.abs(way * self.units / self.m.pose_sizes(q)).max())
        return min(2 * length, longest)

    def joins(self, a, b):
        """Whether poses between them are within the fit: along the chord."""
        first = 0.2 * self.share ** 0.5
        length, here = first, a
        gap = self.m.step_between(here, b) / self.units
        for _ in range(200):
            size = np.linalg.norm(gap)
            if size <= first:
                return True
            if length < 0.01 * first:
                return False
            way = gap / size
            there = self.m.moved(here[None], (min(length, size) * way * self.units)[None])[0]
            then = self.corrected(there, way)
            left = None if then is None else self.m.step_between(then, b) / self.units
            if left is None or np.linalg.norm(left) > size - length / 4:
                length /= 2
                continue
            length = self.next_length(then, way, length, np.linalg.norm(self.m.step_between(there, then) / self.units))
            here, gap = then, left
        return False

    def walk(self, q):
        """Poses along the directions that the equations hardly see."""
        j = self.rows(q[None])[1][0]
        _, sigma, v = np.linalg.svd(j)
        weak = [v[k] for k in range(len(v)) if k >= len(sigma) or sigma[k] < 5 * self.share ** 0.5]
        weak += [(x + s * y) / 2 ** 0.5 for i, x in enumerate(weak) for y in weak[:i] for s in (1, -1)]
        for begin in weak:
            for sign in (1, -1):
                here, way, length = q, sign * begin, 0.2 * self.share ** 0.5
                has_left = False
                for _ in range(self.WALK):
                    there = self.m.moved(here[None], (length * way * self.units)[None])[0]
                    then = self.corrected(there, way)
                    correction = math.inf if then is None else np.linalg.norm(self.m.step_between(there, then) / self.units)
                    if correction > 2 * length:
                        length /= 2
                        if length < 0.002 * self.share ** 0.5:
                            break
                        continue
                    way = self.m.step_between(here, then) / self.units
                    way /= np.linalg.norm(way)
                    here, length = then, self.next_length(then, way, length, correction)
                    yield here
                    # Once round is all of a ring.
                    gone = np.linalg.norm(self.m.step_between(q, here) / self.units)
                    if has_left and gone < 0.1:
                        break
                    has_left = has_left or gone > 0.3

    def hangs_together(self, q, others):
        """Which of the other poses q hangs together with, of those within the fit: an index, or None."""
        if not others:
            return None
        near = sorted(range(len(others)), key=lambda k: np.linalg.norm(self.m.step_between(q, others[k]) / self.units))
        for k in near:
            if self.joins(q, others[k]):
                return k
        first = 0.5 * self.share ** 0.5
        for here in self.walk(q):
            for k in near:
                if np.linalg.norm(self.m.step_between(here, others[k]) / self.units) < max(first, 0.1) and self.joins(here, others[k]):
                    return k
        return None
