"use strict";
/* On paper: light, and all details open; a page lays out the rest, and undoes it afterwards. */
const Printing = (() => {
  function begin(lay, restore) {
    let before = null;
    addEventListener("beforeprint", () => {
      if (before) return;
      const root = document.documentElement, details = [...document.querySelectorAll("details")];
      before = { theme: root.dataset.theme, details, open: details.map(each => each.open) };
      root.dataset.theme = "light";
      for (const each of details) each.open = true;
      Colours.read();
      lay();
    });
    addEventListener("afterprint", () => {
      const { theme, details, open } = before, root = document.documentElement;
      if (theme) root.dataset.theme = theme; else delete root.dataset.theme;
      details.forEach((each, i) => { each.open = open[i]; });
      before = null;
      Colours.read();
      restore();
    });
  }

  return { begin };
})();
