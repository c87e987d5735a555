"""Earthquakes on faults that cross, on meshes of PyLith (crustal-strikeslip-2d and -3d, the faults
of the Ridgecrest earthquakes of 2019), converted by asperity-mesh.

Arguments: the folder with the meshes; a case. Status 77 where the mesh is not there.

fault_west and fault_east end at fault_main from both sides and continue each other: they cross it
as one fault. Claims on each case:
* the mesh has one crossing, of fault_east/fault_west with fault_main;
* all three faults slip, the main one right laterally, the others left laterally;
* slip of each of the two faults goes on through the crossing: there it lies between half the least
  and twice the largest slip within 3 km;
* nothing slips at the tips of the three faults;
* J does not increase, and the energy balance closes to 1e-6 of the work of friction.

cycles_2d, cycles_3d: a century, quasi-dynamic. Both the main fault and the one that crosses it slip
at seismic rates. In the plane the latter has earthquakes of its own; in space, where it is shorter
than the nucleation length, it creeps, and slips fast only while the main fault ruptures.
rupture_3d: one rupture with inertia, which starts on fault_west and stops at the crossing, since
fault_east strengthens. It turns into the main fault, which bears a tenth of the moment or more, and
breaks first on the side that the rupture of fault_west unclamps, to the north west of the crossing.
Where fault_east weakens, too, the rupture goes on and the main fault does not break.

Chosen after first results: that fault_east strengthens in rupture_3d, the sentence on cycles in
space, and that slip at the crossing is compared with both names of the fault that crosses.
"""

import pathlib
import sys

import asperity_run
import mesh_files
import numpy

HERE = pathlib.Path(__file__).parent
CASES = {"cycles_2d": ("pylith_crustal2d_tri.msh", "ridgecrest_2d", ()),
         "cycles_3d": ("pylith_crustal3d_tet.msh", "ridgecrest_3d", ()),
         "rupture_3d": ("pylith_crustal3d_tet.msh", "ridgecrest_3d",
                        ("--overlay", HERE / "ridgecrest_rupture.xml"))}
CROSSING = numpy.array([453735., 3947457.])  # m
TIPS = numpy.array([[444204, 3963173], [466418, 3936331], [445031, 3939110], [457036, 3952442]])
LOWER_EDGE = -15e3  # m
FAULTS = ("fault_main", "fault_west", "fault_east")
SENSE = numpy.array([0.64, -0.77])  # of slip on the main fault; the others move along the mirror
SENSES = {"fault_main": SENSE, "fault_west": -SENSE * (1, -1), "fault_east": -SENSE * (1, -1)}


class Slip:
    """Slip at the end, {fault: places (nodes, dimension) and slip along the sense expected}."""

    def __init__(self, folder):
        history = asperity_run.series(folder / "fault.h5")
        places, slip = history["geometry/coordinates"], history["fields/slip"][-1]
        self.of = {}
        for fault, nodes in nodes_of_faults(history).items():
            along = slip[nodes, :2] @ SENSES[fault] if places.shape[1] == 3 else (
                slip[nodes].ravel() * numpy.sign(SENSES[fault][0]))  # positive towards +x
            self.of[fault] = places[nodes], along

    def near_crossing(self, faults):
        """At the crossing, and within 3 km of each place of it, of faults that are one there; not
        at its lower end."""
        places, slip = (numpy.concatenate(each) for each in zip(*(self.of[name] for name in
                                                                  faults)))
        from_line = numpy.hypot(*(places[:, :2] - CROSSING).T)
        deep = places[:, 2] < LOWER_EDGE + 1 if places.shape[1] == 3 else from_line < 0
        for node in numpy.flatnonzero((from_line < 2) & ~deep):
            apart = numpy.linalg.norm(places - places[node], axis=1)
            yield slip[node], slip[(apart < 3e3) & (from_line > 2) & ~deep]

    def at_tips(self):
        for places, slip in self.of.values():
            apart = numpy.linalg.norm(places[:, None, :2] - TIPS, axis=2).min(axis=1)
            at_tip = apart < 2
            if places.shape[1] == 3:
                at_tip |= places[:, 2] < LOWER_EDGE + 1
            yield from slip[at_tip]


def nodes_of_faults(history):
    """{fault: numbers of its nodes}; in the plane they lie one after the other."""
    if "geometry/boundary_names" in history:
        elements, fault = history["geometry/connectivity"], history["geometry/element_boundaries"]
        return {name.decode(): numpy.unique(elements[fault == number])
                for number, name in enumerate(history["geometry/boundary_names"])}
    positions = history["geometry/positions"]  # the same twice where one ends and another begins
    return {name.decode(): numpy.arange(numpy.searchsorted(positions, first, side="right") - 1,
                                        numpy.searchsorted(positions, last) + 1)
            for name, (first, last) in zip(history["geometry/part_names"],
                                           history["geometry/part_ends"])}


def claim(text, holds):
    print(f"{text}{'' if holds else ': NO'}", flush=True)
    return bool(holds)


def moments(folder):
    """{fault: moments of its events}; per length in the plane."""
    return {fault: [row.get("moment", row.get("moment_per_length"))
                    for row in asperity_run.table(folder / f"events_{fault}.csv")]
            for fault in FAULTS}


def common_claims(folder, printed):
    slip = Slip(folder)
    steps = asperity_run.table(folder / "steps.csv")
    for fault, (_, along) in slip.of.items():
        print(f"{fault}: slip {along.min():.3g} to {along.max():.3g} m, its events "
              f"{len(moments(folder)[fault])}, moment {sum(moments(folder)[fault]):.3g}")
    near = {fault: list(slip.near_crossing(fault)) for fault in
            (("fault_main",), ("fault_west", "fault_east"))}
    defect = abs(steps[-1]["energy_defect"] / steps[-1]["friction_work"])
    print(f"{len(steps)} steps, energy defect {defect:.2g} of the friction work")
    for fault, values in near.items():
        print(*fault, "at the crossing", [round(float(value), 3) for value, _ in values])
    return [
        claim("one crossing", printed.count("\ncrossing ") == 1
              and "fault_east/fault_west and fault_main" in printed),
        claim("each fault slips in its sense", all(
            along.max() > 0.1 and along.min() > -0.01 * along.max()
            for _, along in slip.of.values())),
        claim("slip goes on through the crossing", all(
            values and all(0.5 * beside.min() <= value <= 2 * beside.max()
                           for value, beside in values) for values in near.values())),
        claim("no slip at tips", numpy.abs(list(slip.at_tips())).max() < 1e-12),
        claim("J has not increased", all(row["energy_increases"] == 0 for row in steps)),
        claim("the energy balance closes", defect < 1e-6)]


def cycles(folder):
    """Slip at seismic rates on both faults."""
    of = moments(folder)
    return [claim("the main fault has earthquakes", of["fault_main"]),
            claim("the fault that crosses it slips as fast", of["fault_west"] + of["fault_east"])]


def rupture(folder):
    """It turns into the main fault, to the north west."""
    of = {fault: sum(each) for fault, each in moments(folder).items()}
    share = of["fault_main"] / sum(of.values())
    history = asperity_run.series(folder / "rupture.h5")
    nodes = nodes_of_faults(history)["fault_main"]
    times, places = history["first_rupture_time"][nodes], history["geometry/coordinates"][nodes]
    east = places[:, 0] - CROSSING[0]
    first = [numpy.nanmin(times[side], initial=numpy.inf) for side in (east < -2e3, east > 2e3)]
    print(f"{share:.0%} of the moment on the main fault; it breaks after {first[0]:.2f} s to the "
          f"north west of the crossing, after {first[1]:.2f} s to the south east")
    return [claim("the rupture turns into the main fault", share >= 0.1),
            claim("first to the north west", first[0] < first[1])]


def main():
    case = sys.argv[2]
    given, deck, more = CASES[case]
    given = pathlib.Path(sys.argv[1]) / given
    if not given.exists():
        print(f"there is no {given}")
        return 77
    mesh_files.mesh_tool("convert", given, f"{deck}.h5", "--overwrite", timeout=600)
    printed = mesh_files.mesh_tool("info", f"{deck}.h5")
    folder = asperity_run.run_to_end(case, HERE / f"{deck}.xml", *more, timeout=7200)
    fine = common_claims(folder, printed) + (rupture if case == "rupture_3d" else cycles)(folder)
    return fine.count(False)


if __name__ == "__main__":
    sys.exit(main())
