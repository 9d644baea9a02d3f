# SPDX-License-Identifier: MIT
# Which exceptions are the module's own? A fault in a text or a file, with its places; everything else is Python's ValueError.
"""Exceptions of moivre."""


class ParseError(ValueError):
    """A system, mechanism or robot cannot be read; `str()` shows every fault with its line and a caret.

    Attributes
    ----------
    faults : list of (int, int, str)
        Line and column, both from 1, and what is wrong there.
    line, column : int
        Of the first fault.

    Examples
    --------
    >>> import moivre
    >>> try:
    ...     moivre.solve("x^2 + y^2 - 4; x*y - ;")
    ... except moivre.ParseError as error:
    ...     error.line, error.column
    (1, 21)
    """

    def __init__(self, message, faults=()):
        super().__init__(message, faults)
        self.faults = list(faults)
        self.line, self.column = self.faults[0][:2] if self.faults else (None, None)

    def __str__(self):
        return self.args[0]
