"""How long tests wait for a program before they give it up."""

import os


def seconds(number):
    """For an ordinary build; CMake's ASPERITY_TEST_TIME_FACTOR has more for a slow one."""
    return number * int(os.environ.get("ASPERITY_TEST_TIME_FACTOR", "1"))
