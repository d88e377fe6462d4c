"use strict";
/* The charts of a map: boundaries for each friction and offset, and what the four wheel torques buy. */
const Panels = (() => {
  const APART = 5;  // between the runs of two controllers at one speed [px]
  const ALLOWED = "limit: individual", CORE = [ALLOWED, "limit: both"];

  /* The boundaries of one panel. */
  function boundaries({ series, extent }, panel, looks, layers) {
    const lines = panel.lines.map((ys, i) => ({ xs: panel.speeds, ys, look: looks[i], names: [looks[i].name], fill: looks[i].name === ALLOWED ? "bad" : null }));
    const turns = panel.turns.map((ys, i) => ({ xs: panel.speeds, ys, look: { ...looks[i], dash: [1, 4], width: 1.2 }, names: [looks[i].name, Layers.TURNS] }));
    const { speeds, braking, swerving } = panel.closed;
    const closed = [[braking, Looks.BRAKING], [swerving, Looks.SWERVING]].map(([ys, look]) => ({ xs: speeds, ys, look, names: [Layers.CLOSED] }));
    return {
      title: panel.name, label: `Boundaries at ${panel.name}; the arrow keys go from point to point`,
      note: () => layers.isTime ? "time to collision [s] over speed [m/s]" : "distance [m] over speed [m/s]",
      height: (distance, speed) => layers.height(distance, speed, extent),
      lines: [...closed, ...turns, ...lines], ends: [speeds[0], speeds.at(-1)],
      marks: panel.points.map(point => mark(point, panel, looks[point.series], layersOf(point), series)),
    };
  }

  function mark(point, panel, look, names, series) {
    const n = series.filter(each => !each.is_limit).length, isSmall = point.kind === "run" && !point.is_last;
    const shape = point.kind === "turn" ? "turn" : !isSmall ? look.shape : point.outcome === "avoided" ? "dot" : "cross";
    return { x: point.speed, distance: point.distance, shape, colour: look.colour, isOpen: point.kind === "turn", isCore: CORE.includes(look.name),
      point, panel, look,
      aside: isSmall ? APART * (point.series - (n - 1) / 2) : 0, group: `${look.name} ${point.kind}`, names: [look.name, ...names] };
  }

  function layersOf({ kind, is_last }) {
    if (kind === "turn") return [Layers.TURNS];
    return kind === "run" && !is_last ? [Layers.RUNS] : [];
  }

  /* What the torques buy: a line for each panel. */
  function bought(found) {
    const looks = Looks.of(found.bought.map(({ name }) => ({ name, is_limit: false })));
    const all = found.bought.map(({ speeds, distances }, i) => ({ xs: speeds, ys: distances, look: looks[i], names: [] }));
    return {
      title: "What the four wheel torques buy", label: "Metres that the four wheel torques buy; the arrow keys go from point to point",
      note: () => "limit: both less limit: individual [m] over speed [m/s]", height: distance => distance,
      lines: all, looks, ends: found.ends,
      marks: found.bought.flatMap((each, i) => each.points.map(point => ({ x: point.speed, distance: point.distance, shape: looks[i].shape,
        colour: looks[i].colour, isOpen: false, aside: 0, group: each.name, names: [], point: { ...point, name: each.name },
        panel: found.panels[i], look: looks[i] }))),
    };
  }

  return { boundaries, bought, ALLOWED };
})();
