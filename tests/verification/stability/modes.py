"""The complex rates in a series of equal steps that is a sum of exponentials."""

import numpy


def exponentials(t, y, order, stride):
    """Rates s and amplitudes c of y = sum of c e^(st), as many as `order`.

    The matrix pencil of Hua and Sarkar (1990): the rows of the Hankel matrix of y, reduced to its
    largest singular vectors, are multiplied by e^(s dt) from one sample to the next.
    """
    y, dt = y[::stride], stride * (t[1] - t[0])
    hankel = numpy.lib.stride_tricks.sliding_window_view(y, len(y) // 2)
    basis = numpy.linalg.svd(hankel, full_matrices=False)[2][:order].T
    factors = numpy.linalg.eigvals(numpy.linalg.pinv(basis[:-1]) @ basis[1:]).astype(complex)
    powers = factors[None, :] ** numpy.arange(len(y))[:, None]
    amplitudes = numpy.linalg.lstsq(powers, y.astype(complex), rcond=None)[0]
    return numpy.log(factors) / dt, amplitudes


def lasting(t, y, order=12, stride=4):
    """The rate, Im s >= 0, of what is largest at the end."""
    s, amplitudes = exponentials(t, y, order, stride)
    at_end = numpy.where(s.imag >= 0, numpy.abs(amplitudes * numpy.exp(s * (t[-1] - t[0]))), 0)
    return s[at_end.argmax()]
