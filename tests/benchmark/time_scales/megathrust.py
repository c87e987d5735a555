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
        print(f"t = {row['onset'] / YEAR:.1f} yr: slip {row['peak_slip']:.2f} m, moment "
              f"{row['moment_per_length']:.3g} N, balance off by {defect:.1e} of the friction work")
    return 0 if len(events) >= 4 and worst <= 1e-3 else 1


if __name__ == "__main__":
    sys.exit(main())
