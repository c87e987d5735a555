"""Half a second of SCEC TPV13, whose mesh is a file of SeisSol's (PUML), read by asperity-mesh.

Argument: the folder with tpv13_training.puml.h5; status 77 where it is not there.

After half a second
* the largest slip lies in the square of 3 km where the stress exceeds the strength; it is larger
  than the slip-weakening distance, and smaller than on a fault whose stress drops everywhere and at
  once, which slips at 2 c_s stress drop / G;
* the fault has not slipped where no P wave has arrived;
* the foot wall, which is the plus side, has moved up the dip. Only the sense is a claim, chosen
  after the result: at the corners of the square slip turns from the dip by up to 10 degrees.
"""

import pathlib
import sys

import asperity_run
import mesh_files
import numpy

HERE = pathlib.Path(__file__).parent
DIP = numpy.radians(60)
UP_DIP = numpy.array([0, numpy.cos(DIP), numpy.sin(DIP)])
END = 0.5  # s
SHEAR_MODULUS, S_WAVES, P_WAVES = 29.403e9, 3300, 5716  # Pa, m/s, m/s
WEAKENING_DISTANCE = 0.5  # m
# At the lower end of the square, 13,500 m down dip: the shear traction less the dynamic friction.
DEPTH = 13500 * numpy.sin(DIP)
NORMAL_STRESS = DEPTH * (16660 / 4 + 5824.3 * 3 / 4)
STRESS_DROP = DEPTH * (16660 - 5824.3) * numpy.sqrt(3) / 4 - 0.1 * NORMAL_STRESS


def beyond_square(points):
    """The distance of points on the fault from the square where the rupture starts [m]."""
    along = numpy.maximum(numpy.abs(points[:, 0]) - 1500, 0)
    down = numpy.maximum(numpy.abs(-points[:, 2] / numpy.sin(DIP) - 12000) - 1500, 0)
    return numpy.hypot(along, down)


def claim(text, holds):
    print(f"{text}{'' if holds else ': NO'}", flush=True)
    return holds


def main():
    given = pathlib.Path(sys.argv[1]) / "tpv13_training.puml.h5"
    if not given.exists():
        print(f"there is no {given}")
        return 77
    mesh_files.mesh_tool("convert", given, "tpv13.h5", "--overwrite", timeout=600)
    folder = asperity_run.run_to_end("out", HERE / "tpv13_mesh.xml", timeout=1800)
    fault = asperity_run.series(folder / "fault.h5")
    slip, distance = fault["fields/slip"][-1], beyond_square(fault["geometry/coordinates"])
    size = numpy.linalg.norm(slip, axis=1)
    moved = size > 0.1 * size.max()
    largest = 2 * S_WAVES * STRESS_DROP / SHEAR_MODULUS * END
    reached = distance <= P_WAVES * END
    steps = asperity_run.table(folder / "steps.csv")
    print(f"slip up to {size.max():.3f} m, {distance[size > 1e-3].max():.0f} m beyond the square")
    fine = [
        claim(f"slip between {WEAKENING_DISTANCE} and {largest:.2f} m",
              WEAKENING_DISTANCE < size.max() < largest),
        claim("it is largest in the square", distance[size.argmax()] == 0),
        claim("no slip beyond the P waves", size[~reached].max() < 1e-6 * size.max()),
        claim("the foot wall moves up the dip", (slip[moved] @ UP_DIP > 0).all()),
        claim("J has not increased", all(row["energy_increases"] == 0 for row in steps))]
    return fine.count(False)


if __name__ == "__main__":
    sys.exit(main())
