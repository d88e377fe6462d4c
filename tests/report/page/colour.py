"""Colours as the standards count them: contrast, and how different two look to whom.

Contrast is WCAG 2.2's (L1 + 0.05) / (L2 + 0.05) with the relative luminance L; difference is CIE 1976's distance in
L*a*b* (D65). Dichromats' view is Machado, Oliveira and Fernandes (2009), at severity 1, on linear RGB.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

READERS = {
    "full colour vision": np.eye(3),
    "protanopia": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deuteranopia": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "tritanopia": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def linear(colour: str) -> Array:
    """Linear RGB (3,) of "#rrggbb"."""
    coded = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(coded <= 0.04045, coded / 12.92, ((coded + 0.055) / 1.055) ** 2.4)


def luminance(colour: str) -> float:
    """Relative luminance, 0 to 1."""
    return float(TO_XYZ[1] @ linear(colour))


def contrast(first: str, second: str) -> float:
    """From 1 to 21."""
    low, high = sorted([luminance(first), luminance(second)])
    return (high + 0.05) / (low + 0.05)


def difference(first: str, second: str, reader: str) -> float:
    """Distance in L*a*b*; about 2.3 is just noticeable side by side."""
    seen = [_lab(np.clip(READERS[reader] @ linear(each), 0, 1)) for each in (first, second)]
    return float(np.linalg.norm(seen[0] - seen[1]))


def _lab(rgb: Array) -> Array:
    ratio = TO_XYZ @ rgb / TO_XYZ.sum(axis=1)
    f = np.where(ratio > (6 / 29) ** 3, np.cbrt(ratio), ratio / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])
