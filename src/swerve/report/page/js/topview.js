"use strict";
/* The manoeuvre from above, at the time that is shown. */
class TopView {
  static LAYERS = [["follow", "Follow"], ["forces", "Forces"], ["plan", "Plan"], ["branches", "Ways not taken"],
    ["path", "Path"]];
  static STROBE = 0.5;  // between two bodies on paper [s]
  static FADED = 0.35;  // share of its ink that an obstacle has at later instants [1]
  static GHOST = 0.6;  // likewise of a car that is compared

  constructor(canvas, report) {
    Object.assign(this, { canvas, report, layers: Object.fromEntries(TopView.LAYERS.map(([key]) => [key, true])) });
    this.bounds = bounds(report);
  }

  colour(i) { return Colours.ofLine(i); }

  /* The first car in full, further ones as ghosts beneath it, without the ways not taken. */
  car(ink, camera, i, state, time) {
    const { cars } = this.report, several = cars.length > 1;
    const look = i ? { ...this.layers, branches: false, share: TopView.GHOST } : this.layers;
    Car.draw(ink, camera, cars[i], state, this.colour(i), look);
    Plans.draw(ink, camera, cars[i], time, several ? this.colour(i) : Colours.get("ink"), look);
  }

  draw(time) {
    const { ink, width, height } = sheet(this.canvas), { scene, cars } = this.report;
    const states = cars.map(car => Track.car(car, time)), camera = new Camera(width, height);
    if (this.layers.follow) camera.follow(states[0], this.bounds); else camera.whole(this.bounds);
    Surroundings.ground(ink, camera, scene);
    Surroundings.obstacles(ink, camera, scene, time);
    if (this.layers.path) cars.forEach((car, i) => Car.path(ink, camera, car, time, this.colour(i)));
    for (let i = cars.length - 1; i >= 0; i--) this.car(ink, camera, i, states[i], time);
    if (cars.length > 1) Plans.write(ink, cars.map((car, i) => Car.label(ink, camera, car, states[i], this.colour(i))));
    Surroundings.ruler(ink, camera);
  }

  /* The whole manoeuvre in one picture, for paper. */
  strobe(width, height) {
    const { ink } = sheet(this.canvas, width, height), { scene, cars } = this.report;
    const camera = new Camera(width, height).whole(this.bounds);
    Surroundings.ground(ink, camera, scene);
    for (let time = 0; time <= scene.end; time += TopView.STROBE) {
      const moving = scene.obstacles.filter(each => each.time.length > 1 || time === 0);
      Surroundings.obstacles(ink, camera, { obstacles: moving }, time, time === 0 ? 1 : TopView.FADED);
    }
    cars.forEach((car, i) => Car.path(ink, camera, car, scene.end, this.colour(i)));
    for (let time = 0; time <= scene.end; time += TopView.STROBE) {
      cars.forEach((car, i) => Car.draw(ink, camera, car, Track.car(car, time), this.colour(i), { forces: false }));
    }
    Surroundings.ruler(ink, camera);
  }
}

/* What the cars cover, and the obstacles near them: {X: [low, high], Y: [low, high]} [m]. */
function bounds({ scene, cars }) {
  const range = values => values.reduce(([low, high], each) => [Math.min(low, each), Math.max(high, each)], [Infinity, -Infinity]);
  const own = name => range(cars.flatMap(car => car.motion[name]));
  const X = own("X"), Y = own("Y");
  for (const { outline, X: along, Y: across } of scene.obstacles) {
    const reach = Math.max(...outline.map(each => Math.hypot(...each)));
    const near = along.map((each, i) => [each, across[i]]).filter(([x]) => x > X[0] - 30 && x < X[1] + 30);
    for (const [x, y] of near) {
      X.push(x - reach, x + reach);
      Y.push(y - reach, y + reach);
    }
  }
  const body = Math.max(...cars.map(car => car.body.front));
  return { X: [Math.min(...X) - body, Math.max(...X) + body], Y: range([...Y.map(y => y - 1), ...Y.map(y => y + 1), ...scene.road.edges]) };
}

/* A canvas made as sharp as the screen, and cleared: its context in CSS pixels, and its size in them. */
function sheet(canvas, width = canvas.clientWidth, height = canvas.clientHeight) {
  const ratio = Math.max(window.devicePixelRatio || 1, 1), ink = canvas.getContext("2d");
  const size = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
  ink.setTransform(ratio, 0, 0, ratio, 0, 0);
  ink.clearRect(0, 0, width, height);
  return { ink, width, height };
}
