"use strict";
/* How a series looks: controllers differ by colour and by the shape of their marks, limits, in ink, by their dashes. The
   shapes are paths round (0, 0), for canvas and SVG alike [px]. */
const Looks = (() => {
  const SHAPES = {
    circle: "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z",
    square: "M-3.6,-3.6h7.2v7.2h-7.2z",
    triangle: "M0,-4.8L4.6,3.6H-4.6z",
    diamond: "M0,-5.2L5.2,0L0,5.2L-5.2,0z",
    dot: "M-2.4,0a2.4,2.4 0 1,0 4.8,0a2.4,2.4 0 1,0 -4.8,0z",
    cross: "M-3.4,-3.4L3.4,3.4M-3.4,3.4L3.4,-3.4",
    turn: "M-5,-3.4H5L0,5z",
  };
  const OF_CONTROLLERS = ["circle", "square", "triangle", "diamond"];
  const OF_LIMITS = [[], [9, 4], [5, 3], [9, 3, 2, 3], [2, 3]];
  const BRAKING = { colour: "muted", dash: [12, 5], width: 1.4 }, SWERVING = { colour: "muted", dash: [12, 4, 2, 4, 2, 4], width: 1.4 };

  function of(series) {
    const n = series.filter(each => !each.is_limit).length;
    return series.map(({ name, is_limit }, i) => is_limit
      ? { name, colour: "ink", dash: OF_LIMITS[(i - n) % OF_LIMITS.length], shape: "dot", width: 1.8 }
      : { name, colour: `line-${i % 4 + 1}`, dash: i < 4 ? [] : [7, 3], shape: OF_CONTROLLERS[(i + Math.floor(i / 4)) % 4], width: 2 });
  }

  /* A short piece of the line with its mark. */
  function sample({ colour, dash = [], width = 0, shape, isOpen = false }) {
    const made = svg("svg", { width: 34, height: 12, viewBox: "-17 -6 34 12", class: "sample", "aria-hidden": "true" });
    made.style.color = `var(--${colour})`;
    if (width) made.append(svg("path", { d: "M-17,0H17", stroke: "currentColor", "stroke-width": width, "stroke-dasharray": dash.join(" ") }));
    if (shape) made.append(svg("path", { d: SHAPES[shape], stroke: "currentColor", "stroke-width": 1.6, fill: isOpen ? "var(--card)" : "currentColor" }));
    return made;
  }

  function svg(name, attributes) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  }

  const paths = Object.fromEntries(Object.entries(SHAPES).map(([name, path]) => [name, new Path2D(path)]));
  return { of, sample, paths, BRAKING, SWERVING };
})();
