"""The reasons for which a figure is not drawn."""


class InputError(Exception):
    """The user's input is at fault; the message says what, where and what to try."""


class NoStepYet(InputError):
    """A run that has just begun: nothing is wrong with what it has written."""


class NothingToShow(Exception):
    """The run is sound but has no data for this figure, for example no events."""


class OtherModel(NothingToShow):
    """The figure is for another kind of model, as one in space; an error only if the user named
    it."""
