"use strict";
/* A chart over speed whose marks can be pointed at, and gone through with the arrow keys. The chart is uPlot's. */
class PointChart {
  static HEIGHT = 300;

  /* lines: {xs, ys [m], look, names, fill}; marks: {x, distance [m], shape, colour, isOpen, aside, group, names, point};
     ends: of the speeds [m/s]. `seen` is told of the mark that is shown. */
  constructor(place, { title, note, label, lines, marks, ends, height }, layers, seen) {
    Object.assign(this, { lines, marks, ends, layers, seen, note, height, current: null });
    this.figure = place.appendChild(element("figure", "", "chart"));
    this.caption = this.figure.appendChild(element("figcaption"));
    this.caption.append(element("b", title), element("span", "", "note"));
    this.holder = this.figure.appendChild(element("div", "", "plot"));
    Object.assign(this.holder, { tabIndex: 0, role: "application", ariaLabel: label });
    this.chart = new uPlot(this.options(), this.data(), this.holder);
    this.ring = this.chart.over.appendChild(element("div", "", "ring"));
    this.tip = this.chart.over.appendChild(element("div", "", "tip"));
    this.leave();
    this.listen();
    this.renew();
  }

  /* The marks that nothing hides, and of these the ones that are inside of the axes. */
  get open() { return this.marks.filter(each => this.layers.shows(each.names)); }

  get shown() {
    const { x, y } = this.chart.scales;
    return this.open.filter(each => each.x >= x.min && each.x <= x.max && each.y >= y.min && each.y <= y.max);
  }

  renew() {
    for (const mark of this.marks) mark.y = this.height(mark.distance, mark.x);
    this.caption.lastChild.textContent = this.note();
    this.lines.forEach((line, i) => { this.chart.series[i + 2].show = this.layers.shows(line.names); });
    this.chart.setData(this.data());
    if (this.current && !this.layers.shows(this.current.names)) this.leave();
    else if (this.current) this.go(this.current);
  }

  fit(width = inner(this.figure)) {
    this.chart.setSize({ width, height: PointChart.HEIGHT });
    if (this.current) this.go(this.current);
  }

  data() {
    return uPlot.join([[this.ends, [null, null]], ...this.lines.map(({ xs, ys }) => [xs, ys.map((y, i) => y === null ? null : this.height(y, xs[i]))])]);
  }

  options() {
    const axis = { stroke: () => Colours.get("muted"), grid: { stroke: () => Colours.get("grid"), width: 1 },
      ticks: { show: false }, font: "12px system-ui, sans-serif" };
    return {
      width: inner(this.figure), height: PointChart.HEIGHT, padding: [10, 10, 0, 0], legend: { show: false },
      series: [{}, { show: false }, ...this.lines.map(line => this.series(line))],
      scales: { x: { time: false }, y: { range: () => this.range() } },
      axes: [{ ...axis, size: 30, gap: 7 }, { ...axis, size: 44, gap: 4 }],
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: true, dist: 8 } },
      hooks: { draw: [chart => Marks.draw(chart, this.shown, uPlot.pxRatio)], setCursor: [chart => this.point(chart)],
        setScale: [() => this.current && this.ring && this.go(this.current)] },
    };
  }

  series({ look, fill }) {
    return { stroke: () => Colours.get(look.colour), dash: look.dash, width: look.width, points: { show: false },
      fill: fill ? () => Colours.pale(fill, 0.1) : undefined };
  }

  /* Round the marks that the chart is about, if there are any and not all is to be seen; otherwise from zero to above all. */
  range() {
    const heights = marks => marks.map(each => each.y), all = heights(this.open);
    const core = this.layers.shows([Layers.FAR]) ? [] : heights(this.marks.filter(each => each.isCore));
    if (core.length) return [0.75 * Math.min(...core), 1.35 * Math.max(...core)];
    return [1.1 * Math.min(0, ...all), 1.1 * Math.max(0, ...all) || 1];
  }

  listen() {
    const { over } = this.chart;
    over.addEventListener("click", () => this.click());
    this.holder.addEventListener("keydown", event => this.key(event));
    this.holder.addEventListener("focus", () => {
      if (!this.current && this.holder.matches(":focus-visible") && this.shown.length) this.go(this.shown[0], true);
    });
    new ResizeObserver(() => this.fit()).observe(this.figure);
  }

  point({ cursor }) {
    if (!cursor.event || cursor.left < 0 || this.seen.isHeld()) return;
    const mark = Marks.nearest(this.chart, this.shown, cursor.left, cursor.top);
    if (mark) this.go(mark);
  }

  click() {
    const { left, top } = this.chart.cursor, mark = Marks.nearest(this.chart, this.shown, left, top);
    this.seen.hold(mark ? this : null);
    if (mark) this.go(mark);
  }

  key(event) {
    const keys = ["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "Home", "End"];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (keys.includes(event.key) && this.shown.length) {
      this.go(this.current ? Marks.next(this.shown, this.current, event.key) : this.shown[0], true);
      event.preventDefault();
    } else if (event.key === "Enter" && this.current) {
      this.seen.hold(this);
      this.seen.enter();
      event.preventDefault();  // or the button that has the focus now is pressed
    } else if (event.key === "Escape") this.seen.hold(null);
  }

  /* Show a mark; aloud where it was come to without seeing. */
  go(mark, isTold = false) {
    this.current = mark;
    const [left, top] = Marks.place(this.chart, mark), { clientWidth, clientHeight } = this.chart.over;
    const isInside = left >= -8 && left <= clientWidth + 8 && top >= -8 && top <= clientHeight + 8;
    this.ring.hidden = this.tip.hidden = !isInside;
    this.ring.style.translate = `${left}px ${top}px`;
    this.tip.textContent = this.seen.brief(mark);
    const { offsetWidth, offsetHeight } = this.tip, gap = 12;
    const x = left > clientWidth / 2 ? left - offsetWidth - gap : left + gap, y = top < offsetHeight + gap ? top + gap : top - offsetHeight - gap;
    this.tip.style.translate = `${x}px ${y}px`;
    this.seen.show(this, mark, isTold);
  }

  leave() {
    this.current = null;
    this.ring.hidden = this.tip.hidden = true;
  }
}
