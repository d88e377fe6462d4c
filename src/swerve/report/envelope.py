"""The envelope as a file, to be included in a page."""

from collections.abc import Sequence

from swerve import __version__
from swerve.report.markdown import table
from swerve.study.envelope import REQUIRED, Cell, Envelope


def as_markdown(envelopes: Sequence[Envelope]) -> str:
    """A table for each plant, a row for each friction: the smallest distance avoided, and its ratio to the limit."""
    parts = [_part(each) for each in envelopes]
    return f"Measured by swerve {__version__}.\n\n" + "\n\n".join(parts) + "\n"


def _part(envelope: Envelope) -> str:
    speeds = sorted({cell.condition.speed for cell in envelope.cells})
    frictions = sorted({cell.condition.friction for cell in envelope.cells})
    cells = {(cell.condition.friction, cell.condition.speed): cell for cell in envelope.cells}
    rows = [[f"{mu:g}", *(_shown(cells.get((mu, speed)), envelope.plant) for speed in speeds)] for mu in frictions]
    required, n_short = REQUIRED[envelope.plant], len(envelope.short)
    verdict = f"{len(envelope.cells) - n_short} of {len(envelope.cells)} reach {required:g} times the limit."
    head = table(["$\\mu$ \\ speed", *(f"{speed:g} m/s" for speed in speeds)], rows)
    return f"On the plant `{envelope.plant}`: {verdict}\n\n{head}"


def _shown(cell: Cell | None, plant: str) -> str:
    """Distance and ratio; bold where it does not reach what is required."""
    if cell is None:
        return ""
    if cell.ratio is None:
        return f"**none down from {cell.failed:g}**"
    text = f"{cell.ratio * cell.condition.limit:.1f} m, {cell.ratio:.2f}"
    return text if cell.reaches(REQUIRED[plant]) else f"**{text}**"
