// objects.mjs PACKAGE FILE: failures are thrown, options are objects, callbacks stop a run, bytes are buffers, nothing
// leaks. Run with --expose-gc.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { default: muslin, MuslinError } = await import(pathToFileURL(process.argv[2]));

const context = muslin.contextCreate();
let tape = muslin.tapeCreate(context);
assert.throws(() => tape.set(muslin.measureFind("waist"), 7.8, muslin.MUS_SOURCE_GIVEN),
              (error) => error instanceof MuslinError && error.code === "MUS_ERR_TAPE" && /780\.0 cm/.test(error));
tape.setSize("W40");
tape.complete();
assert.equal(typeof tape.value(muslin.MUS_MEASURE_BUST), "number");

let body = muslin.bodyCreate(context, tape);
let pattern = muslin.designDraft(context, muslin.designFind("skirt"), tape, { ease: 0.02 });
assert.equal(pattern.name(), "skirt");
const text = pattern.writeBytes(); // of libmuslin-exchange
assert.equal(muslin.patternReadFrom(context, text.toString(), text.length, "skirt.json").panelCount(), 2);
assert.equal(muslin.sheetCreate(context, pattern).writePdfBytes().toString("latin1", 0, 5), "%PDF-");

let cloth = muslin.clothCreate(context, pattern, { spacing: 0.04 });
let drape = muslin.drapeCreate(context, cloth, body, { progress_seconds: 0 });
drape.place();
assert.throws(() => drape.sew(() => { throw new RangeError("mine"); }), RangeError);
const sewing = drape.sewAsync(() => true);
assert.throws(() => drape.nodeCount(), /await it first/);
muslin.tapeCreate(muslin.contextCreate()).destroy(); // another context is free
await assert.rejects(sewing, { code: "MUS_ERR_STOPPED" });
await assert.rejects(drape.stepAsync("one", {})); // no number: the call does not begin, and the context stays free
assert.ok(drape.nodeCount() > 0);
let told;
drape.sew((at) => { told = at; });
assert.ok(told.nodes > 0 && told.phase);
const positions = muslin.doubles(drape.positions(), 3 * drape.nodeCount());
assert.ok(positions.every(Number.isFinite));
const options = { spacing: 0.04, progress_seconds: 0, progress: () => true };
assert.throws(() => muslin.dress(context, pattern, body, options), { code: "MUS_ERR_STOPPED" });
const normals = new Float64Array(positions.length); // C writes into it
drape.normals(normals);
assert.ok(normals.some((x) => x !== 0));

cloth.destroy(); // at once; the rest by the collector
assert.throws(() => cloth.nodeCount(), /destroyed/);
tape = body = pattern = cloth = drape = null;
for (let i = 0; i < 20 && muslin.contextBytes(context) > 0; i += 1) {
    global.gc();
    await new Promise((resolve) => setTimeout(resolve, 5));
}
assert.equal(Number(muslin.contextBytes(context)), 0);
let last = muslin.tapeCreate(context);
context.destroy();
last.setSize("W40");
last.destroy();
