"""SEAS BP3-QD with 60 degrees in thrust by the independent program: dipping_fault.py CELL, or
dipping_fault.py FILE with what asperity-bench stiffness writes of a mesh for xml/bp3_qd.xml.

It agrees with the published answers of another boundary element code with elements of 25 m, whose
four intervals after the sixth event repeat. So these are answers of the problem and not of a code.
"""

import os
import sys

import numpy
from dipping_operators import DippingElements
from earthquake_cycles import Problem, events
from mesh_operators import MeshOperator

BP3 = Problem(critical_slip=0.008)
PLACE = 7500  # m down dip
# Of the elements beside that place, when it passes 1 mm/s; limits chosen when 0.2 % had been found.
ONSETS = (177.1, 277.3, 334.3, 421.3, 513.7, 611.1, 674.3, 761.4, 852.5, 950.0)  # yr
SLIPS = (1.06, 3.37, 2.37, 2.61, 2.82, 2.99, 2.33, 2.60, 2.78, 2.98)  # m


def main(cells):
    # The deck's fault has its tangent down dip, against the slip of a thrust.
    operator = (MeshOperator(cells, -1) if os.path.exists(cells) else
                DippingElements(float(cells), BP3.length, 60, BP3.shear_modulus))
    found = []
    for event in events(BP3, operator, ONSETS[-1] + 1):
        slip = float(numpy.interp(PLACE, operator.positions, event.slip))
        print(f"onset {event.onset:.2f} yr, slip {slip:.3f} m", flush=True)
        found.append((event.onset, slip))
    if len(found) != len(ONSETS):
        return True
    onsets, slips = numpy.transpose(found)
    return not (numpy.all(abs(onsets / ONSETS - 1) < 0.005)
                and numpy.all(abs(slips / SLIPS - 1) < 0.02))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
