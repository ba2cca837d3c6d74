// worker.js: one room in a worker. It answers the newest wish; wishes that came before it are dropped.
import { Room } from "./room.js";
import { sketch } from "./sketch.js";

const STOPPED = 19; // MUS_ERR_STOPPED
const HAND = 30; // a moving hand gives the next value within so many milliseconds of a picture
// run of settling [ms] while a hand may still move: each later one has twice the time of the one before
const SLICE = 40;
const FINE_SLICE = 640; // the same of the fine worker, whose runs begin anew
// wishes in a row at most that are shown and not settled: a dragged slider is followed at once, the cloth comes after.
// The next one is settled until its successor is due, for FOLLOW ms at least
const SKIPS = 2,
    FOLLOW = 5;
// the body that is shown, by samples of a ring and distance of rings [m]: while a hand moves, without fingers and toes,
// and when it rests. The cloth lies on the same body in both
const SKIN = { samples: 16, spacing: 0.04, plain: 1 },
    FINE_SKIN = { samples: 32, spacing: 0.025 };
const GROUP_SIZES = [
    [1, "W40"],
    [2, "M50"],
    [4, "C116"],
]; // bit of a group of designs, and the size that its pictures have
let room,
    wish = null,
    busy = false,
    dressed = "",
    shape = "",
    given = 0, // when the last wish was given, since 1970 [ms]
    skipped = 0; // wishes in a row that were shown and not settled, since a newer one was there

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

// Settle in runs, between which the newest wish is looked for; after the first, of `first` ms, a newer wish is waited for.
// A coarse drape is shown after a run when `pause` ms have passed since it was shown last. STOPPED when there is a newer
// wish, else the status.
async function settle(told, pause, first) {
    const start = performance.now();
    let seen = start;
    for (let budget = first || (told.fine ? FINE_SLICE : SLICE); ; ) {
        const end = performance.now() + budget;
        room.onProgress = () => (performance.now() > end ? 1 : 0);
        const status = room.settle();
        room.onProgress = null;
        if (status !== STOPPED) return status;
        if (!told.fine && performance.now() - seen >= pause) {
            meshes({ ...told, rest: false }, false);
            seen = performance.now();
        }
        if (first ? await wished(HAND) : (await turn(), wish !== null)) return STOPPED;
        budget = first ? SLICE : 2 * budget;
        first = 0;
    }
}

async function dress(asked) {
    const start = performance.now();
    const told = { kind: "dressed", id: asked.id, fine: asked.fine };
    const due = 2 * asked.at - given; // the next wish, if the hand keeps its time
    given = asked.at;
    const person = JSON.stringify([asked.person, asked.pose]);
    const newBody = person !== shape || asked.fine;
    tapeOf(asked.person);
    room.body({ ...(asked.fine ? FINE_SKIN : SKIN), pose: asked.pose });
    shape = person;
    room.draft(asked.design);
    const spacing = asked.spacing;
    // the same garment in another size or fabric starts where it hangs; in another pose it is sewn anew
    const kind = `${asked.design} ${asked.pose}`;
    let status = kind === dressed ? room.warm(spacing, asked.fabric) : 1;
    if (status === 0) {
        let first = 0;
        if (!asked.fine) {
            meshes({ ...told, rest: false }, newBody);
            if (skipped === SKIPS) first = Math.max(FOLLOW, due - performance.timeOrigin - performance.now());
            else if (await wished(HAND)) {
                skipped++;
                return;
            }
        }
        skipped = 0;
        status = await settle(told, asked.pause, first);
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

// whether a newer wish comes within `milliseconds`
let wake = null;
function wished(milliseconds) {
    return new Promise((done) => {
        const timer = setTimeout(() => wake(false), milliseconds);
        wake = (come) => {
            clearTimeout(timer);
            wake = null;
            done(come);
        };
    });
}

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
    async open({ module }) {
        room = await Room.open(module);
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
    // the picture of a design in the size of its group
    sketch({ name, groups }) {
        try {
            room.size(GROUP_SIZES.find(([bit]) => groups & bit)[1]);
            room.draft(name);
            postMessage({ kind: "sketch", name, ...sketch(room.sketch()) });
        } catch (error) {
            postMessage({ kind: "sketch", name, text: error.message });
        }
    },
    dress(asked) {
        wish = asked;
        wake?.(true);
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

// what was asked before the module is there waits for it
let opened;
onmessage = async ({ data }) => {
    if (data.call === "open") return (opened = calls.open(data));
    await opened;
    calls[data.call](data);
};
