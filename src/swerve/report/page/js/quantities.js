"use strict";
/* What the charts show: title, unit of display, and the lines, each with times, values in SI and the factor to the unit.
   Of several cars each is one line; then what the wheels have is told by their sum or by the largest. */
const Quantities = (() => {
  const DEGREE = 180 / Math.PI;
  const WHEELS = ["FL", "FR", "RL", "RR"];

  function of({ scene, cars }) {
    const several = cars.length > 1;
    const one = name => cars.map((car, i) => line(several ? car.name : "", car.motion.time, car.motion[name], i));
    const level = (label, value) => ({ label, times: [0, scene.end], values: [value, value], isLevel: true });
    const wheels = (name, together) => several
      ? cars.map((car, i) => line(car.name, car.motion.time, car.motion[name][0].map((_, k) => together(car.motion[name].map(each => each[k]))), i))
      : cars[0].motion[name].map((values, i) => line(WHEELS[i], cars[0].motion.time, values, i));
    const steering = several ? one("delta")
      : [{ ...held("commanded", cars[0], "delta", 2), width: 3, dash: [] }, line("acting", cars[0].motion.time, cars[0].motion.delta, 0)];
    const each = (title, unit, factor, digits, lines, more = {}) => ({ title, unit, factor, digits, lines, ...more });
    return [
      each("Speed", "km/h", 3.6, 1, [...one("speed"), level("goal", scene.goal.speed)], { least: 2 }),
      each("Lateral offset Y", "m", 1, 2, [...one("Y"), level("goal", scene.goal.lateral_offset)], { least: 0.5 }),
      each("Yaw rate", "°/s", DEGREE, 1, one("r"), { least: 2 }),
      each("Sideslip", "°", DEGREE, 2, one("beta"), { least: 1 }),
      each("Steering, road wheel", "°", DEGREE, 2, steering, { least: 1 }),
      each(several ? "Wheel torques, sum" : "Wheel torques", "N m", 1, 0, wheels("torque", sum), { least: 100 }),
      each(several ? "Friction use, largest" : "Friction use", "%", 100, 0, [...wheels("use", largest), level("limit", 1)], { from: 0 }),
      each("Clearance, shown to 5 m", "m", 1, 2, one("clearance"), { from: 0, upTo: 5 }),
      each("Step time", "ms", 1000, 2, cars.map((car, i) => held(several ? car.name : "", car, "step_time", i)), { from: 0 }),
    ].filter(({ lines }) => lines.some(({ values, isLevel }) => !isLevel && values.some(value => value !== null)));
  }

  const line = (label, times, values, index) => ({ label, times, values, index });
  /* of a step: held until the next one, the last until the end */
  const held = (label, { steps, motion }, name, index) => ({ stepped: true,
    ...line(label, [...steps.time, motion.time.at(-1)], [...steps[name], steps[name].at(-1)], index) });
  const sum = values => values.reduce((total, value) => total + value, 0);
  const largest = values => Math.max(...values);
  return { of };
})();
