"""Layered quad-dominant surface meshes on CAD faces. Lengths in mm, angles in degrees."""
import os
from typing import Any, Callable, Dict, Iterable, Iterator, List, Literal, Mapping, NoReturn, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

__version__: str
kernel_version: str  # of the OpenCASCADE that the core is built with

class InvalidInput(ValueError):
    """The caller's fault: a setting, a name, a file that is not there."""

    form: str  # what is said, with a {} for each value
    values: List[Any]  # texts, or dictionaries of a form and values

class GeometryError(RuntimeError):
    """The shape's fault: nothing in it that could be meshed."""

    form: str
    values: List[Any]

class Cancelled(Exception):
    """A stop that was asked for with RunContext.cancel() or Mesher.cancel()."""

class InternalError(RuntimeError):
    """A fault of this library: please report it with the model."""

    form: str
    values: List[Any]

class RunContext:
    """What a run shares with its caller: made for one run, before its file is read, and handed to
    read_file(), read_brep() and Mesher. May be used from any thread.
    """

    def __init__(self) -> None: ...
    def cancel(self) -> None:
        """Stops the run, for good: what is at work raises Cancelled within a tenth of a second
        (OpenCASCADE's readers may take longer).
        """
    @property
    def cancelled(self) -> bool: ...
    @property
    def progress(self) -> Tuple[str, float]:
        """(stage, share): "read", "boundary", "triangulate", "layers" or "core", "" before the
        first, and how much of it is done, 0 to 1.
        """
    @property
    def seconds(self) -> Dict[str, float]:
        """Wall-clock time of each stage so far."""

class Model:
    """A BRep, read once; faces, edges and vertices are numbered from 1, as FreeCAD does."""

    @property
    def face_count(self) -> int: ...
    @property
    def edge_count(self) -> int: ...
    @property
    def vertex_count(self) -> int: ...
    @property
    def diagonal(self) -> float:
        """Diagonal of the bounding box [mm]."""
    @property
    def closed(self) -> bool:
        """Whether every edge of a face is used by exactly two face sides."""
    @property
    def solids(self) -> List[List[int]]:
        """The numbers of the faces around each solid, those of cavities too."""
    @property
    def face_boxes(self) -> List[Optional[Tuple[Tuple[float, ...], Tuple[float, ...]]]]:
        """By face the least and the greatest corner of a box that holds it [mm]; None for a face
        without a surface."""
    @property
    def holes(self) -> List[Tuple[str, List[str], float]]:
        """The inner loops of plane faces: face, edges, and the diameter [mm] of a circle as long."""
    @property
    def dihedral_angles(self) -> List[Optional[float]]:
        """The angle [deg] between the two face sides at each edge; None where there are not two."""
    def project(self, face: int, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """The point of a face, by number from 1, that is nearest to each of the points (n, 3) [mm].

        Raises InvalidInput for a face that is not there.
        """

def read_brep(
    text: str, sew_tolerance: float = ..., context: Optional[RunContext] = ...
) -> Model:
    """Reads BREP text, as FreeCAD's Shape.exportBrepToString() gives it. Faces whose edges lie
    within sew_tolerance [mm] of each other are joined there; 0: none are.

    Raises InvalidInput if the text is no BREP, GeometryError if it holds no face; Cancelled.
    """

def number_rows(form: str, *arrays: NDArray[Any]) -> bytes:
    """Rows of numbers as text: `form` is that of one row, its numbers %d, %10d (integers), %25.16E,
    %r (shortest exact) or %16w (most digits in 16 characters); an array of k columns gives k
    numbers of each row. Arrays are of float64, int32 or int64.
    """

def brep_of_file(path: Union[str, bytes, "os.PathLike[str]"], sew_tolerance: float = ...,
                 context: Optional[RunContext] = ...) -> str:
    """BREP text of what .step .stp .iges .igs .brep .brp .stl files hold, by the ending in any
    case; in mm. The file is read in a child process, so that one that crashes OpenCASCADE's
    readers, or keeps them busy without end, is an error; so is one of which not everything arrives.
    What read_brep() makes of the text with the same sew_tolerance was tried there, too.

    Raises InvalidInput for a missing, damaged or unreadable file, GeometryError if it holds no
    face, Cancelled.
    """

def read_file(path: Union[str, bytes, "os.PathLike[str]"], sew_tolerance: float = ...,
              context: Optional[RunContext] = ...) -> Model:
    """read_brep(brep_of_file(path, sew_tolerance), sew_tolerance)."""

def estimate(
    model: Model, settings: "Settings", context: Optional[RunContext] = ...
) -> Dict[str, Any]:
    """What a mesh will take, within a factor of some three, before anything is made: "elements",
    "megabytes" of memory, "seconds" of computing on one processor, and "driver", the key of the
    setting that most of the elements are for.
    """

class ChildFailed(RuntimeError):
    """What was done in a child process crashed, passed its limits, or could not be begun."""

    reason: Literal["crashed", "seconds", "megabytes", "not started"]

def answer_of_child(command: Sequence[str], request: bytes, seconds: float,
                    megabytes: float) -> bytes:
    """The bytes that the program command[0] answers, which may compute for so long and take so much
    memory beyond its start: what crashes or never ends does so there. Raises ChildFailed.
    """

def answer_parent(act: Callable[[bytes], bytes]) -> NoReturn:
    """In a program that answer_of_child() has started: ends it with the bytes that act(request)
    returns. What is printed is lost.
    """

class Settings:
    """What is asked for, by the keys of docs/settings.md.

    Raises InvalidInput naming the setting and its value. What depends on the model
    is checked by Mesher.
    """

    def __init__(
        self, *,
        faces: Union[Literal["all"], Iterable[str]] = ...,
        feature_angle: float = ...,
        initial_mesh: Optional[Tuple[NDArray[np.float64], NDArray[np.int32]]] = ...,
        size: float,
        curvature_angle: float = ...,
        min_size: float = ...,
        chord_deviation: float = ...,
        relative_chord: float = ...,
        cells_across: int = ...,
        size_growth: float = ...,
        sizes: Iterable[Mapping[str, Any]] = ...,
        refinements: Iterable[Mapping[str, Any]] = ...,
        first_height: float,
        growth: float = ...,
        layers: Union[int, Literal["isotropic"]] = ...,
        walls: Union[Literal["all"], Iterable[Mapping[str, Any]]] = ...,
        others: str = ...,
        match: Iterable[str] = ...,
        off: Iterable[str] = ...,
        boundary: Iterable[str] = ...,
        smooth: Iterable[str] = ...,
        core: str = ...,
        order: int = ...,
        mapped: Iterable[str] = ...,
        periodic: Iterable[Mapping[str, Any]] = ...,
        threads: int = ...,
    ) -> None: ...
    @property
    def faces(self) -> Union[str, Tuple[str, ...]]: ...
    @property
    def feature_angle(self) -> float: ...
    @property
    def size(self) -> float: ...
    @property
    def curvature_angle(self) -> float: ...
    @property
    def min_size(self) -> float: ...
    @property
    def chord_deviation(self) -> float: ...
    @property
    def relative_chord(self) -> float: ...
    @property
    def cells_across(self) -> int: ...
    @property
    def size_growth(self) -> float: ...
    @property
    def first_height(self) -> float: ...
    @property
    def growth(self) -> float: ...
    @property
    def layers(self) -> Union[int, str]: ...
    @property
    def others(self) -> str: ...
    @property
    def match(self) -> Tuple[str, ...]: ...
    @property
    def off(self) -> Tuple[str, ...]: ...
    @property
    def boundary(self) -> Tuple[str, ...]: ...
    @property
    def smooth(self) -> Tuple[str, ...]: ...
    @property
    def core(self) -> str: ...
    @property
    def order(self) -> int: ...
    @property
    def mapped(self) -> Tuple[str, ...]: ...
    @property
    def threads(self) -> int: ...

def schema() -> Dict[str, List[Dict[str, Any]]]:
    """The rows of all settings, by table (mesh, walls, sizes, refinements): key, kind, unit,
    lowest, highest (None: no bound), above, below (the bound itself is not allowed), choices,
    required, default and doc."""

def resolve_wall(settings: Settings, wall: Mapping[str, Any] = ...) -> Dict[str, Any]:
    """What a wall of these settings comes to: first_height and end_height [mm], growth, layers as
    asked, expected_layers (0: open) and the thickness [mm] of those; None where that follows from
    the mesh. `wall` is an entry of the list of walls; its edges may be left out.

    Raises InvalidInput where it contradicts itself.
    """

class LayerReport:
    """One layer of one patch."""

    @property
    def patch(self) -> int:
        """Index into Mesh.patches, from 0."""
    @property
    def layer(self) -> int:
        """From 1."""
    @property
    def front_vertices(self) -> int:
        """After the layer."""
    @property
    def quads(self) -> int:
        """Made in this layer."""
    @property
    def triangles(self) -> int:
        """Made in this layer."""
    @property
    def vetoes(self) -> Dict[str, int]:
        """Why local operations were refused -> how often."""
    @property
    def events(self) -> Dict[str, int]:
        """Why the front lost edges -> how often."""
    @property
    def stops(self) -> Dict[str, int]:
        """Why front vertices got no further kid -> how many."""

class Mesh:
    """A finished mesh, frozen: its arrays are read-only views. Node indices count from 0."""

    @property
    def nodes(self) -> NDArray[np.float64]:
        """(n, 3) [mm]"""
    @property
    def quads(self) -> NDArray[np.int32]:
        """(q, 4), counter-clockwise against the outward normal"""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """(t, 3), counter-clockwise against the outward normal"""
    @property
    def face_of_quad(self) -> NDArray[np.int32]:
        """(q,), number of the CAD face, from 1"""
    @property
    def face_of_triangle(self) -> NDArray[np.int32]:
        """(t,), number of the CAD face, from 1"""
    @property
    def layer_of_quad(self) -> NDArray[np.int32]:
        """(q,), 0: core"""
    @property
    def layer_of_triangle(self) -> NDArray[np.int32]:
        """(t,), 0: core"""
    @property
    def node_parent(self) -> NDArray[np.int32]:
        """(n,), the node it was extruded from; -1: none"""
    @property
    def node_layer(self) -> NDArray[np.int32]:
        """(n,), the layer it was extruded in; 0: boundary or core"""
    @property
    def periodic_nodes(self) -> List[List[List[int]]]:
        """By entry of the settings' periodic: pairs (node, the one that its motion brings it onto)
        """
    @property
    def edge_segments(self) -> Dict[int, NDArray[np.int32]]:
        """CAD edge number (from 1) -> (k, 2), its mesh edges in order"""
    @property
    def mid_nodes(self) -> NDArray[np.float64]:
        """(m, 3) [mm], at order 2: nodes in the middle of mesh edges, numbered on from len(nodes)"""
    @property
    def mids_of_quad(self) -> NDArray[np.int32]:
        """(q, 4) at order 2: mid node k lies between corners k and k + 1"""
    @property
    def mids_of_triangle(self) -> NDArray[np.int32]:
        """(t, 3) at order 2"""
    @property
    def mids_of_segment(self) -> Dict[int, NDArray[np.int32]]:
        """CAD edge number -> (k,) at order 2: between the ends of its edge_segments"""
    @property
    def patches(self) -> List[Dict[str, Any]]:
        """Per patch: patch, faces, layers, quads, triangles, events, triangles_by_cause, vetoes"""
    @property
    def walls(self) -> List[Dict[str, Any]]:
        """Per wall edge and face: edge, face, first_height, growth, achieved_first_height
        {min, mean, max}, achieved_growth, layers, stops, first_stops
        {reason: {point, layer}}, shortfalls [{code, text, form, values}]; empty in a snapshot"""
    @property
    def diagnostics(self) -> List[Dict[str, Any]]:
        """Each: severity ("info", "warning", "error"), code, patch (or None), layer, point, text"""
    @property
    def figures(self) -> Dict[str, Union[int, float]]:
        """Quality figures, as in the report; all zero in a snapshot"""
    @property
    def seconds(self) -> Dict[str, float]:
        """Wall-clock times: boundary, triangulate, layers, core"""

class Mesher:
    """Mesher(model, settings, context=None) -> iterator of LayerReport, one per layer and patch.

    The caller owns the loop and may stop after any layer. The global interpreter lock is released
    while it works. The same input gives the same mesh for any number of threads.

    Raises InvalidInput naming a wrong setting; Cancelled from the loop and from result() after
    cancel(); KeyboardInterrupt.
    """

    def __init__(
        self, model: Model, settings: Settings, context: Optional[RunContext] = ...
    ) -> None: ...
    def __iter__(self) -> Iterator[LayerReport]: ...
    def __next__(self) -> LayerReport: ...
    def cancel(self) -> None:
        """RunContext.cancel() of the mesher's context: stops the work, for good."""
    def snapshot(self) -> Mesh:
        """The Mesh as it stands, before result(); its walls and figures are not measured.

        Raises Cancelled where cancel() comes meanwhile; after it, the mesh is still there.
        """
    def result(self) -> Mesh:
        """Finishes the core and gives the Mesh; the same object every time.

        Runs the loop where it was not begun; where it was, the layers so far are kept.
        """
