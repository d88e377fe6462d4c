"use strict";
/* A car from above: body, wheels turned and coloured by their friction use, the forces on them, and its path. */
const Car = (() => {
  const TYRE = 0.24;  // width as it is drawn [m]
  const ARROW = 0.00042;  // length of a force's arrow [m/N]
  const LEAST_ARROW = 5;  // that is drawn [px]

  function draw(ink, camera, car, state, colour, { forces, share = 1 }) {
    ink.globalAlpha = share;
    camera.inside(ink, state, pixel => {
      body(ink, car.body, colour, pixel);
      for (const wheel of hubs(car.body, state)) tyre(ink, car.body.wheel_radius, wheel, pixel);
      centre(ink, car, pixel);
    });
    if (forces) camera.inside(ink, state, pixel => hubs(car.body, state).forEach(wheel => arrow(ink, wheel, pixel)));
    ink.globalAlpha = 1;
  }

  /* Order FL FR RL RR; the front ones are turned. */
  function hubs(body, { delta, use, Fx, Fy }) {
    return [0, 1, 2, 3].map(i => ({ x: i < 2 ? body.front_axle : body.rear_axle, y: (i % 2 ? -1 : 1) * body.half_track,
      angle: i < 2 ? delta : 0, use: use[i], Fx: Fx[i], Fy: Fy[i] }));
  }

  function body(ink, { front, rear, width }, colour, pixel) {
    const length = front - rear, half = width / 2;
    const at = share => rear + share * length;
    ink.beginPath();
    ink.roundRect(rear, -half, length, width, [0.55, 0.75, 0.75, 0.55]);
    ink.fillStyle = Colours.get("card");
    ink.fill();
    ink.fillStyle = Colours.pale(colour, 0.28);
    ink.fill();
    ink.strokeStyle = colour;
    ink.lineWidth = 2 * pixel;
    ink.stroke();
    ink.fillStyle = Colours.pale(colour, 0.5);
    glass(ink, [[at(0.7), 0.74], [at(0.6), 0.62]], half);
    glass(ink, [[at(0.13), 0.66], [at(0.22), 0.58]], half);
  }

  /* A pane across: two edges, [x, half width as a share]. */
  function glass(ink, [[outer, wide], [inner, narrow]], half) {
    ink.beginPath();
    for (const [x, y] of [[outer, wide], [inner, narrow], [inner, -narrow], [outer, -wide]]) ink.lineTo(x, y * half);
    ink.closePath();
    ink.fill();
  }

  function tyre(ink, radius, { x, y, angle, use }, pixel) {
    ink.save();
    ink.translate(x, y);
    ink.rotate(angle);
    ink.beginPath();
    ink.roundRect(-radius, -TYRE / 2, 2 * radius, TYRE, 0.06);
    ink.fillStyle = Colours.ofUse(use);
    ink.fill();
    ink.strokeStyle = Colours.get("ink");
    ink.lineWidth = 1.2 * pixel;
    ink.stroke();
    ink.restore();
  }

  function centre(ink, { footprint }, pixel) {
    ink.beginPath();
    ink.arc(0, 0, (footprint === "point" ? 4 : 2.5) * pixel, 0, 7);
    ink.fillStyle = Colours.get("ink");
    ink.fill();
  }

  function arrow(ink, { x, y, angle, Fx, Fy }, pixel) {
    const length = ARROW * Math.hypot(Fx, Fy), head = Math.min(9 * pixel, 0.5 * length);
    if (length < LEAST_ARROW * pixel) return;
    ink.save();
    ink.translate(x, y);
    ink.rotate(angle + Math.atan2(Fy, Fx));
    ink.strokeStyle = ink.fillStyle = Colours.get("force");
    ink.lineWidth = 2.6 * pixel;
    ink.beginPath();
    ink.moveTo(0, 0);
    ink.lineTo(length - head, 0);
    ink.stroke();
    ink.beginPath();
    for (const [tip, side] of [[length, 0], [length - head, 0.55 * head], [length - head, -0.55 * head]]) ink.lineTo(tip, side);
    ink.fill();
    ink.restore();
  }

  /* The path of the centre of gravity: driven as a line, what is to come as dots; a diamond where it is closest. */
  function path(ink, camera, car, time, colour) {
    const { X, Y, time: times } = car.motion, now = Track.row(times, time);
    const points = X.map((each, i) => [each, Y[i]]);
    ink.strokeStyle = colour;
    ink.lineWidth = 2;
    camera.trace(ink, points.slice(0, now + 1));
    ink.stroke();
    ink.setLineDash([1.5, 5]);
    ink.lineWidth = 1.5;
    camera.trace(ink, points.slice(now));
    ink.stroke();
    ink.setLineDash([]);
    if (car.closest !== null) diamond(ink, camera, Track.car(car, car.closest), colour);
  }

  function diamond(ink, camera, { X, Y }, colour) {
    const x = camera.x(X), y = camera.y(Y);
    ink.beginPath();
    for (const [dx, dy] of [[5, 0], [0, 5], [-5, 0], [0, -5]]) ink.lineTo(x + dx, y + dy);
    ink.closePath();
    ink.fillStyle = Colours.get("card");
    ink.fill();
    ink.strokeStyle = colour;
    ink.stroke();
  }

  /* Beside the body, each car's on its own line. */
  /* Its name below it, as a label of a plan. */
  function label(ink, camera, car, state, colour) {
    const x = camera.x(state.X) - ink.measureText(car.name).width / 2;
    return { text: car.name, colour, x, y: camera.y(state.Y) + camera.scale * car.body.width / 2 + 14 };
  }

  return { draw, label, path };
})();
