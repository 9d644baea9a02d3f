# SPDX-License-Identifier: MIT
# How is progress told? To a function of (done, total), to a bar shaped like tqdm's, or to a bar of our own choice.
"""Progress of long calls."""

import contextlib


class _Bar:
    """Calls with (done, total) as updates of a bar that has `total` and `update(n)`."""

    def __init__(self, bar):
        self.bar = bar
        self.shown = 0

    def __call__(self, done, total):
        if total:
            self.bar.total = total
        self.bar.update(done - self.shown)
        self.shown = done


@contextlib.contextmanager
def told(progress):
    """The function to call with (done, total) for what a user gave as `progress=`, or None."""
    if progress is None or progress is False:
        yield None
        return
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            raise ValueError("progress=True needs tqdm; give a function of (done, total) instead") from None
        with tqdm() as bar:
            yield _Bar(bar)
        return
    if hasattr(progress, "update") and hasattr(progress, "total"):
        yield _Bar(progress)
        return
    if not callable(progress):
        raise ValueError("progress is True, a function of (done, total), or a bar with `total` and `update`")
    yield progress
