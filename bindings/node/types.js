// types.js: print index.d.ts, the types of index.js for TypeScript, from muslin_abi.json
import { existsSync, readFileSync } from "node:fs";

const given = process.env.MUSLIN_ABI_JSON;
const beside = new URL("muslin_abi.json", import.meta.url);
const file = given ?? (existsSync(beside) ? beside : new URL("../abi/muslin_abi.json", import.meta.url));
const abi = JSON.parse(readFileSync(file, "utf8"));
const camel = (text) => text.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const kindOf = (type) => type.replace(/\bconst\b|\*/g, "").trim();
const stars = (type) => type.split("*").length - 1;
const className = (kind) => kind.slice(4, 5).toUpperCase() + camel(kind.slice(5));
const ARRAYS = { double: "Float64Array", float: "Float32Array", int32_t: "Int32Array", int64_t: "BigInt64Array",
                 uint64_t: "BigUint64Array", uint8_t: "Uint8Array", size_t: "BigUint64Array", char: "Uint8Array" };

function argument(type) {
    const kind = kindOf(type);
    if (type === "const char *") return "string | null";
    if (type === "mus_progress_fn") return "Progress | null";
    if (abi.handles.includes(kind)) return `${className(kind)} | null`;
    if (abi.structs[kind] && stars(type) === 1) return `${type.startsWith("const") ? `Partial<${kind}>` : kind} | null`;
    if (stars(type)) return stars(type) === 1 && ARRAYS[kind] ? `${ARRAYS[kind]} | Pointer | null` : "Pointer | null";
    return abi.callbacks[kind] ? "Pointer | null" : /64|size_t/.test(kind) ? "number | bigint" : "number";
}

function field({ name, type, array = [] }) {
    const kind = type === "const char *" || (type === "char" && array.length) ? "string | null" :
        type === "mus_progress_fn" ? "Progress | Pointer | null" :
        stars(type) || abi.callbacks[type] ? "Pointer | null" : /64/.test(type) ? "number | bigint" : "number";
    return `${name}: ${type === "char" ? kind : kind + "[]".repeat(array.length)};`;
}

// the arguments that a caller gives, and the result
function signature({ result, arguments: list }, method) {
    const out = (type) => type === "char **" || (abi.handles.includes(kindOf(type)) && stars(type) === 2);
    const status = result === "mus_status";
    const made = status ? list.filter(({ type }) => out(type)) : [];
    const bytes = made.some(({ type }) => type === "char **");
    const inputs = list.filter(({ type }) => !(status && out(type)) && !(bytes && type === "size_t *"));
    const first = (i) => i === 0 && !argument(inputs[0].type).startsWith("Partial"); // what the call is about
    const optional = (i) => !first(i) && inputs.slice(i).every(({ type }) => argument(type).endsWith("null"));
    const texts = inputs.map(({ name, type }, i) => `${name}${optional(i) ? "?" : ""}: ` +
        (first(i) ? argument(type).replace(" | null", "") : argument(type)));
    const kinds = made.map(({ type }) => (type === "char **" ? "Buffer" : className(kindOf(type))));
    const back = status ? (kinds.length > 1 ? `[${kinds.join(", ")}]` : kinds[0] ?? "void") :
        result === "const char *" ? "string | null" : result === "void" ? "void" : result === "uint64_t" ? "bigint" :
        stars(result) ? "Pointer" : /int64_t|size_t/.test(result) ? "number | bigint" : "number";
    return [`(${texts.slice(method ? 1 : 0).join(", ")})`, back];
}

const functions = Object.entries(abi.functions).filter(([name]) => !name.endsWith("_destroy"));
const twins = (name, [list, back]) => [`    ${name}${list}: ${back};`, `    ${name}Async${list}: Promise<${back}>;`];
const options = Object.keys(abi.structs).filter((name) => abi.functions[`${name}_init`]);
console.log([
    `// index.d.ts: muslin ${abi.version}, written by types.js from muslin_abi.json`,
    "export type Pointer = bigint | object;",
    "export type Progress = (at: mus_progress) => boolean | void;",
    "export class MuslinError extends Error {", "    status: number;", "    code: string;", "}",
    ...Object.entries(abi.structs).flatMap(([name, { fields }]) =>
        [`export interface ${name} {`, ...fields.map((one) => `    ${field(one)}`), "}"]),
    ...abi.handles.flatMap((kind) => [
        `export interface ${className(kind)} {`, "    destroy(): void;",
        ...functions.filter(([name, { arguments: list }]) =>
            name.startsWith(`${kind}_`) && kindOf(list[0]?.type ?? "") === kind)
            .flatMap(([name, about]) => twins(camel(name.slice(kind.length + 1)), signature(about, true))), "}"]),
    "export interface Structs {", ...options.map((name) => `    ${name.slice(4)}: ${name};`), "}",
    "declare const muslin: {",
    ...functions.flatMap(([name, about]) => twins(camel(name.slice(4)), signature(about, false))),
    ...Object.entries(abi.constants).map(([name, value]) => `    readonly ${name}: ${value};`),
    "    create<K extends keyof Structs>(name: K, fields?: Partial<Structs[K]>): Structs[K];",
    "    doubles(pointer: Pointer, n: number): Float64Array;",
    "    ints(pointer: Pointer, n: number): Int32Array;",
    "    sizeof(type: string): number;", "    MuslinError: typeof MuslinError;", "};", "export default muslin;",
].join("\n"));
