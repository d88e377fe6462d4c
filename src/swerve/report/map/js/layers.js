"use strict";
/* What is drawn, and what is upwards: boxes and buttons, which are the charts' legend as well. */
class Layers {
  static TURNS = "turns";
  static CLOSED = "closed";
  static RUNS = "runs";
  static FAR = "far";

  constructor(looks, changed) {
    Object.assign(this, { changed, hidden: new Set([Layers.RUNS, Layers.FAR]), isTime: false });
    const series = document.getElementById("series"), layers = document.getElementById("extras"), axis = document.getElementById("axis");
    const sample = look => Looks.sample({ colour: "muted", ...look });
    series.append(...looks.map(look => this.box(look.name, [Looks.sample(look), look.name])));
    layers.append(
      this.box(Layers.TURNS, [sample({ shape: "turn", isOpen: true }), "braking turns to steering"]),
      this.box(Layers.CLOSED, ["closed forms", sample(Looks.BRAKING), "v²/(2µg)", sample(Looks.SWERVING), "v√(2w/(µg))"]),
      this.box(Layers.RUNS, ["every run", sample({ shape: "dot" }), "avoided", sample({ shape: "cross" }), "not avoided"]),
      this.box(Layers.FAR, ["all distances, not only those near the limit"]));
    axis.append(this.radio("distance", "Distance", false), this.radio("time", "Time to collision", true));
  }

  /* Whether nothing that a thing belongs to is hidden. */
  shows(names) { return names.every(name => !this.hidden.has(name)); }

  /* A distance [m] as it is drawn at a speed [m/s]: itself, or the time until contact without action [s]. */
  height(distance, speed, extent) { return this.isTime ? (distance - extent) / speed : distance; }

  box(key, parts) {
    const label = element("label"), box = element("input");
    Object.assign(box, { type: "checkbox", checked: !this.hidden.has(key), id: `shows-${key.replaceAll(/[^\w-]+/g, "-")}` });
    box.addEventListener("change", () => {
      if (box.checked) this.hidden.delete(key); else this.hidden.add(key);
      this.changed();
    });
    label.append(box, ...parts);
    return label;
  }

  radio(id, words, isTime) {
    const label = element("label"), button = element("input");
    Object.assign(button, { type: "radio", name: "axis", id: `axis-${id}`, checked: isTime === this.isTime });
    button.addEventListener("change", () => { this.isTime = isTime; this.changed(); });
    label.append(button, words);
    return label;
  }
}
