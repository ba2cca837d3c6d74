// ranges.js: what the colours of a fit map span: least, largest, unit, and its factor. By the number of the map.
export const RANGES = {
    1: [-0.05, 0.05, "%", 100],
    2: [-0.05, 0.05, "%", 100],
    3: [0, 500, " Pa", 1],
    4: [0, 0.1, " cm", 100],
};
