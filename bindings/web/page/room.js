// room.js: the module room.wasm as a JavaScript object, for the page's workers and for Node.

const decoder = new TextDecoder(),
    encoder = new TextEncoder();

export class MuslinError extends Error {
    constructor(status, text) {
        super(text || `status ${status}`);
        this.status = status;
    }
}

export class Room {
    // module: a WebAssembly.Module. The functions of src/room.c are methods without "room_".
    static async open(module) {
        const room = new Room();
        room.onProgress = null;
        const wasi = {
            clock_time_get: (id, precision, out) => {
                new DataView(room.memory.buffer).setBigUint64(out, BigInt(Math.round(performance.now() * 1e6)), true);
                return 0;
            },
        };
        // everything else of the system is not there: 8 is "bad file descriptor"
        const system = new Proxy(wasi, { get: (own, name) => own[name] ?? (() => 8) });
        const host = { progress: (...told) => (room.onProgress ? room.onProgress(...told) : 0) };
        const imports = Object.fromEntries(WebAssembly.Module.imports(module).map(({ module: from }) => [from, {}]));
        for (const { module: from, name } of WebAssembly.Module.imports(module))
            imports[from][name] = from === "host" ? host[name] : system[name];
        const instance = await WebAssembly.instantiate(module, imports);
        room.c = instance.exports;
        room.memory = instance.exports.memory;
        instance.exports._initialize();
        room.check(room.c.room_open());
        room.measures = room.names("measure");
        return room;
    }

    check(status) {
        if (status !== 0) throw new MuslinError(status, this.read(this.c.room_error()));
    }

    read(at) {
        const memory = new Uint8Array(this.memory.buffer);
        return decoder.decode(memory.subarray(at, memory.indexOf(0, at)));
    }

    write(text) {
        const data = encoder.encode(text);
        const at = this.c.room_text(data.length);
        new Uint8Array(this.memory.buffer).set(data, at);
        return data.length;
    }

    names(noun) {
        const found = [];
        for (let i = 0, at; (at = this.c[`room_${noun}_name`](i)) !== 0; i++) found.push(this.read(at));
        return found;
    }

    designs() {
        const told = (noun, i) => this.read(this.c[`room_design_${noun}`](i));
        return Array.from({ length: this.c.room_design_count() }, (_, i) => ({
            name: told("name", i),
            title: told("title", i),
            family: told("family", i),
            groups: this.c.room_design_groups(i),
        }));
    }

    // numbers of the designs that match a phrase, the best first; none for a phrase that is refused
    search(phrase) {
        this.write(phrase);
        const count = Math.max(0, this.c.room_design_search());
        return [...new Int32Array(this.memory.buffer, this.c.room_design_found(), count)];
    }

    size(name) {
        this.write(name);
        this.check(this.c.room_size());
    }

    tape(text) {
        this.check(this.c.room_tape(this.write(text)));
    }

    measure(name, value) {
        const i = this.measures.indexOf(name);
        if (value === undefined) return this.c.room_measure(i);
        this.check(this.c.room_measure_set(i, value));
    }

    body({ samples = 0, spacing = 0, plain = 0, pose = -1 } = {}) {
        this.check(this.c.room_body(samples, spacing, plain, pose));
    }

    draft(design) {
        this.write(design);
        this.check(this.c.room_draft());
    }

    // the sew lines of the drafted pattern's pieces, as text (see room_sketch in src/room.c)
    sketch() {
        this.check(this.c.room_sketch());
        return decoder.decode(new Uint8Array(this.memory.buffer, this.c.room_bytes(), this.c.room_bytes_size()));
    }

    // form: "pdf", "svg", "json" or "tape"; the bytes as a Uint8Array
    file(form, paper = 0, title = "") {
        this.write(title);
        this.check(this.c.room_write(["pdf", "svg", "json", "tape"].indexOf(form), paper));
        return new Uint8Array(this.memory.buffer, this.c.room_bytes(), this.c.room_bytes_size()).slice();
    }

    // status of a run that may end without rest: the cloth is there all the same
    sew(spacing, fabric = -1) {
        return this.c.room_sew(spacing, fabric);
    }

    warm(spacing, fabric = -1) {
        return this.c.room_warm(spacing, fabric);
    }

    settle() {
        return this.c.room_settle();
    }

    get hash() {
        return BigInt.asUintN(64, this.c.room_hash()).toString(16).padStart(16, "0");
    }

    floats(at, count) {
        return at === 0 ? null : new Float32Array(new Float64Array(this.memory.buffer, at, count));
    }

    indices(at, count) {
        return new Uint32Array(this.memory.buffer, at, count).slice();
    }

    bodyMesh() {
        const n = this.c.room_body_vertices();
        return {
            positions: this.floats(this.c.room_body_positions(), 3 * n),
            normals: this.floats(this.c.room_body_normals(), 3 * n),
            triangles: this.indices(this.c.room_body_triangle(), 3 * this.c.room_body_triangles()),
        };
    }

    clothMesh() {
        const n = this.c.room_nodes();
        return {
            positions: this.floats(this.c.room_positions(), 3 * n),
            normals: this.floats(this.c.room_normals(), 3 * n),
            triangles: this.indices(this.c.room_triangle(), 3 * this.c.room_triangles()),
            rest: this.floats(this.c.room_rest(), 2 * n),
        };
    }

    // strain along the warp (1), along the weft (2), pressure [Pa] (3) or gap [m] (4) at each node
    map(which) {
        return this.floats(this.c.room_map(which), this.c.room_nodes());
    }

    levels() {
        const out = this.c.room_text(64),
            found = [];
        const aligned = (out + 7) & ~7;
        for (let i = 0; i < this.c.room_levels(); i++) {
            const name = this.c.room_level(i, aligned);
            const [body, garment, right] = new Float64Array(this.memory.buffer, aligned, 3);
            found.push({ level: this.read(name), side: right < 0 ? "" : right ? "right" : "left", body, garment });
        }
        return found;
    }
}
