"use strict";
/* The palette of the style sheet as it is now, for canvases, which know no CSS variables.
   Four lines are told apart by colour and by dashes; friction use runs along a ramp of rising lightness (cividis), which
   colour-blind readers and grey print keep in order. */
const Colours = (() => {
  const NAMES = ["page", "card", "border", "ink", "muted", "accent", "good", "bad", "grid", "road", "lane", "obstacle",
    "force", "line-1", "line-2", "line-3", "line-4"];
  const RAMP = [[0, 34, 78], [67, 78, 108], [125, 124, 120], [188, 174, 108], [254, 232, 56]];
  const DASHES = [[], [8, 3], [2, 3], [10, 3, 2, 3]];
  const now = {};

  function read() {
    const probe = document.body.appendChild(document.createElement("i"));
    for (const name of NAMES) {
      probe.style.color = `var(--${name})`;
      now[name] = getComputedStyle(probe).color;
    }
    probe.remove();
  }

  /* share of the friction circle -> colour; above 1 as at 1 */
  function ofUse(share) {
    const place = Math.min(1, Math.max(0, share ?? 0)) * (RAMP.length - 1);
    const low = Math.min(RAMP.length - 2, Math.floor(place));
    const mixed = RAMP[low].map((from, i) => Math.round(from + (place - low) * (RAMP[low + 1][i] - from)));
    return `rgb(${mixed.join(",")})`;
  }

  const ramp = () => `linear-gradient(90deg, ${RAMP.map(each => `rgb(${each.join(",")})`).join(",")})`;
  const ofLine = index => now[`line-${index % 4 + 1}`];
  const dash = index => DASHES[index % 4];
  const pale = (name, share) => `color-mix(in srgb, ${now[name] ?? name} ${100 * share}%, transparent)`;
  return { read, get: name => now[name], ofUse, ramp, ofLine, dash, pale };
})();
