"""The ways in which a figure may not come into being."""


class InputError(Exception):
    """The user's input is at fault; the message says what, where and what to try."""


class NothingToShow(Exception):
    """The run is sound but has nothing for this figure, a run without events for instance."""


class OtherDimension(NothingToShow):
    """The figure is not for runs in as many dimensions; nobody misses it who did not name it."""
