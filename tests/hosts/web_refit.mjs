// web_refit.mjs WASM ROOM DESIGN...: what a moved slider costs in WebAssembly: CPU milliseconds of body, draft, cut and
// rest at 20 mm after the bust has grown by a millimetre, medians of 30; a line a design.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [wasm, script, ...designs] = process.argv.slice(2);
const { Room } = await import(pathToFileURL(script));
const room = await Room.open(await WebAssembly.compile(readFileSync(wasm)));
const SPACING = 0.02,
    SKIN = { samples: 16, spacing: 0.04, plain: 1 }, // as the page has while a hand moves
    TIMES = 30;
for (const design of designs) {
    const taken = [[], [], [], []];
    const timed = (at, work) => {
        const start = process.cpuUsage().user;
        work();
        taken[at].push((process.cpuUsage().user - start) / 1000);
    };
    room.size("W40");
    room.body(SKIN);
    room.draft(design);
    room.sew(SPACING);
    for (let i = 1; i <= TIMES; i++) {
        room.size("W40");
        room.measure("bust", 0.92 + 0.001 * i);
        timed(0, () => room.body(SKIN));
        timed(1, () => room.draft(design));
        timed(2, () => (room.warm(SPACING), room.clothMesh(), room.bodyMesh()));
        timed(3, () => room.settle());
    }
    const middle = (values) => values.sort((a, b) => a - b)[values.length >> 1].toFixed(1);
    console.log(design, room.c.room_nodes(), ...taken.map(middle));
}
