"""Compares the work of two runs with the same prescribed steps."""

import asperity_run


def assert_same_effort(test, reference, folder):
    """Equal but for one iteration of the fixed point, and one of TNNMG beside it, more or less in
    a step, which the corrections leave to chance: Gauss-Seidel is local to a rank. J never
    rises."""
    tables = [asperity_run.table(each / "steps.csv") for each in (reference, folder)]
    test.assertEqual(len(tables[0]), len(tables[1]))
    for ours, theirs in zip(*tables):
        test.assertEqual(ours["time"], theirs["time"])
        for name, most in (("fixed_point_iterations", 1), ("rate_problems", 1),
                           ("tnnmg_iterations", 2)):
            test.assertLessEqual(abs(ours[name] - theirs[name]), most)
        test.assertEqual((ours["energy_rises"], theirs["energy_rises"]), (0, 0))
    total = [sum(row["tnnmg_iterations"] for row in rows) for rows in tables]
    test.assertLess(abs(total[1] - total[0]), 0.05 * total[0])
