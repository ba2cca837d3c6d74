// node.js: the package in Node
import { readFile } from "node:fs/promises";
import { Room } from "./room.js";

export { MuslinError, Room } from "./room.js";

export async function open() {
    return Room.open(await WebAssembly.compile(await readFile(new URL("muslin.wasm", import.meta.url))));
}
