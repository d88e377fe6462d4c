"""The numbers of a run, in SI: what `swerve run --json` prints."""

from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import swerve
from swerve.control import Plan
from swerve.conventions import GRAVITY, STATES
from swerve.scenario import Scenario
from swerve.signals import Command
from swerve.simulate.decision import decision
from swerve.simulate.excursion import lateral_excursion
from swerve.simulate.friction_use import friction_use_of, largest, mean_while_shaped
from swerve.simulate.log import Log
from swerve.simulate.outcome import Outcome, decide, n_sane, ratio_to, sideslip, touches
from swerve.world import Footprint, Obstacle, Road, clearance

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Range:
    """Smallest, largest and last value of a column."""

    min: float
    max: float
    final: float

    @classmethod
    def of(cls, values: Array) -> "Range":
        """The range of values (n,)."""
        return cls(float(values.min()), float(values.max()), float(values[-1]))


@dataclass(frozen=True)
class StepTime:
    """How long the controller's step took, over the steps of a run [s]."""

    median: float
    p99: float
    max: float

    @classmethod
    def of(cls, times: Array) -> "StepTime":
        """Statistics of times (n,) [s]."""
        return cls(float(np.median(times)), float(np.percentile(times, 99)), float(times.max()))


@dataclass(frozen=True)
class Divergence:
    """Where a simulation stopped being a motion.

    Attributes:
        time: of the first row that is none [s].
        last: vx, vy, r, psi, X, Y just before it, in SI.
    """

    time: float
    last: dict[str, float]

    @classmethod
    def of(cls, states: Array, times: Array) -> "Divergence | None":
        """The first row of states (n, 6) at times (n,) that is no motion; None when there is none."""
        n = n_sane(states)
        if n == len(states):
            return None
        return cls(float(times[n]), dict(zip(STATES, states[max(n - 1, 0)].tolist(), strict=True)))


@dataclass(frozen=True)
class Result:
    """The verdict and the numbers behind it; each is named and measured as in the JSON of `swerve run`.

    Attributes:
        scenario: its name.
        controller: its name.
        plant: its name.
        seed: of the run.
        version: of swerve.
        outcome: the verdict.
        min_distance_ratio: smallest sqrt(rho) over all ellipses, 1 is contact; None without ellipses [1].
        min_clearance: between footprint and obstacles; None without obstacles [m].
        impact_speed: relative to the obstacle, at first contact; None without contact [m/s].
        impact_obstacle: index of that obstacle; None without contact.
        oncoming_lane_time: with any part of the footprint beyond the oncoming edge; None without oncoming lanes [s].
        decision: none, brake, steer-left, steer-right, brake+steer-left or brake+steer-right.
        lateral_offset: Y [m].
        speed: over ground [m/s].
        final_yaw_rate: magnitude [rad/s].
        final_lateral_speed: magnitude of vy [m/s].
        max_sideslip: magnitude [rad].
        max_yaw_rate: magnitude [rad/s].
        max_steer: magnitude of the road-wheel angle [rad].
        step_time: of the controller alone.
        steps: of the controller.
        fallback_steps: steps that were answered by a fallback.
        solver_failures: quadratic programs without an answer.
        wall_time: of the whole run [s].
        divergence: when and from what state the simulation diverged; None when it did not.
        lateral_excursion: farthest from the strip between the line it began on and the one it was to hold [m].
        max_friction_use: largest share of its friction that any wheel used; None if none touched the road [1].
        mean_friction_use: over the wheels, while an obstacle shaped the plan; None where none did [1].
        driver_deviation: largest magnitude of commanded less driver's steering angle; None without a driver [rad].
    """

    scenario: str
    controller: str
    plant: str
    seed: int
    version: str
    outcome: Outcome
    min_distance_ratio: float | None
    min_clearance: float | None
    impact_speed: float | None
    impact_obstacle: int | None
    oncoming_lane_time: float | None
    decision: str
    lateral_offset: Range
    speed: Range
    final_yaw_rate: float
    final_lateral_speed: float
    max_sideslip: float
    max_yaw_rate: float
    max_steer: float
    step_time: StepTime
    steps: int
    fallback_steps: int
    solver_failures: int
    wall_time: float
    divergence: Divergence | None
    lateral_excursion: float
    max_friction_use: float | None
    mean_friction_use: float | None
    driver_deviation: float | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain values, ready for `json.dumps`; a number that is not finite becomes None."""
        return {key: _plain(value) for key, value in asdict(self).items()}


def evaluate(
    scenario: Scenario,
    controller: str,
    plant: str,
    seed: int,
    log: Log,
    commands: list[Command],
    plans: list[Plan],
    wall_time: float,
) -> Result:
    """Measure a run that is over."""
    motion, times = log.motion, log.motion["time"]
    states = motion.stack("vx", "vy", "r", "psi", "X", "Y")
    n = n_sane(states)
    times, poses = times[:n], motion.stack("X", "Y", "psi")[:n]
    footprint, vehicle = scenario.ego.to_footprint(), scenario.ego.to_vehicle()
    road, obstacles = scenario.road.to_world(), [obstacle.to_world() for obstacle in scenario.obstacles]
    contact = np.array([touches(each, footprint, poses, times) for each in obstacles]).reshape(-1, len(times))
    ratios = [ratio_to(each, footprint, poses, times) for each in obstacles]
    gaps = [clearance(footprint, poses, each, times) for each in obstacles]
    impact = _first_impact(contact)
    use = friction_use_of(scenario, motion, n)
    grip = scenario.road.friction * vehicle.mass * GRAVITY
    speed = np.hypot(motion["vx"], motion["vy"])
    return Result(
        scenario=scenario.name,
        controller=controller,
        plant=plant,
        seed=seed,
        version=swerve.__version__,
        outcome=decide(states, np.any(contact, axis=0), poses, road, footprint),
        min_distance_ratio=min((float(ratio.min()) for ratio in ratios if ratio is not None), default=None),
        min_clearance=min((float(gap.min()) for gap in gaps), default=None),
        impact_speed=None if impact is None else _impact_speed(states, times, impact, obstacles),
        impact_obstacle=None if impact is None else impact.obstacle,
        oncoming_lane_time=_oncoming_lane_time(road, footprint, poses, times),
        decision=decision(commands, plans, grip, scenario.controller.sample_time),
        lateral_offset=Range.of(motion["Y"]),
        speed=Range.of(speed),
        final_yaw_rate=abs(float(motion["r"][-1])),
        final_lateral_speed=abs(float(motion["vy"][-1])),
        max_sideslip=float(np.abs(sideslip(states)).max()),
        max_yaw_rate=float(np.abs(motion["r"]).max()),
        max_steer=float(np.abs(motion["delta"]).max()),
        step_time=StepTime.of(log.steps["step_time"]),
        steps=len(plans),
        fallback_steps=sum(plan.fallback is not None for plan in plans),
        solver_failures=sum(plan.solver_failures for plan in plans),
        wall_time=wall_time,
        divergence=Divergence.of(states, motion["time"]),
        lateral_excursion=lateral_excursion(poses[:, 1], scenario.goal.lateral_offset),
        max_friction_use=largest(use),
        mean_friction_use=mean_while_shaped(use, plans, scenario.n_substeps),
        driver_deviation=_driver_deviation(log),
    )


def _driver_deviation(log: Log) -> float | None:
    """Over the steps whose driver's input is finite."""
    deviation = np.abs(log.steps["delta"] - log.steps["delta_driver"])
    return max(deviation[np.isfinite(deviation)].tolist(), default=None)


class _Impact(NamedTuple):
    """The first contact: row of the motion, and index of the obstacle."""

    row: int
    obstacle: int


def _first_impact(contact: NDArray[np.bool_]) -> _Impact | None:
    """The first of contact (obstacles, n); of several obstacles at that instant the first one."""
    if not contact.any():
        return None
    row = int(np.argmax(contact.any(axis=0)))
    return _Impact(row, int(np.argmax(contact[:, row])))


def _impact_speed(states: Array, times: Array, impact: _Impact, obstacles: list[Obstacle]) -> float:
    """Speed relative to the obstacle at the instant of the impact [m/s]."""
    vx, vy, _, psi = states[impact.row, :4]
    over_ground = np.array([vx * np.cos(psi) - vy * np.sin(psi), vx * np.sin(psi) + vy * np.cos(psi)])
    return float(np.linalg.norm(over_ground - obstacles[impact.obstacle].velocity_at(times[impact.row])))


def _oncoming_lane_time(road: Road, footprint: Footprint, poses: Array, times: Array) -> float | None:
    """Sum of the steps that begin with a part of the footprint in an oncoming lane [s]."""
    if road.oncoming_edge is None:
        return None
    return float(np.diff(times)[road.is_oncoming(footprint, poses)[:-1]].sum())


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, Outcome):
        return value.value
    return None if isinstance(value, float) and not np.isfinite(value) else value
