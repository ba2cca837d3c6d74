// web.mjs URL FOLDER: the fitting room in headless Chromium; prints one line a claim. Run by web.py, which has put
// playwright-core and axe-core beside.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { cpus, loadavg } from "node:os";

const [url, folder, tape] = process.argv.slice(2);
const require = createRequire(`${folder}/`);
const { chromium } = require("playwright-core");
let failed = 0;
function claim(holds, told) {
    failed += !holds;
    console.log(`${holds ? "ok  " : "FAIL"} ${told}`);
}
const middle = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]?.toFixed(0);
const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [
        "--no-sandbox",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        // WebGL without a graphics card; what else the processor draws, and how, the browser chooses itself
        "--enable-unsafe-swiftshader",
    ],
});
const context = await browser.newContext({
    acceptDownloads: true,
    permissions: ["clipboard-read", "clipboard-write"],
    viewport: { width: 1100, height: 760 },
});
const page = await context.newPage();
const errors = [];
function watch(page) {
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(error.message));
}
watch(page);
const load = () => `load ${loadavg()[0].toFixed(1)} on ${cpus().length} of ${cpus()[0].model}`;
const log = () => page.evaluate(() => ({ ...window.fitting }));
async function rest(fine = false) {
    // until the wish that was made last is at rest
    const names = fine ? ["fine"] : ["rests", "fine"]; // the fine worker may be first
    await page.waitForFunction(
        (all) => all.some((name) => window.fitting[name].length > window.before[name]),
        names,
        { timeout: 120000 },
    );
}
const mark = () =>
    page.evaluate(() => {
        window.before = { rests: window.fitting.rests.length, fine: window.fitting.fine.length };
    });

// axe-core's findings on a page; the serious ones are refused
async function accessible(page, where) {
    await page.addScriptTag({ content: readFileSync(require.resolve("axe-core/axe.min.js"), "utf8") });
    const { violations } = await page.evaluate(() => window.axe.run());
    const serious = violations.filter((one) => ["serious", "critical"].includes(one.impact));
    claim(
        serious.length === 0,
        `axe-core ${where}: ${serious.length} serious findings of ${violations.length} ${serious.map((one) => one.id)}`,
    );
}
const choose = (design) => page.click(`#design label:has([value=${design}])`);

let begin = Date.now();
await page.goto(url);
await page.waitForFunction(() => window.fitting?.ready, null, { timeout: 60000 });
const ready = Date.now() - begin;
await page.evaluate(() => {
    window.before = { rests: 0, fine: 0 };
});
await rest();
claim(
    ready < 20000,
    `ready after ${ready} ms, first garment at rest ${Date.now() - begin} ms after the address was typed`,
);
await rest(true);
await page.screenshot({ path: `${folder}/page.png` });

for (const design of ["skirt", "jeans", "shirt"]) {
    await page.fill("#search", design);
    await mark();
    begin = Date.now();
    await choose(design);
    await rest();
    const { hash } = await log();
    await page.screenshot({ path: `${folder}/${design}.png` });
    claim(/^[0-9a-f]{16}$/.test(hash), `${design} at rest after ${Date.now() - begin} ms at 20 mm`);
}

// pictures of the designs that are in view; all designs are listed first, so that the list that was there before is
// not taken for the answer
await page.fill("#search", "");
await page.waitForFunction(() => document.querySelectorAll("#design label").length === 200);
await page.fill("#search", "skirt");
await page.waitForFunction(
    () =>
        document.querySelectorAll("#design label").length < 200 &&
        document.querySelectorAll("#design path[d]").length >= 6,
    null,
    { timeout: 60000 },
);
const drawn = await page.evaluate(() => {
    const boxes = [...document.querySelectorAll("#design path[d]")].map((path) => path.getBBox());
    return boxes.filter(({ width, height }) => width > 10 && height > 10).length;
});
claim(drawn >= 6, `${drawn} designs found for "skirt" have a picture of their pieces`);
await page.screenshot({ path: `${folder}/designs.png` });

// a slider moved in the page: nine single values, then dragged for two seconds, a value each 45 ms, as by a hand
await page.fill("#search", "");
await mark();
await choose("tshirt");
await rest();
await rest(true);
await page.waitForTimeout(1000); // pictures of the designs in view
const moved = await page.evaluate(async () => {
    const input = document.getElementById("measure-bust"),
        { pictures, rests } = window.fitting,
        pause = (time) => new Promise((done) => setTimeout(done, time));
    const move = (value) => {
        input.value = value;
        input.dispatchEvent(new Event("input", { bubbles: true }));
    };
    const single = { first: [], rest: [] };
    for (let i = 0; i < 9; i++) {
        const before = [pictures.length, rests.length];
        move(92 + 0.5 * i);
        while (rests.length === before[1]) await pause(5);
        single.first.push(pictures[before[0]]);
        single.rest.push(rests[before[1]]);
        await pause(100);
    }
    const start = performance.now(),
        before = pictures.length;
    for (let i = 0; i < 40; i++) {
        move(92 + 0.2 * i);
        await pause(45);
    }
    const seconds = (performance.now() - start) / 1000;
    return { single, seconds, rate: (pictures.length - before) / seconds, dragged: pictures.slice(before) };
});
const first = middle(moved.single.first),
    still = middle(moved.single.rest),
    aims = [first < 60, moved.rate >= 20, still < 400].filter(Boolean).length;
claim(
    moved.dragged.length > 0,
    `slider moved: first picture after ${first} ms (aim 60), rest after ${still} ms (aim 400), medians of 9; dragged ` +
        `for ${moved.seconds.toFixed(1)} s: ${moved.rate.toFixed(1)} drapes shown a second (aim 20), each ` +
        `${middle(moved.dragged)} ms after its value; ${aims} of 3 aims; 20 mm, ${load()}`,
);
await page.waitForTimeout(100);
await rest(true);
claim(true, `fine rest (10 mm) ${middle((await log()).fine.slice(-1))} ms after the hand rested`);

// a fit map, a pose, a language, files
await page.selectOption("#map", "3");
await page.selectOption("#language", "de");
await mark();
await rest(true);
await page.screenshot({ path: `${folder}/pressure.png` });
claim(
    (await page.locator("#legend").isVisible()) &&
        (await page.locator("legend").first().textContent()) === "Kleidungsstück",
    "fit map with its legend, German words",
);
for (const [form, begins] of [
    ["pdf", "%PDF"],
    ["svg", "<"],
    ["glb", "glTF"],
    ["json", "{"],
    ["tape", "# muslin"],
]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`[data-file=${form}]`)]);
    await download.saveAs(`${folder}/out.${form}`);
    const data = readFileSync(`${folder}/out.${form}`);
    claim(
        data.subarray(0, 12).toString("latin1").includes(begins),
        `${download.suggestedFilename()}: ${data.length} bytes`,
    );
}
await mark();
await page.setInputFiles("#tape", tape);
await rest();
claim(true, "own tape file dressed");

// accessibility, the keyboard, an address that was shared, no network
await accessible(page, "at the desk");

// by keyboard alone: another design, a measure, a pose
await page.fill("#search", "");
await page.focus("#design :checked");
await mark();
await page.keyboard.press("ArrowDown");
const next = await page.inputValue("#design :checked");
await rest();
claim(next !== "tshirt", `arrow keys choose a design: ${next}`);
await page.focus("#measure-hip");
const hip = Number(await page.inputValue("#measure-hip"));
await mark();
await page.keyboard.press("ArrowRight");
await rest();
const wider = Number(await page.inputValue("#measure-hip"));
claim(wider === hip + 0.5, `arrow keys move a slider: hip ${hip} to ${wider} cm`);
await mark();
await page.selectOption("#pose", { index: 2 });
await rest();
await rest(true);
await page.screenshot({ path: `${folder}/pose.png` });
claim(true, `pose ${await page.locator("#pose option:checked").textContent()} dressed`);
await page.click("#share");
const link = await page.evaluate(() => navigator.clipboard.readText());
const shared = JSON.parse(decodeURIComponent(new URL(link).hash.slice(1)));
claim(shared.design === next && shared.measures.hip > 0, `the link has the state: ${link.length} characters`);

const picture = () => page.locator("#view").screenshot();
const before = await picture();
await page.focus("#view");
for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
await page.waitForTimeout(500);
const turned = await picture();
claim(!before.equals(turned), "arrow keys turn the view");
const box = await page.locator("#view").boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
await page.mouse.down();
await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2, { steps: 4 });
await page.mouse.up();
await page.waitForTimeout(500);
const dragged = await picture();
await page.mouse.wheel(0, 300);
await page.waitForTimeout(500);
claim(!dragged.equals(turned) && !dragged.equals(await picture()), "a pointer turns the view, a wheel moves it away");
await page.waitForFunction(() => navigator.serviceWorker.controller);
const address = page.url();
await context.setOffline(true);
await page.goto("about:blank");
await page.goto(address);
await page.waitForFunction(() => window.fitting?.rests.length > 0, null, { timeout: 60000 });
claim(
    (await page.inputValue("#language")) === "de" && (await page.inputValue("#map")) === "3",
    "the shared address opens without a network as it was left",
);
await context.setOffline(false);

// a phone, and the words of each language
const phone = await browser.newContext({ viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true });
const small = await phone.newPage();
watch(small);
await small.goto(url);
await small.waitForFunction(() => window.fitting?.fine.length > 0, null, { timeout: 120000 });
await small.screenshot({ path: `${folder}/phone.png` });
const wide = await small.evaluate(() => document.documentElement.scrollWidth);
claim(wide <= 390, `on a phone the page is ${wide} of 390 pixels wide`);
await accessible(small, "on a phone");
for (const language of ["de", "fr", "es", "en"]) {
    await small.selectOption("#language", language);
    const lacking = await small.evaluate(
        () => [...document.querySelectorAll("[data-word]")].filter((one) => one.textContent.trim() === "").length,
    );
    claim(lacking === 0, `${language}: every label has its word, "${await small.textContent("legend")}"`);
}
await phone.close();
claim(errors.length === 0, `${errors.length} errors on the console ${errors.slice(0, 3).join("; ")}`);
claim((await log()).failed.length === 0, `no garment failed`);
writeFileSync(`${folder}/log.json`, JSON.stringify(await log()));
await browser.close();
process.exit(failed > 0 ? 1 : 0);
