// worker.js: one room in a worker. It answers the newest wish; wishes that came before it are dropped.
import { Room } from "./room.js";

const STOPPED = 19; // MUS_ERR_STOPPED
let room,
    wish = null,
    busy = false,
    dressed = "",
    shape = "";

function meshes(told, body) {
    const cloth = room.clothMesh();
    const message = { ...told, cloth, body: body ? room.bodyMesh() : null };
    const lent = [cloth, message.body]
        .filter(Boolean)
        .flatMap((mesh) => Object.values(mesh).map((data) => data.buffer));
    postMessage(message, lent);
}

function tapeOf(person) {
    if (person.file) room.tape(person.file);
    else room.size(person.size);
    for (const [name, value] of Object.entries(person.measures)) room.measure(name, value);
}

// Settle in runs of 40, 80, 160 ... ms (fine: from 640 on, each run begins anew); between them the newest wish is looked for. False when there is one.
async function settle(told) {
    for (let budget = told.fine ? 640 : 40; ; budget *= 2) {
        const end = performance.now() + budget;
        room.onProgress = () => (performance.now() > end ? 1 : 0);
        const status = room.settle();
        room.onProgress = null;
        if (status !== STOPPED) return status;
        if (!told.fine) meshes({ ...told, rest: false }, false);
        await turn();
        if (wish !== null) return STOPPED;
    }
}

async function dress(asked) {
    const start = performance.now();
    const told = { kind: "dressed", id: asked.id, fine: asked.fine };
    const person = JSON.stringify([asked.person, asked.pose]);
    const newBody = person !== shape || asked.fine;
    tapeOf(asked.person);
    room.body(32, 0.025, asked.pose);
    shape = person;
    room.draft(asked.design);
    const spacing = asked.spacing;
    // the same garment in another size or fabric starts where it hangs; in another pose it is sewn anew
    const kind = `${asked.design} ${asked.pose}`;
    let status = kind === dressed ? room.warm(spacing, asked.fabric) : 1;
    if (status === 0) {
        if (!asked.fine) meshes({ ...told, rest: false }, newBody);
        status = await settle(told);
        if (status === STOPPED) return;
    } else {
        room.onProgress = (phase, share) => {
            postMessage({ kind: "progress", id: asked.id, phase, share });
            return 0;
        };
        status = room.sew(spacing, asked.fabric);
        room.onProgress = null;
    }
    dressed = status === 0 ? kind : "";
    if (room.c.room_nodes() === 0) throw new Error(room.read(room.c.room_reason()) || room.read(room.c.room_error()));
    const made = Object.fromEntries(room.measures.map((name) => [name, room.measure(name)]));
    meshes(
        {
            ...told,
            rest: true,
            status,
            reason: status === 0 ? "" : room.read(room.c.room_reason()),
            made,
            hash: room.hash,
            levels: room.levels(),
            map: asked.map ? room.map(asked.map) : null,
            milliseconds: performance.now() - start,
        },
        newBody,
    );
}

// a turn of the message queue, in which a newer wish can come
const channel = new MessageChannel();
const turn = () =>
    new Promise((done) => {
        channel.port1.onmessage = done;
        channel.port2.postMessage(0);
    });

async function work() {
    if (busy) return;
    busy = true;
    while ((await turn(), wish !== null)) {
        const asked = wish;
        wish = null;
        try {
            await dress(asked);
        } catch (error) {
            dressed = "";
            postMessage({ kind: "failed", id: asked.id, fine: asked.fine, text: error.message });
        }
    }
    busy = false;
}

const calls = {
    async open({ url }) {
        room = await Room.open(await WebAssembly.compileStreaming(fetch(url)));
        postMessage({
            kind: "open",
            designs: room.designs(),
            sizes: room.names("size"),
            fabrics: room.names("fabric"),
            poses: room.names("pose"),
        });
    },
    search({ phrase, id }) {
        postMessage({ kind: "found", id, found: room.search(phrase) });
    },
    dress(asked) {
        wish = asked;
        work();
    },
    file({ form, paper, title, id }) {
        try {
            const bytes = room.file(form, paper, title);
            postMessage({ kind: "file", id, bytes }, [bytes.buffer]);
        } catch (error) {
            postMessage({ kind: "failed", id, text: error.message });
        }
    },
};

onmessage = ({ data }) => calls[data.call](data);
