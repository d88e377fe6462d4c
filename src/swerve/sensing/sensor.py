"""From truth to measurement: sample and hold, delay, noise, and where the wheel loads come from."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from swerve.conventions import PSI, VX, VY, R, X, Y
from swerve.sensing.past import Past, Truth
from swerve.signals import Driver, Measurement, Observation
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from swerve.world import Obstacle


@dataclass(frozen=True)
class Noise:
    """Standard deviations of white, normal noise, one draw a sample and channel.

    Attributes:
        speed: of vx [m/s].
        lateral_speed: of vy [m/s].
        yaw_rate: of r [rad/s].
        heading: of psi [rad].
        position: of X and of Y [m].
        wheel_load: of each wheel [N].
        obstacle_position: of each obstacle's X and Y [m].
        obstacle_velocity: of each obstacle's velocity along X and Y [m/s].
    """

    speed: float = 0.0
    lateral_speed: float = 0.0
    yaw_rate: float = 0.0
    heading: float = 0.0
    position: float = 0.0
    wheel_load: float = 0.0
    obstacle_position: float = 0.0
    obstacle_velocity: float = 0.0


@dataclass(frozen=True)
class Sensor:
    """All that the controller gets to know.

    Attributes:
        delay: age of every measurement [s].
        noise: on its channels.
        estimates_loads: wheel loads from the measured accelerations and the vehicle's parameters, not from the plant.
        vehicle: for that estimate.
        driver: whose input is measured too, as late as all else; None where nobody sits at the wheel.
    """

    delay: float
    noise: Noise
    estimates_loads: bool
    vehicle: Vehicle
    driver: Driver | None = None

    def measure(
        self, time: float, past: Past, obstacles: Sequence[Obstacle], generator: np.random.Generator
    ) -> Measurement:
        """The measurement that is there at `time` [s]: of `time - delay`, and of time zero before that."""
        stamp = max(0.0, time - self.delay)
        truth, noise = past.at(stamp), self.noise
        deviations = np.zeros(6)
        deviations[[VX, VY, R, PSI, X, Y]] = (
            noise.speed,
            noise.lateral_speed,
            noise.yaw_rate,
            noise.heading,
            noise.position,
            noise.position,
        )
        return Measurement(
            time,
            stamp,
            truth.vehicle + deviations * generator.standard_normal(6),
            self._loads(truth) + noise.wheel_load * generator.standard_normal(4),
            tuple(self._observe(obstacle, stamp, generator) for obstacle in obstacles),
            None if self.driver is None else self.driver(stamp, truth.vehicle),
        )

    def _loads(self, truth: Truth) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
        """Loads (4,) [N], of the plant or by `vehicle.loads`; friction plays no part in them."""
        if not self.estimates_loads:
            return np.asarray(truth.wheel_loads)
        return np.maximum(wheel_loads(Parameters.of(self.vehicle, friction=1.0), *truth.acceleration), 0.0)

    def _observe(self, obstacle: Obstacle, stamp: float, generator: np.random.Generator) -> Observation:
        x, y = obstacle.position_at(stamp) + self.noise.obstacle_position * generator.standard_normal(2)
        vx, vy = obstacle.velocity_at(stamp) + self.noise.obstacle_velocity * generator.standard_normal(2)
        heading = float(obstacle.heading_at(stamp))
        return Observation(obstacle.shape, (float(x), float(y)), (float(vx), float(vy)), heading)
