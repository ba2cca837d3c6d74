// index.js: the C interface of muslin for Node. It reads muslin_abi.json, so that it knows every function.
//
// muslin.designDraft is mus_design_draft, and tape.setSize is mus_tape_set_size. Beyond the plain C call
//   * a status that is not MUS_OK is thrown as a MuslinError with status, code and the library's sentence;
//   * objects that C gives through pointers (mus_tape **out) are results, and are freed by the collector or destroy();
//   * bytes that C gives (char **bytes, size_t *size) are a Buffer;
//   * an object stands for options: { spacing: 0.02 } is a mus_dress_def with its defaults and this spacing;
//   * a function stands for a progress function: true stops the run.
// Each function has a twin that runs off the main thread: await muslin.dressAsync(...). Constants are muslin.MUS_*.
import { existsSync, readFileSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import koffi from "koffi";

const here = dirname(fileURLToPath(import.meta.url));

// ---- the description and the libraries ----

function readAbi() {
    const tried = [process.env.MUSLIN_ABI_JSON, join(here, "../abi/muslin_abi.json"), join(here, "muslin_abi.json"),
                   "/usr/local/share/muslin/muslin_abi.json", "/usr/share/muslin/muslin_abi.json"].filter(Boolean);
    const path = tried.find((file) => existsSync(file));
    if (!path) throw new Error(`muslin_abi.json was not found: ${tried.join(", ")}`);
    return JSON.parse(readFileSync(path, "utf8"));
}

// MUSLIN_LIB (file or folder), the build folder of the repository, the system's libraries
const opened = {};
function library(name) {
    if (opened[name]) return opened[name];
    const named = process.env.MUSLIN_LIB;
    const folder = named ? (statSync(named).isDirectory() ? named : dirname(named)) : join(here, "../../build/lib");
    const path = join(folder, `${name}.so`);
    return (opened[name] = koffi.load(named || existsSync(path) ? path : `${name}.so.${abi.abi}`));
}

const abi = readAbi();
const camel = (text) => text.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const kindOf = (type) => type.replace(/\bconst\b|\*/g, "").trim();
const stars = (type) => type.split("*").length - 1;
const handles = new Set(abi.handles);

// ---- types: numbers are passed as typed arrays, handles as pointers, structs as objects ----

for (const name of abi.handles) koffi.opaque(name);
koffi.alias("mus_status", "int32_t");
for (const name of Object.keys(abi.callbacks)) koffi.alias(name, "void *");
for (const [name, struct] of Object.entries(abi.structs)) {
    const fields = {};
    for (const { name: field, type, array = [] } of struct.fields) {
        let made = type.startsWith("const char *") ? "str" : stars(type) ? "void *" : kindOf(type);
        for (const length of array.toReversed?.() ?? [...array].reverse()) {
            made = type === "char" ? koffi.array("char", length, "String") : koffi.array(made, length);
        }
        fields[field] = made;
    }
    if (koffi.sizeof(koffi.struct(name, fields)) !== struct.size) throw new Error(`${name} has another size here`);
}
const progressType = koffi.pointer(koffi.proto("int32_t mus_progress_call(void *user, void *progress)"));

function argumentType(type) {
    const kind = kindOf(type);
    if (type === "const char *") return "str";
    if (handles.has(kind) && stars(type) === 2) return koffi.out(koffi.pointer(kind, 2));
    if (handles.has(kind)) return koffi.pointer(kind);
    if (abi.structs[kind] && stars(type) === 1) {
        return type.startsWith("const") ? koffi.pointer(kind) : koffi.inout(koffi.pointer(kind));
    }
    if (type === "char **") return koffi.out(koffi.pointer("void *"));
    return stars(type) ? "void *" : kind;
}

const natives = {};
function native(name) {
    const { library: file, result, arguments: list } = abi.functions[name];
    const back = result === "const char *" ? "str" : stars(result) ? "void *" : result;
    return (natives[name] ??= library(file).func(name, back, list.map(({ type }) => argumentType(type))));
}

// ---- errors, and objects with their contexts ----

export class MuslinError extends Error {
    constructor(status, text) {
        super(text);
        this.name = "MuslinError";
        this.status = status;
        this.code = native("mus_status_name")(status);
    }
}

function check(status, state) {
    if (status === 0) return;
    const text = state ? native("mus_context_error")(state.context) : "";
    throw new MuslinError(status, text || native("mus_status_text")(status));
}

// the context is freed after the last of its objects, in whatever order the collector ends them; what ends while a
// call runs off the main thread waits for that call
function release(held) {
    const { destroy, pointer, state } = held;
    if (state.waiting) return void state.waiting.push(held);
    if (destroy) destroy(pointer);
    if (--state.count === 0) native("mus_context_destroy")(state.context);
}
const registry = new FinalizationRegistry(release);

class Handle {
    #held;
    constructor(held) {
        this.#held = held;
        held.state.count += 1;
        registry.register(this, held, this);
    }
    static held(object) {
        if (!object.#held) throw new Error("this object is destroyed");
        return object.#held;
    }
    destroy() {
        if (!this.#held) return;
        registry.unregister(this);
        release(this.#held);
        this.#held = undefined;
    }
    [Symbol.dispose ?? Symbol("dispose")]() {
        this.destroy();
    }
}

const classes = {};
for (const kind of abi.handles) {
    const name = camel(kind.slice(3));
    classes[kind] = { [name]: class extends Handle {} }[name];
}

function own(kind, pointer, state) {
    if (!pointer) return null;
    if (kind === "mus_context") return new classes[kind]({ pointer, state: { context: pointer, count: 0 } });
    return new classes[kind]({ pointer, state, destroy: native(`${kind}_destroy`) });
}

// ---- calls ----

const muslin = { MuslinError, ...abi.constants, sizeof: koffi.sizeof };

// options or a report: the struct with its defaults, then `fields`: muslin.create("drape_report")
muslin.create = (name, fields = {}) => {
    const made = {};
    native(`mus_${name}_init`)(made, koffi.sizeof(`mus_${name}`));
    return Object.assign(made, fields);
};
// copies of arrays that the library owns
muslin.doubles = (pointer, n) => new Float64Array(koffi.view(pointer, 8 * n).slice(0));
muslin.ints = (pointer, n) => new Int32Array(koffi.view(pointer, 4 * n).slice(0));

function progressHook(progress, call) {
    return koffi.register((_, at) => {
        try {
            return progress(koffi.decode(at, "mus_progress")) ? 1 : 0;
        } catch (error) {
            call.raised ??= { error };
            return 1;
        }
    }, progressType);
}

// what C gets for the arguments of a call, and how to read what it gives
function prepare(name, given) {
    const { result, arguments: list } = abi.functions[name];
    const call = { values: [], made: [], hooks: [], given }; // `given`: objects stay alive during the call
    const hook = (value) => call.hooks[call.hooks.push(progressHook(value, call)) - 1];
    given = [...given];
    for (const { type } of list) {
        const kind = kindOf(type);
        if (result === "mus_status" && (type === "char **" || (handles.has(kind) && stars(type) === 2))) {
            const out = [null];
            call.made.push({ kind, out });
            call.values.push(out);
            continue;
        }
        if (type === "size_t *" && call.made.at(-1)?.kind === "char") {
            call.values.push((call.made.at(-1).size = new BigUint64Array(1)));
            continue;
        }
        let value = given.shift() ?? null;
        if (value instanceof Handle) {
            const held = Handle.held(value);
            call.state ??= held.state;
            if (held.state.waiting) throw new Error("another call runs with this context: await it first");
            value = held.pointer;
        } else if (type === "mus_progress_fn" && value) {
            value = hook(value);
        } else if (value && type.startsWith("const") && abi.structs[kind]) {
            if (value.size === undefined) value = muslin.create(kind.slice(4), value);
            if (typeof value.progress === "function") value = { ...value, progress: hook(value.progress) };
        }
        call.values.push(value);
    }
    return call;
}

// after a call, also one that koffi refused: the context is free again, what ended meanwhile goes
function end(call) {
    call.given.length = 0; // koffi keeps its last callback, which must not keep them
    const ended = call.state?.waiting ?? [];
    if (call.state) call.state.waiting = null;
    ended.forEach(release);
    call.hooks.forEach((one) => koffi.unregister(one));
}

function finish(name, call, back) {
    const { result } = abi.functions[name];
    const made = call.made.map(({ kind, out, size }) => {
        if (kind !== "char") return own(kind, out[0], call.state);
        const bytes = out[0] && Buffer.from(koffi.view(out[0], Number(size[0])).slice(0));
        if (out[0]) native("mus_context_alloc")(call.state.context, out[0], 0);
        return bytes;
    });
    if (call.raised) throw call.raised.error;
    if (result === "uint64_t") return BigInt(back);
    if (result !== "mus_status") return back;
    check(back, call.state);
    return made.length > 1 ? made : made[0];
}

function now(name, given) {
    const call = prepare(name, given);
    let back;
    try {
        back = native(name)(...call.values);
    } finally {
        end(call);
    }
    return finish(name, call, back);
}

function later(name, given) {
    return new Promise((resolve, reject) => {
        const call = prepare(name, given);
        if (call.state) call.state.waiting = [];
        try {
            native(name).async(...call.values, (error, back) => {
                try {
                    end(call);
                    if (error) throw error;
                    resolve(finish(name, call, back));
                } catch (failure) {
                    reject(failure);
                }
            });
        } catch (failure) {
            end(call);
            throw failure;
        }
    });
}

for (const [name, { arguments: list }] of Object.entries(abi.functions)) {
    if (name.endsWith("_destroy")) continue; // object.destroy()
    const kind = abi.handles.find((handle) => name.startsWith(`${handle}_`) && kindOf(list[0]?.type ?? "") === handle);
    for (const [run, suffix] of [[now, ""], [later, "Async"]]) {
        muslin[camel(name.slice(4)) + suffix] = (...given) => run(name, given);
        if (!kind) continue;
        classes[kind].prototype[camel(name.slice(kind.length + 1)) + suffix] = function (...given) {
            return run(name, [this, ...given]);
        };
    }
}

export default muslin;
