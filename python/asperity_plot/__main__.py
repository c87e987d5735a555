"""Makes `python3 -m asperity_plot DIR` the same as `asperity-plot DIR`."""

from asperity.program import run_program

from asperity_plot.cli import main


def run() -> None:
    run_program(main)


if __name__ == "__main__":
    run()
