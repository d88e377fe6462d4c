"use strict";
/* Values of the document at any time: linear between two rows, the last one before it for what is held. */
const Track = (() => {
  /* the last row that is not after `time`, the first one before all */
  function row(times, time) {
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time + 1e-9) low = middle; else high = middle - 1;
    }
    return low;
  }

  function between(times, time) {
    const i = row(times, time);
    if (i + 1 >= times.length) return [i, i, 0];
    return [i, i + 1, Math.min(1, Math.max(0, (time - times[i]) / (times[i + 1] - times[i])))];
  }

  function mixed(values, [i, j, share]) {
    return values[i] === null || values[j] === null ? values[i] : values[i] + share * (values[j] - values[i]);
  }

  /* pose, steering and the wheels of a car [SI] */
  function car({ motion }, time) {
    const at = between(motion.time, time);
    const one = name => mixed(motion[name], at);
    const each = name => motion[name].map(values => mixed(values, at));
    return { X: one("X"), Y: one("Y"), psi: one("psi"), delta: one("delta"), speed: one("speed"),
      clearance: one("clearance"), Fx: each("Fx"), Fy: each("Fy"), Fz: each("Fz"), use: each("use") };
  }

  function obstacle(track, time) {
    const at = between(track.time, time);
    return { X: mixed(track.X, at), Y: mixed(track.Y, at), psi: mixed(track.psi, at) };
  }

  const step = (car, time) => row(car.steps.time, time);
  return { row, car, obstacle, step };
})();
