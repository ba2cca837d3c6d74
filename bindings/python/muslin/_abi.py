"""_abi.py: the C interface as ctypes sees it, and nothing else.

Written by bindings/python/generate.py from include/muslin/*.h; do not edit.
"""
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_float, c_int32, c_int64,
                    c_size_t, c_uint64, c_uint8, c_void_p)

VERSION = "0.2.0"

# constants
MUS_VERSION_MAJOR = 0
MUS_VERSION_MINOR = 2
MUS_VERSION_PATCH = 0
MUS_ABI = 1
MUS_NONE = -1
MUS_LOG_ERROR = 0
MUS_LOG_WARNING = 1
MUS_LOG_INFO = 2
MUS_OK = 0
MUS_ERR_ARG = 1
MUS_ERR_MEMORY = 2
MUS_ERR_VERSION = 3
MUS_ERR_STATE = 4
MUS_ERR_LIMIT = 5
MUS_ERR_FILE = 6
MUS_ERR_FORMAT = 7
MUS_ERR_UNSUPPORTED = 8
MUS_ERR_TAPE = 9
MUS_ERR_BODY = 10
MUS_ERR_PATTERN = 11
MUS_ERR_DESIGN = 12
MUS_ERR_MESH = 13
MUS_ERR_STEP = 14
MUS_ERR_DIVERGED = 15
MUS_ERR_SEW = 16
MUS_ERR_UNSETTLED = 17
MUS_ERR_TANGLED = 18
MUS_ERR_STOPPED = 19
MUS_STATUS_COUNT = 20
MUS_LANGUAGE_ENGLISH = 0
MUS_SEX_UNSET = 0
MUS_SEX_FEMALE = 1
MUS_SEX_MALE = 2
MUS_SEX_CHILD = 3
MUS_SOURCE_NONE = 0
MUS_SOURCE_GIVEN = 1
MUS_SOURCE_DERIVED = 2
MUS_MEASURE_STATURE = 0
MUS_MEASURE_BUST = 1
MUS_MEASURE_WAIST = 2
MUS_MEASURE_HIP = 3
MUS_MEASURE_UNDERBUST = 4
MUS_MEASURE_HIGH_BUST = 5
MUS_MEASURE_HIGH_HIP = 6
MUS_MEASURE_NECK = 7
MUS_MEASURE_SHOULDER = 8
MUS_MEASURE_SHOULDER_SLOPE = 9
MUS_MEASURE_ACROSS_BACK = 10
MUS_MEASURE_ACROSS_FRONT = 11
MUS_MEASURE_BACK_WAIST = 12
MUS_MEASURE_FRONT_WAIST = 13
MUS_MEASURE_BUST_DEPTH = 14
MUS_MEASURE_BUST_SPAN = 15
MUS_MEASURE_SCYE_DEPTH = 16
MUS_MEASURE_ARM = 17
MUS_MEASURE_ELBOW = 18
MUS_MEASURE_UPPER_ARM = 19
MUS_MEASURE_WRIST = 20
MUS_MEASURE_HAND = 21
MUS_MEASURE_WAIST_HEIGHT = 22
MUS_MEASURE_WAIST_TO_HIP = 23
MUS_MEASURE_RISE = 24
MUS_MEASURE_INLEG = 25
MUS_MEASURE_CROTCH_LENGTH = 26
MUS_MEASURE_THIGH = 27
MUS_MEASURE_KNEE = 28
MUS_MEASURE_CALF = 29
MUS_MEASURE_ANKLE = 30
MUS_MEASURE_HEAD = 31
MUS_MEASURE_FOOT = 32
MUS_MEASURE_NAPE_HEIGHT = 33
MUS_MEASURE_BUST_HEIGHT = 34
MUS_MEASURE_ARM_ANGLE = 35
MUS_MEASURE_COUNT = 36
MUS_WITHOUT_ARM_LEFT = 1
MUS_WITHOUT_ARM_RIGHT = 2
MUS_WITHOUT_FOREARM_LEFT = 4
MUS_WITHOUT_FOREARM_RIGHT = 8
MUS_WITHOUT_HAND_LEFT = 16
MUS_WITHOUT_HAND_RIGHT = 32
MUS_WITHOUT_LEG_LEFT = 64
MUS_WITHOUT_LEG_RIGHT = 128
MUS_WITHOUT_SHANK_LEFT = 256
MUS_WITHOUT_SHANK_RIGHT = 512
MUS_WITHOUT_FOOT_LEFT = 1024
MUS_WITHOUT_FOOT_RIGHT = 2048
MUS_WITHOUT_ALL = 4095
MUS_LANDMARK_CROWN = 0
MUS_LANDMARK_NAPE = 1
MUS_LANDMARK_BUST = 2
MUS_LANDMARK_WAIST = 3
MUS_LANDMARK_HIP = 4
MUS_LANDMARK_CROTCH = 5
MUS_LANDMARK_SHOULDER_LEFT = 6
MUS_LANDMARK_SHOULDER_RIGHT = 7
MUS_LANDMARK_WRIST_LEFT = 8
MUS_LANDMARK_WRIST_RIGHT = 9
MUS_LANDMARK_ANKLE_LEFT = 10
MUS_LANDMARK_ANKLE_RIGHT = 11
MUS_LANDMARK_COUNT = 12
MUS_JOINT_ROOT = 0
MUS_JOINT_LUMBAR = 1
MUS_JOINT_NECK = 2
MUS_JOINT_SHOULDER_LEFT = 3
MUS_JOINT_SHOULDER_RIGHT = 4
MUS_JOINT_ELBOW_LEFT = 5
MUS_JOINT_ELBOW_RIGHT = 6
MUS_JOINT_WRIST_LEFT = 7
MUS_JOINT_WRIST_RIGHT = 8
MUS_JOINT_HIP_LEFT = 9
MUS_JOINT_HIP_RIGHT = 10
MUS_JOINT_KNEE_LEFT = 11
MUS_JOINT_KNEE_RIGHT = 12
MUS_JOINT_ANKLE_LEFT = 13
MUS_JOINT_ANKLE_RIGHT = 14
MUS_JOINT_COUNT = 15
MUS_POSE_FLEXION = 0
MUS_POSE_ABDUCTION = 1
MUS_POSE_ROTATION = 2
MUS_FOOT_LEFT = 1
MUS_FOOT_RIGHT = 2
MUS_SCAN_FOUND = 0
MUS_SCAN_X = 1
MUS_SCAN_Y = 2
MUS_SCAN_Z = 3
MUS_SCAN_TORSO = 0
MUS_SCAN_HEAD = 1
MUS_SCAN_ARMS = 2
MUS_SCAN_HANDS = 3
MUS_SCAN_LEGS = 4
MUS_SCAN_FEET = 5
MUS_SCAN_PART_COUNT = 6
MUS_SCAN_BUST = 0
MUS_SCAN_WAIST = 1
MUS_SCAN_HIP = 2
MUS_SCAN_THIGH = 3
MUS_SCAN_WRIST = 4
MUS_SCAN_GIRTH_COUNT = 5
MUS_PIECE_LINE = 0
MUS_PIECE_QUADRATIC = 1
MUS_PIECE_CUBIC = 2
MUS_PIECE_ARC = 3
MUS_SEAM_REVERSED = 0
MUS_SEAM_DIRECT = 1
MUS_HOLD_NONE = 0
MUS_HOLD_NECK = 1
MUS_HOLD_ARMPIT = 2
MUS_HOLD_BUST = 3
MUS_HOLD_WAIST = 4
MUS_HOLD_HIP = 5
MUS_HOLD_CROTCH = 6
MUS_HOLD_BICEPS = 7
MUS_HOLD_WRIST = 8
MUS_HOLD_THIGH = 9
MUS_HOLD_KNEE = 10
MUS_HOLD_ANKLE = 11
MUS_HOLD_COUNT = 12
MUS_CLOSURE_NONE = 0
MUS_CLOSURE_ZIP = 1
MUS_CLOSURE_BUTTONS = 2
MUS_CLOSURE_TIES = 3
MUS_NOTCH_SINGLE = 1
MUS_NOTCH_DOUBLE = 2
MUS_NOTCH_TRIPLE = 3
MUS_MATERIAL_MAIN = 0
MUS_MATERIAL_LINING = 1
MUS_MATERIAL_INTERFACING = 2
MUS_MATERIAL_RIB = 3
MUS_MATERIAL_ELASTIC = 4
MUS_MATERIAL_COUNT = 5
MUS_SIDE_FRONT = 1
MUS_SIDE_BACK = 2
MUS_SIDE_LEFT = 4
MUS_SIDE_RIGHT = 8
MUS_LAYERS_MOST = 16
MUS_FAULT_OPEN_OUTLINE = 1
MUS_FAULT_CROSSING = 2
MUS_FAULT_SEAM_LENGTH = 3
MUS_FAULT_TWISTED_SEAM = 4
MUS_FAULT_SEWN_TWICE = 5
MUS_FAULT_SMALL_PANEL = 6
MUS_FAULT_LOOSE_EDGE = 7
MUS_FAULT_LOOSE_PIECE = 8
MUS_FAULT_MIRRORED = 9
MUS_FAULT_MISSING_PIECE = 10
MUS_FAULT_OPENING = 11
MUS_FAULT_CLOSED = 12
MUS_GROUP_WOMEN = 1
MUS_GROUP_MEN = 2
MUS_GROUP_CHILDREN = 4
MUS_EASE_BUST = 0
MUS_EASE_WAIST = 1
MUS_EASE_HIP = 2
MUS_EASE_COUNT = 3
MUS_BEND_PLATE = 0
MUS_BEND_PAPER = 1
MUS_CLOTH_NODES = 1048576
MUS_METHOD_RK4 = 0
MUS_METHOD_VERLET = 1
MUS_METHOD_EULER = 2
MUS_REASON_NONE = 0
MUS_REASON_SETTLED = 1
MUS_REASON_TWISTED_SEAM = 2
MUS_REASON_PANEL_CROSSES = 3
MUS_REASON_SEAM_OPEN = 4
MUS_REASON_START_TANGLED = 5
MUS_REASON_SLID_OFF = 6
MUS_REASON_TANGLED = 7
MUS_REASON_NOT_SETTLED = 8
MUS_REASON_UNSTABLE = 9
MUS_REASON_BAD_INPUT = 10
MUS_REASON_STOPPED = 11
MUS_REASON_NOT_WORN = 12
MUS_REASON_COUNT = 13
MUS_DRESS_PLACE_BOTH = 0
MUS_DRESS_PLACE_PATTERN = 1
MUS_DRESS_PLACE_FOUND = 2
MUS_DRESS_PLACE_RAISED = 3
MUS_DRESS_STARTS_MOST = 8
MUS_FIT_STRAIN = 0
MUS_FIT_WARP = 1
MUS_FIT_WEFT = 2
MUS_FIT_PRESSURE = 3
MUS_FIT_GAP = 4
MUS_WORN_NECK = 0
MUS_WORN_ARM_LEFT = 1
MUS_WORN_ARM_RIGHT = 2
MUS_WORN_LEG_LEFT = 3
MUS_WORN_LEG_RIGHT = 4
MUS_WORN_LIMBS = 5
MUS_WORN_YES = 0
MUS_WORN_UNKNOWN = 1
MUS_WORN_OPENING = 2
MUS_WORN_INSIDE_OUT = 3
MUS_WORN_SHOULDER = 4
MUS_WORN_HOOD = 5
MUS_WORN_LOW = 6
MUS_WORN_ROLLED = 7
MUS_WORN_TIGHT = 8
MUS_WORN_THROUGH = 9
MUS_WORN_COUNT = 10
MUS_PAPER_A4 = 0
MUS_PAPER_LETTER = 1
MUS_PAPER_A3 = 2
MUS_PAPER_A0 = 3
MUS_PAPER_ROLL = 4
MUS_LINE_CUT = 0
MUS_LINE_SEW = 1
MUS_LINE_NOTCH = 2
MUS_LINE_GRAIN = 3
MUS_LINE_MARK = 4
MUS_LINE_LABEL = 5
MUS_DXF_AAMA = 0
MUS_DXF_ASTM = 1
MUS_DXF_CUT = 0
MUS_DXF_SEW = 1
MUS_MESH_OBJ = 0
MUS_MESH_GLB = 1
MUS_MESH_USDA = 2
MUS_MESH_PLY = 3
MUS_MESH_PC2 = 4
MUS_CATALOGUE_READ = 0
MUS_CATALOGUE_WRITE = 1
MUS_DISTANCE_PIECES = 0
MUS_DISTANCE_SEAMS = 1
MUS_DISTANCE_SURFACE = 2
MUS_DISTANCE_OPENINGS = 3
MUS_DISTANCE_PANELS = 4
MUS_DISTANCE_CLOTH = 5
MUS_DISTANCE_COUNT = 6

# names of the lists, by number
STATUS_NAMES = ("OK", "ERR_ARG", "ERR_MEMORY", "ERR_VERSION", "ERR_STATE", "ERR_LIMIT", "ERR_FILE", "ERR_FORMAT",
                "ERR_UNSUPPORTED", "ERR_TAPE", "ERR_BODY", "ERR_PATTERN", "ERR_DESIGN", "ERR_MESH", "ERR_STEP",
                "ERR_DIVERGED", "ERR_SEW", "ERR_UNSETTLED", "ERR_TANGLED", "ERR_STOPPED")
MEASURE_NAMES = ("STATURE", "BUST", "WAIST", "HIP", "UNDERBUST", "HIGH_BUST", "HIGH_HIP", "NECK", "SHOULDER",
                 "SHOULDER_SLOPE", "ACROSS_BACK", "ACROSS_FRONT", "BACK_WAIST", "FRONT_WAIST", "BUST_DEPTH",
                 "BUST_SPAN", "SCYE_DEPTH", "ARM", "ELBOW", "UPPER_ARM", "WRIST", "HAND", "WAIST_HEIGHT",
                 "WAIST_TO_HIP", "RISE", "INLEG", "CROTCH_LENGTH", "THIGH", "KNEE", "CALF", "ANKLE", "HEAD", "FOOT",
                 "NAPE_HEIGHT", "BUST_HEIGHT", "ARM_ANGLE")
JOINT_NAMES = ("ROOT", "LUMBAR", "NECK", "SHOULDER_LEFT", "SHOULDER_RIGHT", "ELBOW_LEFT", "ELBOW_RIGHT", "WRIST_LEFT",
               "WRIST_RIGHT", "HIP_LEFT", "HIP_RIGHT", "KNEE_LEFT", "KNEE_RIGHT", "ANKLE_LEFT", "ANKLE_RIGHT")


# opaque handles, and structs, whose fields stand below


class mus_context(Structure):
    pass


class mus_tape(Structure):
    pass


class mus_body(Structure):
    pass


class mus_move(Structure):
    pass


class mus_manifold(Structure):
    pass


class mus_pattern(Structure):
    pass


class mus_cut_line(Structure):
    pass


class mus_faults(Structure):
    pass


class mus_layout(Structure):
    pass


class mus_cloth(Structure):
    pass


class mus_drape(Structure):
    pass


class mus_fit(Structure):
    pass


class mus_sheet(Structure):
    pass


class mus_mesh(Structure):
    pass


class mus_catalogue(Structure):
    pass


class mus_context_def(Structure):
    pass


class mus_limb(Structure):
    pass


class mus_body_def(Structure):
    pass


class mus_pose(Structure):
    pass


class mus_scan_def(Structure):
    pass


class mus_scan_report(Structure):
    pass


class mus_manifold_def(Structure):
    pass


class mus_edge_def(Structure):
    pass


class mus_seam_def(Structure):
    pass


class mus_placement(Structure):
    pass


class mus_topology(Structure):
    pass


class mus_homology(Structure):
    pass


class mus_form_def(Structure):
    pass


class mus_cut_def(Structure):
    pass


class mus_seam_walk(Structure):
    pass


class mus_layout_def(Structure):
    pass


class mus_layout_item(Structure):
    pass


class mus_layout_piece(Structure):
    pass


class mus_draft_def(Structure):
    pass


class mus_fabric(Structure):
    pass


class mus_cloth_def(Structure):
    pass


class mus_bare(Structure):
    pass


class mus_integrate_def(Structure):
    pass


class mus_reason(Structure):
    pass


class mus_drape_def(Structure):
    pass


class mus_plane(Structure):
    pass


class mus_estimate(Structure):
    pass


class mus_progress(Structure):
    pass


class mus_drape_report(Structure):
    pass


class mus_dress_def(Structure):
    pass


class mus_dress_report(Structure):
    pass


class mus_fit_spread(Structure):
    pass


class mus_fit_level(Structure):
    pass


class mus_worn(Structure):
    pass


class mus_sheet_def(Structure):
    pass


class mus_sheet_piece(Structure):
    pass


class mus_sheet_line(Structure):
    pass


class mus_sheet_dxf(Structure):
    pass


class mus_sheet_plt(Structure):
    pass


class mus_pattern_dxf(Structure):
    pass


class mus_pattern_val(Structure):
    pass


class mus_mesh_view(Structure):
    pass


class mus_mesh_motion(Structure):
    pass


class mus_mesh_file(Structure):
    pass


# callbacks
mus_alloc_fn = CFUNCTYPE(c_void_p, c_void_p, c_void_p, c_size_t, c_size_t)
mus_log_fn = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)
mus_layout_progress_fn = CFUNCTYPE(c_int32, c_void_p, c_double, c_double)
mus_rate_fn = CFUNCTYPE(None, c_void_p, c_double, POINTER(c_double), POINTER(c_double))
mus_rate32_fn = CFUNCTYPE(None, c_void_p, c_double, POINTER(c_float), POINTER(c_float))
mus_energy_fn = CFUNCTYPE(c_double, c_void_p, c_double, POINTER(c_double))
mus_energy32_fn = CFUNCTYPE(c_double, c_void_p, c_double, POINTER(c_float))
mus_progress_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(mus_progress))

# fields of the structs
mus_context_def._fields_ = [("size", c_size_t), ("alloc", mus_alloc_fn), ("alloc_user", c_void_p),
                            ("log", mus_log_fn), ("log_user", c_void_p)]
mus_limb._fields_ = [("size", c_size_t), ("name", c_char_p), ("origin", c_double * 3), ("axis", c_double * 3),
                     ("side", c_double * 3), ("pole", c_double * 2), ("contours", c_int32),
                     ("contour", POINTER(c_double)), ("corners", c_int32), ("outline", POINTER(c_double)),
                     ("joint", c_int32)]
mus_body_def._fields_ = [("size", c_size_t), ("samples", c_int32), ("ring_spacing", c_double), ("ellipse", c_int32),
                         ("without", c_int32), ("limbs", c_int32), ("limb", POINTER(mus_limb)), ("plain", c_int32),
                         ("stoop", c_double), ("head_forward", c_double), ("sway", c_double)]
mus_pose._fields_ = [("size", c_size_t), ("place", c_double * 3), ("angle", c_double * 3 * 15)]
mus_scan_def._fields_ = [("size", c_size_t), ("up", c_int32), ("front", c_int32), ("unit", c_double),
                         ("spacing", c_double), ("corners", c_int32), ("gap", c_double), ("samples", c_int32),
                         ("ring_spacing", c_double), ("distances", c_int32)]
mus_scan_report._fields_ = [("size", c_size_t), ("unit", c_double), ("frame", c_double * 9), ("place", c_double * 3),
                            ("stature", c_double), ("crotch", c_double), ("armpit", c_double * 2),
                            ("arm_angle", c_double * 2), ("vertices", c_int32), ("contours", c_int32),
                            ("holes", c_int32), ("widest_hole", c_double), ("filled", c_int32),
                            ("deepest_fill", c_double), ("girth", c_double * 5), ("girth_height", c_double * 5),
                            ("mesh_to_body", c_double * 3 * 6), ("body_to_mesh", c_double * 3 * 6)]
mus_manifold_def._fields_ = [("size", c_size_t), ("spacing", c_double), ("threads", c_int32)]
mus_edge_def._fields_ = [("size", c_size_t), ("name", c_char_p), ("start", c_int32), ("end", c_int32),
                         ("npiece", c_int32), ("nxy", c_int32), ("kinds", POINTER(c_int32)), ("xy", POINTER(c_double))]
mus_seam_def._fields_ = [("size", c_size_t), ("edge_a", c_int32), ("edge_b", c_int32), ("direction", c_int32),
                         ("ease", c_double), ("tolerance", c_double), ("laid", c_int32), ("closure", c_int32),
                         ("open", c_int32), ("buttons", c_int32)]
mus_placement._fields_ = [("size", c_size_t), ("origin", c_double * 3), ("rotation", c_double * 9),
                          ("bend", c_double), ("bend_x", c_double), ("fold", c_double)]
mus_topology._fields_ = [("size", c_size_t), ("vertices", c_int32), ("edges", c_int32), ("faces", c_int32),
                         ("euler", c_int32), ("components", c_int32), ("loops", c_int32), ("orientable", c_int32),
                         ("manifold", c_int32), ("genus", c_int32)]
mus_homology._fields_ = [("size", c_size_t), ("cells", c_int32 * 3), ("rank", c_int32 * 2), ("betti", c_int32 * 3),
                         ("euler", c_int32), ("torsion", c_int32)]
mus_form_def._fields_ = [("size", c_size_t), ("mirror", c_int32), ("labels", c_int32)]
mus_cut_def._fields_ = [("size", c_size_t), ("name", c_char_p), ("seam_name", c_char_p), ("edge_a", c_int32),
                        ("edge_b", c_int32), ("s_a", c_double), ("s_b", c_double), ("npiece", c_int32),
                        ("nxy", c_int32), ("kinds", POINTER(c_int32)), ("xy", POINTER(c_double))]
mus_seam_walk._fields_ = [("size", c_size_t), ("length_a", c_double), ("length_b", c_double), ("excess", c_double),
                          ("notches_a", c_int32), ("notches_b", c_int32), ("notch_off", c_double),
                          ("corner_start", c_double), ("corner_end", c_double)]
mus_layout_def._fields_ = [("size", c_size_t), ("width", c_double), ("gap", c_double), ("allowance", c_double),
                           ("material", c_int32), ("fold", c_int32), ("nap", c_int32), ("tolerance", c_double),
                           ("stripe", c_double), ("steps", c_int64), ("runs", c_int32), ("threads", c_int32),
                           ("seed", c_uint64), ("progress", mus_layout_progress_fn), ("user", c_void_p)]
mus_layout_item._fields_ = [("size", c_size_t), ("n", c_int32), ("xy", POINTER(c_double)), ("count", c_int32),
                            ("turn_count", c_int32), ("turns", POINTER(c_double))]
mus_layout_piece._fields_ = [("size", c_size_t), ("panel", c_int32), ("name", c_char_p), ("mirrored", c_int32),
                             ("turned", c_int32), ("layers", c_int32), ("on_fold", c_int32), ("spare", c_int32),
                             ("turn", c_double * 4), ("shift", c_double * 2), ("n", c_int32), ("xy", POINTER(c_double))]
mus_draft_def._fields_ = [("size", c_size_t), ("ease", c_double), ("length", c_double), ("sleeve", c_double)]
mus_fabric._fields_ = [("size", c_size_t), ("weight", c_double), ("stretch", c_double * 2), ("shear", c_double),
                       ("bend", c_double * 3), ("damping", c_double), ("friction", c_double), ("thickness", c_double),
                       ("bend_hysteresis", c_double), ("contraction", c_double)]
mus_cloth_def._fields_ = [("size", c_size_t), ("spacing", c_double), ("fabric", POINTER(mus_fabric)),
                          ("bending", c_int32), ("paper_curvature", c_double), ("coarser", c_int32),
                          ("nodes_most", c_int32)]
mus_bare._fields_ = [("size", c_size_t), ("nodes", c_int32), ("springs", c_int32), ("bends", c_int32),
                     ("pins", c_int32), ("place", POINTER(c_double)), ("mass", POINTER(c_double)),
                     ("spring", POINTER(c_int32)), ("length", POINTER(c_double)), ("stiffness", POINTER(c_double)),
                     ("dashpot", POINTER(c_double)), ("bend", POINTER(c_int32)),
                     ("bend_stiffness", POINTER(c_double)), ("pin", POINTER(c_int32))]
mus_integrate_def._fields_ = [("size", c_size_t), ("method", c_int32), ("guard_every", c_int32), ("start", c_double),
                              ("step", c_double), ("rate", mus_rate_fn), ("energy", mus_energy_fn),
                              ("rate32", mus_rate32_fn), ("energy32", mus_energy32_fn), ("energy_growth", c_double),
                              ("energy_floor", c_double), ("user", c_void_p)]
mus_reason._fields_ = [("size", c_size_t), ("kind", c_int32), ("panel", c_int32), ("seam", c_int32),
                       ("node", c_int32), ("count", c_int32), ("value", c_double), ("place", c_double * 3),
                       ("text", c_char * 256)]
mus_drape_def._fields_ = [("size", c_size_t), ("gravity", c_double * 3), ("precision", c_int32), ("threads", c_int32),
                          ("collision_distance", c_double), ("clearance", c_double), ("friction", c_double),
                          ("drag", c_double), ("seam_pull", c_double), ("sew_seconds", c_double),
                          ("settle_seconds", c_double), ("settle_residual", c_double), ("integrator", c_int32),
                          ("contact_ball", c_double), ("self_contact", c_int32), ("thickness", c_double),
                          ("self_friction", c_double), ("sew_once", c_int32), ("progress_seconds", c_double)]
mus_plane._fields_ = [("size", c_size_t), ("point", c_double * 3), ("normal", c_double * 3),
                      ("velocity", c_double * 3), ("spin", c_double), ("friction", c_double), ("reach", c_double)]
mus_estimate._fields_ = [("size", c_size_t), ("step", c_double), ("step_bound", c_double),
                         ("steps_per_frame", c_int32), ("node", c_int32), ("node_mass", c_double),
                         ("node_stiffness", c_double), ("bend_share", c_double), ("seconds", c_double),
                         ("node_evaluations", c_int64)]
mus_progress._fields_ = [("size", c_size_t), ("phase", c_char_p), ("progress", c_double), ("coarse", c_int32),
                         ("nodes", c_int32), ("triangles", c_int32), ("positions", POINTER(c_double)),
                         ("triangle", POINTER(c_int32))]
mus_drape_report._fields_ = [("size", c_size_t), ("nodes", c_int32), ("springs", c_int32), ("seams", c_int32),
                             ("seams_closed", c_int32), ("welded", c_int32), ("worst_seam", c_int32),
                             ("settled", c_int32), ("max_seam_gap", c_double), ("max_penetration", c_double),
                             ("max_strain", c_double), ("residual", c_double), ("max_speed", c_double),
                             ("energy", c_double), ("step", c_double), ("step_bound", c_double), ("steps", c_int64),
                             ("spring_evaluations", c_int64), ("contact_queries", c_int64), ("sew_time", c_double),
                             ("settle_time", c_double), ("step_parts", c_int32), ("rest_distance", c_double),
                             ("contact_impulse", c_double * 3), ("self_contacts", c_int32), ("self_queries", c_int64)]
mus_dress_def._fields_ = [("size", c_size_t), ("spacing", c_double), ("fabric", POINTER(mus_fabric)),
                          ("self_contact", c_int32), ("precision", c_int32), ("threads", c_int32),
                          ("friction", c_double), ("drape", POINTER(mus_drape_def)), ("place", c_int32),
                          ("retry", c_int32), ("open_closures", c_int32), ("progress", mus_progress_fn),
                          ("progress_user", c_void_p), ("progress_seconds", c_double), ("nodes_most", c_int32),
                          ("seconds_most", c_double)]
mus_dress_report._fields_ = [("size", c_size_t), ("found", c_int32), ("starts", c_int32), ("kept", c_int32),
                             ("start_place", c_int32 * 8), ("start_patient", c_int32 * 8), ("start_end", c_int32 * 8),
                             ("start_seconds", c_double * 8), ("place_seconds", c_double), ("cut_seconds", c_double),
                             ("sew_seconds", c_double), ("settle_seconds", c_double)]
mus_fit_spread._fields_ = [("size", c_size_t), ("p50", c_double), ("p95", c_double), ("p99", c_double),
                           ("mean", c_double), ("least", c_double), ("largest", c_double), ("node", c_int32),
                           ("area", c_double)]
mus_fit_level._fields_ = [("size", c_size_t), ("level", c_int32), ("right", c_int32), ("body", c_double),
                          ("garment", c_double), ("worn", c_double), ("ease", c_double), ("gap", c_double)]
mus_worn._fields_ = [("size", c_size_t), ("kind", c_int32), ("limb", c_int32), ("panel", c_int32), ("node", c_int32),
                     ("value", c_double), ("place", c_double * 3), ("through", c_int32), ("through_depth", c_double),
                     ("through_area", c_double), ("through_place", c_double * 3), ("text", c_char * 256)]
mus_sheet_def._fields_ = [("size", c_size_t), ("paper", c_int32), ("allowance", c_double), ("margin", c_double),
                          ("overlap", c_double), ("title", c_char_p), ("person", c_char_p), ("fold", c_int32),
                          ("language", c_char_p), ("notes", c_char_p)]
mus_sheet_piece._fields_ = [("size", c_size_t), ("panel", c_int32), ("name", c_char_p), ("copies", c_int32),
                            ("mirrored", c_int32), ("fold", c_int32), ("turn", c_double * 4), ("shift", c_double * 2),
                            ("box", c_double * 4), ("size_index", c_int32), ("materials", c_int32 * 8)]
mus_sheet_line._fields_ = [("size", c_size_t), ("piece", c_int32), ("kind", c_int32), ("edge", c_int32),
                           ("filled", c_int32), ("op_count", c_int32), ("point_count", c_int32),
                           ("ops", POINTER(c_uint8)), ("points", POINTER(c_double))]
mus_sheet_dxf._fields_ = [("size", c_size_t), ("dialect", c_int32), ("boundary", c_int32), ("size_name", c_char_p),
                          ("date", c_char_p), ("nested", c_int32), ("size_count", c_int32),
                          ("sheets", POINTER(POINTER(mus_sheet))), ("size_names", POINTER(c_char_p))]
mus_sheet_plt._fields_ = [("size", c_size_t), ("hpgl2", c_int32), ("by_piece", c_int32), ("one_pen", c_int32)]
mus_pattern_dxf._fields_ = [("size", c_size_t), ("path", c_char_p), ("text", c_char_p), ("text_size", c_size_t),
                            ("rules_path", c_char_p), ("rules", c_char_p), ("rules_size", c_size_t),
                            ("size_name", c_char_p)]
mus_pattern_val._fields_ = [("size", c_size_t), ("path", c_char_p), ("text", c_char_p), ("text_size", c_size_t),
                            ("measures_path", c_char_p), ("measures", c_char_p), ("measures_size", c_size_t),
                            ("size_name", c_char_p)]
mus_mesh_view._fields_ = [("size", c_size_t), ("name", c_char_p), ("vertex_count", c_int32),
                          ("triangle_count", c_int32), ("positions", POINTER(c_double)),
                          ("normals", POINTER(c_double)), ("texcoords", POINTER(c_double)),
                          ("triangles", POINTER(c_int32)), ("colour", c_double * 4), ("two_sided", c_int32)]
mus_mesh_motion._fields_ = [("size", c_size_t), ("positions", POINTER(c_double)), ("normals", POINTER(c_double))]
mus_mesh_file._fields_ = [("size", c_size_t), ("form", c_int32), ("count", c_int32),
                          ("meshes", POINTER(mus_mesh_view)), ("cloths", POINTER(POINTER(mus_cloth))),
                          ("materials", POINTER(c_char_p)), ("keys", c_int32), ("times", POINTER(c_double)),
                          ("motion", POINTER(mus_mesh_motion))]


# functions: name -> (library, result, arguments)
FUNCTIONS = {
    "mus_status_name": ("core", c_char_p, [c_int32]),
    "mus_status_text": ("core", c_char_p, [c_int32]),
    "mus_version": ("core", None, [POINTER(c_int32)]),
    "mus_context_def_init": ("core", None, [POINTER(mus_context_def), c_size_t]),
    "mus_context_create": ("core", c_int32, [POINTER(mus_context_def), POINTER(POINTER(mus_context))]),
    "mus_context_destroy": ("core", None, [POINTER(mus_context)]),
    "mus_context_error": ("core", c_char_p, [POINTER(mus_context)]),
    "mus_context_bytes": ("core", c_size_t, [POINTER(mus_context)]),
    "mus_context_allocations": ("core", c_uint64, [POINTER(mus_context)]),
    "mus_context_fail": ("core", c_int32, [POINTER(mus_context), c_int32, c_char_p]),
    "mus_context_alloc": ("core", c_void_p, [POINTER(mus_context), c_void_p, c_size_t]),
    "mus_context_log": ("core", None, [POINTER(mus_context), c_int32, c_char_p]),
    "mus_language_count": ("core", c_int32, []),
    "mus_language_tag": ("core", c_char_p, [c_int32]),
    "mus_language_name": ("core", c_char_p, [c_int32]),
    "mus_language_is_right_to_left": ("core", c_int32, [c_int32]),
    "mus_language_find": ("core", c_int32, [c_char_p]),
    "mus_language_row_count": ("core", c_int32, []),
    "mus_language_row_key": ("core", c_char_p, [c_int32]),
    "mus_language_text": ("core", c_char_p, [c_int32, c_char_p]),
    "mus_language_compose": ("core", c_int32, [c_int32, c_char_p, c_char_p, c_char_p, c_size_t]),
    "mus_measure_count": ("core", c_int32, []),
    "mus_measure_name": ("core", c_char_p, [c_int32]),
    "mus_measure_unit": ("core", c_int32, [c_int32]),
    "mus_measure_find": ("core", c_int32, [c_char_p]),
    "mus_tape_create": ("core", c_int32, [POINTER(mus_context), POINTER(POINTER(mus_tape))]),
    "mus_tape_copy": ("core", c_int32, [POINTER(mus_tape), POINTER(POINTER(mus_tape))]),
    "mus_tape_destroy": ("core", None, [POINTER(mus_tape)]),
    "mus_tape_context": ("core", POINTER(mus_context), [POINTER(mus_tape)]),
    "mus_tape_set_sex": ("core", c_int32, [POINTER(mus_tape), c_int32]),
    "mus_tape_sex": ("core", c_int32, [POINTER(mus_tape)]),
    "mus_tape_set_name": ("core", c_int32, [POINTER(mus_tape), c_char_p]),
    "mus_tape_name": ("core", c_char_p, [POINTER(mus_tape)]),
    "mus_tape_set": ("core", c_int32, [POINTER(mus_tape), c_int32, c_double, c_int32]),
    "mus_tape_value": ("core", c_double, [POINTER(mus_tape), c_int32]),
    "mus_tape_source": ("core", c_int32, [POINTER(mus_tape), c_int32]),
    "mus_tape_set_size": ("core", c_int32, [POINTER(mus_tape), c_char_p]),
    "mus_tape_size_count": ("core", c_int32, []),
    "mus_tape_size_name": ("core", c_char_p, [c_int32]),
    "mus_tape_complete": ("core", c_int32, [POINTER(mus_tape)]),
    "mus_tape_is_complete": ("core", c_int32, [POINTER(mus_tape)]),
    "mus_tape_warning_count": ("core", c_int32, [POINTER(mus_tape)]),
    "mus_tape_warning": ("core", c_char_p, [POINTER(mus_tape), c_int32]),
    "mus_body_def_init": ("core", None, [POINTER(mus_body_def), c_size_t]),
    "mus_body_create": ("core", c_int32, [POINTER(mus_context), POINTER(mus_tape), POINTER(mus_body_def),
                                          POINTER(POINTER(mus_body))]),
    "mus_limb_init": ("core", None, [POINTER(mus_limb), c_size_t]),
    "mus_body_create_limbs": ("core", c_int32, [POINTER(mus_context), c_int32, POINTER(mus_limb),
                                                POINTER(mus_body_def), POINTER(POINTER(mus_body))]),
    "mus_body_destroy": ("core", None, [POINTER(mus_body)]),
    "mus_body_limb_count": ("core", c_int32, [POINTER(mus_body)]),
    "mus_body_limb_name": ("core", c_char_p, [POINTER(mus_body), c_int32]),
    "mus_body_asked": ("core", c_double, [POINTER(mus_body), c_int32]),
    "mus_body_made": ("core", c_double, [POINTER(mus_body), c_int32]),
    "mus_body_source": ("core", c_int32, [POINTER(mus_body), c_int32]),
    "mus_body_volume": ("core", c_double, [POINTER(mus_body)]),
    "mus_body_vertex_count": ("core", c_int32, [POINTER(mus_body)]),
    "mus_body_triangle_count": ("core", c_int32, [POINTER(mus_body)]),
    "mus_body_vertices": ("core", POINTER(c_double), [POINTER(mus_body)]),
    "mus_body_normals": ("core", POINTER(c_double), [POINTER(mus_body)]),
    "mus_body_triangles": ("core", POINTER(c_int32), [POINTER(mus_body)]),
    "mus_body_limb_range": ("core", c_int32, [POINTER(mus_body), c_int32, POINTER(c_int32)]),
    "mus_body_contour_count": ("core", c_int32, [POINTER(mus_body), c_int32]),
    "mus_body_contour_name": ("core", c_char_p, [POINTER(mus_body), c_int32, c_int32]),
    "mus_body_contour_points": ("core", c_int32, [POINTER(mus_body), c_int32, c_int32, c_int32, POINTER(c_double)]),
    "mus_body_landmark": ("core", c_int32, [POINTER(mus_body), c_int32, POINTER(c_double)]),
    "mus_body_depth": ("core", c_int32, [POINTER(mus_body), c_int32, POINTER(c_double), POINTER(c_double),
                                         POINTER(c_double)]),
    "mus_pose_init": ("core", None, [POINTER(mus_pose), c_size_t]),
    "mus_joint_name": ("core", c_char_p, [c_int32]),
    "mus_joint_limits": ("core", c_int32, [c_int32, c_int32, POINTER(c_double), POINTER(c_double)]),
    "mus_pose_check": ("core", c_int32, [POINTER(mus_context), POINTER(mus_pose)]),
    "mus_pose_count": ("core", c_int32, []),
    "mus_pose_name": ("core", c_char_p, [c_int32]),
    "mus_pose_named": ("core", c_int32, [POINTER(mus_context), c_char_p, POINTER(mus_pose)]),
    "mus_pose_feet": ("core", c_int32, [c_char_p]),
    "mus_body_pose": ("core", c_int32, [POINTER(mus_body), POINTER(mus_pose), POINTER(POINTER(mus_body))]),
    "mus_body_rest_pose": ("core", c_int32, [POINTER(mus_body), POINTER(mus_pose)]),
    "mus_body_stance": ("core", c_int32, [POINTER(mus_body), POINTER(mus_pose)]),
    "mus_body_ground": ("core", c_int32, [POINTER(mus_body), POINTER(mus_pose)]),
    "mus_body_stand": ("core", c_int32, [POINTER(mus_body), c_int32, POINTER(mus_pose)]),
    "mus_body_clear_arms": ("core", c_int32, [POINTER(mus_body), POINTER(mus_pose), c_double]),
    "mus_move_create": ("core", c_int32, [POINTER(mus_context), c_int32, POINTER(c_double), POINTER(mus_pose),
                                          c_double, POINTER(POINTER(mus_move))]),
    "mus_move_destroy": ("core", None, [POINTER(mus_move)]),
    "mus_move_count": ("core", c_int32, []),
    "mus_move_name": ("core", c_char_p, [c_int32]),
    "mus_move_named": ("core", c_int32, [POINTER(mus_context), c_char_p, c_double, POINTER(POINTER(mus_move))]),
    "mus_body_move": ("core", c_int32, [POINTER(mus_body), c_char_p, c_double, POINTER(POINTER(mus_move))]),
    "mus_move_period": ("core", c_double, [POINTER(mus_move)]),
    "mus_move_duration": ("core", c_double, [POINTER(mus_move)]),
    "mus_move_at": ("core", c_int32, [POINTER(mus_move), c_double, POINTER(mus_pose)]),
    "mus_scan_def_init": ("core", None, [POINTER(mus_scan_def), c_size_t]),
    "mus_scan_report_init": ("core", None, [POINTER(mus_scan_report), c_size_t]),
    "mus_body_create_scan": ("core", c_int32, [POINTER(mus_context), c_int32, POINTER(c_double), c_int32,
                                               POINTER(c_int32), POINTER(mus_scan_def), POINTER(mus_scan_report),
                                               POINTER(POINTER(mus_body))]),
    "mus_manifold_def_init": ("core", None, [POINTER(mus_manifold_def), c_size_t]),
    "mus_manifold_create": ("core", c_int32, [POINTER(mus_body), POINTER(mus_manifold_def),
                                              POINTER(POINTER(mus_manifold))]),
    "mus_manifold_destroy": ("core", None, [POINTER(mus_manifold)]),
    "mus_manifold_vertex_count": ("core", c_int32, [POINTER(mus_manifold)]),
    "mus_manifold_triangle_count": ("core", c_int32, [POINTER(mus_manifold)]),
    "mus_manifold_piece_count": ("core", c_int32, [POINTER(mus_manifold)]),
    "mus_manifold_cut_count": ("core", c_int32, [POINTER(mus_manifold)]),
    "mus_manifold_volume": ("core", c_double, [POINTER(mus_manifold)]),
    "mus_manifold_vertices": ("core", POINTER(c_double), [POINTER(mus_manifold)]),
    "mus_manifold_normals": ("core", POINTER(c_double), [POINTER(mus_manifold)]),
    "mus_manifold_triangles": ("core", POINTER(c_int32), [POINTER(mus_manifold)]),
    "mus_pattern_create": ("core", c_int32, [POINTER(mus_context), c_char_p, POINTER(POINTER(mus_pattern))]),
    "mus_pattern_copy": ("core", c_int32, [POINTER(mus_pattern), POINTER(POINTER(mus_pattern))]),
    "mus_pattern_destroy": ("core", None, [POINTER(mus_pattern)]),
    "mus_pattern_context": ("core", POINTER(mus_context), [POINTER(mus_pattern)]),
    "mus_pattern_name": ("core", c_char_p, [POINTER(mus_pattern)]),
    "mus_pattern_set_name": ("core", c_int32, [POINTER(mus_pattern), c_char_p]),
    "mus_pattern_add_panel": ("core", c_int32, [POINTER(mus_pattern), c_char_p, POINTER(c_int32)]),
    "mus_pattern_add_point": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_double, POINTER(c_int32)]),
    "mus_edge_def_init": ("core", None, [POINTER(mus_edge_def), c_size_t]),
    "mus_pattern_add_edge": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_edge_def), POINTER(c_int32)]),
    "mus_pattern_set_outline": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_int32),
                                                  POINTER(c_int32)]),
    "mus_pattern_set_edge_label": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p]),
    "mus_pattern_set_edge_allowance": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double]),
    "mus_hold_name": ("core", c_char_p, [c_int32]),
    "mus_hold_find": ("core", c_int32, [c_char_p]),
    "mus_pattern_set_edge_hold": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_double]),
    "mus_pattern_hold_label": ("core", c_int32, [POINTER(mus_pattern), c_char_p, c_int32, c_double, POINTER(c_int32)]),
    "mus_pattern_set_edge_elastic": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_double]),
    "mus_seam_def_init": ("core", None, [POINTER(mus_seam_def), c_size_t]),
    "mus_pattern_add_seam": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_seam_def), POINTER(c_int32)]),
    "mus_pattern_open_closures": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32)]),
    "mus_pattern_add_notch": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_int32, POINTER(c_int32)]),
    "mus_pattern_add_mark": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p, c_int32, POINTER(c_double),
                                               POINTER(c_int32)]),
    "mus_pattern_set_grain": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_double]),
    "mus_pattern_set_cut": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_int32]),
    "mus_material_name": ("core", c_char_p, [c_int32]),
    "mus_material_find": ("core", c_int32, [c_char_p]),
    "mus_pattern_set_material": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_int32]),
    "mus_pattern_set_cut_only": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_pattern)]),
    "mus_pattern_set_panel_name": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p]),
    "mus_pattern_set_panel_label": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p]),
    "mus_pattern_set_panel_sides": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32]),
    "mus_pattern_add_opening": ("core", c_int32, [POINTER(mus_pattern), c_char_p]),
    "mus_placement_init": ("core", None, [POINTER(mus_placement), c_size_t]),
    "mus_pattern_set_placement": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(mus_placement)]),
    "mus_pattern_placement": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(mus_placement)]),
    "mus_pattern_set_layer": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32]),
    "mus_pattern_layer": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_join": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_pattern), c_int32]),
    "mus_pattern_panel_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_point_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_edge_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_seam_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_notch_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_mark_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_opening_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_opening": ("core", c_char_p, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_find_panel": ("core", c_int32, [POINTER(mus_pattern), c_char_p]),
    "mus_pattern_find_edge": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p]),
    "mus_pattern_panel_name": ("core", c_char_p, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_panel_label": ("core", c_char_p, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_panel_sides": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32)]),
    "mus_pattern_outline": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32),
                                              POINTER(POINTER(c_int32)), POINTER(POINTER(c_int32))]),
    "mus_pattern_rim": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_int32),
                                          c_int32, POINTER(c_int32)]),
    "mus_pattern_cut_line": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double,
                                               POINTER(POINTER(mus_cut_line))]),
    "mus_cut_line_destroy": ("core", None, [POINTER(mus_cut_line)]),
    "mus_cut_line_loop_count": ("core", c_int32, [POINTER(mus_cut_line)]),
    "mus_cut_line_loop": ("core", c_int32, [POINTER(mus_cut_line), c_int32, POINTER(c_int32),
                                            POINTER(POINTER(c_double))]),
    "mus_cut_line_dart_count": ("core", c_int32, [POINTER(mus_cut_line)]),
    "mus_cut_line_dart": ("core", c_int32, [POINTER(mus_cut_line), c_int32, POINTER(c_double)]),
    "mus_pattern_grain": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_double)]),
    "mus_pattern_cut": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_int32)]),
    "mus_pattern_material": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_int32),
                                               POINTER(c_int32)]),
    "mus_pattern_cut_only": ("core", POINTER(mus_pattern), [POINTER(mus_pattern)]),
    "mus_pattern_point": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_double)]),
    "mus_pattern_edge_panel": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_edge_ends": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_int32)]),
    "mus_pattern_edge_name": ("core", c_char_p, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_edge_label": ("core", c_char_p, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_edge_allowance": ("core", c_double, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_edge_hold": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_double)]),
    "mus_pattern_edge_elastic": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_double),
                                                   POINTER(c_double)]),
    "mus_pattern_edge_pieces": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32),
                                                  POINTER(POINTER(c_int32)), POINTER(c_int32),
                                                  POINTER(POINTER(c_double))]),
    "mus_pattern_edge_length": ("core", c_double, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_edge_at": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_double),
                                              POINTER(c_double)]),
    "mus_pattern_edge_polyline": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_double),
                                                    c_int32, POINTER(c_int32)]),
    "mus_pattern_panel_area": ("core", c_double, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_panel_perimeter": ("core", c_double, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_seam": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(mus_seam_def)]),
    "mus_pattern_edge_seam": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_notch": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_double),
                                            POINTER(c_int32)]),
    "mus_pattern_mark": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), POINTER(c_char_p),
                                           POINTER(c_int32), POINTER(POINTER(c_double))]),
    "mus_topology_init": ("core", None, [POINTER(mus_topology), c_size_t]),
    "mus_pattern_topology": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_topology)]),
    "mus_pattern_loop": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32), c_int32,
                                           POINTER(c_int32), POINTER(c_double)]),
    "mus_pattern_loop_label": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_char_p)]),
    "mus_homology_init": ("core", None, [POINTER(mus_homology), c_size_t]),
    "mus_pattern_homology": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(mus_homology),
                                               POINTER(c_int32), c_int32]),
    "mus_pattern_boundary": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_int32), c_int32,
                                               POINTER(c_int32)]),
    "mus_form_def_init": ("core", None, [POINTER(mus_form_def), c_size_t]),
    "mus_pattern_form": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_form_def), POINTER(c_uint8), c_size_t,
                                           POINTER(c_size_t), POINTER(c_uint64)]),
    "mus_pattern_check": ("core", c_int32, [POINTER(mus_pattern), POINTER(c_int32), POINTER(POINTER(mus_faults))]),
    "mus_faults_destroy": ("core", None, [POINTER(mus_faults)]),
    "mus_faults_count": ("core", c_int32, [POINTER(mus_faults)]),
    "mus_faults_item": ("core", c_int32, [POINTER(mus_faults), c_int32, POINTER(c_int32), POINTER(c_int32),
                                          POINTER(c_int32), POINTER(c_int32)]),
    "mus_faults_text": ("core", c_char_p, [POINTER(mus_faults), c_int32]),
    "mus_pattern_keep_history": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_undo": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_redo": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_undo_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_redo_count": ("core", c_int32, [POINTER(mus_pattern)]),
    "mus_pattern_dart": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_double), POINTER(c_double),
                                           POINTER(c_double)]),
    "mus_pattern_add_dart": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_double, POINTER(c_double),
                                               POINTER(c_int32)]),
    "mus_pattern_rotate_dart": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_double, c_int32,
                                                  c_double, POINTER(c_int32)]),
    "mus_pattern_split_dart": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_int32),
                                                 POINTER(c_double), POINTER(c_double), c_int32, POINTER(c_int32)]),
    "mus_pattern_merge_darts": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_int32, POINTER(c_int32)]),
    "mus_pattern_shorten_dart": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double]),
    "mus_pattern_release_dart": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32)]),
    "mus_cut_def_init": ("core", None, [POINTER(mus_cut_def), c_size_t]),
    "mus_pattern_separate": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_cut_def), POINTER(c_int32),
                                               POINTER(c_int32)]),
    "mus_pattern_dart_to_seam": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_cut_def), POINTER(c_int32),
                                                   POINTER(c_int32)]),
    "mus_pattern_join_panels": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32)]),
    "mus_pattern_mirror_panel": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p, POINTER(c_int32)]),
    "mus_pattern_unfold": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_add_facing": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_char_p, POINTER(c_int32)]),
    "mus_pattern_add_patch": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_char_p, c_int32, POINTER(c_double),
                                                POINTER(c_int32)]),
    "mus_pattern_remove_panel": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_remove_seam": ("core", c_int32, [POINTER(mus_pattern), c_int32]),
    "mus_pattern_spread": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_int32, c_double, c_double,
                                             c_double]),
    "mus_pattern_flare": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_int32, c_double]),
    "mus_pattern_pleat": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_int32, c_double, c_double,
                                            c_double]),
    "mus_pattern_lay_pleats": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_double),
                                                 POINTER(c_double)]),
    "mus_pattern_lengthen": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_double), POINTER(c_double),
                                               c_double]),
    "mus_pattern_move_point": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_double]),
    "mus_pattern_move_control": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_double, c_double]),
    "mus_pattern_redraw_edge": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, POINTER(c_int32), c_int32,
                                                  POINTER(c_double)]),
    "mus_pattern_fair_edge": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double]),
    "mus_pattern_split_edge": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_char_p, POINTER(c_int32)]),
    "mus_pattern_merge_edges": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(c_int32)]),
    "mus_seam_walk_init": ("core", None, [POINTER(mus_seam_walk), c_size_t]),
    "mus_pattern_walk_seam": ("core", c_int32, [POINTER(mus_pattern), c_int32, POINTER(mus_seam_walk)]),
    "mus_pattern_true_seam": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_int32, c_int32]),
    "mus_pattern_notch_seam": ("core", c_int32, [POINTER(mus_pattern), c_int32, c_double, c_int32]),
    "mus_layout_def_init": ("core", None, [POINTER(mus_layout_def), c_size_t]),
    "mus_layout_create": ("core", c_int32, [POINTER(mus_context), POINTER(mus_pattern), POINTER(mus_layout_def),
                                            POINTER(POINTER(mus_layout))]),
    "mus_layout_item_init": ("core", None, [POINTER(mus_layout_item), c_size_t]),
    "mus_layout_create_items": ("core", c_int32, [POINTER(mus_context), c_int32, POINTER(mus_layout_item),
                                                  POINTER(mus_layout_def), POINTER(POINTER(mus_layout))]),
    "mus_layout_destroy": ("core", None, [POINTER(mus_layout)]),
    "mus_layout_context": ("core", POINTER(mus_context), [POINTER(mus_layout)]),
    "mus_layout_width": ("core", c_double, [POINTER(mus_layout)]),
    "mus_layout_length": ("core", c_double, [POINTER(mus_layout)]),
    "mus_layout_folded": ("core", c_double, [POINTER(mus_layout)]),
    "mus_layout_utilisation": ("core", c_double, [POINTER(mus_layout)]),
    "mus_layout_steps": ("core", c_int64, [POINTER(mus_layout)]),
    "mus_layout_piece_init": ("core", None, [POINTER(mus_layout_piece), c_size_t]),
    "mus_layout_piece_count": ("core", c_int32, [POINTER(mus_layout)]),
    "mus_layout_piece_get": ("core", c_int32, [POINTER(mus_layout), c_int32, POINTER(mus_layout_piece)]),
    "mus_design_count": ("core", c_int32, []),
    "mus_design_name": ("core", c_char_p, [c_int32]),
    "mus_design_family": ("core", c_char_p, [c_int32]),
    "mus_design_title": ("core", c_char_p, [c_int32]),
    "mus_design_words": ("core", c_char_p, [c_int32]),
    "mus_design_fabric": ("core", c_char_p, [c_int32]),
    "mus_design_groups": ("core", c_int32, [c_int32]),
    "mus_design_find": ("core", c_int32, [c_char_p]),
    "mus_design_search": ("core", c_int32, [POINTER(mus_context), c_char_p, c_int32, POINTER(c_int32),
                                            POINTER(c_double), POINTER(c_int32)]),
    "mus_design_axis_count": ("core", c_int32, []),
    "mus_design_axis_name": ("core", c_char_p, [c_int32]),
    "mus_design_option_count": ("core", c_int32, [c_int32]),
    "mus_design_option_name": ("core", c_char_p, [c_int32, c_int32]),
    "mus_design_spell": ("core", c_int32, [POINTER(mus_context), c_char_p, c_char_p, c_size_t]),
    "mus_draft_def_init": ("core", None, [POINTER(mus_draft_def), c_size_t]),
    "mus_design_draft": ("core", c_int32, [POINTER(mus_context), c_int32, POINTER(mus_tape), POINTER(mus_draft_def),
                                           POINTER(POINTER(mus_pattern))]),
    "mus_design_draft_words": ("core", c_int32, [POINTER(mus_context), c_char_p, POINTER(mus_tape),
                                                 POINTER(mus_draft_def), POINTER(POINTER(mus_pattern))]),
    "mus_design_grade": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_pattern), POINTER(c_double),
                                           POINTER(c_int32)]),
    "mus_design_grade_apply": ("core", c_int32, [POINTER(mus_pattern), POINTER(c_double),
                                                 POINTER(POINTER(mus_pattern))]),
    "mus_design_ease": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_tape), POINTER(c_double)]),
    "mus_fabric_init": ("core", None, [POINTER(mus_fabric), c_size_t]),
    "mus_fabric_count": ("core", c_int32, []),
    "mus_fabric_name": ("core", c_char_p, [c_int32]),
    "mus_fabric_source": ("core", c_char_p, [c_int32]),
    "mus_fabric_find": ("core", c_int32, [c_char_p, POINTER(mus_fabric)]),
    "mus_fabric_value_count": ("core", c_int32, []),
    "mus_fabric_value_key": ("core", c_char_p, [c_int32]),
    "mus_fabric_value_source": ("core", c_char_p, [c_int32, c_int32]),
    "mus_fabric_get": ("core", c_int32, [POINTER(mus_fabric), c_int32, POINTER(c_double)]),
    "mus_fabric_set": ("core", c_int32, [POINTER(mus_context), POINTER(mus_fabric), c_int32, c_double]),
    "mus_fabric_check": ("core", c_int32, [POINTER(mus_context), POINTER(mus_fabric)]),
    "mus_cloth_def_init": ("core", None, [POINTER(mus_cloth_def), c_size_t]),
    "mus_cloth_create": ("core", c_int32, [POINTER(mus_context), POINTER(mus_pattern), POINTER(mus_cloth_def),
                                           POINTER(POINTER(mus_cloth))]),
    "mus_cloth_create_grid": ("core", c_int32, [POINTER(mus_context), c_int32, c_int32, POINTER(c_double),
                                                POINTER(mus_cloth_def), POINTER(POINTER(mus_cloth))]),
    "mus_bare_init": ("core", None, [POINTER(mus_bare), c_size_t]),
    "mus_cloth_create_bare": ("core", c_int32, [POINTER(mus_context), POINTER(mus_bare), POINTER(POINTER(mus_cloth))]),
    "mus_cloth_destroy": ("core", None, [POINTER(mus_cloth)]),
    "mus_cloth_node_count": ("core", c_int32, [POINTER(mus_cloth)]),
    "mus_cloth_triangle_count": ("core", c_int32, [POINTER(mus_cloth)]),
    "mus_cloth_panel_count": ("core", c_int32, [POINTER(mus_cloth)]),
    "mus_cloth_name": ("core", c_char_p, [POINTER(mus_cloth)]),
    "mus_cloth_panel_name": ("core", c_char_p, [POINTER(mus_cloth), c_int32]),
    "mus_cloth_spring_count": ("core", c_int32, [POINTER(mus_cloth)]),
    "mus_cloth_pair_count": ("core", c_int32, [POINTER(mus_cloth)]),
    "mus_cloth_spacing": ("core", c_double, [POINTER(mus_cloth)]),
    "mus_cloth_mass": ("core", c_double, [POINTER(mus_cloth)]),
    "mus_cloth_rest": ("core", POINTER(c_double), [POINTER(mus_cloth)]),
    "mus_cloth_node_panels": ("core", POINTER(c_int32), [POINTER(mus_cloth)]),
    "mus_cloth_masses": ("core", POINTER(c_double), [POINTER(mus_cloth)]),
    "mus_cloth_triangles": ("core", POINTER(c_int32), [POINTER(mus_cloth)]),
    "mus_cloth_pairs": ("core", POINTER(c_int32), [POINTER(mus_cloth)]),
    "mus_cloth_pair_seams": ("core", POINTER(c_int32), [POINTER(mus_cloth)]),
    "mus_cloth_panel_range": ("core", c_int32, [POINTER(mus_cloth), c_int32, POINTER(c_int32)]),
    "mus_cloth_panel_border": ("core", c_int32, [POINTER(mus_cloth), c_int32, POINTER(c_int32),
                                                 POINTER(POINTER(c_int32))]),
    "mus_integrate_def_init": ("core", None, [POINTER(mus_integrate_def), c_size_t]),
    "mus_integrate_work": ("core", c_int64, [c_int32, c_int64]),
    "mus_integrate": ("core", c_int32, [POINTER(mus_context), POINTER(mus_integrate_def), c_int64,
                                        POINTER(c_double), c_int64, POINTER(c_double), POINTER(c_int64)]),
    "mus_integrate_f32": ("core", c_int32, [POINTER(mus_context), POINTER(mus_integrate_def), c_int64,
                                            POINTER(c_float), c_int64, POINTER(c_float), POINTER(c_int64)]),
    "mus_arrange_pattern": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_body)]),
    "mus_reason_init": ("core", None, [POINTER(mus_reason), c_size_t]),
    "mus_reason_name": ("core", c_char_p, [c_int32]),
    "mus_pattern_reason": ("core", c_int32, [POINTER(mus_pattern), POINTER(mus_reason)]),
    "mus_drape_def_init": ("core", None, [POINTER(mus_drape_def), c_size_t]),
    "mus_drape_create": ("core", c_int32, [POINTER(mus_context), POINTER(mus_cloth), POINTER(mus_body),
                                           POINTER(mus_drape_def), POINTER(POINTER(mus_drape))]),
    "mus_drape_create_plain": ("core", c_int32, [POINTER(mus_context), POINTER(mus_cloth), POINTER(mus_drape_def),
                                                 POINTER(POINTER(mus_drape))]),
    "mus_drape_destroy": ("core", None, [POINTER(mus_drape)]),
    "mus_drape_place": ("core", c_int32, [POINTER(mus_drape)]),
    "mus_drape_warm": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_drape)]),
    "mus_drape_set_state": ("core", c_int32, [POINTER(mus_drape), POINTER(c_double), POINTER(c_double)]),
    "mus_drape_pin": ("core", c_int32, [POINTER(mus_drape), c_int32, c_int32]),
    "mus_drape_tack": ("core", c_int32, [POINTER(mus_drape), c_int32, c_int32, c_double, POINTER(c_int32)]),
    "mus_drape_untack": ("core", c_int32, [POINTER(mus_drape), c_int32]),
    "mus_drape_set_gravity": ("core", c_int32, [POINTER(mus_drape), POINTER(c_double)]),
    "mus_drape_step_bound": ("core", c_double, [POINTER(mus_drape)]),
    "mus_drape_step": ("core", c_int32, [POINTER(mus_drape), c_int32, c_double]),
    "mus_drape_evaluate": ("core", c_int32, [POINTER(mus_drape), c_int32]),
    "mus_drape_move_body": ("core", c_int32, [POINTER(mus_drape), POINTER(c_double)]),
    "mus_drape_pose_body": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_pose), c_double]),
    "mus_drape_body_pose": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_pose)]),
    "mus_plane_init": ("core", None, [POINTER(mus_plane), c_size_t]),
    "mus_drape_add_plane": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_plane), POINTER(c_int32)]),
    "mus_drape_move_plane": ("core", c_int32, [POINTER(mus_drape), c_int32, POINTER(c_double), c_double]),
    "mus_estimate_init": ("core", None, [POINTER(mus_estimate), c_size_t]),
    "mus_drape_estimate": ("core", c_int32, [POINTER(mus_drape), c_double, POINTER(mus_estimate)]),
    "mus_drape_forces": ("core", c_int32, [POINTER(mus_drape), POINTER(c_double)]),
    "mus_drape_depth": ("core", c_int32, [POINTER(mus_drape), c_int32, POINTER(c_double), POINTER(c_double),
                                          POINTER(c_double)]),
    "mus_drape_sew": ("core", c_int32, [POINTER(mus_drape), mus_progress_fn, c_void_p]),
    "mus_drape_settle": ("core", c_int32, [POINTER(mus_drape), mus_progress_fn, c_void_p]),
    "mus_drape_positions": ("core", POINTER(c_double), [POINTER(mus_drape)]),
    "mus_drape_velocities": ("core", POINTER(c_double), [POINTER(mus_drape)]),
    "mus_drape_node_count": ("core", c_int32, [POINTER(mus_drape)]),
    "mus_drape_time": ("core", c_double, [POINTER(mus_drape)]),
    "mus_drape_start": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_reason)]),
    "mus_drape_reason": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_reason)]),
    "mus_drape_report_init": ("core", None, [POINTER(mus_drape_report), c_size_t]),
    "mus_drape_report_get": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_drape_report)]),
    "mus_drape_skipped": ("core", c_char_p, [POINTER(mus_drape)]),
    "mus_drape_hash": ("core", c_uint64, [POINTER(mus_drape)]),
    "mus_drape_gaps": ("core", c_int32, [POINTER(mus_drape), POINTER(c_double)]),
    "mus_drape_crossings": ("core", c_int32, [POINTER(mus_drape), c_int32, POINTER(c_int32), POINTER(c_int64)]),
    "mus_drape_untangle": ("core", c_int32, [POINTER(mus_drape), POINTER(c_int64)]),
    "mus_drape_normals": ("core", c_int32, [POINTER(mus_drape), POINTER(c_double)]),
    "mus_dress_def_init": ("core", None, [POINTER(mus_dress_def), c_size_t]),
    "mus_dress_report_init": ("core", None, [POINTER(mus_dress_report), c_size_t]),
    "mus_dress": ("core", c_int32, [POINTER(mus_context), POINTER(mus_pattern), POINTER(mus_body),
                                    POINTER(mus_dress_def), POINTER(mus_dress_report), POINTER(mus_reason),
                                    POINTER(POINTER(mus_cloth)), POINTER(POINTER(mus_drape))]),
    "mus_fit_create": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_body), POINTER(POINTER(mus_fit))]),
    "mus_fit_destroy": ("core", None, [POINTER(mus_fit)]),
    "mus_fit_node_count": ("core", c_int32, [POINTER(mus_fit)]),
    "mus_fit_warp": ("core", POINTER(c_double), [POINTER(mus_fit)]),
    "mus_fit_weft": ("core", POINTER(c_double), [POINTER(mus_fit)]),
    "mus_fit_pressure": ("core", POINTER(c_double), [POINTER(mus_fit)]),
    "mus_fit_gap": ("core", POINTER(c_double), [POINTER(mus_fit)]),
    "mus_fit_area": ("core", POINTER(c_double), [POINTER(mus_fit)]),
    "mus_fit_spread_init": ("core", None, [POINTER(mus_fit_spread), c_size_t]),
    "mus_fit_spread_get": ("core", c_int32, [POINTER(mus_fit), c_int32, POINTER(mus_fit_spread)]),
    "mus_fit_level_init": ("core", None, [POINTER(mus_fit_level), c_size_t]),
    "mus_fit_level_count": ("core", c_int32, [POINTER(mus_fit)]),
    "mus_fit_level_get": ("core", c_int32, [POINTER(mus_fit), c_int32, POINTER(mus_fit_level)]),
    "mus_worn_init": ("core", None, [POINTER(mus_worn), c_size_t]),
    "mus_worn_name": ("core", c_char_p, [c_int32]),
    "mus_fit_worn": ("core", c_int32, [POINTER(mus_drape), POINTER(mus_pattern), POINTER(mus_body), POINTER(mus_worn)]),
    "mus_sheet_def_init": ("print", None, [POINTER(mus_sheet_def), c_size_t]),
    "mus_sheet_create": ("print", c_int32, [POINTER(mus_context), POINTER(mus_pattern), POINTER(mus_sheet_def),
                                            POINTER(POINTER(mus_sheet))]),
    "mus_sheet_create_sizes": ("print", c_int32, [POINTER(mus_context), c_int32, POINTER(POINTER(mus_pattern)),
                                                  POINTER(c_char_p), POINTER(mus_sheet_def),
                                                  POINTER(POINTER(mus_sheet))]),
    "mus_sheet_destroy": ("print", None, [POINTER(mus_sheet)]),
    "mus_sheet_page_count": ("print", c_int32, [POINTER(mus_sheet)]),
    "mus_sheet_columns": ("print", c_int32, [POINTER(mus_sheet)]),
    "mus_sheet_rows": ("print", c_int32, [POINTER(mus_sheet)]),
    "mus_sheet_extent": ("print", c_int32, [POINTER(mus_sheet), POINTER(c_double)]),
    "mus_sheet_page": ("print", c_int32, [POINTER(mus_sheet), c_int32, POINTER(c_double)]),
    "mus_sheet_piece_init": ("print", None, [POINTER(mus_sheet_piece), c_size_t]),
    "mus_sheet_piece_count": ("print", c_int32, [POINTER(mus_sheet)]),
    "mus_sheet_piece_get": ("print", c_int32, [POINTER(mus_sheet), c_int32, POINTER(mus_sheet_piece)]),
    "mus_sheet_line_init": ("print", None, [POINTER(mus_sheet_line), c_size_t]),
    "mus_sheet_line_count": ("print", c_int32, [POINTER(mus_sheet)]),
    "mus_sheet_line_get": ("print", c_int32, [POINTER(mus_sheet), c_int32, POINTER(mus_sheet_line)]),
    "mus_sheet_write_pdf": ("print", c_int32, [POINTER(mus_sheet), c_char_p]),
    "mus_sheet_write_pdf_bytes": ("print", c_int32, [POINTER(mus_sheet), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_sheet_write_svg": ("print", c_int32, [POINTER(mus_sheet), c_char_p]),
    "mus_sheet_write_svg_bytes": ("print", c_int32, [POINTER(mus_sheet), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_pattern_write_instructions": ("print", c_int32, [POINTER(mus_pattern), c_char_p, c_char_p]),
    "mus_pattern_write_instructions_bytes": ("print", c_int32, [POINTER(mus_pattern), c_char_p, POINTER(c_char_p),
                                                                POINTER(c_size_t)]),
    "mus_pattern_write_instructions_in": ("print", c_int32, [POINTER(mus_pattern), c_char_p, c_char_p, c_char_p]),
    "mus_pattern_write_instructions_in_bytes": ("print", c_int32, [POINTER(mus_pattern), c_char_p, c_char_p,
                                                                   POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_layout_write_svg": ("print", c_int32, [POINTER(mus_layout), c_char_p]),
    "mus_layout_write_svg_bytes": ("print", c_int32, [POINTER(mus_layout), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_sheet_dxf_init": ("print", None, [POINTER(mus_sheet_dxf), c_size_t]),
    "mus_sheet_write_dxf": ("print", c_int32, [POINTER(mus_sheet), POINTER(mus_sheet_dxf), c_char_p]),
    "mus_sheet_write_dxf_bytes": ("print", c_int32, [POINTER(mus_sheet), POINTER(mus_sheet_dxf), POINTER(c_char_p),
                                                     POINTER(c_size_t)]),
    "mus_sheet_write_rul": ("print", c_int32, [POINTER(mus_sheet), POINTER(mus_sheet_dxf), c_char_p]),
    "mus_sheet_write_rul_bytes": ("print", c_int32, [POINTER(mus_sheet), POINTER(mus_sheet_dxf), POINTER(c_char_p),
                                                     POINTER(c_size_t)]),
    "mus_sheet_plt_init": ("print", None, [POINTER(mus_sheet_plt), c_size_t]),
    "mus_sheet_write_plt": ("print", c_int32, [POINTER(mus_sheet), POINTER(mus_sheet_plt), c_char_p]),
    "mus_sheet_write_plt_bytes": ("print", c_int32, [POINTER(mus_sheet), POINTER(mus_sheet_plt), POINTER(c_char_p),
                                                     POINTER(c_size_t)]),
    "mus_tape_read": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_char_p, POINTER(POINTER(mus_tape))]),
    "mus_tape_read_from": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_size_t, c_char_p, c_char_p,
                                                 POINTER(POINTER(mus_tape))]),
    "mus_tape_write": ("exchange", c_int32, [POINTER(mus_tape), c_char_p]),
    "mus_tape_write_bytes": ("exchange", c_int32, [POINTER(mus_tape), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_pattern_read": ("exchange", c_int32, [POINTER(mus_context), c_char_p, POINTER(POINTER(mus_pattern))]),
    "mus_pattern_read_from": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_size_t, c_char_p,
                                                    POINTER(POINTER(mus_pattern))]),
    "mus_pattern_dxf_init": ("exchange", None, [POINTER(mus_pattern_dxf), c_size_t]),
    "mus_pattern_read_dxf": ("exchange", c_int32, [POINTER(mus_context), POINTER(mus_pattern_dxf),
                                                   POINTER(POINTER(mus_pattern))]),
    "mus_pattern_val_init": ("exchange", None, [POINTER(mus_pattern_val), c_size_t]),
    "mus_pattern_read_val": ("exchange", c_int32, [POINTER(mus_context), POINTER(mus_pattern_val),
                                                   POINTER(POINTER(mus_pattern))]),
    "mus_pattern_propose_seams": ("exchange", c_int32, [POINTER(mus_pattern), POINTER(c_int32), POINTER(c_int32),
                                                        POINTER(c_double), c_int32, POINTER(c_int32)]),
    "mus_pattern_write": ("exchange", c_int32, [POINTER(mus_pattern), c_char_p]),
    "mus_pattern_write_bytes": ("exchange", c_int32, [POINTER(mus_pattern), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_pattern_write_garmentcode": ("exchange", c_int32, [POINTER(mus_pattern), c_char_p]),
    "mus_pattern_write_garmentcode_bytes": ("exchange", c_int32, [POINTER(mus_pattern), POINTER(c_char_p),
                                                                  POINTER(c_size_t)]),
    "mus_pattern_write_svg": ("exchange", c_int32, [POINTER(mus_pattern), c_char_p]),
    "mus_pattern_write_svg_bytes": ("exchange", c_int32, [POINTER(mus_pattern), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_fabric_load": ("exchange", c_int32, [POINTER(mus_context), c_char_p, POINTER(mus_fabric)]),
    "mus_fabric_load_from": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_size_t, c_char_p,
                                                   POINTER(mus_fabric)]),
    "mus_fabric_save": ("exchange", c_int32, [POINTER(mus_context), POINTER(mus_fabric), c_char_p,
                                              POINTER(c_char_p), c_char_p]),
    "mus_fabric_save_bytes": ("exchange", c_int32, [POINTER(mus_context), POINTER(mus_fabric), c_char_p,
                                                    POINTER(c_char_p), POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_mesh_view_init": ("exchange", None, [POINTER(mus_mesh_view), c_size_t]),
    "mus_mesh_write_obj": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_int32, POINTER(mus_mesh_view)]),
    "mus_mesh_write_obj_bytes": ("exchange", c_int32, [POINTER(mus_context), c_int32, POINTER(mus_mesh_view),
                                                       POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_mesh_write_glb": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_int32, POINTER(mus_mesh_view)]),
    "mus_mesh_write_glb_bytes": ("exchange", c_int32, [POINTER(mus_context), c_int32, POINTER(mus_mesh_view),
                                                       POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_mesh_motion_init": ("exchange", None, [POINTER(mus_mesh_motion), c_size_t]),
    "mus_mesh_write_glb_motion": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_int32,
                                                        POINTER(mus_mesh_view), c_int32, POINTER(c_double),
                                                        POINTER(mus_mesh_motion)]),
    "mus_mesh_write_glb_motion_bytes": ("exchange", c_int32, [POINTER(mus_context), c_int32, POINTER(mus_mesh_view),
                                                              c_int32, POINTER(c_double), POINTER(mus_mesh_motion),
                                                              POINTER(c_char_p), POINTER(c_size_t)]),
    "mus_mesh_file_init": ("exchange", None, [POINTER(mus_mesh_file), c_size_t]),
    "mus_mesh_write": ("exchange", c_int32, [POINTER(mus_context), c_char_p, POINTER(mus_mesh_file)]),
    "mus_mesh_write_bytes": ("exchange", c_int32, [POINTER(mus_context), POINTER(mus_mesh_file), POINTER(c_char_p),
                                                   POINTER(c_size_t)]),
    "mus_mesh_read_obj": ("exchange", c_int32, [POINTER(mus_context), c_char_p, POINTER(POINTER(mus_mesh))]),
    "mus_mesh_read_obj_from": ("exchange", c_int32, [POINTER(mus_context), c_char_p, c_size_t, c_char_p,
                                                     POINTER(POINTER(mus_mesh))]),
    "mus_mesh_destroy": ("exchange", None, [POINTER(mus_mesh)]),
    "mus_mesh_vertex_count": ("exchange", c_int32, [POINTER(mus_mesh)]),
    "mus_mesh_triangle_count": ("exchange", c_int32, [POINTER(mus_mesh)]),
    "mus_mesh_vertices": ("exchange", POINTER(c_double), [POINTER(mus_mesh)]),
    "mus_mesh_triangles": ("exchange", POINTER(c_int32), [POINTER(mus_mesh)]),
    "mus_catalogue_open": ("catalogue", c_int32, [POINTER(mus_context), c_char_p, c_int32,
                                                  POINTER(POINTER(mus_catalogue))]),
    "mus_catalogue_destroy": ("catalogue", None, [POINTER(mus_catalogue)]),
    "mus_catalogue_add": ("catalogue", c_int32, [POINTER(mus_catalogue), POINTER(mus_pattern), c_char_p,
                                                 POINTER(c_int32)]),
    "mus_catalogue_begin": ("catalogue", c_int32, [POINTER(mus_catalogue)]),
    "mus_catalogue_commit": ("catalogue", c_int32, [POINTER(mus_catalogue)]),
    "mus_catalogue_rollback": ("catalogue", c_int32, [POINTER(mus_catalogue)]),
    "mus_catalogue_count": ("catalogue", c_int32, [POINTER(mus_catalogue)]),
    "mus_catalogue_name": ("catalogue", c_int32, [POINTER(mus_catalogue), c_int32, POINTER(c_char_p)]),
    "mus_catalogue_exact": ("catalogue", c_int32, [POINTER(mus_catalogue), POINTER(mus_pattern), POINTER(c_int32),
                                                   c_int32, POINTER(c_int32)]),
    "mus_catalogue_nearest": ("catalogue", c_int32, [POINTER(mus_catalogue), POINTER(mus_pattern), c_int32,
                                                     POINTER(c_int32), POINTER(c_double), POINTER(c_int32),
                                                     POINTER(c_int32)]),
    "mus_catalogue_explain": ("catalogue", c_int32, [POINTER(mus_catalogue), POINTER(mus_pattern), c_int32,
                                                     POINTER(c_double), c_char_p, c_size_t]),
    "mus_catalogue_containing": ("catalogue", c_int32, [POINTER(mus_catalogue), POINTER(mus_pattern),
                                                        POINTER(c_int32), c_int32, POINTER(c_int32)]),
}
