"""The D-class sedan of Table 2, completed.

Table 2 has masses, axles, track, yaw inertia and rolling radius, and so do the published data of the simulator's own
D-class sedan, from which roll and pitch inertia and the centre of gravity's height are taken. What is not published is
reasoned, line by line. At rest a front wheel carries 4116 N of the sprung mass, a rear one 2604 N: 420 kg and 265 kg.
"""

from typing import Final

from swerve.vehicle.multibody.actuators import Actuators
from swerve.vehicle.multibody.chassis import Chassis, TyreDynamics

TYRE_215_55_R17: Final = TyreDynamics(
    longitudinal_stiffness=14.5,  # [1] with Cx: slip stiffness 22 Fz, as measured car tyres have; peak at 12 % of slip
    longitudinal_shape=1.5,  # [1] a locked wheel keeps 77 % of the peak, usual on dry asphalt
    longitudinal_relaxation=0.25,  # [m] slip stiffness, 8e4 N, over the carcass's stiffness, 3.2e5 N/m
    lateral_relaxation=0.5,  # [m] cornering stiffness, 7.5e4 N, over the carcass's stiffness, 1.5e5 N/m
    vertical_stiffness=2.2e5,  # [N/m] 215/55 R17 at 2.3 bar: 200 to 240
    vertical_damping=50.0,  # [N s/m] a rolling tyre has next to none
    rolling_resistance=0.01,  # [1] class C of the European tyre label: 0.0078 to 0.009, and bearings
)

D_CLASS_CHASSIS: Final = Chassis(
    unsprung_mass=(40.0, 40.0),  # [kg] Table 2: 80 kg an axle
    cg_height=0.52,  # [m] published for the D-class sedan of Table 2
    roll_inertia=671.3,  # [kg m^2] published, with Table 2's yaw inertia
    pitch_inertia=1972.8,  # [kg m^2] published, with Table 2's yaw inertia
    spring_rate=(2.4e4, 2.1e4),  # [N/m] 1.20 Hz in front and 1.42 Hz behind, so that the car pitches little (Olley)
    damping_rate=(1900.0, 1400.0),  # [N s/m] 0.30 of critical
    anti_roll_stiffness=(2.2e4, 8.0e3),  # [N m/rad] with the springs: 4.1 deg of roll at 1 g, 61 % of it in front
    roll_centre_height=(0.05, 0.10),  # [m] usual for a strut in front and a multi-link axle behind
    wheel_inertia=1.2,  # [kg m^2] 0.9 of wheel, tyre and disc, 0.3 of the motor's rotor
    drag_area=0.65,  # [m^2] drag coefficient 0.29 and 2.25 m^2
    tyre=TYRE_215_55_R17,
)

# The paper has one motor a wheel, whatever torque is asked of it, and steering without a lag.
D_CLASS_ACTUATORS: Final = Actuators(
    delay=0.01,  # [s] two cycles of 5 ms on a vehicle's bus
    steering_lag=0.02,  # [s] 8 Hz of bandwidth, an active front steer's
    steering_rate_limit=1.2,  # [rad/s] of the road wheels; 1100 deg/s of a steering wheel, a hasty driver's
    motor_lag=0.01,  # [s] a current controller and its bus
    motor_torque_limit=1250.0,  # [N m] an in-wheel motor's peak; 1.1 times what mu 0.85 takes of a front wheel at rest
    motor_power_limit=7.5e4,  # [W] an in-wheel motor's peak
    brake_lag=0.05,  # [s] an electro-hydraulic brake
    brake_torque_limit=3000.0,  # [N m] locks the front wheel of a car that stands on its nose at mu 1
)
