"""What all figures have in common: size, type, lines, the caption, and how they are saved.

The colours are of Okabe and Ito's palette, which colour-blind readers tell apart; lines differ in style or width as
well, so that they are told apart in grey print.
"""

from pathlib import Path
from typing import Any, Final

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from swerve import __version__
from swerve.errors import one_line
from swerve.simulate import Result, Run

WIDTH: Final = 7.0  # of a figure: a page's text width [inch]
CAPTION_HEIGHT: Final = 0.25  # at the foot of a figure [inch]
PADDING: Final = 0.07  # round each of the axes [inch]
RESOLUTION: Final = 200  # of PNG files [1/inch]
LONGEST_NAME: Final = 40  # characters of a scenario's name in a caption
SQRT_RHO: Final = "\N{SQUARE ROOT}\N{GREEK SMALL LETTER RHO}"

BLACK: Final = "#000000"
GREY: Final = "#707070"
BLUE: Final = "#0072B2"
SKY: Final = "#56B4E9"
ORANGE: Final = "#D55E00"

COMMANDED: Final[dict[str, Any]] = {"color": SKY, "linewidth": 2.6}
ACTING: Final[dict[str, Any]] = {"color": BLACK, "linewidth": 1.0}
LIMIT: Final[dict[str, Any]] = {"color": ORANGE, "linestyle": ":", "linewidth": 1.2}
GOAL: Final[dict[str, Any]] = {"color": GREY, "linestyle": "--", "linewidth": 1.0, "zorder": 1.5}

STYLE: Final[Any] = {  # matplotlib's type for it lists all of its keys
    "font.family": "DejaVu Sans",  # comes with matplotlib: the same file on every machine
    "font.size": 8.0,
    "axes.labelsize": 8.0,
    "axes.linewidth": 0.6,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.xmargin": 0.0,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.5,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "lines.linewidth": 1.2,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "hatch.linewidth": 0.5,
    "pdf.fonttype": 42,  # TrueType, which publishers take and editors can edit
}

METADATA: Final[dict[str, dict[str, Any]]] = {  # no dates
    ".png": {"Software": f"swerve {__version__}"},
    ".pdf": {"Creator": f"swerve {__version__}", "CreationDate": None},
}

styled = rc_context(STYLE)  # decorates what draws


def new_figure(run: Run, height: float) -> Figure:
    """An empty figure with the caption of the run at its foot, for which its layout leaves room; height in inch."""
    return captioned_figure(caption(run), height)


def captioned_figure(text: str, height: float) -> Figure:
    """The same with any caption."""
    room = CAPTION_HEIGHT / height
    engine = ConstrainedLayoutEngine(rect=(0.0, room, 1.0, 1.0 - room), w_pad=PADDING, h_pad=PADDING)
    figure = Figure(figsize=(WIDTH, height), layout=engine)
    put_text(figure, text)
    return figure


def widen(axes: Axes, least: float) -> None:
    """Let the y axis cover at least this much: a line that is flat but for rounding errors is to look flat."""
    low, high = axes.get_ylim()
    if high - low < least:
        axes.set_ylim((low + high - least) / 2, (low + high + least) / 2)


def put_caption(figure: Figure, run: Run) -> None:
    """What was run and the verdict, at the foot of the figure."""
    put_text(figure, caption(run))


def put_text(figure: Figure, text: str) -> None:
    """Any caption, at the foot of the figure."""
    figure.text(0.01, 0.06 / figure.get_figheight(), text, color=GREY, fontsize=7.0, parse_math=False)


def caption(run: Run) -> str:
    """Scenario, controller, plant and verdict."""
    result = run.result
    name = printable(one_line(result.scenario, LONGEST_NAME))
    who = f"{name}: {result.controller} on {result.plant}, seed {result.seed}, swerve {result.version}"
    return f"{who}. {result.outcome.value.replace('_', ' ').capitalize()}{_how_near(result)}."


def printable(text: str) -> str:
    """The text with "?" for what is beyond Latin-1, where it may have letters that the font does not."""
    return text.encode("latin-1", "replace").decode("latin-1")


def _how_near(result: Result) -> str:
    values = result.to_json()  # where a number that is not finite is None
    if values["min_distance_ratio"] is not None:
        return f", smallest {SQRT_RHO} {result.min_distance_ratio:.3f} (1 is contact)"
    return "" if values["min_clearance"] is None else f", smallest clearance {result.min_clearance:.2f} m"


@styled
def save(figure: Figure, path: Path) -> None:
    """Write a figure to a .png or .pdf file; the same figure gives the same bytes."""
    figure.savefig(path, dpi=RESOLUTION, metadata=METADATA[path.suffix])
