"""Makes `python3 -m asperity_report DIR` the same as `asperity-report DIR`."""

from asperity.program import run_program

from asperity_report.cli import main


def run() -> None:
    run_program(main)


if __name__ == "__main__":
    run()
