"use strict";
/* From the world [m], Y to the left of X, to a canvas [px], y downwards. */
class Camera {
  static VISIBLE = 55;  // along X when it follows a car [m]
  static LEAST_SCALE = 9;  // then [px/m]
  static AHEAD = 0.2;  // share of the width by which the middle is ahead of the car it follows
  static MARGIN = 4;  // round what is shown as a whole [m]

  constructor(width, height) { Object.assign(this, { width, height, scale: 1, X: 0, Y: 0 }); }

  x(X) { return this.width / 2 + this.scale * (X - this.X); }
  y(Y) { return this.height / 2 - this.scale * (Y - this.Y); }
  X_at(x) { return this.X + (x - this.width / 2) / this.scale; }

  /* Show all of bounds {X: [low, high], Y: [low, high]}. */
  whole(bounds) {
    const span = name => bounds[name][1] - bounds[name][0] + Camera.MARGIN;
    this.scale = Math.min(this.width / span("X"), this.height / span("Y"), 24);
    this.X = (bounds.X[0] + bounds.X[1]) / 2;
    this.Y = (bounds.Y[0] + bounds.Y[1]) / 2;
    return this;
  }

  /* Keep a pose in view, and still along an axis along which all of the bounds fit. */
  follow(pose, bounds) {
    this.scale = Math.max(Camera.LEAST_SCALE, this.width / Camera.VISIBLE);
    const ahead = Camera.AHEAD * this.width / this.scale;
    const centre = (name, size, lead) => {
      const [low, high] = bounds[name];
      return high - low + Camera.MARGIN < size / this.scale ? (low + high) / 2 : pose[name] + lead;
    };
    this.X = centre("X", this.width, ahead * Math.cos(pose.psi));
    this.Y = centre("Y", this.height, Math.min(ahead, 0.2 * this.height / this.scale) * Math.sin(pose.psi));
    return this;
  }

  /* Draw in the frame of a pose, in metres, y to the left; `draw` gets the width of a pixel [m]. */
  inside(ink, { X, Y, psi }, draw) {
    ink.save();
    ink.translate(this.x(X), this.y(Y));
    ink.rotate(-psi);
    ink.scale(this.scale, -this.scale);
    draw(1 / this.scale);
    ink.restore();
  }

  /* A path of points [[X, Y], ...] as the canvas' current path. */
  trace(ink, points, close = false) {
    ink.beginPath();
    for (const [X, Y] of points) ink.lineTo(this.x(X), this.y(Y));
    if (close) ink.closePath();
  }
}
