"""The fuzzing of the controller as a file, to be included in a page."""

from collections import Counter

from swerve import __version__
from swerve.report.markdown import table
from swerve.study.fuzz import Fuzz


def as_markdown(fuzz: Fuzz) -> str:
    """How the steps were answered, and what was wrong."""
    answers = table(["answer", "steps"], [[name.replace("_", " "), str(n)] for name, n in sorted(fuzz.answers.items())])
    faults = Counter(fault.sentence for fault in fuzz.faults)
    wrong = "\n".join(f"- {n} steps: {sentence}" for sentence, n in faults.most_common()) or "Nothing was wrong."
    return f"""{fuzz.n_steps} steps from seed {fuzz.seed}, measured by swerve {__version__}.

{answers}

{wrong}
"""
