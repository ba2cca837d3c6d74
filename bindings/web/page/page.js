// page.js: the controls, the workers (coarse while a hand moves, fine when it rests, a clerk that searches designs and
// draws their pictures), and the address as the state.
import { RANGES } from "./ranges.js";
import { View } from "./view.js";
import { languages, word } from "./words.js";

const $ = (id) => document.getElementById(id);
const SLIDERS = {
    stature: [0.8, 2.1],
    bust: [0.5, 1.5],
    waist: [0.45, 1.5],
    hip: [0.5, 1.6],
    back_waist: [0.2, 0.55],
    arm: [0.25, 0.75],
    inleg: [0.3, 1.0],
};
const COARSE = 0.02,
    FINE = 0.01,
    PAUSE = 250, // spacing [m]; time at rest before the fine drape begins [ms], chosen: longer than between two keys
    DRAWN = 4, // a coarse drape on its way to rest is shown again after this many frames' time: drawing takes a fifth
    LISTED = 200; // designs in the list at most
const start = {
    design: "tshirt",
    size: "W40",
    fabric: -1,
    pose: -1,
    colour: "#5278a8",
    map: 0,
    language: "en",
    measures: {},
};
let state = start,
    told = { designs: [], sizes: [], fabrics: [], poses: [] },
    made = {},
    last = null,
    id = 0,
    pause = 0;
const view = new View($("view")),
    waiting = new Map();
// what a test reads: milliseconds of each picture and of each rest
const log = (window.fitting = { ready: false, pictures: [], rests: [], fine: [], failed: [], sketches: 0, hash: "" });

try {
    state = { ...start, ...JSON.parse(decodeURIComponent(location.hash.slice(1))) };
} catch {
    // no state in the address
}
const say = (text) => {
    $("status").textContent = text;
};
const tell = (name) => word(state.language, name);

const module = WebAssembly.compileStreaming(fetch("room.wasm"));
function worker(onOpen = () => {}) {
    const made = new Worker("worker.js", { type: "module" });
    made.onmessage = ({ data }) => (data.kind === "open" ? onOpen(data) : answer(data));
    module.then((ready) => made.postMessage({ call: "open", module: ready }));
    return made;
}
// to a worker that may not have its module yet
const send = (to, message) => module.then(() => to.postMessage(message));

const asked = new Map(); // when each wish was sent
let finishing = 0, // the wish that the fine worker is at
    resting = 0; // the one that the coarse worker is at
function wish(to, fine) {
    asked.set(++id, performance.now());
    if (fine) finishing = id;
    else resting = id;
    send(to, {
        call: "dress",
        id,
        fine,
        at: performance.timeOrigin + performance.now(),
        pause: DRAWN * view.frame,
        design: state.design,
        fabric: state.fabric,
        pose: state.pose,
        map: state.map,
        spacing: fine ? FINE : COARSE,
        person: { size: state.size, file: state.file, measures: state.measures },
    });
}

function change(part = {}) {
    state = { ...state, ...part };
    // a fine worker that is busy is no longer asked, and would take the coarse one's time; a new one starts at rest
    if (finishing) {
        fine.terminate();
        fine = null;
        finishing = 0;
    }
    clearTimeout(pause);
    view.move(true);
    wish(coarse, false);
}

// The coarse drape is at rest. When the hand is too: the fine drape, and the address (10 ms in browsers)
function settled() {
    resting = 0;
    pause = setTimeout(() => {
        view.move(false);
        fine ??= worker();
        wish(fine, true);
        history.replaceState(null, "", `#${encodeURIComponent(JSON.stringify({ ...state, file: undefined }))}`);
    }, PAUSE);
}

let shown = 0;
function answer(data) {
    if (data.kind === "file") return waiting.get(data.id)?.(data.bytes);
    if (data.kind === "found") return data.id === searched && showDesigns(data.found.map((i) => told.designs[i]));
    if (data.kind === "sketch") return draw(data);
    if (data.id === finishing && (data.rest || data.kind === "failed")) finishing = 0;
    if (data.id === resting && (data.rest || data.kind === "failed")) settled();
    if (data.kind === "progress")
        return say(`${tell(data.phase ? "settling" : "sewing")} ${Math.round(100 * data.share)} %`);
    if (data.kind === "failed") {
        log.failed.push(data.text);
        return say(`${tell("failed")}: ${data.text}`);
    }
    if (data.id < shown) return;
    shown = data.id;
    const since = performance.now() - asked.get(data.id);
    const nodes = data.cloth.positions.length / 3;
    view.show(data.body, data.cloth, { colour: state.colour, map: state.map, values: data.map });
    (data.fine ? log.fine : data.rest ? log.rests : log.pictures).push(since);
    if (!data.rest) return;
    last = data;
    log.hash = data.hash;
    say(
        data.status === 0
            ? `${tell("atRest")}: ${Math.round(since)} ms, ${nodes} nodes`
            : data.reason,
    );
    made = data.made;
    sliders();
    $("levels").tBodies[0].innerHTML = "";
    for (const level of data.levels) {
        const row = $("levels").tBodies[0].insertRow(),
            head = document.createElement("th");
        head.scope = "row";
        head.textContent = `${tell(level.level)} ${level.side}`;
        row.append(head);
        for (const value of [level.body, level.garment, level.garment - level.body])
            row.insertCell().textContent = (100 * value).toFixed(1);
    }
}

// ---- controls ----

function sliders() {
    for (const name of Object.keys(SLIDERS)) {
        const input = $(`measure-${name}`),
            value = state.measures[name] ?? made[name];
        if (value === undefined || input === document.activeElement) continue;
        input.value = (100 * value).toFixed(1);
        input.parentElement.lastChild.textContent = `${input.value} cm`;
    }
}

function makeSliders() {
    for (const [name, [low, high]] of Object.entries(SLIDERS)) {
        const label = document.createElement("label"),
            text = document.createElement("span"),
            input = document.createElement("input");
        label.className = "slider";
        text.dataset.word = name;
        Object.assign(input, { type: "range", id: `measure-${name}`, min: 100 * low, max: 100 * high, step: 0.5 });
        input.addEventListener("input", () => {
            input.parentElement.lastChild.textContent = `${input.value} cm`;
            change({ measures: { ...state.measures, [name]: input.value / 100 } });
        });
        label.append(text, input, document.createElement("span"));
        $("measures").append(label);
    }
}

function options(select, rows, value) {
    select.replaceChildren(...rows.map(([key, text]) => new Option(text, key, false, String(key) === String(value))));
}

// all designs, or those that the library's search finds; an answer to an older phrase is dropped
let searched = 0;
function listDesigns() {
    const phrase = $("search").value.trim();
    searched = ++id;
    if (phrase === "") showDesigns(told.designs);
    else send(clerk, { call: "search", phrase, id });
}

// a card for each design: a radio button, its picture when it comes into view, its title
const sketches = new Map(); // pictures that are there or were asked for
function showDesigns(found) {
    const cards = found.slice(0, LISTED).map((one) => {
        const card = document.createElement("label"),
            input = document.createElement("input"),
            title = document.createElement("span");
        Object.assign(input, { type: "radio", name: "design", value: one.name, checked: one.name === state.design });
        const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
        picture.setAttribute("aria-hidden", "true");
        picture.append(document.createElementNS("http://www.w3.org/2000/svg", "path"));
        title.textContent = one.title;
        card.append(input, picture, title);
        return card;
    });
    seen.disconnect();
    $("design").replaceChildren(...cards);
    cards.forEach((card) => seen.observe(card));
    $("design").querySelector(":checked")?.parentElement.scrollIntoView({ block: "nearest" });
}

const cardOf = (name) => $("design").querySelector(`[value="${CSS.escape(name)}"]`)?.parentElement;
const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        seen.unobserve(target);
        const name = target.firstChild.value,
            made = sketches.get(name);
        if (made) draw(made);
        if (made !== undefined) continue;
        sketches.set(name, null);
        send(clerk, { call: "sketch", name, groups: told.designs.find((one) => one.name === name).groups });
    }
});

// data: { name, size [cm], path }; without a path where the design could not be drafted
function draw(data) {
    if (!sketches.get(data.name)) log.sketches++;
    sketches.set(data.name, data);
    const picture = cardOf(data.name)?.querySelector("svg");
    if (!picture || !data.path) return;
    const [width, height] = data.size,
        side = 1.06 * Math.max(width, height);
    picture.setAttribute("viewBox", `${(width - side) / 2} ${(height - side) / 2} ${side} ${side}`);
    picture.firstChild.setAttribute("d", data.path);
}

function speak() {
    document.documentElement.lang = state.language;
    for (const element of document.querySelectorAll("[data-word]")) element.textContent = tell(element.dataset.word);
    options(
        $("pose"),
        [[-1, tell("standing")], ...told.poses.map((name, i) => [i, name.replaceAll("_", " ")])],
        state.pose,
    );
    legend();
}

function legend() {
    const range = RANGES[state.map];
    $("legend").hidden = !range;
    if (range) [$("low").textContent, $("high").textContent] = [0, 1].map((i) => `${range[i] * range[3]}${range[2]}`);
}

function fill() {
    listDesigns();
    options(
        $("size"),
        told.sizes.map((name) => [name, name]),
        state.size,
    );
    options($("fabric"), [[-1, "muslin"], ...told.fabrics.map((name, i) => [i, name])], state.fabric);
    options($("language"), Object.entries(languages), state.language);
    $("colour").value = state.colour;
    $("map").value = state.map;
    speak();
}

// ---- files ----

function save(name, bytes, type) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([bytes], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

async function file(form) {
    if (form === "glb") return save(`${state.design}.glb`, await view.glb(), "model/gltf-binary");
    const bytes = await new Promise((done) => {
        waiting.set(++id, done);
        send(coarse, { call: "file", form, paper: Number($("paper").value), title: state.design, id });
    });
    save(
        `${state.design}.${form}`,
        bytes,
        { pdf: "application/pdf", svg: "image/svg+xml", json: "application/json" }[form] ?? "text/plain",
    );
}

$("panel").addEventListener("submit", (event) => event.preventDefault());
$("search").addEventListener("input", listDesigns);
$("design").addEventListener("change", ({ target }) => change({ design: target.value }));
$("size").addEventListener("change", () => change({ size: $("size").value, measures: {}, file: undefined }));
for (const name of ["fabric", "pose"])
    $(name).addEventListener("change", () => change({ [name]: Number($(name).value) }));
$("map").addEventListener("change", () => {
    change({ map: Number($("map").value) });
    legend();
});
$("colour").addEventListener("input", () => {
    state.colour = $("colour").value;
    view.show(null, null, { colour: state.colour, map: state.map, values: last?.map });
});
$("colour").addEventListener("change", () => change());
$("language").addEventListener("change", () => {
    state.language = $("language").value;
    change();
    speak();
});
$("tape").addEventListener("change", async () => {
    const [given] = $("tape").files;
    if (given) change({ file: await given.text(), measures: {} });
});
$("share").addEventListener("click", async () => {
    // what a tape file has given stands in the address as measures
    const measures = state.file
        ? Object.fromEntries(Object.keys(SLIDERS).map((name) => [name, made[name]]))
        : state.measures;
    const link = new URL(`#${encodeURIComponent(JSON.stringify({ ...state, measures, file: undefined }))}`, location);
    await navigator.clipboard?.writeText(link.href).catch(() => {});
    say(`${tell("linked")}: ${link.href.slice(0, 60)}`);
});
for (const button of document.querySelectorAll("[data-file]"))
    button.addEventListener("click", () => file(button.dataset.file));

makeSliders();
const coarse = worker((data) => {
    told = data;
    fill();
    log.ready = true;
    change();
});
let fine = null;
const clerk = worker();
if ("serviceWorker" in navigator) navigator.serviceWorker.register("sw.js");
