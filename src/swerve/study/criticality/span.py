"""Over which part of a straight line a footprint, moved along it without turning, touches an obstacle.

Both shapes are convex, so the part is an interval, and it has a closed form. With the footprint's origin at
q + lambda d in the obstacle's frame, and support functions h:

    obstacle a rectangle    for every edge normal n of either:
                            -h_o(-n) - h_e(n) <= (q + lambda d) . n <= h_o(n) + h_e(-n)
    obstacle an ellipse     in axes in which it is the unit disc: the line meets the footprint's outline, mirrored, and
                            made 1 larger all round: a unit disc about each corner and a strip along each edge

Contact is that of a run's outcome: a distance of 0 to a rectangle, sqrt(rho) of 1 to an ellipse.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.world import Ellipse, Footprint, Shape

Array = NDArray[np.float64]
Span = tuple[Array, Array]  # from and to; +inf and -inf where there is no contact anywhere


def contact_span(footprint: Footprint, shape: Shape, offset: Array, turn: Array, along: Array) -> Span:
    """Smallest and largest lambda of a contact.

    Args:
        footprint: in its body frame.
        shape: of the obstacle, in its own frame.
        offset: (..., 2) q, the footprint's origin at lambda = 0, in the obstacle's frame [m].
        turn: (...) of the footprint's frame from the obstacle's [rad].
        along: (..., 2) d, in the obstacle's frame [m for each unit of lambda].
    """
    if isinstance(shape, Ellipse):
        return _to_disc(footprint.outline(), np.array(shape.semi_axes), offset, turn, along)
    first, last = np.full(turn.shape, -np.inf), np.full(turn.shape, np.inf)
    for angle in (np.zeros(turn.shape), turn):
        for normal in (_direction(angle), _direction(angle + np.pi / 2)):
            seen = rotate(normal, -turn)
            low = -shape.support(-normal) - footprint.support(seen)
            high = shape.support(normal) + footprint.support(-seen)
            first, last = _both((first, last), slab(low, high, dot(offset, normal), dot(along, normal)))
    return first, last


def rotate(vectors: Array, angle: Array) -> Array:
    """Vectors (..., 2) turned anticlockwise by angles (...) [rad]."""
    cos, sin = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack((cos * x - sin * y, sin * x + cos * y), axis=-1)


def _to_disc(outline: Array, semi_axes: Array, offset: Array, turn: Array, along: Array) -> Span:
    """Span of contact between an outline (k, 2) and the ellipse: the hull of those of its corners and edges."""
    corners = [(offset + rotate(corner, turn)) / semi_axes for corner in outline]
    rate = along / semi_axes
    spans = [_disc(corner, rate) for corner in corners]
    if len(corners) > 1:
        spans += [_edge(*ends, rate) for ends in zip(corners, [*corners[1:], corners[0]], strict=True)]
    return np.minimum.reduce([first for first, _ in spans]), np.maximum.reduce([last for _, last in spans])


def _disc(point: Array, rate: Array) -> Span:
    """Where |point + lambda rate| <= 1: between the roots of a quadratic."""
    a, b, c = dot(rate, rate), dot(point, rate), dot(point, point) - 1
    moves = a > 0
    scale = np.where(moves, a, 1.0)
    meets = np.where(moves, b**2 >= a * c, c <= 0)
    with np.errstate(over="ignore"):
        middle = -b / scale
        reach = np.where(moves, np.sqrt(np.maximum(b**2 - a * c, 0)) / scale, np.inf)
    return np.where(meets, middle - reach, np.inf), np.where(meets, middle + reach, -np.inf)


def _edge(start: Array, end: Array, rate: Array) -> Span:
    """Where the origin is abreast of the moving edge, and no further than 1 from its line."""
    tangent = end - start
    length = np.hypot(tangent[..., 0], tangent[..., 1])
    tangent = tangent / length[..., np.newaxis]
    normal = np.stack((-tangent[..., 1], tangent[..., 0]), axis=-1)
    one = np.ones(length.shape)
    abreast = slab(-length, 0 * one, dot(start, tangent), dot(rate, tangent))
    return _both(abreast, slab(-one, one, dot(start, normal), dot(rate, normal)))


def slab(low: Array, high: Array, value: Array, rate: Array) -> Span:
    """Where low <= value + lambda rate <= high, each (...)."""
    moves = rate != 0
    scale = np.where(moves, rate, 1.0)
    with np.errstate(over="ignore"):  # so slow that it is infinite
        ends = (low - value) / scale, (high - value) / scale
    stays = np.where((low <= value) & (value <= high), -np.inf, np.inf)
    return np.where(moves, np.minimum(*ends), stays), np.where(moves, np.maximum(*ends), -stays)


def _both(one: Span, other: Span) -> Span:
    """The intersection of two spans."""
    first, last = np.maximum(one[0], other[0]), np.minimum(one[1], other[1])
    is_empty = first > last
    return np.where(is_empty, np.inf, first), np.where(is_empty, -np.inf, last)


def _direction(angle: Array) -> Array:
    return np.stack((np.cos(angle), np.sin(angle)), axis=-1)


def dot(a: Array, b: Array) -> Array:
    """Inner products (...) of vectors (..., 2)."""
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1]
