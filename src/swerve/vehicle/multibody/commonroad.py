"""Three cars of the multi-body model of CommonRoad (Althoff and Wuersching, CommonRoad: Vehicle Models, 2020, table 6).

Facts of the parameter files of commonroad-vehicle-models (BSD), in SI: 1 Ford Escort, 2 BMW 320i, 3 VW Vanagon. An
axle's mass is halved, front and rear track are averaged (they differ by 2.4 % at most), a bar's torsion rate has its
sign turned. The tyre, of the ADAMS handbook, has neither load sensitivity nor friction: B, C and D are constant, for
friction 1; camber thrust, ply steer, and the joint by which the body moves sideways on its axles are not here. What
that model lacks - relaxation of slip, drag, rolling resistance, actuators but the steering's rate - is as in the
D-class sedan.
"""

from dataclasses import replace
from typing import Final

from swerve.vehicle.multibody.chassis import Chassis, TyreDynamics
from swerve.vehicle.multibody.sedan import D_CLASS_ACTUATORS, TYRE_215_55_R17
from swerve.vehicle.parameters import Vehicle
from swerve.vehicle.tyre import Tyre

RADIUS = 0.344  # [m] R_w
SHAPE, PEAK, STIFFNESS = 1.3507, 1.0489, 21.92  # [1] p_cy1, p_dy1, -p_ky1: cornering stiffness over load
LONGITUDINAL_SHAPE, SLIP_STIFFNESS = 1.6411, 22.303  # [1] p_cx1, p_kx1; the peak, 12 % higher there, is the lateral one

TYRE: Final = Tyre(b0=STIFFNESS / (SHAPE * PEAK), b1=0.0, c0=SHAPE, c1=0.0, d0=PEAK, d1=0.0)
ACTUATORS: Final = replace(D_CLASS_ACTUATORS, steering_rate_limit=0.4)  # [rad/s] v_max of all three


def _tyre(vertical_stiffness: float) -> TyreDynamics:
    """The handbook's tyre on a vertical spring, K_zt [N/m]."""
    return replace(
        TYRE_215_55_R17,
        longitudinal_stiffness=SLIP_STIFFNESS / (LONGITUDINAL_SHAPE * PEAK),
        longitudinal_shape=LONGITUDINAL_SHAPE,
        vertical_stiffness=vertical_stiffness,
        vertical_damping=0.0,
    )


def _cg_height(mass: float, sprung_mass: float, sprung_height: float) -> float:
    """Of the whole vehicle [m], with the wheels' masses at their centres."""
    return (sprung_mass * sprung_height + (mass - sprung_mass) * RADIUS) / mass


FORD_ESCORT: Final = Vehicle(
    name="ford-escort",
    mass=1225.888,  # [kg] m
    yaw_inertia=1538.853,  # [kg m^2] I_z
    cg_to_front_axle=0.88392,  # [m] a
    cg_to_rear_axle=1.50876,  # [m] b
    half_track=(1.389888 + 1.423416) / 4,  # [m] T_f, T_r
    wheel_radius=RADIUS,
    steering_limit=0.91,  # [rad]
    force_limit=0.95,  # [1] not there
    length=4.298,  # [m] l
    width=1.674,  # [m] w
    cg_to_front_end=1.70,  # [m] not there: a front overhang of 0.82 m
    tyre=TYRE,
)
FORD_ESCORT_CHASSIS: Final = Chassis(
    unsprung_mass=(65.67256 / 2, 65.67256 / 2),  # [kg] m_uf, m_ur
    cg_height=_cg_height(1225.888, 1094.543, 0.59436),  # [m] of m_s, h_s
    roll_inertia=244.0472,  # [kg m^2] I_Phi_s
    pitch_inertia=1342.260,  # [kg m^2] I_y_s
    spring_rate=(21898.33, 21898.33),  # [N/m] K_sf, K_sr
    damping_rate=(1459.390, 1459.390),  # [N s/m] K_sdf, K_sdr
    anti_roll_stiffness=(12880.27, 0.0),  # [N m/rad] -K_tsf, -K_tsr
    roll_centre_height=(0.0, 0.0),  # [m] h_raf, h_rar
    wheel_inertia=1.7,  # [kg m^2] I_y_w
    drag_area=0.65,  # [m^2] not there
    tyre=_tyre(189785.5),
)

BMW_320I: Final = Vehicle(
    name="bmw-320i",
    mass=1093.295,  # [kg]
    yaw_inertia=1791.600,  # [kg m^2]
    cg_to_front_axle=1.156196,  # [m]
    cg_to_rear_axle=1.422717,  # [m]
    half_track=(1.38684 + 1.36398) / 4,  # [m]
    wheel_radius=RADIUS,
    steering_limit=1.066,  # [rad]
    force_limit=0.95,  # [1] not there
    length=4.508,  # [m]
    width=1.610,  # [m]
    cg_to_front_end=1.93,  # [m] not there: a front overhang of 0.77 m
    tyre=TYRE,
)
BMW_320I_CHASSIS: Final = Chassis(
    unsprung_mass=(63.79218 / 2, 63.79218 / 2),  # [kg]
    cg_height=_cg_height(1093.295, 965.7108, 0.61373004),  # [m]
    roll_inertia=207.2652,  # [kg m^2]
    pitch_inertia=1565.818,  # [kg m^2]
    spring_rate=(24453.14, 19635.50),  # [N/m]
    damping_rate=(1786.244, 1649.083),  # [N s/m]
    anti_roll_stiffness=(6914.882, 2643.601),  # [N m/rad]
    roll_centre_height=(0.0, 0.0),  # [m]
    wheel_inertia=1.7,  # [kg m^2]
    drag_area=0.65,  # [m^2] not there
    tyre=_tyre(158294.1),
)

VW_VANAGON: Final = Vehicle(
    name="vw-vanagon",
    mass=1478.898,  # [kg]
    yaw_inertia=2473.118,  # [kg m^2]
    cg_to_front_axle=1.150792,  # [m]
    cg_to_rear_axle=1.321136,  # [m]
    half_track=(1.574292 + 1.543812) / 4,  # [m]
    wheel_radius=RADIUS,
    steering_limit=1.023,  # [rad]
    force_limit=0.95,  # [1] not there
    length=4.569,  # [m]
    width=1.844,  # [m]
    cg_to_front_end=2.20,  # [m] not there: a front overhang of 1.05 m
    tyre=TYRE,
)
VW_VANAGON_CHASSIS: Final = Chassis(
    unsprung_mass=(81.14429 / 2, 81.14429 / 2),  # [kg]
    cg_height=_cg_height(1478.898, 1316.609, 0.804490644),  # [m]
    roll_inertia=479.8843,  # [kg m^2]
    pitch_inertia=2204.323,  # [kg m^2]
    spring_rate=(33577.44, 39125.02),  # [N/m]
    damping_rate=(2405.564, 2769.727),  # [N s/m]
    anti_roll_stiffness=(33948.22, 7731.374),  # [N m/rad]
    roll_centre_height=(0.0, 0.0),  # [m]
    wheel_inertia=1.7,  # [kg m^2]
    drag_area=1.2,  # [m^2] not there: a box of 3.4 m^2
    tyre=_tyre(212641.6),
)
