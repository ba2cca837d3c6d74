// index.d.ts: the package muslin. Lengths are metres, positions x y z with y upwards and z to the front.

/** An error of the library: its status (MUS_ERR_*) and its sentence. */
export class MuslinError extends Error {
    status: number;
}

export interface Design {
    name: string;
    title: string;
    family: string;
    /** bits: 1 women, 2 men, 4 children */
    groups: number;
}

export interface Mesh {
    /** x y z of each vertex [m] */
    positions: Float32Array;
    /** unit normals, x y z of each vertex; null without room for them */
    normals: Float32Array | null;
    /** three vertices a triangle, counter-clockwise from outside */
    triangles: Uint32Array;
}

export interface ClothMesh extends Mesh {
    /** x y of each node in its flat panel [m] */
    rest: Float32Array;
}

/** Girths at a level of the body [m]. */
export interface Level {
    level: string;
    side: "" | "left" | "right";
    body: number;
    garment: number;
}

/** One tape, body, pattern and cloth. Calls run where they are made: in a page, use a worker. */
export class Room {
    static open(module: WebAssembly.Module): Promise<Room>;

    /** Called while cloth moves: phase 0 sewing, 1 settling; share done; number and address of the positions. Nonzero
     * stops the run. */
    onProgress: ((phase: number, share: number, nodes: number, positions: number) => number) | null;
    /** names of all measures */
    readonly measures: string[];
    /** digest of the state of the cloth, equal to the library's on every machine */
    readonly hash: string;

    /** Names in the order of their indices. */
    names(noun: "size" | "fabric" | "pose" | "design" | "measure"): string[];
    designs(): Design[];

    /** Take the tape of a size of the table: "W40", "M50", "C116". */
    size(name: string): void;
    /** Take the tape that a text in the form of muslin_tape(5) holds. */
    tape(text: string): void;
    /** A measure of the tape [m; degrees where it is an angle]; NaN where it is unknown. */
    measure(name: string): number;
    measure(name: string, value: number): void;
    /**
     * Make the body. `samples` round a ring, `spacing` of rings [m], 0: the library's; `plain`: 1 without fingers and
     * toes; `pose`: index, -1: as made.
     */
    body(options?: { samples?: number; spacing?: number; plain?: 0 | 1; pose?: number }): void;
    bodyMesh(): Mesh;

    /** Draft a design by its name or in words. */
    draft(design: string): void;
    /** Write the pattern or the tape. `paper`: MUS_PAPER_*, 0: A4. */
    file(form: "pdf" | "svg" | "json" | "tape", paper?: number, title?: string): Uint8Array;

    /** Cut with `spacing` [m], sew and settle; `fabric`: index, -1: the default. A status other than 0 tells why the
     * garment is not at rest. */
    sew(spacing: number, fabric?: number): number;
    /** Cut anew, and put the cloth where the last one lies. */
    warm(spacing: number, fabric?: number): number;
    /** Let the cloth come to rest. */
    settle(): number;
    clothMesh(): ClothMesh;
    /** At each node: strain along the warp (1), along the weft (2), pressure [Pa] (3), gap [m] (4). */
    map(which: 1 | 2 | 3 | 4): Float32Array | null;
    levels(): Level[];
}

/** The core, ready for a tape. */
export function open(): Promise<Room>;
