"""How the programs in Python begin and end, and the types of their options."""

import argparse
import math
import os
import sys
from functools import wraps
from typing import Callable, Tuple

from . import durations
from .errors import InputError

DONE, INPUT_ERROR = 0, 2  # exit status


def program(name: str):
    """Of `main(arguments)`, which returns the exit status of the program `name`: says what is wrong
    with the input in a line, and which packages are missing."""
    def decorate(main: Callable[..., int]) -> Callable[..., int]:
        @wraps(main)
        def run(arguments=None) -> int:
            try:
                status = main(arguments)
                sys.stdout.flush()
                return status
            except ImportError as error:
                return fail(name, what_to_install(error))
            except InputError as error:
                return fail(name, str(error))
            except BrokenPipeError:  # whoever reads the text has seen enough, as `head` has
                os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
                return DONE
        return run
    return decorate


def fail(name: str, *messages: str) -> int:
    """Each message once on standard error; the exit status."""
    for message in dict.fromkeys(messages):
        print(f"{name}: {message}", file=sys.stderr)
    return INPUT_ERROR if messages else DONE


def what_to_install(error: ImportError) -> str:
    return (f"{sys.executable} has no module {error.name} ({error}). On Debian: apt-get install "
            "python3-numpy python3-h5py python3-matplotlib, for /usr/bin/python3; another Python "
            "first on PATH does not see them.")


def time(text: str) -> float:
    """[s], of a number or of one with a unit."""
    try:
        return durations.seconds(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"'{text}' is no number")
    return value


def not_negative(of: Callable[[str], float]) -> Callable[[str], float]:
    """The type `of` without negative values."""
    def convert(text: str) -> float:
        value = of(text)
        if value < 0.0:
            raise argparse.ArgumentTypeError(f"'{text}' is negative")
        return value
    return convert


def positive(of: Callable[[str], float]) -> Callable[[str], float]:
    """The type `of` above 0."""
    def convert(text: str) -> float:
        value = of(text)
        if value <= 0.0:
            raise argparse.ArgumentTypeError(f"'{text}' is not above 0")
        return value
    return convert


def words(text: str) -> Tuple[str, ...]:
    """Those between commas."""
    return tuple(word.strip() for word in text.split(",") if word.strip())
