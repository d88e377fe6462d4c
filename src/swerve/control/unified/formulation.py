"""The controller's formula: which terms, limits and paths make the program of a way; all that is built only once.

minimise  sum_i |eta(k+i) - eta_ref|_Q^2 + sum_j |du(k+j)|_R^2 + w sum |Fx|^2 + penalties            (10)
with      the nonlinear two-track model (1), linearised along each way's shifted plan                (12), (13)
within    steering lock, wheel forces that leave room for the lateral demand                         (14)
          half-planes between footprint and obstacles, road edges, slip angles below the tyre's peak (15)
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import EVERYTHING, Actuation
from swerve.control.driver import DriverActuation
from swerve.control.plan import Passing, Side
from swerve.control.settings import Goal, Horizon, Latency, Weights
from swerve.control.unified.assistance import Assistance, Lead
from swerve.control.unified.compensation import state_at_effect
from swerve.control.unified.condensing import Blocking
from swerve.control.unified.deadline import Deadline
from swerve.control.unified.improve import WayPlan
from swerve.control.unified.limits import (
    InputBox,
    Lane,
    ObstacleLimit,
    Penalty,
    RoadEdge,
    SlipLimit,
    SoftLimit,
    SteeringRateLimit,
)
from swerve.control.unified.lines import Lines
from swerve.control.unified.memory import Memory
from swerve.control.unified.outlook import outlook
from swerve.control.unified.prediction import PredictionModel
from swerve.control.unified.program import Program
from swerve.control.unified.scene import SHORTEST_LOOK, Place, Scene, look
from swerve.control.unified.screening import Pricing, price
from swerve.control.unified.separation import Separation
from swerve.control.unified.settings import UnifiedSettings
from swerve.control.unified.situation import Situation
from swerve.control.unified.tail import Tail
from swerve.control.unified.terms import InputRate, Tracking, WheelForce
from swerve.control.unified.way import Way
from swerve.conventions import DELTA, VX, VY, Y
from swerve.signals import Measurement
from swerve.vehicle import Vehicle
from swerve.world import Footprint, Road

Array = NDArray[np.float64]

N_COARSE = 16  # steps of the tail that are larger than a sample
CALM = 0.25  # [1] share of the slip angle that a straight stop may take; changes of steering cost 1 / share^4 as much
LANE_KEPT = 0.1  # [m] to each side by which a stop may leave its line
LANE = Penalty(5e3, 2e4)  # [1/m, 1/m^2] of more than that
GROWTH = 1.0  # [1/s] of the gap beside an obstacle, with foresight, in a swerve: what a prediction gets wrong grows so
TIMING = 0.15  # [s] by which an obstacle that crosses may come earlier or later: so much wider is the gap beside it
PASSING = 2.5e3  # [1/m] of a gap that is missed beside an obstacle
STOPPING = 2e3  # [1/m] of one that is missed behind it: more than a standing vehicle gains by creeping on
EDGE = Penalty(5e3, 2e4)  # [1/m, 1/m^2] of what is off the road: less than of a collision, more than of a slide


@dataclass(frozen=True)
class _Calmness:
    """How much a way may steer: a stop has nothing to gain from it but what tyres that slip sideways brake."""

    input_rate: InputRate
    slip: SlipLimit


class Formulation:
    """The formula for one vehicle on one road."""

    def __init__(
        self,
        vehicle: Vehicle,
        footprint: Footprint,
        road: Road,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        latency: Latency,
        settings: UnifiedSettings,
        actuation: Actuation = EVERYTHING,
    ) -> None:
        """Build the kernels; a first time compiles them."""
        self.vehicle, self.horizon, self.latency, self.settings = vehicle, horizon, latency, settings
        self.actuation = actuation
        able = actuation.braking, actuation.turning
        self.place = Place(footprint, road, friction, goal.lateral_offset, settings.clearance_margin, *able)
        self.model = PredictionModel(vehicle, friction, horizon)
        self.blocking = Blocking(horizon, actuation)
        at_the_wheel = DriverActuation(vehicle, friction, actuation)
        self.assistance = Assistance(at_the_wheel, self.blocking, horizon.sample_time)
        n_fine = 2 * horizon.prediction + 1 + horizon.prediction
        self._tail = Tail(horizon.prediction + N_COARSE)
        self._separation = Separation(footprint, n_fine + N_COARSE, n_fine)
        self._lines = Lines(footprint, self._tail.n_steps)
        self._half_samples = np.arange(2 * horizon.prediction + 1) * horizon.sample_time / 2
        self._tracking = (
            Tracking(VX, goal.speed, weights.speed),
            Tracking(VY, 0.0, weights.lateral_speed),
            Tracking(Y, goal.lateral_offset, weights.lateral_offset),
        )
        self._force = WheelForce(settings.force_weight, self.blocking)
        self._trust = np.array([settings.trust_steering] + 4 * [settings.trust_force])
        prices = (settings.clearance_penalty, settings.clearance_penalty_quadratic)
        self._beside = Penalty(*prices, settings.passing_gap, PASSING)
        self._behind = Penalty(*prices, settings.stopping_gap, STOPPING)
        self._edges = self._road_edges()
        self._swerving = self._calmness(weights, 1.0)
        self._straight = self._calmness(weights, CALM)
        self._pricing = Pricing(goal, weights, horizon.sample_time, settings.clearance_penalty)

    def scene(self, measurement: Measurement, memory: Memory) -> Scene:
        """What this step plans in, from where its command begins to act."""
        delay = self.latency.effect(float(measurement.state[VX]))
        start = state_at_effect(measurement, memory.commands, delay, self.model)
        time, known = measurement.time + delay, memory.forecasts
        return look(self.place, start, time, known, memory.threats, self._tail, self._lines)

    def situation(
        self,
        scene: Scene,
        way: Way,
        measurement: Measurement,
        memory: Memory,
        deadline: Deadline,
        lead: Lead = Lead.NOBODY,
    ) -> Situation:
        """Cost and limits of this step for one way."""
        duration = float(self._half_samples[-1])
        beyond = outlook(scene, way, self.horizon.sample_time, self.horizon.prediction, N_COARSE, duration)
        times = scene.time + np.concatenate([self._half_samples, duration + beyond.times])
        obstacles = [self._obstacle(scene, way, i, times) for i in range(len(scene.forecasts))]
        is_calm = way.is_straight and lead is Lead.NOBODY
        calm = self._straight if is_calm else self._swerving
        tracking = self._tracking if lead is Lead.NOBODY else self.assistance.terms(lead, measurement)
        terms = (*tracking, calm.input_rate.after(memory.command), self._force)
        lane = self._lane(scene) if is_calm else ()
        within = self.actuators(measurement.wheel_loads, memory)
        if lead is Lead.DRIVER:
            within = self.assistance.held(within, measurement, memory.deviation)
        program = replace(within, terms=terms, soft=(*obstacles, *lane, *self._edges, calm.slip))
        loads, trust = measurement.wheel_loads, self._trust
        return Situation(way, program, self.model, self._tail, beyond, times, scene.start, loads, trust, deadline)

    def actuators(self, loads: Array, memory: Memory) -> Program:
        """A program of nothing but what the actuators can do, with wheel loads (4,) [N], after the last command."""
        box = InputBox.of(self.vehicle, self.place.friction, loads, self.blocking)
        rate = self.vehicle.steering_rate_limit * self.horizon.sample_time
        is_limited = self.actuation.steers and np.isfinite(rate)
        hard = [SteeringRateLimit(rate, float(memory.command[DELTA]), self.blocking)] if is_limited else []
        return Program((), box, hard, ())

    def price(self, scene: Scene, way: Way) -> float:
        """The price of a way as a point mass would drive it [1]."""
        beyond = outlook(scene, way, self.horizon.sample_time, self.horizon.prediction, N_COARSE, 0.0)
        return price(scene, way, beyond, self._tail, self._lines, self._pricing)

    def total(self, plan: WayPlan) -> float:
        """What a plan costs, horizon and beyond [1]."""
        trajectory, beyond = plan.step.trajectory, plan.situation.outlook
        poses = trajectory.poses[len(self._half_samples) :]
        window = SHORTEST_LOOK - float(self._half_samples[-1])
        return plan.step.merit + self._pricing.tracking(poses, trajectory.speeds_beyond, beyond.durations, window)

    def _obstacle(self, scene: Scene, way: Way, index: int, times: Array) -> ObstacleLimit:
        """The limit for one obstacle."""
        forecast, passing, margin = scene.forecasts[index], way.passing[index], self.place.margin
        crossing = TIMING * abs(float(forecast.velocity[1]))
        beside = replace(self._beside, comfort=self.settings.passing_gap + crossing)
        penalty = self._behind if passing is Passing.BEHIND else beside
        growth = GROWTH if scene.threats and passing is not Passing.BEHIND else 0.0
        return ObstacleLimit(index, forecast, times, self._separation, passing, margin, penalty, growth)

    def _calmness(self, weights: Weights, share: float) -> "_Calmness":
        rates = np.array([weights.steering_rate / share**4] + 4 * [weights.force_rate])
        slip = Penalty(self.settings.slip_penalty, self.settings.slip_penalty_quadratic)
        return _Calmness(InputRate.of(rates, self.blocking), SlipLimit(share * self.settings.slip_limit, slip))

    def _lane(self, scene: Scene) -> list[SoftLimit]:
        """The lane of a way that only brakes, from where the vehicle is to its goal."""
        here, goal = float(scene.start[Y]), self.place.lateral_offset
        return [Lane(min(here, goal) - LANE_KEPT, max(here, goal) + LANE_KEPT, LANE)]

    def _road_edges(self) -> list[SoftLimit]:
        edges = ((Side.LEFT, self.place.road.left_edge), (Side.RIGHT, self.place.road.right_edge))
        place = self.place
        return [RoadEdge(side, edge, place.footprint, place.margin, EDGE) for side, edge in edges if edge is not None]
