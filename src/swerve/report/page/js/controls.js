"use strict";
/* Buttons, the scrubber, layers, moments and keys: all that sets the player. */
class Controls {
  constructor(report, player, view) {
    const ids = ["play", "scrub", "time", "speed", "now", "reason"];
    Object.assign(this, { report, player, view }, Object.fromEntries(ids.map(id => [id, document.getElementById(id)])));
    const { play, scrub, speed } = this;
    scrub.max = player.end;
    for (const each of Player.SPEEDS) speed.append(new Option(`${each} ×`, each, each === 1, each === 1));
    play.addEventListener("click", () => player.toggle());
    scrub.addEventListener("input", () => player.seek(Number(scrub.value)));
    speed.addEventListener("change", () => { player.speed = Number(speed.value); });
    this.layers(document.getElementById("layers"));
    this.moments(document.getElementById("moments"));
    document.addEventListener("keydown", event => this.key(event));
  }

  draw(time) {
    const { play, scrub, speed, player } = this;
    play.textContent = player.playing ? "Pause" : "Play";
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", `${time.toFixed(2)} s`);
    speed.value = player.speed;
    this.time.textContent = `${time.toFixed(2)} / ${player.end.toFixed(1)} s`;
    this.reason.replaceChildren(...this.report.cars.map(car => this.why(car, time)));
    this.now.replaceChildren(...this.report.cars.slice(0, 1).flatMap(car => this.words(car, time)));
  }

  words(car, time) {
    const { speed, delta, X, Y } = Track.car(car, time);
    const values = [[(3.6 * speed).toFixed(1), "km/h"], [`X ${X.toFixed(1)}, Y ${Y.toFixed(2)}`, "m"],
      [(delta * 180 / Math.PI).toFixed(1), "° steering"]];
    return [...values.flatMap(([value, unit]) => [element("b", value), ` ${unit}  ·  `]), "plan ",
      element("b", car.steps.name[Track.step(car, time)])];
  }

  why(car, time) {
    const line = element("span", this.report.cars.length > 1 ? `${car.name}, ` : "");
    line.append(`${time.toFixed(2)} s  ·  ${Band.words(car, time)}`);
    return line;
  }

  layers(place) {
    for (const [key, words] of TopView.LAYERS) {
      const label = place.appendChild(element("label")), box = element("input");
      Object.assign(box, { type: "checkbox", checked: true, id: `layer-${key}` });
      box.addEventListener("change", () => { this.view.layers[key] = box.checked; this.player.changed(); });
      label.append(box, words);
    }
  }

  moments(place) {
    const { cars } = this.report;
    const all = cars.flatMap(car => car.moments.map(each => ({ ...each, who: cars.length > 1 ? `${car.name}: ` : "" })));
    for (const { time, words, who } of all.sort((a, b) => a.time - b.time)) {
      const button = place.appendChild(element("button"));
      button.type = "button";
      button.append(element("b", `${time.toFixed(2)} s`), ` ${who}${words}`);
      button.addEventListener("click", () => { this.player.playing = false; this.player.seek(time); });
    }
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { player } = this, on = event.target, far = event.shiftKey ? 10 : 1;
    const takesSpace = on.closest?.("button, summary, select, input[type=checkbox], a"), takesArrows = on.closest?.("select, .wide, pre");
    const actions = {
      " ": () => takesSpace || player.toggle(),
      ArrowLeft: () => takesArrows || player.move(-far),
      ArrowRight: () => takesArrows || player.move(far),
      Home: () => takesArrows || player.seek(0),
      End: () => takesArrows || player.seek(player.end),
      "+": () => player.faster(1), "=": () => player.faster(1), "-": () => player.faster(-1),
      f: () => document.getElementById("layer-follow").click(),
    };
    const act = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (act && !act()) event.preventDefault();  // an element that takes the key itself is left to it
  }
}
