"use strict";
/* The plan of a step: the way that is taken, solid with a dot for each sample, and those that are not, dashed; each with
   its name at its end; one that touches an obstacle is crossed out there, with the speed at which it does. */
const Plans = (() => {
  const FONT = "600 12px system-ui, sans-serif";
  const ROOM = 15;  // between two names, one below the other [px]

  function draw(ink, camera, car, time, colour, { plan, branches }) {
    const k = Track.step(car, time), step = car.plans[k], own = step.branches[step.taken], labels = [];
    if (branches) labels.push(...step.branches.filter(each => each !== own && each.path.length).map(each => other(ink, camera, each)));
    if (plan) labels.push(...chosen(ink, camera, step.path, own?.path ?? [], car.steps.name[k], colour));
    name(ink, camera, labels);
  }

  function poses(path) {
    const points = [];
    for (let i = 0; i < path.length; i += 3) points.push([path[i], path[i + 1], path[i + 2]]);
    return points;
  }

  function other(ink, camera, branch) {
    const points = poses(branch.path), colour = Colours.get(branch.impact_speed === null ? "muted" : "bad");
    ink.strokeStyle = colour;
    ink.lineWidth = 1.5;
    ink.setLineDash([7, 5]);
    camera.trace(ink, points);
    ink.stroke();
    ink.setLineDash([]);
    return { points, text: label(branch), colour };
  }

  function label({ name, impact_speed, off_road }) {
    if (impact_speed !== null) return `✕ ${name}, ${(3.6 * impact_speed).toFixed(0)} km/h`;
    return off_road > 0.005 ? `${name}, off the road` : name;
  }

  function chosen(ink, camera, path, beyond, name, colour) {
    const points = poses(path), far = poses(beyond);
    ink.strokeStyle = ink.fillStyle = colour;
    ink.lineWidth = 1.4;
    camera.trace(ink, far);
    ink.stroke();
    ink.lineWidth = 3;
    camera.trace(ink, points);
    ink.stroke();
    for (const [X, Y] of points) {
      ink.beginPath();
      ink.arc(camera.x(X), camera.y(Y), 2.6, 0, 7);
      ink.fill();
    }
    const last = far.length ? far : points;
    return last.length ? [{ points: last, text: name, colour }] : [];
  }

  /* Names at the last points in view. */
  function name(ink, camera, labels) {
    ink.font = FONT;
    for (const label of labels) place(ink, camera, label);
    write(ink, labels.filter(each => each.text));
  }

  /* Labels {text, colour, x, y} from the top down, pushed apart where they would meet; x is their left end [px]. */
  function write(ink, labels) {
    ink.font = FONT;
    ink.textAlign = "left";
    ink.lineJoin = "round";
    const shown = labels.sort((a, b) => a.y - b.y);
    shown.forEach((each, i) => {
      for (const above of shown.slice(0, i)) {
        if (Math.abs(above.x - each.x) < 90 && each.y - above.y < ROOM) each.y = above.y + ROOM;
      }
      ink.strokeStyle = Colours.get("road");
      ink.lineWidth = 4;
      ink.strokeText(each.text, each.x, each.y);
      ink.fillStyle = each.colour;
      ink.fillText(each.text, each.x, each.y);
    });
  }

  function place(ink, camera, label) {
    const [X, Y] = label.points.at(-1), room = ink.measureText(label.text).width + 8;
    label.x = Math.min(camera.width - room, Math.max(8, camera.x(X) + 7));
    label.y = Math.min(camera.height - 26, Math.max(16, camera.y(Y) + 4));
  }

  return { draw, write };
})();
