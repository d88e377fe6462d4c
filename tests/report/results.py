"""A result, and a small ablation, to report about."""

from dataclasses import replace

from swerve.simulate import Outcome
from swerve.simulate.result import Range, Result, StepTime
from swerve.study.ablation import Ablation, Row, Scene
from swerve.study.variants import Variant

RESULT = Result(
    scenario="wet",
    controller="unified",
    plant="planar",
    seed=7,
    version="0",
    outcome=Outcome.AVOIDED,
    min_distance_ratio=1.0123,
    min_clearance=None,
    impact_speed=None,
    impact_obstacle=None,
    oncoming_lane_time=None,
    decision="steer-left",
    lateral_offset=Range(-0.1, 3.0, 0.01),
    speed=Range(18.0, 20.0, 20.0),
    final_yaw_rate=0.0,
    final_lateral_speed=0.0,
    max_sideslip=0.05,
    max_yaw_rate=0.5,
    max_steer=0.1,
    step_time=StepTime(0.0015, 0.004, 0.01),
    steps=100,
    fallback_steps=2,
    solver_failures=3,
    divergence=None,
    lateral_excursion=3.0,
    max_friction_use=0.97,
    mean_friction_use=None,
    wall_time=1.0,
)

COLLIDED = replace(RESULT, scenario="paper", outcome=Outcome.COLLIDED, min_distance_ratio=0.0, max_steer=0.0)

ABLATION = Ablation(
    (Scene("paper", "as in the paper"), Scene("wet", "on a wet road")),
    (
        Row(Variant("as printed", "as-printed", (), "To the letter."), (COLLIDED, replace(COLLIDED, scenario="wet"))),
        Row(
            Variant("unified, bare", "unified", ("controller.unified.iterations=1",), "It works."),
            (replace(RESULT, scenario="paper"), replace(RESULT, min_distance_ratio=None)),
        ),
    ),
)
