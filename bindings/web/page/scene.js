// scene.js: the worker that draws body and garment, in three.js: turned by hand or arrow keys, coloured plain or by a
// fit map. view.js, on the page's side, sends it the canvas, its size, the events of the hand, and what is to be shown.
import {
    AmbientLight,
    BufferAttribute,
    BufferGeometry,
    Color,
    DirectionalLight,
    DoubleSide,
    DynamicDrawUsage,
    EventDispatcher,
    Mesh,
    MeshLambertMaterial,
    MeshStandardMaterial,
    PerspectiveCamera,
    Scene,
    Vector3,
    WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { GLTFExporter } from "three/examples/jsm/exporters/GLTFExporter.js";
import { RANGES } from "./ranges.js";

const LOW = new Color("#2b5fc4"),
    MIDDLE = new Color("#f4f4f0"),
    HIGH = new Color("#c4362b");

// whether pictures are drawn by the processor, which also computes the garment
function drawnBySoftware() {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2"),
        names = gl?.getExtension("WEBGL_debug_renderer_info"),
        name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software/i.test(name);
}

// Share of the samples each way while a hand moves and the processor draws; chosen: a quarter of the samples is left,
// and a picture that follows is worth more than its edges
const MOVING = 0.5;

const equal = (a, b) => {
    let i = 0;
    while (i < a.length && a[i] === b[i]) i++;
    return i === a.length;
};

// An attribute keeps its place on the graphics card as long as its length does; what is there already is not sent anew
function put(geometry, name, data, width) {
    const old = name === "index" ? geometry.index : geometry.getAttribute(name);
    if (old?.array.length === data.length) {
        if (equal(old.array, data)) return;
        old.array.set(data);
        old.needsUpdate = true;
        return;
    }
    if (old) geometry.dispose();
    const made = new BufferAttribute(data, width);
    made.setUsage(DynamicDrawUsage);
    if (name === "index") geometry.setIndex(made);
    else geometry.setAttribute(name, made);
}

// What OrbitControls asks of an element: its size, and the events that view.js sends
class Hand extends EventDispatcher {
    style = {};
    clientWidth = 1;
    clientHeight = 1;
    getRootNode = () => this;
    getBoundingClientRect = () => ({ left: 0, top: 0, width: this.clientWidth, height: this.clientHeight });
    setPointerCapture() {}
    releasePointerCapture() {}
    give(event) {
        this.dispatchEvent({ ...event, preventDefault() {}, stopPropagation() {} });
    }
}

class Dressed {
    // density: pixels of the screen in each of the canvas's
    constructor(canvas, density) {
        // edges are smoothed where that is cheap and seen: four samples a pixel double the time of the processor
        this.software = drawnBySoftware();
        this.moving = false; // a hand moves a measure: the next picture comes soon
        this.density = density;
        this.hand = new Hand();
        this.renderer = new WebGLRenderer({ canvas, antialias: density < 2 && !this.software, alpha: true });
        this.timed = -Infinity; // when a frame was measured last [ms]
        this.camera = new PerspectiveCamera(30, 1, 0.05, 30);
        this.camera.position.set(1.5, 1.2, 3.6);
        this.scene = new Scene();
        const lamp = new DirectionalLight(0xffffff, 2.2);
        this.camera.add(lamp);
        lamp.position.set(0.6, 1, 1);
        this.scene.add(new AmbientLight(0xffffff, 1.1), this.camera);
        // no highlights: muslin and skin have nearly none, and the pixels cost half of a standard material's
        const material = (options) => new MeshLambertMaterial(options);
        this.body = new Mesh(new BufferGeometry(), material({ color: 0xcbb8a9 }));
        this.cloth = new Mesh(
            new BufferGeometry(),
            material({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1 }),
        );
        this.body.name = "body";
        this.cloth.name = "garment";
        for (const mesh of [this.body, this.cloth]) {
            mesh.frustumCulled = false;
            this.scene.add(mesh);
        }
        this.controls = new OrbitControls(this.camera, this.hand);
        this.controls.target = new Vector3(0, 0.95, 0);
        this.controls.listenToKeyEvents(this.hand);
        this.controls.keyRotateSpeed = 3;
        this.controls.addEventListener("change", () => this.draw());
        this.controls.update();
    }

    // arrow keys turn; with shift, as OrbitControls has it, they move
    key(event) {
        const turn = { ArrowLeft: 1, ArrowRight: -1 }[event.code];
        if (!turn || event.shiftKey) return this.hand.give(event);
        this.camera.position
            .sub(this.controls.target)
            .applyAxisAngle(new Vector3(0, 1, 0), 0.1 * turn)
            .add(this.controls.target);
        this.controls.update();
    }

    // width and height of the canvas [its pixels]
    resize(width, height, density) {
        this.hand.clientWidth = width;
        this.hand.clientHeight = height;
        this.density = Math.min(density, 2);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.sample();
    }

    sample() {
        const { clientWidth: width, clientHeight: height } = this.hand;
        this.renderer.setPixelRatio(this.density * (this.moving && this.software ? MOVING : 1));
        this.renderer.setSize(width, height, false);
        this.draw();
    }

    // whether a hand moves a measure; the sharp picture is drawn when it rests
    move(moving) {
        if (this.moving === moving) return;
        this.moving = moving;
        if (this.software) this.sample();
    }

    draw() {
        cancelAnimationFrame(this.waiting);
        this.waiting = requestAnimationFrame(() => {
            this.renderer.render(this.scene, this.camera);
            this.time();
        });
    }

    // Measure how long the graphics card, or the processor in its place, is at the frame that was just given to it: of a
    // frame each half second.
    time() {
        const gl = this.renderer.getContext(),
            start = performance.now();
        if (this.timing || start - this.timed < 500) return;
        this.timing = true;
        this.timed = start;
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        const look = () => {
            if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return setTimeout(look, 4);
            gl.deleteSync(fence);
            const taken = performance.now() - start;
            postMessage({ frame: taken });
            this.timing = false;
        };
        setTimeout(look, 4);
    }

    show(mesh, { positions, normals, triangles, rest }) {
        const geometry = mesh.geometry;
        put(geometry, "index", triangles, 1);
        put(geometry, "position", positions, 3);
        if (normals) put(geometry, "normal", normals, 3);
        else geometry.computeVertexNormals();
        if (rest) put(geometry, "uv", rest, 2);
    }

    // values: of each node, which: as in RANGES; null for the plain colour
    paint(colour, which, values) {
        const { material, geometry } = this.cloth,
            plain = !values || !RANGES[which];
        material.color.set(plain ? colour : "#ffffff");
        if (material.vertexColors === plain) material.needsUpdate = true;
        material.vertexColors = !plain;
        if (plain) return geometry.deleteAttribute("color");
        const [low, high] = RANGES[which],
            data = new Float32Array(3 * values.length),
            mixed = new Color();
        values.forEach((value, i) => {
            const share = Math.min(1, Math.max(0, ((Number.isNaN(value) ? high : value) - low) / (high - low)));
            mixed.lerpColors(
                share < 0.5 ? LOW : MIDDLE,
                share < 0.5 ? MIDDLE : HIGH,
                share < 0.5 ? 2 * share : 2 * share - 1,
            );
            mixed.toArray(data, 3 * i);
        });
        put(geometry, "color", data, 3);
    }

    async glb() {
        // glTF has no Lambert material
        const meshes = [this.body, this.cloth].map((mesh) => {
            const { color, side, vertexColors } = mesh.material,
                twin = new Mesh(
                    mesh.geometry,
                    new MeshStandardMaterial({ color, side, vertexColors, roughness: 0.85, metalness: 0 }),
                );
            twin.name = mesh.name;
            return twin;
        });
        return new Uint8Array(await new GLTFExporter().parseAsync(meshes, { binary: true }));
    }
}

let view;
const calls = {
    open: ({ canvas, density }) => (view = new Dressed(canvas, density)),
    resize: ({ width, height, density }) => view.resize(width, height, density),
    event: ({ event }) => (event.type === "keydown" ? view.key(event) : view.hand.give(event)),
    move: ({ moving }) => view.move(moving),
    // body and cloth: meshes, or null for the one that is there
    show({ body, cloth, paint }) {
        if (body) view.show(view.body, body);
        if (cloth) view.show(view.cloth, cloth);
        if (paint) view.paint(paint.colour, paint.map, paint.values);
        view.draw();
    },
    async glb({ id }) {
        const bytes = await view.glb();
        postMessage({ id, bytes }, [bytes.buffer]);
    },
};
onmessage = ({ data }) => calls[data.call](data);
