// scene.js: body and garment in three.js: turned by hand or arrow keys, coloured plain or by a fit map.
import {
    AmbientLight,
    BufferAttribute,
    BufferGeometry,
    Color,
    DirectionalLight,
    DoubleSide,
    DynamicDrawUsage,
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

const LOW = new Color("#2b5fc4"),
    MIDDLE = new Color("#f4f4f0"),
    HIGH = new Color("#c4362b");
export const RANGES = {
    1: [-0.05, 0.05, "%", 100],
    2: [-0.05, 0.05, "%", 100],
    3: [0, 500, " Pa", 1],
    4: [0, 0.1, " cm", 100],
};

// whether pictures are drawn by the processor, which also computes the garment
function drawnBySoftware() {
    const gl = document.createElement("canvas").getContext("webgl2"),
        names = gl?.getExtension("WEBGL_debug_renderer_info"),
        name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software/i.test(name);
}

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

export class Dressed {
    constructor(canvas) {
        // edges are smoothed where that is cheap and seen: four samples a pixel double the time of the processor
        const antialias = devicePixelRatio < 2 && !drawnBySoftware();
        this.renderer = new WebGLRenderer({ canvas, antialias, alpha: true });
        this.canvas = canvas;
        this.frame = 0; // mean time that the last frames took to be drawn [ms]
        this.timed = -Infinity; // when one was measured last [ms]
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
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.target = new Vector3(0, 0.95, 0);
        this.controls.listenToKeyEvents(canvas);
        this.controls.keyRotateSpeed = 3;
        // arrow keys turn; with shift, as OrbitControls has it, they move
        canvas.addEventListener(
            "keydown",
            (event) => {
                const turn = { ArrowLeft: 1, ArrowRight: -1 }[event.key];
                if (!turn || event.shiftKey) return;
                event.stopImmediatePropagation();
                this.camera.position
                    .sub(this.controls.target)
                    .applyAxisAngle(new Vector3(0, 1, 0), 0.1 * turn)
                    .add(this.controls.target);
                this.controls.update();
            },
            true,
        );
        this.controls.addEventListener("change", () => this.draw());
        this.controls.update();
        new ResizeObserver(() => this.resize()).observe(canvas);
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.draw();
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
            this.frame = this.frame ? (3 * this.frame + taken) / 4 : taken;
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
