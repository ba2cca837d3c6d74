// view.js: the page's side of the picture. A worker (scene.js) draws its canvas, so that the controls never wait for a
// picture, which without a graphics card takes the processor as long as a drape.
const EVENTS = ["pointerdown", "pointermove", "pointerup", "pointercancel", "wheel", "keydown", "contextmenu"];
const SENT = ["type", "button", "pointerId", "pointerType", "deltaY", "deltaMode", "key", "code"],
    HELD = ["ctrlKey", "metaKey", "shiftKey"];

export class View {
    constructor(canvas) {
        this.frame = 0; // mean time that the last frames took to be drawn [ms]
        this.waiting = new Map();
        this.id = 0;
        this.worker = new Worker("scene.js", { type: "module" });
        this.worker.onmessage = ({ data }) => {
            if (data.frame) this.frame = this.frame ? (3 * this.frame + data.frame) / 4 : data.frame;
            else {
                this.waiting.get(data.id)(data.bytes);
                this.waiting.delete(data.id);
            }
        };
        const offscreen = canvas.transferControlToOffscreen();
        this.worker.postMessage({ call: "open", canvas: offscreen, density: devicePixelRatio }, [offscreen]);
        const give = (event) => this.give(canvas, event);
        for (const type of EVENTS) canvas.addEventListener(type, give, { passive: false });
        new ResizeObserver(() => {
            const { clientWidth: width, clientHeight: height } = canvas;
            this.worker.postMessage({ call: "resize", width, height, density: devicePixelRatio });
        }).observe(canvas);
    }

    // An event goes on to the worker, by places within the canvas
    give(canvas, event) {
        if (event.type === "pointermove" && !canvas.hasPointerCapture(event.pointerId)) return;
        if (event.type === "pointerdown") canvas.setPointerCapture(event.pointerId);
        if (event.type === "wheel" || event.type === "contextmenu" || event.code?.startsWith("Arrow"))
            event.preventDefault();
        const { left, top } = canvas.getBoundingClientRect(),
            x = event.clientX - left,
            y = event.clientY - top;
        const sent = Object.fromEntries([...SENT, ...HELD].map((name) => [name, event[name]]));
        this.worker.postMessage({ call: "event", event: { ...sent, clientX: x, clientY: y, pageX: x, pageY: y } });
    }

    // body and cloth: meshes, which are given away, or null for the one that is shown; paint: colour, number of the fit
    // map, its values
    show(body, cloth, paint) {
        const lent = [body, cloth].filter(Boolean).flatMap((mesh) => Object.values(mesh).map((data) => data.buffer));
        this.worker.postMessage({ call: "show", body, cloth, paint }, lent);
    }

    move(moving) {
        this.worker.postMessage({ call: "move", moving });
    }

    // the picture as a binary glTF file
    glb() {
        return new Promise((done) => {
            this.waiting.set(++this.id, done);
            this.worker.postMessage({ call: "glb", id: this.id });
        });
    }
}
