"""Muslin for Blender: a panel in the sidebar of the 3D view (Muslin) dresses a body.

Dress makes two objects: the body and the garment, with a UV map in metres (the flat pattern), the integer attribute
"panel" and a material. Dress again puts a changed garment where the last one hangs. Walk writes a movement as point
caches (PC2) that a Mesh Cache modifier plays. With a mesh object named as the wearer, that mesh is scanned and dressed.
"""
import math
import os
import struct

import bpy
import muslin
import numpy

KEPT = {}  # name of the garment's object: the last Dressed, for Dress again


def upright(points):
    """Places of muslin (y up, z forward) in Blender's axes (z up, y back)."""
    points = numpy.asarray(points, numpy.float32).reshape(-1, 3)
    return numpy.stack((points[:, 0], -points[:, 2], points[:, 1]), 1)


def make_object(name, positions, triangles):
    """An object with a new mesh; one of that name gets the mesh in place of its own."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(upright(positions).tolist(), [], numpy.asarray(triangles).tolist())
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    old = bpy.data.objects.get(name)
    if old is not None:
        old.data = mesh
        if "muslin" in old.modifiers:
            old.modifiers.remove(old.modifiers["muslin"])  # a movement of the last mesh
        return old
    made = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(made)
    return made


def material(name, colour):
    made = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    made.use_nodes = True
    shader = next(node for node in made.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = (*colour[:3], 1.0)
    shader.inputs["Roughness"].default_value = 0.9
    made.diffuse_color = (*colour[:3], 1.0)
    return made


def show_garment(name, worn, colour):
    """The garment as an object: UV in metres, attribute panel, material."""
    made = make_object(name, worn.drape.positions, worn.cloth.triangles)
    mesh, rest = made.data, numpy.asarray(worn.cloth.rest, numpy.float32)
    corners = numpy.empty(len(mesh.loops), numpy.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    mesh.uv_layers.new(name="pattern_m").data.foreach_set("uv", rest[corners].ravel())
    panel = mesh.attributes.new("panel", "INT", "POINT")
    panel.data.foreach_set("value", numpy.asarray(worn.cloth.node_panels, numpy.int32))
    mesh.materials.append(material(f"{name} cloth", colour))
    return made


def smooth_over(garment, body):
    """Draw the garment between its nodes, which keep off the skin where flat triangles do not: seams joined, each
    triangle as sixteen on a smooth surface, and what is inside of the body put 2 mm outside, as far as nodes keep off.
    These are modifiers; the mesh has the nodes alone."""
    def modifier(name, kind):
        return garment.modifiers.get(name) or garment.modifiers.new(name, kind)

    modifier("muslin seams", "WELD").merge_threshold = 1e-5
    finer, outside = modifier("muslin finer", "SUBSURF"), modifier("muslin outside", "SHRINKWRAP")
    finer.levels, finer.render_levels = 2, 2
    outside.wrap_method, outside.wrap_mode = "TARGET_PROJECT", "OUTSIDE"
    outside.target, outside.offset = body, 0.002


def show_seams(name, worn):
    """The pairs of nodes that seams bring together, as an object of edges in the plane of the pattern [m]."""
    rest = numpy.asarray(worn.cloth.rest)
    mesh = bpy.data.meshes.new(f"{name} seams")
    flat = numpy.column_stack((rest, numpy.zeros(len(rest))))
    mesh.from_pydata(flat.tolist(), numpy.asarray(worn.cloth.pairs).tolist(), [])
    made = bpy.data.objects.get(f"{name} seams") or bpy.data.objects.new(f"{name} seams", mesh)
    made.data = mesh
    if not made.users_collection:
        bpy.context.collection.objects.link(made)
    made.hide_set(True)
    return made


def write_cache(path, frames):
    """A point cache (PC2): header, then the vertices of each frame in the object's axes, float32."""
    with open(path, "wb") as file:
        file.write(struct.pack("<12siiffi", b"POINTCACHE2\0", 1, len(frames[0]), 1.0, 1.0, len(frames)))
        for frame in frames:
            file.write(upright(frame).astype("<f4").tobytes())


def play(thing, path, frames):
    """A Mesh Cache modifier that plays a point cache from frame 1 on."""
    modifier = thing.modifiers.get("muslin") or thing.modifiers.new("muslin", "MESH_CACHE")
    modifier.cache_format, modifier.filepath = "PC2", path  # of the mesh as it is now
    modifier.frame_start = 1.0
    thing.modifiers.move(thing.modifiers.find("muslin"), 0)  # before those that draw between the nodes
    bpy.context.scene.frame_end = max(bpy.context.scene.frame_end, frames)


def body_of(settings):
    """The body of a mesh object in metres, of a tape file, or of a table size."""
    wearer = settings.wearer
    if wearer is not None:
        mesh = wearer.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
        mesh.calc_loop_triangles()
        points = numpy.array([wearer.matrix_world @ vertex.co for vertex in mesh.vertices])
        triangles = numpy.array([triangle.vertices[:] for triangle in mesh.loop_triangles], numpy.int32)
        turned = numpy.stack((points[:, 0], points[:, 2], -points[:, 1]), 1)
        return muslin.scan(turned, triangles, up="y", front="z", unit=1.0)[0]
    return muslin.Body(bpy.path.abspath(settings.tape) or settings.size, samples=48, ring_spacing=0.02)


class Settings(bpy.types.PropertyGroup):
    design: bpy.props.StringProperty(name="Design", default="tshirt", description="A design, or words: dress neck=v")
    pattern: bpy.props.StringProperty(name="or pattern", subtype="FILE_PATH")
    size: bpy.props.StringProperty(name="Size", default="W40")
    tape: bpy.props.StringProperty(name="or tape", subtype="FILE_PATH")
    wearer: bpy.props.PointerProperty(name="or mesh", type=bpy.types.Object, poll=lambda _, thing: thing.type == "MESH")
    fabric: bpy.props.StringProperty(name="Fabric", default="")
    spacing: bpy.props.FloatProperty(name="Mesh [mm]", default=20.0, min=5.0, max=50.0)
    colour: bpy.props.FloatVectorProperty(name="Colour", subtype="COLOR", default=(0.09, 0.19, 0.40), min=0, max=1)
    pose: bpy.props.StringProperty(name="Pose", default="")
    movement: bpy.props.StringProperty(name="Movement", default="walk")
    frames: bpy.props.IntProperty(name="Frames", default=48, min=2, max=2000)


class Operator:
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            self.run(context.scene.muslin)
        except (muslin.MuslinError, KeyError, ValueError, OSError) as error:
            self.report({"ERROR"}, str(getattr(error, "text", error)))
            return {"CANCELLED"}
        return {"FINISHED"}


class MUSLIN_OT_dress(Operator, bpy.types.Operator):
    """Draft, sew and drape the garment"""
    bl_idname, bl_label = "muslin.dress", "Dress"

    def run(self, settings):
        body = body_of(settings)
        tape = bpy.path.abspath(settings.tape) or settings.size
        pattern = (muslin.Pattern.read(bpy.path.abspath(settings.pattern)) if settings.pattern
                   else muslin.draft(settings.design, tape))
        if settings.pose:
            body = body.posed(body.fit(muslin.Pose(settings.pose)))
        name = f"muslin {pattern.name}"
        worn = self.again(name, pattern, body, settings) or muslin.dress(
            pattern, body, settings.fabric or None, spacing=settings.spacing / 1000)
        KEPT[name] = worn
        if settings.wearer is None:
            skin = make_object("muslin body", body.vertices, body.triangles)
            skin.data.materials.append(material("muslin skin", (0.60, 0.48, 0.40)))
        smooth_over(show_garment(name, worn, settings.colour), settings.wearer or skin)
        show_seams(name, worn)
        self.report({"INFO"}, f"{name}: {len(worn.drape)} nodes, state {worn.drape.state_hash}")

    def again(self, name, pattern, body, settings):
        """The garment from where the last one hangs; None where there is none, or it does not come to rest so."""
        last = KEPT.get(name)
        if last is None or settings.pose or last.pattern.panels != pattern.panels:
            return None
        try:
            cloth = muslin.Cloth(pattern, settings.fabric or None, settings.spacing / 1000)
            drape = muslin.Drape(cloth, body)
            drape.warm(last.drape)
            drape.settle()
        except (muslin.MuslinError, ValueError):
            return None
        last.pattern, last.body, last.cloth, last.drape = pattern, body, cloth, drape
        return last


class MUSLIN_OT_walk(Operator, bpy.types.Operator):
    """Let the body move, and keep body and garment as point caches beside the .blend"""
    bl_idname, bl_label = "muslin.walk", "Walk"

    def run(self, settings):
        name = next(reversed(KEPT), None)
        if name is None:
            raise ValueError("dress the body first")
        worn, scene = KEPT[name], bpy.context.scene
        step, movement = scene.render.fps_base / scene.render.fps, worn.body.move(settings.movement)
        bodies, cloths = [], []
        worn.drape.pose_body(movement.at(0.0), 0.5)
        self.advance(worn.drape, 0.5)
        for frame in range(settings.frames):
            pose = movement.at(frame * step)
            worn.drape.pose_body(pose, step)
            self.advance(worn.drape, step)
            bodies.append(numpy.array(worn.body.posed(pose).vertices))
            cloths.append(numpy.array(worn.drape.positions))
        folder = bpy.path.abspath("//") or bpy.app.tempdir
        for thing, frames in (("muslin body", bodies), (name, cloths)):
            path = os.path.join(folder, f"{thing.replace(' ', '_')}.pc2")
            write_cache(path, frames)
            play(bpy.data.objects[thing], path, settings.frames)
        self.report({"INFO"}, f"{settings.frames} frames in {folder}")

    @staticmethod
    def advance(drape, seconds):
        count = math.ceil(seconds / (0.9 * drape.step_bound))
        drape.step(count, seconds / count)


class MUSLIN_PT_panel(bpy.types.Panel):
    bl_label, bl_category, bl_space_type, bl_region_type = "Muslin", "Muslin", "VIEW_3D", "UI"

    def draw(self, context):
        settings = context.scene.muslin
        for name in ("design", "pattern", "size", "tape", "wearer", "fabric", "colour", "spacing", "pose"):
            self.layout.prop(settings, name)
        self.layout.operator("muslin.dress")
        for name in ("movement", "frames"):
            self.layout.prop(settings, name)
        self.layout.operator("muslin.walk")


CLASSES = (Settings, MUSLIN_OT_dress, MUSLIN_OT_walk, MUSLIN_PT_panel)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.muslin = bpy.props.PointerProperty(type=Settings)


def unregister():
    del bpy.types.Scene.muslin
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
