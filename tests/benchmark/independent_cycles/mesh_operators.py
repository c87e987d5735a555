"""How slip stresses a fault on the mesh of a deck, as asperity-bench stiffness writes it."""

import numpy


class MeshOperator:
    """As in earthquake_cycles. The file counts slip along the fault's tangent; with sense = -1 slip
    is against it, which changes the sign of the compression alone."""

    def __init__(self, file_name, sense=1):
        table = numpy.loadtxt(file_name)
        count = len(table)
        self.positions = table[:, 0]
        self._traction = table[:, 2:2 + count]
        self._compression = sense * table[:, 2 + count:]

    def stress_of(self, slip):
        has_compression = self._compression.shape[1] > 0
        return self._traction @ slip, self._compression @ slip if has_compression else 0
