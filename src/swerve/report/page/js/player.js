"use strict";
/* The one clock of the page: what is shown everywhere is `shown`, the played time, or the instant that is pointed at
   while it does not play [s]. Who draws listens. */
class Player {
  static SPEEDS = [0.1, 0.25, 0.5, 1, 2];

  constructor(end, step) {
    Object.assign(this, { end, step, time: 0, pointed: null, speed: 1, playing: false });
    this.listeners = [];
    this.requested = 0;
  }

  get shown() { return this.playing ? this.time : this.pointed ?? this.time; }

  listen(listener) { this.listeners.push(listener); }

  /* Draw with the next frame: however many changes there were, once. */
  changed() { this.requested ||= requestAnimationFrame(now => this.frame(now)); }

  draw() { for (const listener of this.listeners) listener(this.shown); }

  frame(now) {
    this.requested = 0;
    if (this.playing) {
      this.time = Math.min(this.end, this.time + this.speed * (now - (this.last ?? now)) / 1000);
      this.last = now;
      if (this.time >= this.end) this.playing = false;
    }
    this.draw();
    if (this.playing) this.changed();
  }

  toggle() {
    if (!this.playing && this.time >= this.end) this.time = 0;
    this.playing = !this.playing;
    this.last = null;
    this.changed();
  }

  seek(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.pointed = null;
    this.changed();
  }

  /* By whole steps of the controller, from the step that is shown; pauses. */
  move(steps) {
    this.playing = false;
    this.seek((Math.round(this.time / this.step) + steps) * this.step);
  }

  point(time) {
    this.pointed = time;
    if (!this.playing) this.changed();
  }

  faster(by) {
    const next = Player.SPEEDS.indexOf(this.speed) + by;
    this.speed = Player.SPEEDS[Math.min(Player.SPEEDS.length - 1, Math.max(0, next))];
    this.changed();
  }
}
