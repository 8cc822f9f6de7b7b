# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception of the package."""

from __future__ import annotations


class CircleVoronoiError(ValueError):
    """Input that cannot be used, or a computation that failed.

    The message is one sentence that describes the problem and its place.

    Attributes
    ----------
    code : str
        The kind of error, by its name in C++ and JavaScript, such as ``"negativeRadius"``.
    circle : int or None
        The row to blame (an id in `Diagram.update`), or None if no single row is to blame.
    edit : int or None
        The index of the edit to blame in `Diagram.update`, in the order remove, replace, insert.
    """

    def __init__(self, message: str, code: str = "badInput", circle: int | None = None, edit: int | None = None) -> None:
        super().__init__(message)
        self.code = code
        self.circle = circle
        self.edit = edit

    def __reduce__(self) -> tuple[type, tuple[str, str, int | None, int | None]]:
        return type(self), (str(self), self.code, self.circle, self.edit)
