"use strict";
/* What is round the cars: road, lanes, patches of other friction, obstacles, and a scale along X. */
const Surroundings = (() => {
  const TICKS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];  // [m]
  const FONT = "12px system-ui, sans-serif";

  function ground(ink, camera, scene) {
    const { edges, lines, oncoming } = scene.road;
    ink.fillStyle = edges.length ? Colours.get("grid") : Colours.get("road");
    ink.fillRect(0, 0, camera.width, camera.height);
    if (edges.length) {
      ink.fillStyle = Colours.get("road");
      ink.fillRect(0, camera.y(edges[1]), camera.width, camera.y(edges[0]) - camera.y(edges[1]));
    }
    for (const patch of scene.patches) slippery(ink, camera, patch);
    for (const Y of edges) across(ink, camera, Y, 2.5, []);
    for (const Y of lines) across(ink, camera, Y, 1.5, [3 * camera.scale, 6 * camera.scale]);
    if (oncoming === null) return;
    for (const side of [-2, 2]) across(ink, camera, oncoming, 1.5, [], side);
    against(ink, camera, (oncoming + edges[1]) / 2);
  }

  /* Arrows against X, at places that lie still on the road. */
  function against(ink, camera, Y) {
    ink.fillStyle = Colours.pale("lane", 0.45);
    const every = 25 * camera.scale, y = camera.y(Y), size = 0.5 * camera.scale;
    for (let x = camera.x(0) % every; x < camera.width + every; x += every) {
      ink.beginPath();
      for (const [dx, dy] of [[-2, 0], [0, -1], [0, -0.3], [3, -0.3], [3, 0.3], [0, 0.3], [0, 1]]) ink.lineTo(x + dx * size, y + dy * size);
      ink.fill();
    }
  }

  function across(ink, camera, Y, width, dash, beside = 0) {
    ink.strokeStyle = Colours.get("lane");
    ink.lineWidth = width;
    ink.setLineDash(dash);
    ink.lineDashOffset = -camera.x(0);  // the dashes lie still on the road
    ink.beginPath();
    ink.moveTo(0, camera.y(Y) + beside);
    ink.lineTo(camera.width, camera.y(Y) + beside);
    ink.stroke();
    ink.setLineDash([]);
  }

  function slippery(ink, camera, { x, y, friction }) {
    const left = x[0] === null ? 0 : camera.x(x[0]), right = x[1] === null ? camera.width : camera.x(x[1]);
    const top = y[1] === null ? 0 : camera.y(y[1]), bottom = y[0] === null ? camera.height : camera.y(y[0]);
    ink.fillStyle = Colours.pale("line-1", 0.14);
    ink.fillRect(left, top, right - left, bottom - top);
    ink.fillStyle = Colours.get("muted");
    ink.font = FONT;
    ink.textAlign = "left";
    ink.fillText(`friction ${friction}`, Math.max(left, 0) + 8, Math.max(top, 0) + 18);
  }

  function obstacles(ink, camera, scene, time, share = 1) {
    for (const obstacle of scene.obstacles) {
      camera.inside(ink, Track.obstacle(obstacle, time), pixel => {
        const shape = new Path2D();
        for (const [x, y] of obstacle.outline) shape.lineTo(x, y);
        shape.closePath();
        ink.globalAlpha = share;
        ink.fillStyle = Colours.pale("obstacle", 0.2);
        ink.fill(shape);
        hatch(ink, shape, obstacle.outline, pixel);
        ink.strokeStyle = Colours.get("obstacle");
        ink.lineWidth = 2 * pixel;
        ink.stroke(shape);
        ink.globalAlpha = 1;
      });
    }
  }

  function hatch(ink, shape, outline, pixel) {
    const reach = Math.max(...outline.flat().map(Math.abs));
    ink.save();
    ink.clip(shape);
    ink.beginPath();
    for (let at = -3 * reach; at < reach; at += 9 * pixel) {
      ink.moveTo(at, -reach);
      ink.lineTo(at + 2 * reach, reach);
    }
    ink.strokeStyle = Colours.pale("obstacle", 0.5);
    ink.lineWidth = 1.2 * pixel;
    ink.stroke();
    ink.restore();
  }

  /* Ticks along X at the lower edge, so far apart that their numbers have room. */
  function ruler(ink, camera) {
    const every = TICKS.find(each => each * camera.scale > 70) ?? 1000;
    ink.strokeStyle = ink.fillStyle = Colours.get("muted");
    ink.lineWidth = 1;
    ink.font = FONT;
    ink.textAlign = "center";
    const last = camera.X_at(camera.width);
    for (let X = Math.ceil(camera.X_at(0) / every) * every; X <= last; X += every) {
      const x = camera.x(X);
      ink.beginPath();
      ink.moveTo(x, camera.height);
      ink.lineTo(x, camera.height - 6);
      ink.stroke();
      if (x > 25 && x < camera.width - 25) ink.fillText(`${X} m`, x, camera.height - 10);
    }
  }

  return { ground, obstacles, ruler };
})();
