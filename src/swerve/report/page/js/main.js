"use strict";
/* Reads the document, puts the parts together, and shows the instant after "#t=" in the address, or the start; with
   "play" in it, plays from there. */
const Report = (() => {
  const report = JSON.parse(document.getElementById("document").textContent);
  const player = new Player(report.scene.end, report.scene.sample_time), wanted = new URLSearchParams(location.hash.slice(1));
  Colours.read();
  const view = new TopView(document.getElementById("view"), report);
  const wheels = document.getElementById("wheels");
  const decision = new Decision(document.getElementById("decision"), report.cars);
  const charts = new Charts(document.getElementById("charts"), document.getElementById("band"), report, player);
  const controls = new Controls(report, player, view);
  const paper = new Paper(view, charts, player);
  for (const part of [view, decision, charts, controls]) player.listen(time => part.draw(time));
  player.listen(time => Wheels.draw(wheels, report.cars, time));

  function recolour() {
    Colours.read();
    charts.renew();
    player.changed();
  }

  Theme.begin(recolour);
  document.querySelector(".ramp i").style.background = Colours.ramp();
  for (const key of document.querySelectorAll(".key[data-car]")) key.style.borderTopColor = `var(--line-${key.dataset.car % 4 + 1})`;
  new ResizeObserver(() => player.changed()).observe(view.canvas);
  player.seek(Number(wanted.get("t")) || 0);
  if (wanted.has("play") && !matchMedia("(prefers-reduced-motion: reduce)").matches) player.toggle();
  return { report, player, view, charts, controls, paper };
})();
