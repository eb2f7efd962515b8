"""What is wrong with a sweep, as whoever started it at a terminal is told."""


class SweepError(ValueError):
    """The caller's fault; the text names file, column or row."""
