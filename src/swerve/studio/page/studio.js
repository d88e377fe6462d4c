"use strict";
/* A scene that is moved by hand, run, and watched. The TOML in the text field is what runs; sliders write it. */
const Studio = (() => {
  const SLIDERS = [  // factor from SI to the unit that is shown
    { key: "speed", label: "Speed", unit: "km/h", factor: 3.6, min: 10, max: 200, step: 1 },
    { key: "distance", label: "Distance to the obstacle's middle", unit: "m", factor: 1, min: 3, max: 120, step: 0.5 },
    { key: "offset", label: "Offset of the obstacle to the left", unit: "m", factor: 1, min: -5, max: 5, step: 0.1 },
    { key: "friction", label: "Friction", unit: "", factor: 1, min: 0.1, max: 1.2, step: 0.05 },
  ];
  const CHOSEN = ["scenario", "controller", "plant", "seed"];  // besides what is moved
  const EVERY = 60;  // between two questions about a job [ms]
  const CALM = 120;  // without another move, until the scene is asked for [ms]
  let scenarios = [], moved = {}, asked = 0, timer = 0, scene = Promise.resolve(), job = null;

  const shown = value => String(Number(value.toFixed(4)));

  function slider({ key, label, unit, min, max, step }) {
    const row = element("div", "", "slider"), name = element("label", label), range = element("input"), number = element("input");
    Object.assign(range, { type: "range", id: `range-${key}`, min, max, step: "any" });
    Object.assign(number, { type: "number", id: `number-${key}`, step: "any", required: true });
    name.htmlFor = number.id;
    range.setAttribute("aria-label", label);
    range.addEventListener("input", () => { number.value = shown(Math.round(range.value / step) * step); move(key, unit, number.value); });
    range.addEventListener("keydown", event => {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (!by) return;
      event.preventDefault();
      range.value = Number(number.value) + by * step;
      range.dispatchEvent(new Event("input"));
    });
    number.addEventListener("input", () => { range.value = number.value; if (number.value !== "") move(key, unit, number.value); });
    row.append(name, range, number, element("span", unit, "note"));
    return row;
  }

  function move(key, unit, value) {
    moved[key] = unit ? `${value} ${unit}` : Number(value);
    renew();
  }

  function pick() {
    const picked = scenarios.find(each => each.name === byId("scenario").value);
    moved = {};
    byId("description").textContent = picked.description;
    for (const { key, factor } of SLIDERS) {
      const value = picked.start[key], inputs = [byId(`range-${key}`), byId(`number-${key}`)];
      for (const input of inputs) [input.value, input.disabled] = [value === null ? "" : shown(value * factor), value === null];
    }
    renew(0);
  }

  /* Ask for the scene's TOML, once nothing has moved for a moment; what is asked for later counts. */
  function renew(wait = CALM) {
    const mine = ++asked;
    clearTimeout(timer);
    scene = new Promise(done => { timer = setTimeout(done, wait); }).then(async () => {
      const { toml } = await ask("/api/scene", "POST", { scenario: byId("scenario").value, ...moved });
      if (mine === asked) byId("toml").value = toml;
    });
    scene.then(() => mine === asked && tell(""), error => mine === asked && tell(error.message));
  }

  async function run() {
    busy(true);
    try {
      await settled();
      tell("");
      const wanted = { toml: byId("toml").value, controller: byId("controller").value, plant: byId("plant").value, seed: Number(byId("seed").value) };
      job = await ask("/api/jobs", "POST", wanted);
      while (!["done", "failed", "cancelled"].includes(job.state)) {
        progress(job);
        await new Promise(done => setTimeout(done, EVERY));
        job = await ask(`/api/jobs/${job.number}`);
      }
      progress(job);
      if (job.state === "done") watch(job.run);
      if (job.state === "failed") tell(`The run failed: ${job.message}`);
    } catch (error) {
      byId("status").textContent = "";
      tell(error.message);
    }
    busy(false);
  }

  /* The last scene that was asked for, even if there was another move in between. */
  async function settled() {
    for (let mine = -1; mine !== asked;) {
      mine = asked;
      await scene;
    }
  }

  function busy(is) {
    [byId("run").disabled, byId("cancel").disabled, byId("progress").hidden] = [is, !is, !is];
  }

  function progress({ state, share }) {
    byId("progress").value = share;
    byId("status").textContent = { waiting: "Waiting for its turn", running: "Running", done: "Done", failed: "", cancelled: "Cancelled" }[state];
  }

  function watch(name) {
    const frame = byId("frame"), address = `/runs/${encodeURIComponent(name)}/report.html`, alone = byId("alone");
    const link = element("a", name);
    link.href = address;
    alone.replaceChildren("Kept as ", link);
    byId("waiting").hidden = true;
    frame.hidden = alone.hidden = false;
    frame.src = `${address}#t=0&play`;
    if (byId("result").getBoundingClientRect().top > innerHeight / 2) byId("result").scrollIntoView();
  }

  /* As high as what is in it, so that the page scrolls and not the frame. */
  function fit(frame) {
    const inside = frame.contentDocument.documentElement;
    new ResizeObserver(() => { frame.style.height = `${inside.querySelector("body").offsetHeight + 8}px`; }).observe(inside.querySelector("body"));
  }

  function save() {
    const text = byId("toml").value, name = /^name = "([\w-]+)"/m.exec(text)?.[1] ?? "scene", link = element("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
    link.download = `${name}.toml`;
    link.click();
    URL.revokeObjectURL(link.href);
  }

  const options = names => names.map(name => new Option(name, name));

  /* The library, then each family with its members. */
  function groups({ families }) {
    const members = new Set(families.flatMap(each => each.members)), own = scenarios.map(each => each.name).filter(name => !members.has(name));
    return [["Library", own], ...families.map(each => [`${each.pattern}: ${each.title}`, each.members])].map(([label, names]) => {
      const group = element("optgroup");
      group.label = label;
      group.append(...options(names));
      return group;
    });
  }

  async function begin() {
    const choices = await ask("/api/choices");
    scenarios = choices.scenarios;
    byId("sliders").append(...SLIDERS.map(slider));
    byId("scenario").append(...groups(choices));
    for (const [id, names] of [["controller", choices.controllers], ["plant", choices.plants]]) byId(id).append(...options(names));
    const wanted = new URLSearchParams(location.search);
    for (const [id, value] of [["scenario", "paper"], ["plant", "multibody"], ...wanted].filter(each => CHOSEN.includes(each[0]))) choose(id, value);
    byId("scenario").addEventListener("change", pick);
    byId("scene").addEventListener("submit", event => { event.preventDefault(); run(); });
    byId("cancel").addEventListener("click", () => job && ask(`/api/jobs/${job.number}`, "DELETE").catch(error => tell(error.message)));
    byId("save").addEventListener("click", () => settled().then(save, error => tell(error.message)));
    byId("toml").addEventListener("input", () => { asked += 1; clearTimeout(timer); scene = Promise.resolve(); tell(""); });
    byId("frame").addEventListener("load", event => fit(event.target));
    pick();
    place(wanted);
  }

  /* What there is no such choice of stays as it is. */
  function choose(id, value) {
    const input = byId(id), before = input.value;
    input.value = value;
    if (!input.validity.valid || input.value !== value) input.value = before;
  }

  /* What the address says of the scene, in SI: ?scenario=paper&speed=20&distance=15.8, as a map's page writes it. */
  function place(wanted) {
    const isNumber = key => wanted.has(key) && Number.isFinite(Number(wanted.get(key))) && wanted.get(key).trim() !== "";
    for (const { key, factor } of SLIDERS.filter(each => isNumber(each.key))) {
      moved[key] = Number(wanted.get(key));
      for (const input of [byId(`range-${key}`), byId(`number-${key}`)]) input.value = shown(moved[key] * factor);
    }
    if (isNumber("duration")) moved.duration = Number(wanted.get("duration"));
    if (Object.keys(moved).length) renew(0);
  }

  begin().catch(error => tell(error.message));
})();
