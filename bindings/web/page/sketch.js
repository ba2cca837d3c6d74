// sketch.js: the pieces of a pattern as a small picture: one path of SVG, the pieces in rows.

const GAP = 4; // between pieces [cm]

// lines: the text of room_sketch(). Pieces with the text of their path and their box, still where the sheet has them
function pieces(lines) {
    const found = new Map();
    for (const line of lines.trim().split("\n")) {
        const at = line.indexOf(" "),
            number = line.slice(0, at),
            piece = found.get(number) ?? { steps: [], low: [Infinity, Infinity], high: [-Infinity, -Infinity] };
        found.set(number, piece);
        for (const [, op, rest] of line.slice(at + 1).matchAll(/([MLCZ])([^MLCZ]*)/g)) {
            const numbers = rest.trim().split(/\s+/).filter(Boolean).map(Number);
            numbers.forEach((value, i) => {
                piece.low[i % 2] = Math.min(piece.low[i % 2], value);
                piece.high[i % 2] = Math.max(piece.high[i % 2], value);
            });
            // the lines of an outline follow one another: only the first one begins anew
            if (op !== "Z") piece.steps.push([op === "M" && piece.steps.length > 0 ? "L" : op, numbers]);
        }
    }
    return [...found.values()];
}

// The boxes in rows of at most `wide`: their places, and the size of all
function rows(all, wide) {
    const size = [0, 0],
        places = [];
    let x = 0,
        row = 0;
    for (const { low, high } of all) {
        const w = high[0] - low[0];
        if (x > 0 && x + w > wide) (size[1] += row + GAP), (x = row = 0);
        places.push([x, size[1]]);
        x += w + GAP;
        size[0] = Math.max(size[0], x - GAP);
        row = Math.max(row, high[1] - low[1]);
    }
    size[1] += row;
    return { places, size };
}

// The picture that fills a square best: { size: [width, height], path }, in cm
export function sketch(lines) {
    const all = pieces(lines);
    let best = null;
    for (let wide = 20; wide < 600; wide *= 1.1) {
        const laid = rows(all, wide);
        if (best === null || Math.max(...laid.size) < Math.max(...best.size)) best = laid;
    }
    const told = all.map(({ steps, low }, i) => {
        const moved = (value, axis) => (value - low[axis] + best.places[i][axis]).toFixed(1);
        return `${steps.map(([op, numbers]) => op + numbers.map((v, k) => moved(v, k % 2)).join(" ")).join("")}Z`;
    });
    return { size: best.size, path: told.join("") };
}
