"""A subduction zone, megathrust.py DECK EVENTS [END]: at least so many events until the end of the
deck or the given time [s], and where their energy goes."""

import sys

import asperity_run
from deck_meshes import make_meshes
from sequence import YEAR, catalogue


def main():
    deck, least = asperity_run.SOURCE / "xml" / f"{sys.argv[1]}.xml", int(sys.argv[2])
    make_meshes(deck, "--set", "h=500")
    end = ("--set", f"Time Stepping/Final Time={sys.argv[3]}") if len(sys.argv) > 3 else ()
    folder = asperity_run.run_to_end("out", deck, *end, timeout=14000)
    events = catalogue(folder)
    worst = 0
    for row in events:
        defect = row["energy_defect"] / row["friction_work"]
        worst = max(worst, abs(defect))
        scheme = row["numerical_dissipation"] / row["friction_work"]
        size = (f"Mw {row['magnitude']:.2f}" if "magnitude" in row else
                f"moment {row['moment_per_length']:.3g} N")
        print(f"t = {row['onset'] / YEAR:.6f} yr: slip {row['peak_slip']:.2f} m, {size}; of the "
              f"friction work the time stepping took {scheme:.1e}, and the balance is off by "
              f"{defect:.1e}")
    return 0 if len(events) >= least and worst <= 1e-3 else 1


if __name__ == "__main__":
    sys.exit(main())
