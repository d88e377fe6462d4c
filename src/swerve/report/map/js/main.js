"use strict";
/* Reads the document and puts the parts together. One point of all charts is shown at a time; a click holds it. */
const MapPage = (() => {
  const found = JSON.parse(document.getElementById("document").textContent), looks = Looks.of(found.series);
  const place = document.getElementById("boundaries"), card = new Card(found.extent), charts = [];
  const PRINTED = 336, APART = 24;  // width of a chart and what lies between two, abreast on an A4 page [px]
  let held = null;
  Colours.read();

  const seen = {
    isHeld: () => held !== null,
    brief: ({ point, look }) => Words.brief(point, look.name),
    enter: () => card.focus(),
    show(chart, { point, panel, look }, isTold) {
      for (const each of charts) if (each !== chart) each.leave();
      card.show(point, panel, look);
      if (isTold) card.tell(point, panel, look);
    },
    hold(chart) {
      held = chart;
      document.body.classList.toggle("held", chart !== null);
      if (chart) return;
      for (const each of charts) each.leave();
      card.clear();
    },
  };

  const layers = new Layers(looks, () => { for (const chart of charts) chart.renew(); });
  for (const panel of found.panels) charts.push(new PointChart(place, Panels.boundaries(found, panel, looks, layers), layers, seen));
  if (found.bought.length) {
    const what = Panels.bought(found), chart = new PointChart(place, what, layers, seen);
    const legend = element("p", "", "legend");
    legend.append(...what.looks.map(look => { const entry = element("span"); entry.append(Looks.sample(look), look.name); return entry; }));
    chart.holder.before(legend);
    chart.figure.classList.add("whole");
    charts.push(chart);
  }

  document.getElementById("shaded").hidden = !looks.some(look => look.name === Panels.ALLOWED);
  document.getElementById("card").addEventListener("keydown", event => {
    if (event.key !== "Escape" || !held) return;
    held.holder.focus();
    event.stopPropagation();
  });

  const redraw = () => { for (const { chart } of charts) chart.redraw(); };
  Theme.begin(() => { Colours.read(); redraw(); });
  const printed = ({ figure }) => figure.classList.contains("whole") ? 2 * PRINTED + APART : PRINTED;
  Printing.begin(() => { for (const chart of charts) chart.fit(printed(chart)); }, () => { for (const chart of charts) chart.fit(); });
  return { found, layers, charts, card };
})();
