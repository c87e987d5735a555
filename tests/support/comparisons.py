"""Compares what two runs leave."""

import asperity_run
import numpy

FIELDS = [("fault", "slip_rate"), ("fault", "alpha"), ("fault", "slip"), ("fault", "traction"),
          ("volume", "displacement"), ("volume", "velocity")]


def assert_same_results(whole, folder, series=("fault.h5", "surface.h5"),
                        tables=("steps.csv", "events.csv")):
    """Bit for bit; `tables` may name other files, too."""
    for name in series:
        ours, theirs = (asperity_run.series(each / name) for each in (whole, folder))
        assert set(ours) == set(theirs), name
        for dataset, values in ours.items():
            numpy.testing.assert_array_equal(values, theirs[dataset], f"{name}: {dataset}")
    for name in tables:
        assert asperity_run.content(whole / name) == asperity_run.content(folder / name), name


def largest_difference(found, expected):
    """In units of the largest value expected."""
    assert found.shape == expected.shape, (found.shape, expected.shape)
    return numpy.abs(found - expected).max() / numpy.abs(expected).max()


def largest_errors(expected, found):
    """{field: largest difference of two runs' outputs over the largest value}; their steps, and
    the order of the vertices, must be the same."""
    errors = {}
    for location, field in FIELDS:
        ours, theirs = (asperity_run.series(folder / f"{location}.h5")
                        for folder in (expected, found))
        for name in ("time", "step", "geometry/coordinates", "geometry/vertex_ids"):
            numpy.testing.assert_array_equal(ours[name], theirs[name], name)
        errors[field] = largest_difference(theirs["fields/" + field], ours["fields/" + field])
    return errors


def assert_same_effort(test, reference, folder):
    """Of two runs with the same prescribed steps: equal but for one iteration of the fixed point,
    and one of TNNMG beside it, more or less in a step, which the corrections leave to chance:
    Gauss-Seidel is local to a rank. J never rises."""
    tables = [asperity_run.table(each / "steps.csv") for each in (reference, folder)]
    test.assertEqual(len(tables[0]), len(tables[1]))
    for ours, theirs in zip(*tables):
        test.assertEqual(ours["time"], theirs["time"])
        for name, most in (("fixed_point_iterations", 1), ("rate_problems", 1),
                           ("tnnmg_iterations", 2)):
            test.assertLessEqual(abs(ours[name] - theirs[name]), most)
        test.assertEqual((ours["energy_increases"], theirs["energy_increases"]), (0, 0))
    total = [sum(row["tnnmg_iterations"] for row in rows) for rows in tables]
    test.assertLess(abs(total[1] - total[0]), 0.05 * total[0])


def triangles_at(corners, points):
    """For each of the points (n, 2) the number of the one triangle (m, 3, 2) in which it lies."""
    edges = numpy.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    shares = numpy.linalg.solve(edges, (points[:, None] - corners[:, 0])[..., None])[..., 0]
    is_inside = (shares >= 0).all(axis=2) & (shares.sum(axis=2) <= 1)
    assert (is_inside.sum(axis=1) == 1).all()
    return is_inside.argmax(axis=1)
