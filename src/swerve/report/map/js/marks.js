"use strict";
/* The marks of a chart that can be pointed at: where they are, which is the nearest, and which is next to it. */
class Marks {
  static REACH = 28;  // of the pointer [px]

  static draw(chart, shown, ratio) {
    const { ctx, bbox } = chart;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left - 6 * ratio, bbox.top - 6 * ratio, bbox.width + 12 * ratio, bbox.height + 12 * ratio);
    ctx.clip();
    for (const mark of shown) Marks.put(ctx, mark, chart.valToPos(mark.x, "x", true) + mark.aside * ratio, chart.valToPos(mark.y, "y", true), ratio);
    ctx.restore();
  }

  static put(ctx, { shape, colour, isOpen }, x, y, ratio) {
    ctx.save();
    ctx.translate(x, y);
    ctx.scale(ratio, ratio);
    ctx.lineWidth = 1.6;
    ctx.setLineDash([]);
    ctx.strokeStyle = Colours.get(colour);
    ctx.fillStyle = isOpen ? Colours.get("card") : Colours.get(colour);
    if (shape !== "cross") ctx.fill(Looks.paths[shape]);
    ctx.stroke(Looks.paths[shape]);
    ctx.restore();
  }

  /* On the screen, from the plot's corner [px]. */
  static place(chart, mark) { return [chart.valToPos(mark.x, "x") + mark.aside, chart.valToPos(mark.y, "y")]; }

  /* Nearest to a place [px], or null where none is in reach. */
  static nearest(chart, shown, left, top) {
    const far = shown.map(mark => { const [x, y] = Marks.place(chart, mark); return Math.hypot(x - left, y - top); });
    const least = Math.min(...far);
    return least <= Marks.REACH ? shown[far.indexOf(least)] : null;
  }

  /* Where an arrow leads: up and down at the same speed, left and right to the nearest of the same series. */
  static next(shown, mark, key) {
    if (key === "ArrowUp" || key === "ArrowDown") {
      const column = shown.filter(each => each.x === mark.x).sort((a, b) => a.y - b.y), step = key === "ArrowUp" ? 1 : -1;
      return column[column.indexOf(mark) + step] ?? mark;
    }
    const side = { ArrowLeft: each => each.x < mark.x, ArrowRight: each => each.x > mark.x, Home: () => true, End: () => true }[key];
    const others = shown.filter(each => side(each) && each.group === mark.group);
    const toLeft = key === "ArrowLeft" || key === "End";  // the largest of those on the left, or of all
    const x = others.reduce((best, each) => toLeft ? Math.max(best, each.x) : Math.min(best, each.x), toLeft ? -Infinity : Infinity);
    const there = others.filter(each => each.x === x).sort((a, b) => Math.abs(a.y - mark.y) - Math.abs(b.y - mark.y));
    return there[0] ?? mark;
  }
}
