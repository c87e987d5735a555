"""Places for the names of traces on a map: beside each, clear of the others and of other names."""

from dataclasses import dataclass
from typing import List, Sequence, Tuple

import numpy as np

PLACES = np.linspace(0.1, 0.9, 17)  # along a trace, as shares of its nodes
LETTER, HEIGHT, GAP = 0.6, 1.0, 0.6  # width, height, distance from the trace in sizes of letters


@dataclass(frozen=True)
class Name:
    """A text around `place`, turned by `angle` [degrees], above or below."""

    text: str
    place: np.ndarray    # (2) on the trace
    upwards: np.ndarray  # (2) unit vector away from the trace, on the side of the text
    angle: float
    is_above: bool


def arranged(traces: Sequence[Tuple[str, np.ndarray]], letter: float) -> List[Name]:
    """A name for each trace (nodes, 2), for letters of this size in the unit of the nodes. Each in
    turn takes the place that is farthest from other traces and from the names before it; of places
    equally far the one nearest to the middle of the trace."""
    names, taken = [], [nodes for _, nodes in traces]
    for number, (text, nodes) in enumerate(traces):
        others = np.concatenate([each for k, each in enumerate(taken) if k != number])
        found = max(_candidates(text, nodes), key=lambda name: _clearance(name, others, letter))
        names.append(found)
        taken.append(_box(found, letter))
    return names


def _candidates(text: str, nodes: np.ndarray) -> List[Name]:
    """Those nearest to the middle come first, and above before below."""
    along_it = nodes[-1] - nodes[0]
    along_it = along_it * (-1.0 if along_it[0] < 0.0 else 1.0) / (np.linalg.norm(along_it) or 1.0)
    upwards = np.array([-along_it[1], along_it[0]])
    angle = float(np.degrees(np.arctan2(along_it[1], along_it[0])))
    return [Name(text, nodes[round(share * (len(nodes) - 1))], side * upwards, angle, side > 0)
            for share in sorted(PLACES, key=lambda share: abs(share - 0.5)) for side in (1, -1)]


def _clearance(name: Name, others: np.ndarray, letter: float) -> float:
    """The distance to `others` (n, 2), in whole letters; far is far enough."""
    away = np.linalg.norm(_box(name, letter)[:, None] - others, axis=-1).min() / letter
    return float(np.floor(min(away, 3.0)))


def _box(name: Name, letter: float) -> np.ndarray:
    """Points of the text."""
    along_it = np.array([name.upwards[1], -name.upwards[0]])
    half = 0.5 * LETTER * len(name.text)
    across = np.array([GAP, GAP + 0.5 * HEIGHT, GAP + HEIGHT])
    return (name.place + letter * (np.linspace(-half, half, 9)[:, None, None] * along_it
                                   + across[None, :, None] * name.upwards)).reshape(-1, 2)
