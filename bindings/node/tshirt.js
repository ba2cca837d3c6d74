// tshirt.js [DESIGN [SIZE [SPACING_MM]]]: dress a body of a table size and print the hash of the state.
//
//     npm install && node tshirt.js skirt M50 20
import muslin from "./index.js";

const [design = "tshirt", size = "W40", spacing = "10"] = process.argv.slice(2);

const context = muslin.contextCreate();
const tape = muslin.tapeCreate(context);
tape.setSize(size);
tape.complete();
const body = muslin.bodyCreate(context, tape);
const pattern = muslin.designDraft(context, muslin.designFind(design), tape);
const [cloth, drape] = await muslin.dressAsync(context, pattern, body, { spacing: 0.001 * Number(spacing) });

const report = muslin.create("drape_report");
drape.reportGet(report);
console.error(`${design}: ${report.seams_closed} of ${report.seams} seams closed`);
console.log(drape.hash().toString(16).padStart(16, "0"));
