"use strict";
/* On paper: light, all details open, the whole manoeuvre in one picture, two charts abreast. */
class Paper {
  static WIDTH = 680;  // of an A4 page between its margins [px]
  static VIEW = [650, 200];  // [px]

  constructor(view, charts, player) {
    Object.assign(this, { view, charts, player, before: null });
    addEventListener("beforeprint", () => this.lay());
    addEventListener("afterprint", () => this.restore());
  }

  lay() {
    if (this.before) return;
    const root = document.documentElement, details = [...document.querySelectorAll("details")];
    this.before = { theme: root.dataset.theme, details, open: details.map(each => each.open) };
    root.dataset.theme = "light";
    for (const each of details) each.open = true;
    Colours.read();
    this.charts.fit(holder => holder.id === "band" ? Paper.WIDTH - 30 : Paper.WIDTH / 2 - 34);
    this.view.strobe(...Paper.VIEW);
  }

  restore() {
    const { theme, details, open } = this.before, root = document.documentElement;
    if (theme) root.dataset.theme = theme; else delete root.dataset.theme;
    details.forEach((each, i) => { each.open = open[i]; });
    this.before = null;
    Colours.read();
    this.charts.fit();
    this.player.draw();
  }
}
