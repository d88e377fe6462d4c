"use strict";
/* The card of the point that is shown: its numbers, the command that runs it again, and links. */
class Card {
  static SERVED = /^http:\/\/(127\.0\.0\.1|localhost|\[::1\])(:\d+)?\/maps\//;  // by `swerve view`

  constructor(extent) {
    const place = id => document.getElementById(id);
    Object.assign(this, { extent, hint: place("card-hint"), body: place("card-body"), told: place("told"), shown: null });
  }

  show(point, panel, look) {
    if (point === this.shown) return;
    this.shown = point;
    const title = element("p", "", "who"), numbers = element("dl", "", "facts");
    title.append(Looks.sample(look), element("b", look.name), " ", this.badge(point));
    numbers.append(...Words.rows(point, panel, this.extent).map(([name, text]) => pair(name, text)));
    this.body.replaceChildren(title, numbers, ...this.again(point));
    [this.hint.hidden, this.body.hidden] = [true, false];
  }

  /* Said to who does not see the mark. */
  tell(point, panel, look) {
    this.told.textContent = [look.name, Words.verdict(point), ...Words.rows(point, panel, this.extent).map(each => each.join(" "))].join(", ");
  }

  clear() {
    this.shown = null;
    [this.hint.hidden, this.body.hidden] = [false, true];
  }

  /* To the first thing in it that can be pressed. */
  focus() { this.body.querySelector("button, a")?.focus(); }

  badge(point) {
    const isRun = point.kind === "run";
    return element("span", Words.verdict(point), isRun ? `badge ${point.outcome}` : "note");
  }

  again({ command, replay, studio }) {
    const code = element("pre", command), copy = element("button", "Copy the command"), links = element("p", "", "links");
    copy.type = "button";
    copy.addEventListener("click", () => this.copy(code, copy));
    if (replay) links.append(link(replay, "Watch all controllers here"));
    if (studio && Card.SERVED.test(location.href)) links.append(link(studio, "Open in the studio"));
    const actions = element("div", "", "again");
    actions.append(copy, links);
    return [code, actions];
  }

  /* Where the browser forbids it, the command is selected, and Ctrl-C copies it. */
  async copy(code, button) {
    try {
      await navigator.clipboard.writeText(code.textContent);
      button.textContent = "Copied";
    } catch {
      getSelection().selectAllChildren(code);
      button.textContent = "Selected: press Ctrl-C";
    }
  }
}

function pair(name, text) {
  const made = element("div");
  made.append(element("dt", name), element("dd", text));
  return made;
}

function link(address, words) {
  const made = element("a", words);
  made.href = address;
  return made;
}
