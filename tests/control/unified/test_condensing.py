"""Condensing against roll-outs, and against the dense matrix W of sec. 4.3.2 built the slow way."""

import numpy as np
from hypothesis import given, settings

from swerve.control import Horizon
from swerve.control.unified.condensing import INPUT_SCALE, Blocking, condense
from swerve.control.unified.prediction import Linearisation
from tests.control.unified.situations import BLOCKING, model, random_roll_out, seeds
from tests.vehicle.motions import STATIC


@settings(max_examples=6)
@given(seeds)
def test_sensitivities_are_the_slopes_of_the_roll_out(seed: int) -> None:
    """Changing a free input a little moves states, poses and slip angles as the sensitivities say."""
    trajectory, found, random = random_roll_out(seed)
    for j in random.choice(BLOCKING.n, 12, replace=False):
        z = np.zeros(BLOCKING.n)
        z[j] = 1e-5 if j % 5 == 0 else 1e-4
        ahead, behind = (
            model().roll_out(trajectory.states[0], trajectory.inputs + sign * BLOCKING.spread(z), STATIC)
            for sign in (1, -1)
        )
        for name, slope in vars(found).items():
            skip = 1 if name in ("states", "poses") else 0  # the measured state can't be moved
            finite = (getattr(ahead, name)[skip:] - getattr(behind, name)[skip:]) / (2 * z[j])
            np.testing.assert_allclose(slope[..., j], finite, rtol=2e-4, atol=2e-6, err_msg=f"{name} by {j}")


def test_it_is_the_matrix_of_the_paper() -> None:
    """Each block is the product of the A between an input and a state, times the B of each sample in which it acts."""
    random = np.random.default_rng(1)
    horizon = Horizon(6, 3, 0.05)
    blocking = Blocking(horizon)
    jacobians = Linearisation(
        random.normal(size=(6, 6, 6)),
        random.normal(size=(6, 6, 5)),
        random.normal(size=(6, 5, 6)),
        random.normal(size=(6, 5, 5)),
    )
    found = condense(jacobians, blocking)

    def moved(sample: int, k: int) -> np.ndarray:
        """d x_k / d u_sample, in SI."""
        if sample >= k:
            return np.zeros((6, 5))
        product = jacobians.B[sample]
        for i in range(sample + 1, k):
            product = jacobians.A[i] @ product
        return product

    for block, samples in enumerate([[0], [1], [2, 3, 4, 5]]):
        columns = slice(5 * block, 5 * block + 5)
        for k in range(6):
            at_start = sum(moved(sample, k) for sample in samples)
            at_end = sum(moved(sample, k + 1) for sample in samples)
            output = jacobians.C[k] @ at_start + (jacobians.D[k] if k in samples else 0.0)
            np.testing.assert_allclose(found.states[k][:, columns], at_end * INPUT_SCALE, atol=1e-9)
            np.testing.assert_allclose(found.poses[2 * k][:, columns], output[:3] * INPUT_SCALE, atol=1e-9)
            np.testing.assert_allclose(found.poses[2 * k + 1][:, columns], at_end[[4, 5, 3]] * INPUT_SCALE, atol=1e-9)
            np.testing.assert_allclose(found.front_slip[k, columns], output[3] * INPUT_SCALE, atol=1e-9)
            np.testing.assert_allclose(found.rear_slip[k, columns], output[4] * INPUT_SCALE, atol=1e-9)


def test_the_future_moves_no_past() -> None:
    """No state, pose or slip angle depends on an input that acts later."""
    _, found, _ = random_roll_out(3)
    for k in range(20):
        later = slice(5 * (min(k, 14) + 1), None)
        assert (found.states[k][:, later] == 0).all()
        assert (found.poses[2 * k : 2 * k + 2, :, later] == 0).all()
        assert (found.front_slip[k, later] == 0).all()
        assert (found.rear_slip[k, later] == 0).all()


def test_the_last_free_input_is_held() -> None:
    """Free inputs act one sample each, the last of them until the end of the horizon, in SI."""
    z = np.arange(BLOCKING.n, dtype=float)
    inputs = BLOCKING.spread(z)
    assert inputs.shape == (20, 5)
    np.testing.assert_allclose(inputs[:15], z.reshape(15, 5) * INPUT_SCALE)
    np.testing.assert_array_equal(inputs[15:], np.tile(inputs[14], (5, 1)))
    np.testing.assert_array_equal(BLOCKING.free(inputs), inputs[:15])
