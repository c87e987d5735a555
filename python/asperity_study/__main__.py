"""Makes `python3 -m asperity_study STUDY.xml` the same as `asperity-study STUDY.xml`."""

from asperity.program import run_program

from asperity_study.cli import main


def run() -> None:
    run_program(main)


if __name__ == "__main__":
    run()
