"""What the steps of two runs with the same prescribed steps cost."""

import asperity_run


def assert_same_effort(test, reference, folder):
    """Equal but for one TNNMG iteration more or less in a rate problem, and J never rises."""
    tables = [asperity_run.table(each / "steps.csv") for each in (reference, folder)]
    test.assertEqual(len(tables[0]), len(tables[1]))
    for ours, theirs in zip(*tables):
        for name in ("time", "fixed_point_iterations", "rate_problems"):
            test.assertEqual(ours[name], theirs[name])
        # A step has five to fifteen rate problems.
        difference = abs(ours["tnnmg_iterations"] - theirs["tnnmg_iterations"])
        test.assertLessEqual(difference, 0.5 * ours["rate_problems"])
        test.assertEqual(theirs["energy_rises"], 0)
    total = [sum(row["tnnmg_iterations"] for row in rows) for rows in tables]
    test.assertLess(abs(total[1] - total[0]), 0.02 * total[0])
