"use strict";
/* The four wheels seen from above, front at the top: each one's friction circle and the force in it.
   Up is driving, down is braking, left is left; the edge is mu Fz. */
const Wheels = (() => {
  const NAMES = ["front left", "front right", "rear left", "rear right"];

  function draw(canvas, cars, time) {
    const { ink, width, height } = sheet(canvas), states = cars.map(car => Track.car(car, time));
    const radius = Math.min(width / 4 - 12, height / 4 - 26);
    NAMES.forEach((name, i) => {
      const x = width * (i % 2 ? 0.75 : 0.25), y = height * (i < 2 ? 0.25 : 0.75) + 8;
      circle(ink, x, y, radius);
      states.forEach((state, n) => force(ink, x, y, radius, state, i, cars.length > 1 ? Colours.ofLine(n) : null));
      words(ink, x, y - radius - 9, name, states.map(state => state.use[i]));
    });
    canvas.setAttribute("aria-label", spoken(states[0].use));
  }

  function circle(ink, x, y, radius) {
    ink.lineWidth = 1;
    ink.strokeStyle = Colours.get("border");
    for (const share of [0.5, 1]) {
      if (share === 1) [ink.strokeStyle, ink.lineWidth] = [Colours.get("lane"), 2];
      ink.beginPath();
      ink.arc(x, y, radius * share, 0, 7);
      ink.stroke();
      if (share === 0.5) cross(ink, x, y, radius);
    }
  }

  function cross(ink, x, y, radius) {
    ink.beginPath();
    ink.moveTo(x - radius, y);
    ink.lineTo(x + radius, y);
    ink.moveTo(x, y - radius);
    ink.lineTo(x, y + radius);
    ink.stroke();
  }

  function force(ink, x, y, radius, { Fx, Fy, use }, i, colour) {
    const size = Math.hypot(Fx[i], Fy[i]);
    if (use[i] === null || !size) return;
    const tip = [x - radius * use[i] * Fy[i] / size, y - radius * use[i] * Fx[i] / size];
    ink.strokeStyle = colour ?? Colours.get("force");
    ink.lineWidth = 3;
    ink.beginPath();
    ink.moveTo(x, y);
    ink.lineTo(...tip);
    ink.stroke();
    ink.beginPath();
    ink.arc(...tip, 6, 0, 7);
    ink.fillStyle = Colours.ofUse(use[i]);
    ink.fill();
    ink.strokeStyle = colour ?? Colours.get("ink");
    ink.lineWidth = 1.5;
    ink.stroke();
  }

  const percent = use => use === null ? "in the air" : `${Math.round(100 * use)} %`;

  /* Of more than two cars the numbers would not fit; the chart of friction use has them. */
  function words(ink, x, y, name, uses) {
    ink.textAlign = "center";
    ink.font = "13px system-ui, sans-serif";
    ink.fillStyle = Colours.get("ink");
    ink.fillText(uses.length > 2 ? name : `${name}  ${uses.map(percent).join(" / ")}`, x, y);
  }

  const spoken = uses => `Friction in use: ${NAMES.map((name, i) => `${name} ${percent(uses[i])}`).join(", ")}`;
  return { draw };
})();
