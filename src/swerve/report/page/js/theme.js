"use strict";
/* Light or dark: the system's until the button is pressed. What knows no style sheet is drawn anew after a change. A
   page round this one has its own button. */
const Theme = (() => {
  const root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)"), button = document.getElementById("theme");
  const now = () => root.dataset.theme ?? (dark.matches ? "dark" : "light");
  const label = () => { button.textContent = now() === "dark" ? "Light" : "Dark"; };

  function begin(recolour) {
    const changed = () => { label(); recolour(); };
    if (window.parent !== window) root.dataset.framed = "";
    button.addEventListener("click", () => { root.dataset.theme = now() === "dark" ? "light" : "dark"; changed(); });
    dark.addEventListener("change", changed);
    label();
  }

  return { begin };
})();
