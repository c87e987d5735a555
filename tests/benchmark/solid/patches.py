"""Two patches on the base of a deep wedge: ruptures of either, one after the other."""

import sys

import asperity_run
from sequence import catalogue

BETWEEN = 0.3  # m, where the gap between the patches is


def main():
    folder = asperity_run.run_to_end("out", asperity_run.SOURCE / "xml" / "wedge_3d_patches.xml",
                                     timeout=7000)
    events = catalogue(folder)
    in_front = sum(row["hypocentre_z"] < BETWEEN for row in events)
    for row in events:
        print(f"t = {row['onset']:.2f} s at z = {row['hypocentre_z']:.2f} m: length "
              f"{row['length']:.3f} m, width {row['width']:.3f} m, slip {row['peak_slip']:.3g} m")
    return 0 if min(in_front, len(events) - in_front) >= 3 else 1


if __name__ == "__main__":
    sys.exit(main())
