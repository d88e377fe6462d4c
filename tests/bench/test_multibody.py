"""The manoeuvre on which plants and their peer are timed."""

import pytest

from bench import multibody
from tests.kernel.compilers import uncompiled


def test_all_drive_the_same_manoeuvre() -> None:
    """Both plants end within 6 % of the peer's yaw rate, and every model has a speed."""
    with pytest.MonkeyPatch.context() as patch:
        speeds = uncompiled(patch, lambda: multibody.speeds(n_runs=1))
    peer = speeds["commonroad-vehicle-models"]
    for each in speeds.values():
        assert each.yaw_rate == pytest.approx(peer.yaw_rate, rel=0.06)
        assert each.real_time > 0
