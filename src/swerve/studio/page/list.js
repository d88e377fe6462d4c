"use strict";
/* The list of finished runs: filtered by words and outcome, two of them compared; above it comparisons and maps. */
const List = (() => {
  const OUTCOMES = { avoided: "Avoided", collided: "Collided", left_road: "Left the road", spun: "Spun", diverged: "Diverged" };
  const chosen = new Set();
  let runs = [];

  function card(run) {
    const item = element("li", "", "card"), title = element("h2"), link = title.appendChild(element("a", run.name));
    link.href = `/runs/${encodeURIComponent(run.name)}/report.html`;
    if (run.fault !== null) {
      item.append(title, element("p", run.fault, "fault"));
      return item;
    }
    const picture = element("img");
    Object.assign(picture, { src: `/runs/${encodeURIComponent(run.name)}/thumbnail.svg`, alt: `${run.name} from above`, loading: "lazy" });
    const verdict = element("p");
    verdict.append(element("span", OUTCOMES[run.outcome], `badge ${run.outcome}`), ` ${numbers(run)}`);
    item.append(picture, title, verdict, element("p", `${run.scenario}, ${run.controller} on ${run.plant}, seed ${run.seed}`, "note"),
      element("p", new Date(1000 * run.finished).toLocaleString(), "note"), choice(run));
    return item;
  }

  function numbers({ min_clearance, impact_speed }) {
    if (impact_speed !== null) return `at ${(3.6 * impact_speed).toFixed(1)} km/h`;
    return min_clearance === null ? "" : `${min_clearance.toFixed(2)} m clear`;
  }

  function choice({ name }) {
    const label = element("label"), box = label.appendChild(element("input"));
    Object.assign(box, { type: "checkbox", checked: chosen.has(name) });
    box.setAttribute("aria-label", `Compare ${name}`);
    box.addEventListener("change", () => {
      if (box.checked) chosen.add(name); else chosen.delete(name);
      byId("compare").disabled = chosen.size !== 2;
    });
    label.append("Compare");
    return label;
  }

  function isShown(run) {
    const words = byId("words").value.toLowerCase().split(/\s+/).filter(Boolean), outcome = byId("outcome").value;
    const text = [run.name, run.scenario, run.controller, run.plant, run.outcome, run.decision].join(" ").toLowerCase();
    return words.every(word => text.includes(word)) && (!outcome || run.outcome === outcome);
  }

  function show() {
    const shown = runs.filter(isShown);
    byId("runs").replaceChildren(...shown.map(card));
    byId("count").textContent = runs.length ? `${shown.length} of ${runs.length} runs`
      : "No finished runs in this folder yet: swerve run --out writes one, the studio another.";
  }

  function showLinks(id, found, page) {
    byId(id).hidden = !found.length;
    for (const { name } of found) {
      const link = byId(id).appendChild(element("a", name));
      link.href = `/${id}/${encodeURIComponent(name)}/${page}`;
    }
  }

  async function load() {
    try {
      showLinks("comparisons", await ask("/api/comparisons"), "report.html");
      showLinks("maps", await ask("/api/maps"), "map.html");
      runs = await ask("/api/runs");
      const outcomes = [...new Set(runs.map(each => each.outcome).filter(Boolean))].sort();
      byId("outcome").append(...outcomes.map(each => new Option(OUTCOMES[each], each)));
      show();
    } catch (error) {
      tell(error.message);
    }
  }

  byId("words").addEventListener("input", show);
  byId("outcome").addEventListener("change", show);
  byId("filter").addEventListener("submit", event => {
    event.preventDefault();
    const [first, second] = [...chosen].map(encodeURIComponent);
    if (chosen.size === 2) location.href = `/compare?first=${first}&second=${second}`;
  });
  load();
})();
