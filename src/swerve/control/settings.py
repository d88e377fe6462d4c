"""What every controller is told: horizons, weights of the cost (10), and the goal. All of it without defaults.

The defaults of a scenario file (Table 3 of the paper) are the scenario's; a controller that is built by hand is told
everything.
"""

from dataclasses import dataclass

SLOWEST = 5.0  # [m/s] below, a relaxation length is no longer a delay worth planning with


@dataclass(frozen=True)
class Horizon:
    """How far and how finely a controller looks ahead.

    Attributes:
        prediction: Np [samples].
        control: Nc, after which the input is held [samples].
        sample_time: Ts [s].
    """

    prediction: int
    control: int
    sample_time: float


@dataclass(frozen=True)
class Weights:
    """Weights Q and R of the cost (10).

    Attributes:
        speed: w_vx [s^2/m^2].
        lateral_speed: w_vy [s^2/m^2].
        lateral_offset: w_y [1/m^2].
        steering_rate: on the change of delta in a sample [1/rad^2].
        force_rate: on the change of each wheel force in a sample [1/N^2].
    """

    speed: float
    lateral_speed: float
    lateral_offset: float
    steering_rate: float
    force_rate: float


@dataclass(frozen=True)
class Goal:
    """Where the cost pulls.

    Attributes:
        speed: v_xd [m/s].
        lateral_offset: y_d [m].
    """

    speed: float
    lateral_offset: float


@dataclass(frozen=True)
class Latency:
    """Delays that a controller knows of.

    Attributes:
        sensing: age of a measurement when the controller gets it [s].
        actuation: from a command to what the actuators do: transport, and their lag taken as a delay [s].
        relaxation: length that a tyre rolls until its lateral force has built up, taken as a delay too [m].
    """

    sensing: float
    actuation: float
    relaxation: float

    def effect(self, speed: float) -> float:
        """From a command to its effect on the motion, at a speed [m/s]; SLOWEST for all that is slower [s]."""
        return self.actuation + self.relaxation / max(speed, SLOWEST)
