"use strict";
/* Elements: making one, and how wide one is. */
function element(tag, text = "", name = "") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (name) made.className = name;
  return made;
}

/* Without its padding [px]. */
const inner = holder => {
  const style = getComputedStyle(holder);
  return Math.max(120, holder.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight));
};
