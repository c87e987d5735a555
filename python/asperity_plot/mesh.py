"""A mesh in space: a map of its ground and faults, and a vertical section across the longest fault.

Cells of the section are cut by its plane; cells of the map are the facets of its upper side.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np
from matplotlib.collections import LineCollection

from asperity.errors import InputError
from asperity.h5file import H5File

from . import style, units

FORMAT = "asperity-mesh"
COLOURS = (style.ORANGE, style.BLUE, "#3a8a4c", "#8a3a7d", "#b5912a", "#2a9aa5")
FACES = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))
SIDES = ((0, 1), (1, 2), (2, 0))


@dataclass
class Mesh:
    """Coordinates in m; `up` is the axis that points up."""

    vertices: np.ndarray             # (vertices, 3)
    cells: np.ndarray                # (cells, 4)
    boundaries: Dict[str, np.ndarray]  # (facets, 3) each
    faults: List[str]
    up: int

    @classmethod
    def read(cls, path: Path, up: str) -> "Mesh":
        file = H5File(path)
        if file.attribute("/", "format") != FORMAT:
            raise InputError(f"{path} is no mesh file. A mesh that is divided for ranks is drawn "
                             "from the file before it was divided.")
        cells = file.array("cells").astype(int)
        if cells.shape[1] != 4:
            raise InputError(f"{path} is a mesh in the plane; this figure is of meshes in space.")
        boundaries = {name: file.array(f"boundaries/{name}/facets").astype(int)
                      for name in file.entries("boundaries")}
        outer = _outer(cells)
        faults = [name for name, facets in boundaries.items()
                  if len(facets) and not np.isin(_keys(facets), outer).all()]
        return cls(file.array("vertices"), cells, boundaries, faults, "xyz".index(up))

    @property
    def level(self) -> List[int]:
        """The two horizontal axes, that of the map's abscissa first."""
        return [axis for axis in range(3) if axis != self.up]

    def top(self) -> np.ndarray:
        """(facets, 3) of the boundary whose facets face up most."""
        names = [name for name in self.boundaries if name not in self.faults]
        if not names:
            return np.empty((0, 3), dtype=int)
        height = {name: self._height(name) for name in names if self._is_level(name)}
        return self.boundaries[max(height, key=height.get)] if height else np.empty((0, 3), int)

    def _height(self, name: str) -> float:
        return float(self.vertices[self.boundaries[name]][:, :, self.up].mean())

    def _is_level(self, name: str) -> bool:
        corners = self.vertices[self.boundaries[name]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return bool(np.abs(normals[:, self.up]).sum() > 0.7 * np.linalg.norm(normals, axis=1).sum())


def draw(path: Path, up: str = "z"):
    """A figure of matplotlib."""
    mesh = Mesh.read(path, up)
    far = units.length(np.ptp(mesh.vertices, axis=0))
    point, along = _section(mesh)
    figure, axes = style.panels(1, 2, (12.0, 5.6))
    _map(axes[0, 0], mesh, far, point, along)
    _cut(axes[0, 1], mesh, far, point, along)
    style.title(figure, f"{path.name}: {len(mesh.cells):,} cells, {len(mesh.vertices):,} vertices")
    return figure


def _outer(cells: np.ndarray) -> np.ndarray:
    """Keys of the faces of one cell alone."""
    keys, counts = np.unique(np.concatenate([_keys(cells[:, face]) for face in FACES]),
                             return_counts=True)
    return keys[counts == 1]


def _keys(facets: np.ndarray) -> np.ndarray:
    """(facets) the sorted corners as one thing that can be compared."""
    ordered = np.ascontiguousarray(np.sort(facets, axis=1).astype(np.int64))
    return ordered.view([("", np.int64)] * 3).ravel()


def _section(mesh: Mesh) -> Tuple[np.ndarray, np.ndarray]:
    """A point of the section and its horizontal unit vector: across the fault of the largest area,
    through its middle; without a fault along the map's abscissa, through the middle of the body."""
    along = np.zeros(3)
    along[mesh.level[0]] = 1.0
    if not mesh.faults:
        return 0.5 * (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)), along
    extent = {name: _area(mesh, name) for name in mesh.faults}
    corners = mesh.vertices[mesh.boundaries[max(extent, key=extent.get)]]
    middles = corners.mean(axis=1)
    level = middles[:, mesh.level] - middles[:, mesh.level].mean(axis=0)
    strike = np.linalg.svd(level, full_matrices=False)[2][0]
    if np.ptp(level @ strike) < 1.5 * np.ptp(level @ np.array([-strike[1], strike[0]])):
        # As broad as long on the map: the normals tell better.
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        across = normals[:, mesh.level]
        across = across * np.sign(normals[:, [mesh.up]] + 1e-300)
        if np.linalg.norm(across.sum(axis=0)) > 0.05 * np.linalg.norm(normals, axis=1).sum():
            strike = np.array([-across.sum(axis=0)[1], across.sum(axis=0)[0]])
            strike /= np.linalg.norm(strike)
    along[mesh.level] = -strike[1], strike[0]
    along *= 1.0 if along[mesh.level][np.argmax(np.abs(along[mesh.level]))] > 0.0 else -1.0
    return middles[np.argmin(np.linalg.norm(level, axis=1))], along


def _area(mesh: Mesh, name: str) -> float:
    corners = mesh.vertices[mesh.boundaries[name]]
    return 0.5 * float(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0],
                                               corners[:, 2] - corners[:, 0]), axis=1).sum())


def _map(panel, mesh: Mesh, far, point, along) -> None:
    places = far(mesh.vertices[:, mesh.level])
    top = mesh.top()
    if len(top):
        _lines(panel, places[_sides(top)], style.GREY, 0.25)
    for name, colour in _coloured(mesh):
        facets = mesh.boundaries[name]
        _lines(panel, places[_sides(facets)], colour, 0.2)
        _lines(panel, places[_border(facets)], colour, 1.4, name)
    ends = _ends(mesh, point, along)
    panel.plot(*far(ends[:, mesh.level]).T, color=style.DARK, linewidth=0.9,
               linestyle=(0, (5, 4)), label="section")
    abscissa, ordinate = ("xyz"[axis] for axis in mesh.level)
    panel.set(title="Map: the upper side, and faults seen from above", aspect="equal",
              xlabel=f"{abscissa} [{far.name}]", ylabel=f"{ordinate} [{far.name}]")
    if mesh.up == 1:
        panel.invert_yaxis()  # z points to the south
    panel.legend(loc="upper right", fontsize=8, frameon=True, framealpha=0.9)


def _ends(mesh: Mesh, point, along) -> np.ndarray:
    """(2, 3) where the section leaves the box around the body."""
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    first, last = -np.inf, np.inf
    for axis in mesh.level:
        if abs(along[axis]) > 1e-9:
            limits = np.sort((np.array([low[axis], high[axis]]) - point[axis]) / along[axis])
            first, last = max(first, limits[0]), min(last, limits[1])
    return point + np.array([[first], [last]]) * along


def _cut(panel, mesh: Mesh, far, point, along) -> None:
    normal = np.cross(along, np.eye(3)[mesh.up])
    heights = (mesh.vertices - point) @ normal
    heights[np.abs(heights) < 1e-9 * np.ptp(mesh.vertices)] = 1e-9 * np.ptp(mesh.vertices)
    distance = (mesh.vertices - point) @ along
    flat = far(np.column_stack([distance, mesh.vertices[:, mesh.up]]))
    is_above = heights[mesh.cells] > 0.0
    cells = mesh.cells[is_above.any(axis=1) & ~is_above.all(axis=1)]
    faces = np.unique(np.sort(np.concatenate([cells[:, face] for face in FACES]), axis=1), axis=0)
    _lines(panel, _crossed(faces, heights, flat), style.GREY, 0.35)
    for name, colour in _coloured(mesh):
        _lines(panel, _crossed(mesh.boundaries[name], heights, flat), colour, 1.6, name)
    low, high = mesh.level
    azimuth = np.degrees(np.arctan2(along[low], along[high] * (-1.0 if mesh.up == 1 else 1.0)))
    panel.set(title=f"Section with azimuth {azimuth % 360.0:.0f}°, no exaggeration",
              aspect="equal", xlabel=f"Distance along the section [{far.name}]",
              ylabel=f"{'xyz'[mesh.up]} [{far.name}]")
    panel.autoscale_view()


def _crossed(faces: np.ndarray, heights: np.ndarray, flat: np.ndarray) -> np.ndarray:
    """(lines, 2, 2) where the plane of height 0 cuts triangles."""
    at = heights[faces]
    keep = (at > 0.0).any(axis=1) & (at < 0.0).any(axis=1)
    faces, at = faces[keep], at[keep]
    pieces = []
    for first, second in SIDES:
        a, b = at[:, first], at[:, second]
        cut = a * b < 0.0
        share = np.where(cut, a / np.where(cut, a - b, 1.0), np.nan)[:, None]
        pieces.append(flat[faces[:, first]] * (1.0 - share) + flat[faces[:, second]] * share)
    corners = np.stack(pieces, axis=1)
    return corners[~np.isnan(corners[:, :, 0])].reshape(-1, 2, 2)


def _coloured(mesh: Mesh):
    return [(name, COLOURS[i % len(COLOURS)]) for i, name in enumerate(sorted(mesh.faults))]


def _sides(facets: np.ndarray) -> np.ndarray:
    """(sides, 2) each once."""
    return np.unique(np.sort(np.concatenate([facets[:, side] for side in SIDES]), axis=1), axis=0)


def _border(facets: np.ndarray) -> np.ndarray:
    """(sides, 2) of one facet alone."""
    sides = np.sort(np.concatenate([facets[:, side] for side in SIDES]), axis=1)
    found, counts = np.unique(sides, axis=0, return_counts=True)
    return found[counts == 1]


def _lines(panel, lines, colour, width: float, label: str = "") -> None:
    panel.add_collection(LineCollection(lines, colors=colour, linewidths=width,
                                        label=label or None, rasterized=len(lines) > 20000))
    panel.autoscale_view()
