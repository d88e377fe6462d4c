"use strict";
/* What every page has: light or dark, which is kept for the next one, elements, and requests. */
(() => {
  const KEY = "swerve-theme", root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)");
  const button = document.getElementById("theme");
  const of = page => page.dataset.theme ?? (dark.matches ? "dark" : "light");
  const now = () => of(root);

  function show() {
    button.textContent = now() === "dark" ? "Light" : "Dark";
    document.querySelectorAll("iframe").forEach(agree);
  }

  /* A report in a frame has its own button, which is hidden there. */
  function agree(frame) {
    const inside = frame.contentDocument;
    if (inside?.getElementById("theme") && of(inside.documentElement) !== now()) inside.getElementById("theme").click();
  }

  function toggle() {
    root.dataset.theme = now() === "dark" ? "light" : "dark";
    localStorage.setItem(KEY, root.dataset.theme);
    show();
  }

  if (localStorage.getItem(KEY)) root.dataset.theme = localStorage.getItem(KEY);
  button.addEventListener("click", toggle);
  dark.addEventListener("change", show);
  for (const frame of document.querySelectorAll("iframe")) frame.addEventListener("load", () => agree(frame));
  show();
})();

const byId = id => document.getElementById(id);

function element(tag, text = "", name = "") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (name) made.className = name;
  return made;
}

/* The answer to a request, or an error whose message is the server's own sentence. */
async function ask(path, method = "GET", content = undefined) {
  const body = content === undefined ? {} : { body: JSON.stringify(content), headers: { "content-type": "application/json" } };
  let answer;
  try {
    answer = await fetch(path, { method, ...body });
  } catch {
    throw new Error("swerve view does not answer any more; start it again");
  }
  const found = await answer.json();
  if (!answer.ok) throw new Error(found.detail);
  return found;
}

function tell(message) {
  const fault = byId("fault");
  fault.textContent = message;
  fault.hidden = !message;
}
