// web.mjs URL FOLDER: the fitting room in headless Chromium; prints one line a claim. Run by web.py, which has put
// playwright-core and axe-core beside.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";

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
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
    ],
});
const context = await browser.newContext({ acceptDownloads: true, viewport: { width: 1100, height: 760 } });
const page = await context.newPage();
const errors = [];
page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
page.on("pageerror", (error) => errors.push(error.message));
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
    await page.selectOption("#design", design);
    await rest();
    const { hash } = await log();
    await page.screenshot({ path: `${folder}/${design}.png` });
    claim(/^[0-9a-f]{16}$/.test(hash), `${design} at rest after ${Date.now() - begin} ms at 20 mm`);
}

// a slider dragged for two seconds
await page.fill("#search", "");
await mark();
await page.selectOption("#design", "tshirt");
await rest();
const before = await log(),
    slider = page.locator("#measure-bust");
await mark();
begin = Date.now();
for (let i = 0; i < 40; i++) {
    await slider.evaluate(
        (input, value) => {
            input.value = value;
            input.dispatchEvent(new Event("input", { bubbles: true }));
        },
        92 + 0.2 * i,
    );
    await page.waitForTimeout(45);
}
const spent = (Date.now() - begin) / 1000,
    after = await log();
const pictures = after.pictures.slice(before.pictures.length),
    rests = after.rests.slice(before.rests.length);
claim(
    pictures.length > 0 && rests.length > 0,
    `slider dragged for ${spent.toFixed(1)} s: ${(pictures.length / spent).toFixed(1)} drapes shown a second, ` +
        `first picture ${middle(pictures)} ms, rest ${middle(rests)} ms (medians, 20 mm)`,
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
await page.addScriptTag({ content: readFileSync(require.resolve("axe-core/axe.min.js"), "utf8") });
const { violations } = await page.evaluate(() => window.axe.run());
const serious = violations.filter((one) => ["serious", "critical"].includes(one.impact));
claim(
    serious.length === 0,
    `axe-core: ${serious.length} serious findings of ${violations.length} ${serious.map((one) => one.id)}`,
);
const picture = () => page.locator("#view").screenshot();
const first = await picture();
await page.focus("#view");
for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
await page.waitForTimeout(500);
claim(!first.equals(await picture()), "arrow keys turn the view");
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
claim(errors.length === 0, `${errors.length} errors on the console ${errors.slice(0, 3).join("; ")}`);
claim((await log()).failed.length === 0, `no garment failed`);
writeFileSync(`${folder}/log.json`, JSON.stringify(await log()));
await browser.close();
process.exit(failed > 0 ? 1 : 0);
