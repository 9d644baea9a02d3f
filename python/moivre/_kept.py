# SPDX-License-Identifier: MIT
# How does a long call survive its process? Its ledger, and what makes a call the same one.
"""Runs that are kept."""

import contextlib
import os
import warnings

from . import _moivre

# Say how a call is made, or what is told of its roots, and not what is followed.
_OF_THE_CALL = {"threads", "time_limit", "digits", "cross_check", "certify", "real", "positive", "nonzero", "box", "where"}


@contextlib.contextmanager
def kept(ledger, call, content, options):
    """The options with their ledger, and a function that ends it with the result; without a ledger both do nothing."""
    if ledger is None:
        yield options, lambda text, is_complete: None
        return
    import hashlib  # takes as long as half of the package
    identity = [("command", f"{call} in Python"), ("content", hashlib.sha256(content.encode()).hexdigest())]
    identity += [(name, repr(value)) for name, value in sorted(options.items()) if name not in _OF_THE_CALL]
    book = _moivre.CallLedger(os.fspath(ledger), identity)

    def end(text, is_complete):
        failure = book.end(text, is_complete)
        if failure:
            warnings.warn(f"ledger: {failure}", RuntimeWarning, stacklevel=4)

    yield {**options, "ledger": book}, end
