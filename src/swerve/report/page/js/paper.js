"use strict";
/* On paper: the whole manoeuvre in one picture, two charts abreast. */
class Paper {
  static WIDTH = 680;  // of an A4 page between its margins [px]
  static VIEW = [650, 200];  // [px]

  constructor(view, charts, player) {
    Object.assign(this, { view, charts, player });
    Printing.begin(() => this.lay(), () => this.restore());
  }

  lay() {
    this.charts.fit(holder => holder.id === "band" ? Paper.WIDTH - 30 : Paper.WIDTH / 2 - 34);
    this.view.strobe(...Paper.VIEW);
  }

  restore() {
    this.charts.fit();
    this.player.draw();
  }
}
