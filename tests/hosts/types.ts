// types.ts: what a TypeScript program may and may not write; it is checked and never run
import muslin, { MuslinError, type mus_progress } from "./index.js";
const context = muslin.contextCreate();
const tape = muslin.tapeCreate(context);
tape.setSize("W40");
tape.complete();
const body = muslin.bodyCreate(context, tape);
const pattern = muslin.designDraft(context, muslin.designFind("tshirt"), tape);
const options = { spacing: 0.02, progress: (at: mus_progress) => at.progress > 2 };
const [cloth, drape] = await muslin.dressAsync(context, pattern, body, options);
const n: number = cloth.nodeCount();
const x: Float64Array = muslin.doubles(drape.positions(), 3 * n);
const report = muslin.create("drape_report");
drape.reportGet(report);
const pdf: Buffer = muslin.sheetCreate(context, pattern).writePdfBytes();
const hash: bigint = drape.hash();
try {
    muslin.tapeCreate(context).set(0, 1, muslin.MUS_SOURCE_GIVEN);
} catch (error) {
    if (error instanceof MuslinError) console.error(error.code);
}
// @ts-expect-error a number is no size
tape.setSize(40);
