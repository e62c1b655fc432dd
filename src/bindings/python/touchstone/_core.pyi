# The types of the compiled half. The documented functions are in _queries.py and its neighbours.
from typing import Any, Dict, Iterable, Iterator, List, Literal, Mapping, Optional, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._names import Feature, Level, Nature, Trend

__version__: str
_names: Dict[str, Tuple[str, ...]]

_Bools = NDArray[np.bool_]
_Doubles = NDArray[np.float64]
_Codes = NDArray[np.uint8]
_Indices = NDArray[np.uint32]
_Weights = Tuple[float, float, float]
_Pair = Tuple[str, int, int]
_Intersection = Tuple[str, int, str, int, str]
_Several = Union[slice, NDArray[Any], List[int], List[bool]]
_Number = Tuple[int, int]
_BodyPair = Tuple[str, _Number, _Number]
_BodyIntersection = Tuple[str, _Number, str, _Number, str]
_Order = Literal["wxyz", "xyzw"]
_Turn = Literal["shorter", "as-given"]

class Answer:
    contact: bool
    toi: float
    toi_upper: float
    starts_within: bool
    nature: Nature
    feature_a: Feature
    feature_b: Feature
    level: Level
    trend: Trend
    weights_a: _Weights
    weights_b: _Weights
    def __bool__(self) -> bool: ...

class Answers:
    contact: _Bools
    toi: _Doubles
    toi_upper: _Doubles
    nature: _Codes
    feature_a: _Codes
    feature_b: _Codes
    level: _Codes
    trend: _Codes
    starts_within: _Bools
    weights_a: _Doubles
    weights_b: _Doubles
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> Answer: ...
    @overload
    def __getitem__(self, i: _Several) -> Answers: ...
    def __iter__(self) -> Iterator[Answer]: ...
    def to_pandas(self) -> Any: ...

class ExactTime:
    lower: float
    upper: float
    def __float__(self) -> float: ...
    def __lt__(self, other: Any) -> bool: ...
    def __le__(self, other: Any) -> bool: ...
    def __gt__(self, other: Any) -> bool: ...
    def __ge__(self, other: Any) -> bool: ...

class Distance:
    value: float
    feature_a: Feature
    feature_b: Feature
    weights_a: _Weights
    weights_b: _Weights
    def __float__(self) -> float: ...

class Distances:
    value: _Doubles
    feature_a: _Codes
    feature_b: _Codes
    weights_a: _Doubles
    weights_b: _Doubles
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> Distance: ...
    @overload
    def __getitem__(self, i: _Several) -> Distances: ...
    def __iter__(self) -> Iterator[Distance]: ...
    def to_pandas(self) -> Any: ...

class Mesh:
    vertex_count: int
    dimension: int
    metric: str
    faces: _Indices
    edges: _Indices
    points: _Indices
    def __init__(self, vertices: Union[int, ArrayLike], faces: Optional[ArrayLike] = None,
                 edges: Optional[ArrayLike] = None, points: Optional[ArrayLike] = None, separation: float = 0.0,
                 metric: str = "euclidean", radii: Optional[ArrayLike] = None, *, dimension: Optional[int] = None,
                 excluded_vertices: Optional[ArrayLike] = None, excluded_pairs: Iterable[_Pair] = (),
                 groups: Optional[ArrayLike] = None, group_pairs: Optional[ArrayLike] = None,
                 only_listed_groups: bool = False, pair_separations: Mapping[_Pair, float] = ...) -> None: ...
    def has_pairs(self) -> bool: ...
    def may_collide(self, pair: _Pair) -> bool: ...
    def separation_of(self, pair: _Pair) -> float: ...
    def corners(self, pair: _Pair) -> List[int]: ...
    def describe(self, pair: Union[_Pair, _Intersection]) -> str: ...

class Pairs:
    kind: List[str]
    first: _Indices
    second: _Indices
    separation: _Doubles
    answers: Answers
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> _Pair: ...
    @overload
    def __getitem__(self, i: _Several) -> Pairs: ...
    def __iter__(self) -> Iterator[_Pair]: ...
    def to_pandas(self) -> Any: ...

class FirstContact:
    contact: bool
    toi: float
    toi_upper: float
    free: bool
    earliest: Pairs
    at_start: Pairs
    start_checked: bool
    start_intersections: Intersections

class ClosestApproach:
    distance: float
    first_contact: FirstContact

class FreeStep:
    outcome: str
    length: float
    positions: _Doubles
    first_contact: FirstContact
    proofs: int

class MeshSteps:
    mesh: Mesh
    searches: int
    def __init__(self, mesh: Any) -> None: ...
    def first_contact(self, x0: ArrayLike, x1: ArrayLike, t_max: float = 1.0, threads: int = 1, *,
                      check_start: bool = False) -> FirstContact: ...
    def all_contacts(self, x0: ArrayLike, x1: ArrayLike, t_max: float = 1.0, threads: int = 1) -> Pairs: ...
    def free_step(self, x0: ArrayLike, x1: ArrayLike, kept_fraction: float = 0.0, threads: int = 1, *,
                  check_start: bool = False, float32: bool = False) -> FreeStep: ...
    def release(self) -> None: ...

class MeshReader:
    def __init__(self, triangulate: bool, weld: bool, drop_degenerate: bool) -> None: ...
    def read(self, file: str) -> Tuple[_Doubles, Any, Any, Any, List[str], Any, int, int]: ...
    def check_elements(self, file: str) -> None: ...

class Intersections:
    first_element: List[str]
    first: _Indices
    second_element: List[str]
    second: _Indices
    sort: List[str]
    pierces: _Bools
    weights_first: _Doubles
    weights_second: _Doubles
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> _Intersection: ...
    @overload
    def __getitem__(self, i: _Several) -> Intersections: ...
    def __iter__(self) -> Iterator[_Intersection]: ...
    def to_pandas(self) -> Any: ...

class Body:
    points: _Doubles
    mesh: Mesh
    def __init__(self, points: Any, faces: Optional[ArrayLike] = None, edges: Optional[ArrayLike] = None,
                 loose_points: Optional[ArrayLike] = None, radii: Optional[ArrayLike] = None, *,
                 mesh: Optional[Any] = None) -> None: ...

class BodyPairs:
    kind: List[str]
    first_body: _Indices
    first: _Indices
    second_body: _Indices
    second: _Indices
    separation: _Doubles
    answers: Answers
    excluded: int
    turned: _Indices
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> _BodyPair: ...
    @overload
    def __getitem__(self, i: slice) -> BodyPairs: ...
    def __iter__(self) -> Iterator[_BodyPair]: ...
    def to_pandas(self) -> Any: ...

class BodyIntersections:
    first_element: List[str]
    first_body: _Indices
    first: _Indices
    second_element: List[str]
    second_body: _Indices
    second: _Indices
    sort: List[str]
    in_open: int
    cancelled: int
    excluded: int
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, i: int) -> _BodyIntersection: ...
    @overload
    def __getitem__(self, i: slice) -> BodyIntersections: ...
    def __iter__(self) -> Iterator[_BodyIntersection]: ...
    def to_pandas(self) -> Any: ...

class FirstBodyContact:
    contact: bool
    toi: float
    toi_upper: float
    free: bool
    earliest: BodyPairs
    at_start: BodyPairs
    start_checked: bool
    start_intersections: BodyIntersections
    in_open: int
    cancelled: int
    excluded: int
    turned: _Indices
    t_max: float

class FreeBodyStep:
    outcome: str
    length: float
    poses: _Doubles
    first_contact: FirstBodyContact
    proofs: int

class BodyScrewAnswer:
    verdict: str
    free: bool
    free_until: float
    contact_by: float
    start_checked: bool
    start_intersections: BodyIntersections
    pairs: BodyPairs
    pair_verdict: List[str]
    pair_free_until: _Doubles
    pair_contact_by: _Doubles
    pair_deviation: _Doubles
    in_open: int
    cancelled: int
    excluded: int
    turned: _Indices
    t_max: float

class BodyDistance:
    distance: float
    pairs: BodyPairs
    intersections: BodyIntersections
    excluded: int
    in_open: int
    cancelled: int

# Any: one motion has a result, and n motions have a list of n.
class Bodies:
    bodies: List[Body]
    separation: float
    metric: str
    def __init__(self, bodies: Iterable[Body], *, separation: float = 0.0, metric: str = "euclidean",
                 ignore: ArrayLike = (), groups: Optional[ArrayLike] = None, group_pairs: Optional[ArrayLike] = None,
                 only_listed_groups: bool = False) -> None: ...
    def __len__(self) -> int: ...
    def first_contact(self, start: ArrayLike, end: ArrayLike, *, quaternion: _Order, turn: _Turn = "shorter",
                      t_max: float = 1.0, threads: int = 1, check_start: bool = True) -> Any: ...
    def all_contacts(self, start: ArrayLike, end: ArrayLike, *, quaternion: _Order, turn: _Turn = "shorter",
                     t_max: float = 1.0, threads: int = 1) -> Any: ...
    def candidates(self, start: ArrayLike, end: ArrayLike, *, quaternion: _Order, turn: _Turn = "shorter",
                   threads: int = 1) -> Any: ...
    def free_step(self, start: ArrayLike, end: ArrayLike, *, quaternion: _Order, turn: _Turn = "shorter",
                  threads: int = 1, check_start: bool = True) -> Any: ...
    def solve_screw(self, start: ArrayLike, end: ArrayLike, *, quaternion: _Order, turn: _Turn = "shorter",
                    inner: Optional[ArrayLike] = None, t_max: float = 1.0, threads: int = 1, check_start: bool = True,
                    arcs: int = 8, most_arcs: int = 256) -> Any: ...
    def contact_normal(self, contacts: BodyPairs, start: ArrayLike, end: ArrayLike, *, quaternion: _Order,
                       turn: _Turn = "shorter", t_max: float = 1.0, threads: int = 1) -> _Doubles: ...
    def intersections(self, poses: ArrayLike, *, quaternion: _Order, threads: int = 1) -> Any: ...
    def distance(self, poses: ArrayLike, *, quaternion: _Order, threads: int = 1) -> Any: ...
    def separation_of(self, pair: _BodyPair) -> float: ...
    def describe(self, pair: _BodyPair) -> str: ...

class CurvedArrays:
    kind: str
    single: bool
    longer_turns: int
    first_longer_turn: int
    def __len__(self) -> int: ...
    def solve(self, t_max: float, separation: ArrayLike, metric: str, threads: int,
              method: str, wanted: str) -> Union[Answers, Answer]: ...
    def contact_times(self, t_max: float, separation: ArrayLike, metric: str, threads: int) -> List[Any]: ...
    def distance(self, t: float, metric: str, threads: int) -> Union[Distances, Distance]: ...
    def contact_normal(self, t_max: float, separation: ArrayLike, threads: int) -> _Doubles: ...

class ProvedFile:
    queries: bytes
    proofs: bytes
    answers: Answers

class Finding:
    failure: str
    degeneracy: str
    count: int
    kind: str
    start: _Doubles
    end: _Doubles
    contact: bool
    toi: Optional[float]
    truth: Answer
    detail: str
    case_name: str
    separation: float
    metric: str
    def page(self) -> str: ...

class FuzzReport:
    queries: int
    failures: int
    allowed: int
    kinds_of_failure: int
    findings: List[Finding]
    def page(self) -> str: ...
    def to_pandas(self) -> Any: ...

class StepFinding:
    failure: str
    question: str
    detail: str
    count: int
    mesh: Mesh
    x0: _Doubles
    x1: _Doubles
    case_name: str
    def page(self) -> str: ...

class StepReport:
    steps: int
    failures: int
    kinds_of_failure: int
    left_out: List[str]
    findings: List[StepFinding]

def judge(truth: Answers, contact: _Bools, toi: _Doubles, late_ulps: Optional[int], late_fraction: Optional[float],
          classes: Optional[List[str]]) -> Tuple[_Codes, _Bools]: ...
def kind_name(kind: str) -> str: ...
def curved_queries(kind: str, first: Tuple[ArrayLike, ...], second: Tuple[ArrayLike, ...],
                   shorter_turn: bool) -> CurvedArrays: ...
def prove(kind: str, start: ArrayLike, end: ArrayLike, separation: float, metric: str, threads: int) -> ProvedFile: ...
def prove_curved(queries: CurvedArrays, separation: float, metric: str, threads: int) -> ProvedFile: ...
def fuzz(solver: Any, kinds: Optional[List[str]], families: Optional[List[str]], cases: int, seed: int, climb: int,
         separation: float, metric: str, early_ulps: Optional[int], early_fraction: Optional[float],
         late_ulps: Optional[int], late_fraction: Optional[float], near: float, failures: Optional[List[str]],
         findings: int) -> FuzzReport: ...
def fuzz_steps(solver: Any, cases: int, seconds: Optional[float], families: Optional[List[str]], seed: int,
               separations: bool, groups: bool, may_end_in_contact: bool, stall: float,
               early_fraction: Optional[float], late_fraction: float, twice: bool, findings: int) -> StepReport: ...
# None in a build without pages, and so are claims_page and mesh_page
def page(kind: str, start: ArrayLike, end: ArrayLike, t_max: float, separation: float, metric: str,
         title: str) -> str: ...
def claims_page(title: str, summary: str, cards: List[Tuple[Any, ...]]) -> str: ...
def mesh_page(mesh: Mesh, x0: ArrayLike, x1: ArrayLike, t_max: float, threads: int) -> str: ...
def solve(kind: str, start: ArrayLike, end: ArrayLike, t_max: float, separation: ArrayLike, metric: str, threads: int,
          method: str, wanted: str) -> Union[Answers, Answer]: ...
def contact_times(kind: str, start: ArrayLike, end: ArrayLike, t_max: float, separation: ArrayLike, metric: str,
                  threads: int) -> List[Any]: ...
def distance(kind: str, start: ArrayLike, end: ArrayLike, t: float, metric: str,
             threads: int) -> Union[Distances, Distance]: ...
def contact_normal(kind: str, start: ArrayLike, end: ArrayLike, t_max: float, separation: ArrayLike,
                   threads: int) -> _Doubles: ...
def toi_gradient(kind: str, start: ArrayLike, end: ArrayLike, t_max: float, separation: ArrayLike,
                 threads: int) -> _Doubles: ...
def first_contact(mesh: Any, x0: ArrayLike, x1: ArrayLike, t_max: float, threads: int,
                  check_start: bool) -> FirstContact: ...
def all_contacts(mesh: Any, x0: ArrayLike, x1: ArrayLike, t_max: float, threads: int, check_start: bool) -> Pairs: ...
def closest_approach(mesh: Any, x0: ArrayLike, x1: ArrayLike, t_max: float, threads: int,
                     check_start: bool) -> ClosestApproach: ...
def frame_files(names: List[str], in_order: bool) -> List[str]: ...
def candidates(mesh: Any, x0: ArrayLike, x1: ArrayLike, t_max: float, threads: int, check_start: bool) -> Pairs: ...
def intersections(mesh: Any, x: ArrayLike, threads: int) -> Intersections: ...
def intersects(mesh: Any, x: ArrayLike, threads: int) -> bool: ...
def free_step(mesh: Any, x0: ArrayLike, x1: ArrayLike, kept_fraction: float, threads: int,
              check_start: bool, float32: bool) -> FreeStep: ...
