"use strict";
/* The step that is shown in words: which way is taken, why, and what the others would have cost. */
class Decision {
  constructor(place, cars) {
    Object.assign(this, { place, cars, shown: "" });
  }

  draw(time) {
    const steps = this.cars.map(car => Track.step(car, time));
    if (steps.join() === this.shown) return;
    this.shown = steps.join();
    this.place.replaceChildren(...this.cars.flatMap((car, i) => this.parts(car, steps[i])));
  }

  parts(car, k) {
    const { name, fallback, time } = car.steps, plan = car.plans[k];
    const who = this.cars.length > 1 ? `${car.name}: ` : "";
    const parts = [element("h3", `${who}${name[k]}, step at ${time[k].toFixed(2)} s`)];
    const why = [fallback[k] && `Fallback: ${fallback[k]}.`, sentence(plan.reason), plan.active && `Active limits: ${plan.active}.`, planned(plan.use)];
    parts.push(element("p", why.filter(Boolean).join(" "), "note"));
    if (plan.branches.length) parts.push(table(plan.branches, plan.taken ?? plan.branches.findIndex(each => each.name === name[k])));
    else parts.push(element("p", "Nothing else was tried in this step.", "note"));
    return parts;
  }
}

/* What the command is to take of each wheel's friction. */
function planned(use) {
  const words = ["FL", "FR", "RL", "RR"].map((name, i) => use[i] !== null && `${name} ${Math.round(100 * use[i])} %`).filter(Boolean);
  return words.length > 0 && `Friction asked for: ${words.join(", ")}.`;
}

function sentence(words) {
  return words && `${words[0].toUpperCase()}${words.slice(1).replace(/\.$/, "")}.`;
}

function table(branches, taken) {
  const rows = branches.map((each, i) => row("td", [i === taken ? `${each.name} ✓` : each.name, number(each.cost, 0),
    distance(each.violation), distance(each.off_road), speed(each.impact_speed)], i === taken));
  const head = element("thead");
  head.append(row("th", ["Way", "Cost", "Too near", "Off road", "Impact"]));
  const body = element("tbody"), made = element("table"), wide = element("div", "", "wide");
  body.append(...rows);
  made.append(head, body);
  wide.append(made);
  return wide;
}

function row(kind, cells, isTaken = false) {
  const made = element("tr", "", isTaken ? "taken" : "");
  made.append(...cells.map(each => element(kind, each)));
  return made;
}

const number = (value, digits) => value === null ? "–" : value.toLocaleString("en", { maximumFractionDigits: digits, minimumFractionDigits: digits });
const distance = value => value === null ? "–" : value >= 0.005 ? `${number(value, 2)} m` : "no";
const speed = value => value === null ? "no" : `${number(3.6 * value, 0)} km/h`;
