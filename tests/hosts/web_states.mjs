// web_states.mjs WASM ROOM SPACING < pairs: for a design and a size on each line, prints state hash and CPU milliseconds.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [wasm, script, spacing] = process.argv.slice(2);
const { Room } = await import(pathToFileURL(script));
const room = await Room.open(await WebAssembly.compile(readFileSync(wasm)));
for (const line of readFileSync(0, "utf8").trim().split("\n")) {
    const [design, size] = line.split(" "),
        start = process.cpuUsage();
    room.size(size);
    room.body();
    room.draft(design);
    room.sew(Number(spacing));
    console.log(design, size, room.hash, Math.round(process.cpuUsage(start).user / 1000));
}
