"use strict";
/* A point in words: what its card, the note beside it and a screen reader say. */
const Words = (() => {
  const OUTCOMES = { avoided: "Avoided", collided: "Collided", left_road: "Left the road", spun: "Spun", diverged: "Diverged" };
  const TITLES = { run: null, limit: "Limit", turn: "Turns to steering", bought: "Torques" };
  const unit = (value, digits, of) => `${value.toFixed(digits)} ${of}`;

  /* Name and text of each number; what is not there is left out. */
  function rows(point, panel, extent) {
    const { distance } = point, plain = value => String(Number(value.toFixed(4)));
    const found = [["Speed", `${plain(point.speed)} m/s, ${plain(3.6 * point.speed)} km/h`], ["Friction", plain(panel.friction)]];
    if (panel.offset !== 0) found.push(["Offset", `${plain(panel.offset)} m`]);
    if (point.kind === "bought") {
      return [...found, ["Both", unit(point.both, 2, "m")], ["Individual", unit(point.individual, 2, "m")], ["Bought", unit(distance, 2, "m")]];
    }
    found.push(["Distance", unit(distance, 2, "m")], ["Time to collision", unit((distance - extent) / point.speed, 3, "s")]);
    const more = [["Of the limit", point.of_limit, value => `${value.toFixed(3)} times`], ["Decision", point.decision, String],
      ["Clearance", point.clearance, value => unit(value, 3, "m")], ["Impact speed", point.impact_speed, value => unit(3.6 * value, 1, "km/h")]];
    return [...found, ...more.filter(each => each[1] !== null && each[1] !== undefined).map(([name, value, text]) => [name, text(value)])];
  }

  const verdict = point => TITLES[point.kind] ?? OUTCOMES[point.outcome] ?? point.outcome;
  const brief = (point, name) => point.kind === "bought" ? `${point.name}: ${unit(point.distance, 2, "m")}`
    : `${name}: ${unit(point.distance, 2, "m")}, ${verdict(point).toLowerCase()}`;
  return { rows, verdict, brief };
})();
