// browser.js: the package in a browser or its worker; a bundler copies muslin.wasm, whose address stands here
import { Room } from "./room.js";

export { MuslinError, Room } from "./room.js";

export async function open() {
    return Room.open(await WebAssembly.compileStreaming(fetch(new URL("muslin.wasm", import.meta.url))));
}
