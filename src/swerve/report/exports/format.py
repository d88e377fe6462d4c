"""What a format is: which files it makes of a run, and what has to be installed for it."""

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from swerve.errors import InputError
from swerve.simulate import Run

Write = Callable[[Run, Path], None]  # writes a run to the file of this path


@dataclass(frozen=True)
class Format:
    """A format that a run can be exported to.

    Attributes:
        name: by which it is asked for.
        files: what writes each file, by the file's name.
        module: that has to be installed, which the extra of the format's name brings; None without one.
        program: that has to be on the PATH; None without one.
    """

    name: str
    files: Mapping[str, Write]
    module: str | None = None
    program: str | None = None

    def require(self, option: str) -> None:
        """See to it that the format can be written here; messages name the `option` that asks for it.

        Raises:
            InputError: something is not installed.
        """
        if self.module is not None and find_spec(self.module) is None:
            cure = f"install it with: pip install 'swerve[{self.name}]'"
            raise InputError(f"{option} {self.name}: needs the package {self.module}, which is not installed; {cure}")
        if self.program is not None and shutil.which(self.program) is None:
            cure = "install it, or export to webp or gif"
            raise InputError(
                f"{option} {self.name}: needs the program {self.program}, which is not on the PATH; {cure}"
            )
