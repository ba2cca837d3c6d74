"""_types.py: the types that the signatures of the package name; nothing of it is needed when the package runs."""
from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Union

if TYPE_CHECKING:
    import numpy
    import numpy.typing

    Array = numpy.typing.NDArray[Any]  # a memoryview, or a list of rows, where numpy is not installed
    Numbers = Union[numpy.typing.NDArray[Any], Iterable[Any]]  # numbers, nested or flat

PathLike = Union[str, "os.PathLike[str]"]
MeshLists = tuple[list[tuple[float, float, float]], list[tuple[int, int, int]]]
