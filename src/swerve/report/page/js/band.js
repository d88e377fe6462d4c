"use strict";
/* Which plan was taken in each step, as a band along time: a colour, a hatching and a name for each. */
const Band = (() => {
  const ROW = 30;  // height of a car's row [px]
  const COLOURS = { keep: "muted", brake: "line-2", left: "line-1", right: "line-3" };

  /* Consecutive steps of one name and kind: {from, to, name, isFallback} [s]. */
  function segments({ steps, motion }) {
    const found = [];
    steps.time.forEach((from, k) => {
      const isFallback = Boolean(steps.fallback[k]), last = found.at(-1), to = steps.time[k + 1] ?? motion.time.at(-1);
      if (last && last.name === steps.name[k] && last.isFallback === isFallback) last.to = to;
      else found.push({ from, to, name: steps.name[k], isFallback });
    });
    return found;
  }

  const height = cars => cars.length * ROW + 34;

  /* Draw in a chart's own canvas, whose pixels are `ratio` to a CSS pixel. */
  function draw(chart, bands, ratio) {
    const { ctx: ink, bbox } = chart;
    ink.save();
    ink.beginPath();
    ink.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ink.clip();
    bands.forEach((band, i) => band.forEach(each => {
      const left = chart.valToPos(each.from, "x", true), right = chart.valToPos(each.to, "x", true);
      const room = bbox.height / bands.length;
      segment(ink, each, left, bbox.top + i * room + 2 * ratio, right - left, room - 4 * ratio, ratio);
    }));
    ink.restore();
  }

  function segment(ink, { name, isFallback }, x, y, width, height, ratio) {
    const colour = isFallback ? "bad" : COLOURS[name.split(",")[0]] ?? "line-4";
    ink.save();
    ink.beginPath();
    ink.rect(x, y, Math.max(1, width - ratio), height);
    ink.clip();
    ink.fillStyle = Colours.pale(colour, 0.2);
    ink.fill();
    if (isFallback || name.includes(",")) hatch(ink, x, y, width, height, Colours.pale(colour, 0.45), ratio);
    ink.fillStyle = Colours.get(colour);
    ink.fillRect(x, y, width, 4 * ratio);
    ink.font = `${12 * ratio}px system-ui, sans-serif`;
    ink.textAlign = "left";
    ink.textBaseline = "middle";
    const words = isFallback ? "fallback" : name;
    ink.fillStyle = Colours.get("ink");
    if (ink.measureText(words).width + 10 * ratio < width) ink.fillText(words, x + 5 * ratio, y + height / 2 + 2 * ratio);
    ink.restore();
  }

  function hatch(ink, x, y, width, height, colour, ratio) {
    ink.strokeStyle = colour;
    ink.lineWidth = 1.5 * ratio;
    ink.beginPath();
    for (let at = x - height; at < x + width; at += 7 * ratio) {
      ink.moveTo(at, y + height);
      ink.lineTo(at + height, y);
    }
    ink.stroke();
  }

  /* The decision at a time in a line: which way, why, and what holds it. */
  function words(car, time) {
    const k = Track.step(car, time), { reason, active } = car.plans[k], fallback = car.steps.fallback[k];
    const why = fallback ? `fallback, ${fallback}` : reason;
    return `${car.steps.name[k]}${why && `: ${why}`}${active && `; held by ${active}`}`;
  }

  return { segments, height, draw, words };
})();
