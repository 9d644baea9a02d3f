# SPDX-License-Identifier: MIT
# Which types has the public face of the module? For type checkers and editors.
import os
from decimal import Decimal
from fractions import Fraction
from typing import Any, Callable, Iterator, Literal, Mapping, Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

__version__: str

_Path = Union[str, os.PathLike[str]]
_Floats = npt.NDArray[np.float64]
_Complexes = npt.NDArray[np.complex128]
_Ints = npt.NDArray[np.int64]
_Bools = npt.NDArray[np.bool_]
_Number = Union[int, float, complex, Fraction, Decimal]
_Tracker = Literal["cvode", "lanes"]
_Start = Literal["auto", "total-degree", "multihomogeneous", "polyhedral"]
_Precision = Literal["auto", "double", "double-double"]
_Angles = Literal["rad", "deg"]
_Progress = Union[None, bool, Callable[[int, int], Any], Any]
# A text, a path, texts, sympy's expressions, or (coefficients, exponents) of each equation.
_Equations = Union[_Path, Sequence[Any], Any]

class ParseError(ValueError):
    faults: list[tuple[int, int, str]]
    line: Optional[int]
    column: Optional[int]

class Root:
    x: _Complexes
    variables: tuple[str, ...]
    real: bool
    singular: bool
    multiplicity: int
    accuracy: float
    residual: float
    condition: float
    certified: Optional[bool]
    on_boundary: list[str]
    def __getitem__(self, variable: Any) -> Union[float, complex]: ...
    def keys(self) -> tuple[str, ...]: ...

class Result:
    complete: bool
    completeness: Optional[str]
    message: str
    variables: list[str]
    paths: dict[str, int]
    filtered: int
    cross_check: Optional[dict[str, Any]]
    points: _Complexes
    set_points: _Complexes
    planes: list[dict[str, Any]]
    real: _Bools
    singular: _Bools
    multiplicity: _Ints
    accuracy: _Floats
    residual: _Floats
    condition: _Floats
    certified: list[Optional[bool]]
    @property
    def real_points(self) -> _Floats: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, index: int) -> Root: ...
    @overload
    def __getitem__(self, index: slice) -> list[Root]: ...
    def __iter__(self) -> Iterator[Root]: ...
    def digits(self, digits: int, progress: _Progress = ..., time_limit: Optional[float] = ...) -> list[Optional[list[Any]]]: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_csv(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_paths_csv(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_phc(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_text(self, all: bool = ...) -> str: ...

def solve(equations: _Equations, *, variables: Optional[Sequence[Any]] = ..., real: Optional[bool] = ...,
          positive: Optional[bool] = ..., nonzero: Optional[bool] = ...,
          box: Optional[Mapping[Any, tuple[Optional[float], Optional[float]]]] = ..., where: Union[None, str, Sequence[Any]] = ...,
          parameters: Optional[Mapping[Any, tuple[_Number, _Number]]] = ..., start_points: Optional[npt.ArrayLike] = ...,
          tracker: Optional[_Tracker] = ..., start: Optional[_Start] = ..., seed: Optional[int] = ...,
          threads: Optional[int] = ..., time_limit: Optional[float] = ..., slice: Optional[bool] = ...,
          precision: Optional[_Precision] = ..., certify: Optional[bool] = ..., every_path: Optional[bool] = ..., digits: Optional[int] = ...,
          cross_check: Optional[bool] = ..., tracker_options: Optional[Mapping[str, Any]] = ..., progress: _Progress = ...,
          ledger: Optional[_Path] = ...) -> Result: ...

class Info:
    variables: list[str]
    equations: int
    terms: int
    degrees: list[int]
    total_degree: Optional[int]
    paths: dict[str, Optional[int]]
    conditions: list[str]
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_text(self) -> str: ...

class Verdict:
    holds: bool
    proofs_hold: bool
    refuted: list[dict[str, Any]]
    open: list[dict[str, Any]]
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_text(self) -> str: ...

def info(equations: _Equations, *, variables: Optional[Sequence[Any]] = ..., time_limit: Optional[float] = ...) -> Info: ...
def check(equations: _Equations, result: Union[Result, _Path], *, variables: Optional[Sequence[Any]] = ...,
          time_limit: Optional[float] = ...) -> Verdict: ...

class Family:
    variables: list[str]
    parameters: list[str]
    roots: int
    complete: bool
    standing: str
    @classmethod
    def learn(cls, equations: _Equations, parameters: Union[Sequence[Any], Mapping[Any, float]], *,
              variables: Optional[Sequence[Any]] = ..., monodromy: bool = ..., nonzero: bool = ..., trace_test: Optional[bool] = ...,
              tracker: Optional[_Tracker] = ..., start: Optional[_Start] = ..., seed: Optional[int] = ...,
              threads: Optional[int] = ..., time_limit: Optional[float] = ..., certify: Optional[bool] = ...,
              tracker_options: Optional[Mapping[str, Any]] = ..., progress: _Progress = ..., ledger: Optional[_Path] = ...) -> Family: ...
    @classmethod
    def load(cls, path: _Path) -> Family: ...
    def save(self, path: _Path) -> None: ...
    def solve(self, members: npt.ArrayLike, *, tracker: Optional[_Tracker] = ..., seed: Optional[int] = ...,
              threads: Optional[int] = ..., time_limit: Optional[float] = ..., certify: Optional[bool] = ...,
              tracker_options: Optional[Mapping[str, Any]] = ..., progress: _Progress = ...) -> Members: ...
    def member(self, values: Mapping[Any, Union[_Number, str]], *, tracker: Optional[_Tracker] = ..., seed: Optional[int] = ...,
               threads: Optional[int] = ..., time_limit: Optional[float] = ..., certify: Optional[bool] = ...,
               tracker_options: Optional[Mapping[str, Any]] = ..., progress: _Progress = ...) -> Result: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...

class Members:
    points: _Complexes
    member: _Ints
    counts: _Ints
    real: _Bools
    multiplicity: _Ints
    accuracy: _Floats
    certified: _Bools
    decided: _Bools
    completeness: list[Optional[str]]
    complete: bool
    def __len__(self) -> int: ...
    def of(self, member: int) -> _Complexes: ...
    def to_csv(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...

class Body:
    def __getattr__(self, coordinate: str) -> float: ...

class Closure:
    id: str
    names: tuple[str, ...]
    q: _Floats
    bodies: dict[str, Body]
    points: dict[str, _Floats]
    certified: Optional[bool]
    singular: bool
    multiplicity: int
    residual: float
    misfit: float
    fitted: bool
    play: Optional[float]
    drawn: bool
    def __getitem__(self, name: str) -> float: ...

class _Reported:
    @property
    def svg(self) -> str: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_svg(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_html(self, path: Optional[_Path] = ...) -> Optional[str]: ...

class Closures(_Reported):
    complete: bool
    completeness: Optional[str]
    message: str
    counts: dict[str, int]
    paths: dict[str, int]
    moves: bool
    time: float
    names: list[str]
    ids: list[str]
    q: _Floats
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, index: Union[int, str]) -> Closure: ...
    @overload
    def __getitem__(self, index: slice) -> list[Closure]: ...
    def __iter__(self) -> Iterator[Closure]: ...
    def to_csv(self, path: Optional[_Path] = ..., angles: _Angles = ...) -> Optional[str]: ...
    def to_svg(self, path: Optional[_Path] = ..., three_views: bool = ...) -> Optional[str]: ...
    def sensitivity(self) -> Sensitivity: ...
    def guesses(self) -> Guesses: ...

class Event:
    kind: str
    t: float
    q: _Floats
    drivers: list[float]
    ending: list[str]
    beginning: list[str]

class Branch:
    id: str
    t: _Floats
    q: _Floats
    velocity: _Floats
    acceleration: _Floats
    begins: float
    ends: float
    begin_event: Optional[Event]
    event: Optional[Event]
    complete: bool
    message: str

class Motion(_Reported):
    complete: bool
    message: str
    failures: list[str]
    names: list[str]
    events: list[Event]
    branches: list[Branch]
    def __len__(self) -> int: ...
    def to_json(self, path: Optional[_Path] = ..., continuous: bool = ...) -> Optional[str]: ...
    def to_csv(self, path: Optional[_Path] = ..., angles: _Angles = ..., continuous: bool = ...) -> Optional[str]: ...

class Sweep(_Reported):
    names: list[str]
    shape: tuple[int, ...]
    at: _Floats
    real: _Ints
    usable: _Ints
    complex: _Ints
    moves: _Bools
    decided: _Bools
    borders: _Floats
    complete: bool
    def __len__(self) -> int: ...
    def to_csv(self, path: Optional[_Path] = ...) -> Optional[str]: ...

class ClosureSensitivity:
    id: str
    missing: str
    rates: _Floats
    worst_case: _Floats
    root_sum_square: _Floats

class Sensitivity:
    dimensions: list[str]
    quantities: list[str]
    values: _Floats
    tolerances: _Floats
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> ClosureSensitivity: ...
    def rate(self, quantity: str, dimension: str, closure: int = ...) -> float: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_csv(self, path: Optional[_Path] = ..., angles: _Angles = ...) -> Optional[str]: ...

class Guesses:
    names: list[str]
    ids: list[str]
    q: _Floats
    def __len__(self) -> int: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_csv(self, path: Optional[_Path] = ..., angles: _Angles = ...) -> Optional[str]: ...

class Mobility:
    degrees_of_freedom: int
    gruebler: int
    driven_freedoms: int
    rank: int
    redundant: list[str]
    is_singular: bool
    is_assembled: bool
    q: _Floats
    null_space: _Floats
    json: str
    text: str
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...

class Newton:
    converged: bool
    status: str
    message: str
    q: _Floats
    iterates: _Floats
    residuals: _Floats
    rank: int
    is_singular: bool
    condition: float
    json: str
    text: str
    def __len__(self) -> int: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...

class Mechanism:
    title: str
    coordinates: list[str]
    points: list[str]
    dimensions: list[str]
    warnings: list[str]
    def __init__(self, source: Union[_Path, Mapping[str, Any]]) -> None: ...
    @classmethod
    def from_robot(cls, path: _Path, *, loops: Optional[_Path] = ..., hold: Optional[Mapping[str, float]] = ...,
                   tip: Optional[str] = ..., pose: Optional[npt.ArrayLike] = ...) -> Mechanism: ...
    def point_position(self, point: str, q: npt.ArrayLike) -> _Floats: ...
    def closures(self, *, at: Optional[float] = ..., fit: Optional[float] = ..., meshings: Optional[bool] = ...,
                 tolerance: Optional[float] = ..., tracker: Optional[_Tracker] = ..., start: Optional[_Start] = ...,
                 seed: Optional[int] = ..., threads: Optional[int] = ..., time_limit: Optional[float] = ...,
                 certify: Optional[bool] = ..., tracker_options: Optional[Mapping[str, Any]] = ...,
                 progress: _Progress = ...) -> Closures: ...
    def motion(self, *, begin: Optional[float] = ..., end: Optional[float] = ..., steps: Optional[int] = ...,
               checkpoints: Optional[int] = ..., guess: Optional[Mapping[str, float]] = ..., from_guess: Optional[bool] = ...,
               closure: Union[None, str, Sequence[str]] = ..., fit: Optional[float] = ..., meshings: Optional[bool] = ...,
               tracker: Optional[_Tracker] = ..., start: Optional[_Start] = ..., seed: Optional[int] = ...,
               threads: Optional[int] = ..., time_limit: Optional[float] = ..., certify: Optional[bool] = ...,
               tracker_options: Optional[Mapping[str, Any]] = ..., progress: _Progress = ...) -> Motion: ...
    def sweep(self, vary: Mapping[str, tuple[float, float, int]], *, at: Optional[float] = ..., fit: Optional[float] = ...,
              meshings: Optional[bool] = ..., borders: Optional[bool] = ..., tracker: Optional[_Tracker] = ...,
              start: Optional[_Start] = ..., seed: Optional[int] = ..., threads: Optional[int] = ...,
              time_limit: Optional[float] = ..., tracker_options: Optional[Mapping[str, Any]] = ...,
              progress: _Progress = ...) -> Sweep: ...
    def sensitivity(self, tolerance: Optional[float] = ..., *, at: Optional[float] = ..., **options: Any) -> Sensitivity: ...
    def guesses(self, *, at: Optional[float] = ..., **options: Any) -> Guesses: ...
    def mobility(self, *, at: Optional[float] = ..., guess: Optional[Mapping[str, float]] = ..., fit: Optional[float] = ...,
                 meshings: Optional[bool] = ..., time_limit: Optional[float] = ...) -> Mobility: ...
    def newton(self, *, at: Optional[float] = ..., guess: Optional[Mapping[str, float]] = ...,
               weight: Optional[Mapping[str, float]] = ..., tolerance: Optional[float] = ...,
               max_iterations: Optional[int] = ...) -> Newton: ...

class Arm:
    robot: str
    base: str
    tip: str
    joints: list[str]
    limits: list[Optional[tuple[float, float]]]
    def __init__(self, path: _Path, base: Optional[str] = ..., tip: Optional[str] = ...,
                 hold: Optional[Mapping[str, float]] = ...) -> None: ...
    @classmethod
    def from_dh(cls, rows: Sequence[Sequence[Any]] | npt.NDArray[Any], *, modified: bool = ..., name: str = ...,
                hold: Optional[Mapping[str, float]] = ...) -> Arm: ...
    def fk(self, q: npt.ArrayLike) -> _Floats: ...
    def misfit(self, q: npt.ArrayLike, poses: npt.ArrayLike) -> tuple[Any, Any]: ...
    def ik(self, poses: npt.ArrayLike, *, pose_accuracy: Optional[float] = ..., nearest: Optional[npt.ArrayLike] = ...,
           limits: Optional[Literal["wrap"]] = ..., tracker: Optional[_Tracker] = ..., start: Optional[_Start] = ...,
           seed: Optional[int] = ..., threads: Optional[int] = ..., time_limit: Optional[float] = ...,
           tracker_options: Optional[Mapping[str, Any]] = ..., progress: _Progress = ...) -> Postures: ...

class SelfMotion:
    dimension: int
    q: _Floats
    directions: _Floats
    lost: _Floats
    relations: list[tuple[_Floats, float]]
    samples: _Floats
    closes: bool
    misfit: float
    within_digits: bool
    def contains(self, q: npt.ArrayLike, within: Optional[float] = ...) -> bool: ...

class NearestPosture:
    q: _Floats
    position: float
    rotation: float

class Postures:
    values: _Floats
    in_limits: _Floats
    counts: _Ints
    moves: _Bools
    decided: _Bools
    residual: _Floats
    within_digits: _Bools
    moved_by_digits: _Floats
    smallest_singular_value: _Floats
    distance: Optional[_Floats]
    complete: bool
    def __len__(self) -> int: ...
    def __getitem__(self, pose: int) -> _Floats: ...
    def names(self, pose: int = ...) -> list[str]: ...
    def turns(self, pose: int = ...) -> list[_Floats]: ...
    def motions(self, pose: int = ...) -> list[SelfMotion]: ...
    def nearest_posture(self, pose: int = ...) -> Optional[NearestPosture]: ...
    def message(self, pose: int = ...) -> str: ...
    def to_json(self, path: Optional[_Path] = ...) -> Optional[str]: ...
    def to_csv(self, path: Optional[_Path] = ..., angles: _Angles = ...) -> Optional[str]: ...
    def to_svg(self, path: Optional[_Path] = ..., three_views: bool = ...) -> Optional[str]: ...
    def to_html(self, path: Optional[_Path] = ...) -> Optional[str]: ...
