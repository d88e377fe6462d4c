"""The folder of compiled kernels: it holds code that will be loaded, so only the user may write to it."""

import logging
import os
import stat
from pathlib import Path

from platformdirs import user_cache_path

VARIABLE = "SWERVE_CACHE_DIR"
LOG = logging.getLogger(__name__)


def private_folder() -> Path | None:
    """$SWERVE_CACHE_DIR, else the user's cache folder; None, with a warning, if others could write to it."""
    named = os.environ.get(VARIABLE)
    folder = Path(named) if named else user_cache_path("swerve", appauthor=False) / "kernels"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = folder.stat()
    except OSError as error:
        LOG.warning("kernels run uncompiled: %s can't be made: %s", folder, error)
        return None
    if os.name == "posix" and not _is_private(status):
        LOG.warning("kernels run uncompiled: %s can be written by others; `chmod 700` it or set %s", folder, VARIABLE)
        return None
    return folder


def _is_private(status: os.stat_result) -> bool:
    return status.st_uid == os.getuid() and not status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
