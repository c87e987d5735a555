"""half_planes.py against the equations of equilibrium and against its closed forms."""

import math
import sys

import numpy
from half_planes import Body, per_slip


def decaying(body, k):
    """C of the half plane y > 0 from its solutions (u_x, u_y, s_xy, s_yy)(y) e^(ikx) that vanish
    far away, by the matrix of d/dy, which Hooke's law and equilibrium give."""
    G, nu = body.shear_modulus, body.poissons_ratio
    lame = 2 * G * nu / (1 - 2 * nu)
    P = lame + 2 * G
    A = numpy.zeros((4, 4), dtype=complex)
    A[0, 1], A[0, 2] = -1j * k, 1 / G
    A[1, 0], A[1, 3] = -1j * k * lame / P, 1 / P
    A[2, 0], A[2, 3] = k**2 * (P - lame**2 / P), -1j * k * lame / P
    A[3, 2] = -1j * k
    # The eigenvalues are k and -k, twice each and with one eigenvector each. Newton's iteration
    # makes them 1 and -1, with all eigenvectors: the matrix sign.
    sign = A / abs(k)
    for _ in range(60):
        sign = (sign + numpy.linalg.inv(sign)) / 2
    vanishing = numpy.linalg.svd(numpy.eye(4) - sign)[0][:, :2]
    return vanishing[:2] @ numpy.linalg.inv(-vanishing[2:])  # the outward normal is -y


def closed_form(upper, lower, k):
    A = sum((1 - body.poissons_ratio) / body.shear_modulus for body in (upper, lower))
    B = sum(sign * (1 - 2 * body.poissons_ratio) / (2 * body.shear_modulus)
            for sign, body in ((1, upper), (-1, lower)))
    shear = abs(k) * A / (A**2 - B**2)
    return shear, 1j * math.copysign(1, k) * B / A * shear


def main():
    failed = 0
    soft, stiff = Body(1.3, 0.2), Body(5, 0.35)
    for k in (2.0, -7.0):
        errors = {"compliance": max(numpy.abs(decaying(body, k) / body.compliance(k) - 1).max()
                                    for body in (soft, stiff))}
        for name, bodies in (("soft above", (soft, stiff)), ("stiff above", (stiff, soft))):
            known = numpy.array(closed_form(*bodies, k))
            errors[name] = numpy.abs(numpy.array(per_slip(*bodies, k)) / known - 1).max()
        shear, compression = per_slip(soft, soft, k)
        errors["equal"] = max(abs(shear / (1.3 * abs(k) / (2 * 0.8)) - 1), abs(compression / shear))
        failed += sum(not error < 1e-12 for error in errors.values())
        print(f"k = {k:g}: " + ", ".join(f"{name} {error:.1e}" for name, error in errors.items()))
    return failed


if __name__ == "__main__":
    sys.exit(main())
