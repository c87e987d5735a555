"""A subduction zone over several cycles: enough events, and where their energy goes."""

import sys

import asperity_run
from sequence import YEAR, catalogue


def main():
    folder = asperity_run.run_to_end("out", asperity_run.SOURCE / "xml" / "megathrust_2d.xml",
                                     timeout=14000)
    events = catalogue(folder)
    worst = 0
    for row in events:
        defect = row["energy_defect"] / row["friction_work"]
        worst = max(worst, abs(defect))
        scheme = row["numerical_dissipation"] / row["friction_work"]
        print(f"t = {row['onset'] / YEAR:.1f} yr: slip {row['peak_slip']:.2f} m, moment "
              f"{row['moment_per_length']:.3g} N; of the friction work the time stepping "
              f"took {scheme:.1e}, and the balance is off by {defect:.1e}")
    return 0 if len(events) >= 4 and worst <= 1e-3 else 1


if __name__ == "__main__":
    sys.exit(main())
