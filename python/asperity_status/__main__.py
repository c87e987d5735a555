"""Makes `python3 -m asperity_status DIR` the same as `asperity-status DIR`."""

from asperity.program import run_program

from asperity_status.cli import main


def run() -> None:
    run_program(main)


if __name__ == "__main__":
    run()
