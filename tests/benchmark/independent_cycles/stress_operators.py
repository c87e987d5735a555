"""How slip makes shear stress on a vertical antiplane fault in a half space, discretised.

For slip with the wavenumber k on cells of size h the stress is -G/(2 h) symbol(kh), exactly kh. A
fault that reaches the surface is half of one whose other half mirrors it.
"""

import numpy


def elements(theta):
    """Boundary elements with constant slip, whose stress is that in their middle."""
    return 2 * numpy.sin(theta / 2)


def rows(height):
    """Linear finite elements: rows of right triangles, `height` times as high as the fault's cells
    are long, so that the stencil is that of five points."""
    def symbol(theta):
        return 2 * numpy.sin(theta / 2) * numpy.sqrt(1 + (height * numpy.sin(theta / 2)) ** 2)
    return symbol


SYMBOLS = {"elements": elements, "squares": rows(1), "narrow_rows": rows(1 / numpy.sqrt(3))}
_SAMPLES = 1 << 21  # of the symbol, for the stress of one node at another


class StressOperator:
    """As in earthquake_cycles, in the middle of elements or at the vertices of finite elements, of
    which the first lies at the surface. Nothing compresses the fault."""

    def __init__(self, name, cell, length, shear_modulus):
        self.count = int(round(length / cell))
        has_surface_node = name != "elements"
        self.positions = cell * (numpy.arange(self.count) + (0 if has_surface_node else 0.5))
        self._mirrored_from = 1 if has_surface_node else 0
        self._size = 2 * self.count - self._mirrored_from
        angles = 2 * numpy.pi * numpy.arange(_SAMPLES) / _SAMPLES
        angles = numpy.minimum(angles, 2 * numpy.pi - angles)
        at_distance = numpy.fft.ifft(SYMBOLS[name](angles)).real[:self._size]
        self._length = 1 << (2 * self._size - 1).bit_length()
        kernel = numpy.zeros(self._length)
        kernel[:self._size] = at_distance
        kernel[1 - self._size:] = at_distance[:0:-1]
        self._kernel = numpy.fft.rfft(-shear_modulus / (2 * cell) * kernel)

    def stress_of(self, slip):
        whole = numpy.concatenate([slip[self._mirrored_from:][::-1], slip])
        stress = numpy.fft.irfft(numpy.fft.rfft(whole, self._length) * self._kernel, self._length)
        return stress[self._size - self.count:self._size], 0
