"use strict";
/* Charts over time that share a cursor, a zoom and the player's instant. The charts are uPlot's. */
class Charts {
  static KEY = "swerve";
  static HEIGHT = 168;

  constructor(place, band, report, player) {
    Object.assign(this, { place, report, player, charts: [] });
    this.bands = report.cars.map(Band.segments);
    this.add(band, this.band());
    for (const each of Quantities.of(report)) this.add(...this.quantity(each));
    this.resizing = new ResizeObserver(() => this.fit());
    for (const { holder } of this.charts) this.resizing.observe(holder);
  }

  draw(time) {
    for (const { chart, playhead, readouts } of this.charts) {
      const x = chart.valToPos(time, "x");
      playhead.style.transform = `translateX(${x}px)`;
      playhead.hidden = x < 0 || x > chart.over.clientWidth;
      for (const readout of readouts) readout(time);
    }
  }

  /* As wide as their places, or as is said [px]. */
  fit(width = null) {
    for (const { chart, holder } of this.charts) chart.setSize({ width: width?.(holder) ?? inner(holder), height: chart.height });
    this.draw(this.player.shown);
  }

  renew() { for (const { chart } of this.charts) chart.redraw(); }

  add(holder, [options, data, readouts = []]) {
    const chart = new uPlot({ ...options, width: inner(holder) }, data, holder);
    const playhead = chart.over.appendChild(element("div", "", "playhead"));
    chart.over.addEventListener("click", () => this.player.seek(chart.posToVal(chart.cursor.left, "x")));
    chart.over.addEventListener("mouseleave", () => this.player.point(null));
    this.charts.push({ chart, holder, playhead, readouts });
  }

  quantity(what) {
    const figure = this.place.appendChild(element("figure", "", "chart"));
    const { caption, readouts } = legend(what);
    figure.append(caption);
    const shown = what.lines.map(({ times, values }) => [times, values.map(value => value === null ? null : value * what.factor)]);
    const data = uPlot.join([[[0, this.report.scene.end], [null, null]], ...shown]);  // the first makes all as long
    const series = [{}, { show: false }, ...what.lines.map(line => ({
      stroke: () => line.isLevel ? Colours.get("muted") : Colours.ofLine(line.index),
      dash: line.isLevel ? [3, 4] : line.dash ?? Colours.dash(line.index),
      width: line.width ?? (line.isLevel ? 1.5 : 2),
      paths: line.stepped ? uPlot.paths.stepped({ align: 1 }) : undefined,
      points: { show: false },
    }))];
    const range = (chart, low, high) => extent(what, low, high);
    return [figure, [this.options(Charts.HEIGHT, series, range), data, readouts]];
  }

  band() {
    const ends = [0, this.report.scene.end];
    const options = this.options(Band.height(this.bands), [{}, { show: false }], () => [0, 1]);
    options.axes[1] = { show: false };
    options.padding = [8, 16, 0, 16];
    options.hooks.draw = [chart => Band.draw(chart, this.bands, uPlot.pxRatio)];
    return [options, [ends, [0, 0]]];
  }

  options(height, series, range) {
    const axis = { stroke: () => Colours.get("muted"), grid: { stroke: () => Colours.get("grid"), width: 1 },
      ticks: { show: false }, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" };
    return {
      height, series, legend: { show: false }, padding: [8, 8, 0, 0],
      scales: { x: { time: false }, y: { range } },
      axes: [{ ...axis, size: 30, gap: 7, values: (chart, ticks) => ticks.map(each => `${each} s`) }, { ...axis, size: 48, gap: 4 }],
      cursor: { y: false, points: { show: false }, drag: { x: true, y: false, setScale: true }, sync: { key: Charts.KEY, scales: ["x", null] } },
      hooks: { setCursor: [chart => this.point(chart)] },
    };
  }

  /* Only the chart under the pointer tells; the others follow it. */
  point(chart) {
    if (chart.cursor.event && chart.cursor.left >= 0) this.player.point(chart.posToVal(chart.cursor.left, "x"));
  }
}

/* From the values' range to the axis': `from` a fixed end, `upTo` the largest end, at least `least` high. */
function extent({ from, upTo = Infinity, least = 0 }, low, high) {
  const start = from ?? low ?? 0, end = Math.max(start + 1e-6, high ?? 1), missing = Math.max(0, least - (end - start)) / 2;
  const margin = 0.08 * (end - start);
  return [from ?? start - missing - margin, Math.min(upTo, end + missing + margin)];
}

/* Title, unit, and of each line a sample, its name and its value at the time that is shown. */
function legend({ title, unit, factor, digits, lines }) {
  const caption = element("figcaption"), names = element("span", "", "legend"), readouts = [];
  const name = element("b", title);
  name.append(" ", element("small", unit));
  for (const line of lines) {
    const entry = names.appendChild(element("span")), sample = entry.appendChild(element("i", "", "key"));
    sample.style.borderTopColor = line.isLevel ? "var(--muted)" : `var(--line-${line.index % 4 + 1})`;
    sample.style.borderTopStyle = line.isLevel ? "dotted" : (line.dash ?? Colours.dash(line.index)).length ? "dashed" : "solid";
    if (line.label) entry.append(line.label);
    const value = entry.appendChild(element("output"));
    if (line.isLevel) value.textContent = (line.values[0] * factor).toFixed(digits);
    else readouts.push(time => {
      const now = line.values[Track.row(line.times, time)];
      value.textContent = now === null ? "–" : (now * factor).toFixed(digits);
    });
  }
  caption.append(name, names);
  return { caption, readouts };
}
