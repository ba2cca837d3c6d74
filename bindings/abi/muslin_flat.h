/* muslin_flat.h: muslin 0.2.0 as plain declarations, for foreign-function interfaces.
 *
 * No include, no macro, no attribute: cffi and LuaJIT read it as it is; a C compiler wants <stddef.h> and
 * <stdint.h> before it. Written by bindings/python/generate.py from include/muslin/; do not edit. The contract
 * of each function stands in those headers and in the manual. */

enum {
    MUS_VERSION_MAJOR = 0,
    MUS_VERSION_MINOR = 2,
    MUS_VERSION_PATCH = 0,
    MUS_ABI = 1,
    MUS_NONE = -1,
    MUS_LOG_ERROR = 0,
    MUS_LOG_WARNING = 1,
    MUS_LOG_INFO = 2,
    MUS_OK = 0,
    MUS_ERR_ARG = 1,
    MUS_ERR_MEMORY = 2,
    MUS_ERR_VERSION = 3,
    MUS_ERR_STATE = 4,
    MUS_ERR_LIMIT = 5,
    MUS_ERR_FILE = 6,
    MUS_ERR_FORMAT = 7,
    MUS_ERR_UNSUPPORTED = 8,
    MUS_ERR_TAPE = 9,
    MUS_ERR_BODY = 10,
    MUS_ERR_PATTERN = 11,
    MUS_ERR_DESIGN = 12,
    MUS_ERR_MESH = 13,
    MUS_ERR_STEP = 14,
    MUS_ERR_DIVERGED = 15,
    MUS_ERR_SEW = 16,
    MUS_ERR_UNSETTLED = 17,
    MUS_ERR_TANGLED = 18,
    MUS_ERR_STOPPED = 19,
    MUS_STATUS_COUNT = 20,
    MUS_LANGUAGE_ENGLISH = 0,
    MUS_SEX_UNSET = 0,
    MUS_SEX_FEMALE = 1,
    MUS_SEX_MALE = 2,
    MUS_SEX_CHILD = 3,
    MUS_SOURCE_NONE = 0,
    MUS_SOURCE_GIVEN = 1,
    MUS_SOURCE_DERIVED = 2,
    MUS_MEASURE_STATURE = 0,
    MUS_MEASURE_BUST = 1,
    MUS_MEASURE_WAIST = 2,
    MUS_MEASURE_HIP = 3,
    MUS_MEASURE_UNDERBUST = 4,
    MUS_MEASURE_HIGH_BUST = 5,
    MUS_MEASURE_HIGH_HIP = 6,
    MUS_MEASURE_NECK = 7,
    MUS_MEASURE_SHOULDER = 8,
    MUS_MEASURE_SHOULDER_SLOPE = 9,
    MUS_MEASURE_ACROSS_BACK = 10,
    MUS_MEASURE_ACROSS_FRONT = 11,
    MUS_MEASURE_BACK_WAIST = 12,
    MUS_MEASURE_FRONT_WAIST = 13,
    MUS_MEASURE_BUST_DEPTH = 14,
    MUS_MEASURE_BUST_SPAN = 15,
    MUS_MEASURE_SCYE_DEPTH = 16,
    MUS_MEASURE_ARM = 17,
    MUS_MEASURE_ELBOW = 18,
    MUS_MEASURE_UPPER_ARM = 19,
    MUS_MEASURE_WRIST = 20,
    MUS_MEASURE_HAND = 21,
    MUS_MEASURE_WAIST_HEIGHT = 22,
    MUS_MEASURE_WAIST_TO_HIP = 23,
    MUS_MEASURE_RISE = 24,
    MUS_MEASURE_INLEG = 25,
    MUS_MEASURE_CROTCH_LENGTH = 26,
    MUS_MEASURE_THIGH = 27,
    MUS_MEASURE_KNEE = 28,
    MUS_MEASURE_CALF = 29,
    MUS_MEASURE_ANKLE = 30,
    MUS_MEASURE_HEAD = 31,
    MUS_MEASURE_FOOT = 32,
    MUS_MEASURE_NAPE_HEIGHT = 33,
    MUS_MEASURE_BUST_HEIGHT = 34,
    MUS_MEASURE_ARM_ANGLE = 35,
    MUS_MEASURE_COUNT = 36,
    MUS_WITHOUT_ARM_LEFT = 1,
    MUS_WITHOUT_ARM_RIGHT = 2,
    MUS_WITHOUT_FOREARM_LEFT = 4,
    MUS_WITHOUT_FOREARM_RIGHT = 8,
    MUS_WITHOUT_HAND_LEFT = 16,
    MUS_WITHOUT_HAND_RIGHT = 32,
    MUS_WITHOUT_LEG_LEFT = 64,
    MUS_WITHOUT_LEG_RIGHT = 128,
    MUS_WITHOUT_SHANK_LEFT = 256,
    MUS_WITHOUT_SHANK_RIGHT = 512,
    MUS_WITHOUT_FOOT_LEFT = 1024,
    MUS_WITHOUT_FOOT_RIGHT = 2048,
    MUS_WITHOUT_ALL = 4095,
    MUS_LANDMARK_CROWN = 0,
    MUS_LANDMARK_NAPE = 1,
    MUS_LANDMARK_BUST = 2,
    MUS_LANDMARK_WAIST = 3,
    MUS_LANDMARK_HIP = 4,
    MUS_LANDMARK_CROTCH = 5,
    MUS_LANDMARK_SHOULDER_LEFT = 6,
    MUS_LANDMARK_SHOULDER_RIGHT = 7,
    MUS_LANDMARK_WRIST_LEFT = 8,
    MUS_LANDMARK_WRIST_RIGHT = 9,
    MUS_LANDMARK_ANKLE_LEFT = 10,
    MUS_LANDMARK_ANKLE_RIGHT = 11,
    MUS_LANDMARK_COUNT = 12,
    MUS_JOINT_ROOT = 0,
    MUS_JOINT_LUMBAR = 1,
    MUS_JOINT_NECK = 2,
    MUS_JOINT_SHOULDER_LEFT = 3,
    MUS_JOINT_SHOULDER_RIGHT = 4,
    MUS_JOINT_ELBOW_LEFT = 5,
    MUS_JOINT_ELBOW_RIGHT = 6,
    MUS_JOINT_WRIST_LEFT = 7,
    MUS_JOINT_WRIST_RIGHT = 8,
    MUS_JOINT_HIP_LEFT = 9,
    MUS_JOINT_HIP_RIGHT = 10,
    MUS_JOINT_KNEE_LEFT = 11,
    MUS_JOINT_KNEE_RIGHT = 12,
    MUS_JOINT_ANKLE_LEFT = 13,
    MUS_JOINT_ANKLE_RIGHT = 14,
    MUS_JOINT_COUNT = 15,
    MUS_POSE_FLEXION = 0,
    MUS_POSE_ABDUCTION = 1,
    MUS_POSE_ROTATION = 2,
    MUS_FOOT_LEFT = 1,
    MUS_FOOT_RIGHT = 2,
    MUS_SCAN_FOUND = 0,
    MUS_SCAN_X = 1,
    MUS_SCAN_Y = 2,
    MUS_SCAN_Z = 3,
    MUS_SCAN_TORSO = 0,
    MUS_SCAN_HEAD = 1,
    MUS_SCAN_ARMS = 2,
    MUS_SCAN_HANDS = 3,
    MUS_SCAN_LEGS = 4,
    MUS_SCAN_FEET = 5,
    MUS_SCAN_PART_COUNT = 6,
    MUS_SCAN_BUST = 0,
    MUS_SCAN_WAIST = 1,
    MUS_SCAN_HIP = 2,
    MUS_SCAN_THIGH = 3,
    MUS_SCAN_WRIST = 4,
    MUS_SCAN_GIRTH_COUNT = 5,
    MUS_PIECE_LINE = 0,
    MUS_PIECE_QUADRATIC = 1,
    MUS_PIECE_CUBIC = 2,
    MUS_PIECE_ARC = 3,
    MUS_SEAM_REVERSED = 0,
    MUS_SEAM_DIRECT = 1,
    MUS_HOLD_NONE = 0,
    MUS_HOLD_NECK = 1,
    MUS_HOLD_ARMPIT = 2,
    MUS_HOLD_BUST = 3,
    MUS_HOLD_WAIST = 4,
    MUS_HOLD_HIP = 5,
    MUS_HOLD_CROTCH = 6,
    MUS_HOLD_BICEPS = 7,
    MUS_HOLD_WRIST = 8,
    MUS_HOLD_THIGH = 9,
    MUS_HOLD_KNEE = 10,
    MUS_HOLD_ANKLE = 11,
    MUS_HOLD_COUNT = 12,
    MUS_CLOSURE_NONE = 0,
    MUS_CLOSURE_ZIP = 1,
    MUS_CLOSURE_BUTTONS = 2,
    MUS_CLOSURE_TIES = 3,
    MUS_NOTCH_SINGLE = 1,
    MUS_NOTCH_DOUBLE = 2,
    MUS_NOTCH_TRIPLE = 3,
    MUS_MATERIAL_MAIN = 0,
    MUS_MATERIAL_LINING = 1,
    MUS_MATERIAL_INTERFACING = 2,
    MUS_MATERIAL_RIB = 3,
    MUS_MATERIAL_ELASTIC = 4,
    MUS_MATERIAL_COUNT = 5,
    MUS_SIDE_FRONT = 1,
    MUS_SIDE_BACK = 2,
    MUS_SIDE_LEFT = 4,
    MUS_SIDE_RIGHT = 8,
    MUS_LAYERS_MOST = 16,
    MUS_FAULT_OPEN_OUTLINE = 1,
    MUS_FAULT_CROSSING = 2,
    MUS_FAULT_SEAM_LENGTH = 3,
    MUS_FAULT_TWISTED_SEAM = 4,
    MUS_FAULT_SEWN_TWICE = 5,
    MUS_FAULT_SMALL_PANEL = 6,
    MUS_FAULT_LOOSE_EDGE = 7,
    MUS_FAULT_LOOSE_PIECE = 8,
    MUS_FAULT_MIRRORED = 9,
    MUS_FAULT_MISSING_PIECE = 10,
    MUS_FAULT_OPENING = 11,
    MUS_FAULT_CLOSED = 12,
    MUS_GROUP_WOMEN = 1,
    MUS_GROUP_MEN = 2,
    MUS_GROUP_CHILDREN = 4,
    MUS_EASE_BUST = 0,
    MUS_EASE_WAIST = 1,
    MUS_EASE_HIP = 2,
    MUS_EASE_COUNT = 3,
    MUS_BEND_PLATE = 0,
    MUS_BEND_PAPER = 1,
    MUS_CLOTH_NODES = 1048576,
    MUS_METHOD_RK4 = 0,
    MUS_METHOD_VERLET = 1,
    MUS_METHOD_EULER = 2,
    MUS_REASON_NONE = 0,
    MUS_REASON_SETTLED = 1,
    MUS_REASON_TWISTED_SEAM = 2,
    MUS_REASON_PANEL_CROSSES = 3,
    MUS_REASON_SEAM_OPEN = 4,
    MUS_REASON_START_TANGLED = 5,
    MUS_REASON_SLID_OFF = 6,
    MUS_REASON_TANGLED = 7,
    MUS_REASON_NOT_SETTLED = 8,
    MUS_REASON_UNSTABLE = 9,
    MUS_REASON_BAD_INPUT = 10,
    MUS_REASON_STOPPED = 11,
    MUS_REASON_NOT_WORN = 12,
    MUS_REASON_COUNT = 13,
    MUS_DRESS_PLACE_BOTH = 0,
    MUS_DRESS_PLACE_PATTERN = 1,
    MUS_DRESS_PLACE_FOUND = 2,
    MUS_DRESS_PLACE_RAISED = 3,
    MUS_DRESS_STARTS_MOST = 8,
    MUS_FIT_STRAIN = 0,
    MUS_FIT_WARP = 1,
    MUS_FIT_WEFT = 2,
    MUS_FIT_PRESSURE = 3,
    MUS_FIT_GAP = 4,
    MUS_WORN_NECK = 0,
    MUS_WORN_ARM_LEFT = 1,
    MUS_WORN_ARM_RIGHT = 2,
    MUS_WORN_LEG_LEFT = 3,
    MUS_WORN_LEG_RIGHT = 4,
    MUS_WORN_LIMBS = 5,
    MUS_WORN_YES = 0,
    MUS_WORN_UNKNOWN = 1,
    MUS_WORN_OPENING = 2,
    MUS_WORN_INSIDE_OUT = 3,
    MUS_WORN_SHOULDER = 4,
    MUS_WORN_HOOD = 5,
    MUS_WORN_LOW = 6,
    MUS_WORN_ROLLED = 7,
    MUS_WORN_TIGHT = 8,
    MUS_WORN_THROUGH = 9,
    MUS_WORN_COUNT = 10,
    MUS_PAPER_A4 = 0,
    MUS_PAPER_LETTER = 1,
    MUS_PAPER_A3 = 2,
    MUS_PAPER_A0 = 3,
    MUS_PAPER_ROLL = 4,
    MUS_LINE_CUT = 0,
    MUS_LINE_SEW = 1,
    MUS_LINE_NOTCH = 2,
    MUS_LINE_GRAIN = 3,
    MUS_LINE_MARK = 4,
    MUS_LINE_LABEL = 5,
    MUS_DXF_AAMA = 0,
    MUS_DXF_ASTM = 1,
    MUS_DXF_CUT = 0,
    MUS_DXF_SEW = 1,
    MUS_MESH_OBJ = 0,
    MUS_MESH_GLB = 1,
    MUS_MESH_USDA = 2,
    MUS_MESH_PLY = 3,
    MUS_MESH_PC2 = 4,
    MUS_CATALOGUE_READ = 0,
    MUS_CATALOGUE_WRITE = 1,
    MUS_DISTANCE_PIECES = 0,
    MUS_DISTANCE_SEAMS = 1,
    MUS_DISTANCE_SURFACE = 2,
    MUS_DISTANCE_OPENINGS = 3,
    MUS_DISTANCE_PANELS = 4,
    MUS_DISTANCE_CLOTH = 5,
    MUS_DISTANCE_COUNT = 6
};

typedef int32_t mus_status;
typedef struct mus_context mus_context;
typedef struct mus_tape mus_tape;
typedef struct mus_body mus_body;
typedef struct mus_move mus_move;
typedef struct mus_manifold mus_manifold;
typedef struct mus_pattern mus_pattern;
typedef struct mus_cut_line mus_cut_line;
typedef struct mus_faults mus_faults;
typedef struct mus_layout mus_layout;
typedef struct mus_cloth mus_cloth;
typedef struct mus_drape mus_drape;
typedef struct mus_fit mus_fit;
typedef struct mus_sheet mus_sheet;
typedef struct mus_mesh mus_mesh;
typedef struct mus_catalogue mus_catalogue;
typedef struct mus_context_def mus_context_def;
typedef struct mus_limb mus_limb;
typedef struct mus_body_def mus_body_def;
typedef struct mus_pose mus_pose;
typedef struct mus_scan_def mus_scan_def;
typedef struct mus_scan_report mus_scan_report;
typedef struct mus_manifold_def mus_manifold_def;
typedef struct mus_edge_def mus_edge_def;
typedef struct mus_seam_def mus_seam_def;
typedef struct mus_placement mus_placement;
typedef struct mus_topology mus_topology;
typedef struct mus_homology mus_homology;
typedef struct mus_form_def mus_form_def;
typedef struct mus_cut_def mus_cut_def;
typedef struct mus_seam_walk mus_seam_walk;
typedef struct mus_layout_def mus_layout_def;
typedef struct mus_layout_item mus_layout_item;
typedef struct mus_layout_piece mus_layout_piece;
typedef struct mus_draft_def mus_draft_def;
typedef struct mus_fabric mus_fabric;
typedef struct mus_cloth_def mus_cloth_def;
typedef struct mus_bare mus_bare;
typedef struct mus_integrate_def mus_integrate_def;
typedef struct mus_reason mus_reason;
typedef struct mus_drape_def mus_drape_def;
typedef struct mus_plane mus_plane;
typedef struct mus_estimate mus_estimate;
typedef struct mus_progress mus_progress;
typedef struct mus_drape_report mus_drape_report;
typedef struct mus_dress_def mus_dress_def;
typedef struct mus_dress_report mus_dress_report;
typedef struct mus_fit_spread mus_fit_spread;
typedef struct mus_fit_level mus_fit_level;
typedef struct mus_worn mus_worn;
typedef struct mus_sheet_def mus_sheet_def;
typedef struct mus_sheet_piece mus_sheet_piece;
typedef struct mus_sheet_line mus_sheet_line;
typedef struct mus_sheet_dxf mus_sheet_dxf;
typedef struct mus_sheet_plt mus_sheet_plt;
typedef struct mus_pattern_dxf mus_pattern_dxf;
typedef struct mus_pattern_val mus_pattern_val;
typedef struct mus_mesh_view mus_mesh_view;
typedef struct mus_mesh_motion mus_mesh_motion;
typedef struct mus_mesh_file mus_mesh_file;
typedef void *(*mus_alloc_fn)(void *user, void *ptr, size_t old_size, size_t new_size);
typedef void (*mus_log_fn)(void *user, int32_t level, const char *text);
typedef int32_t (*mus_layout_progress_fn)(void *user, double done, double length);
typedef void (*mus_rate_fn)(void *user, double t, const double *y, double *dy);
typedef void (*mus_rate32_fn)(void *user, double t, const float *y, float *dy);
typedef double (*mus_energy_fn)(void *user, double t, const double *y);
typedef double (*mus_energy32_fn)(void *user, double t, const float *y);
typedef int32_t (*mus_progress_fn)(void *user, const mus_progress *progress);

struct mus_context_def {
    size_t size;
    mus_alloc_fn alloc;
    void *alloc_user;
    mus_log_fn log;
    void *log_user;
};

struct mus_limb {
    size_t size;
    const char *name;
    double origin[3];
    double axis[3];
    double side[3];
    double pole[2];
    int32_t contours;
    const double *contour;
    int32_t corners;
    const double *outline;
    int32_t joint;
};

struct mus_body_def {
    size_t size;
    int32_t samples;
    double ring_spacing;
    int32_t ellipse;
    int32_t without;
    int32_t limbs;
    const mus_limb *limb;
    int32_t plain;
    double stoop;
    double head_forward;
    double sway;
};

struct mus_pose {
    size_t size;
    double place[3];
    double angle[15][3];
};

struct mus_scan_def {
    size_t size;
    int32_t up;
    int32_t front;
    double unit;
    double spacing;
    int32_t corners;
    double gap;
    int32_t samples;
    double ring_spacing;
    int32_t distances;
};

struct mus_scan_report {
    size_t size;
    double unit;
    double frame[9];
    double place[3];
    double stature;
    double crotch;
    double armpit[2];
    double arm_angle[2];
    int32_t vertices;
    int32_t contours;
    int32_t holes;
    double widest_hole;
    int32_t filled;
    double deepest_fill;
    double girth[5];
    double girth_height[5];
    double mesh_to_body[6][3];
    double body_to_mesh[6][3];
};

struct mus_manifold_def {
    size_t size;
    double spacing;
    int32_t threads;
};

struct mus_edge_def {
    size_t size;
    const char *name;
    int32_t start;
    int32_t end;
    int32_t npiece;
    int32_t nxy;
    const int32_t *kinds;
    const double *xy;
};

struct mus_seam_def {
    size_t size;
    int32_t edge_a;
    int32_t edge_b;
    int32_t direction;
    double ease;
    double tolerance;
    int32_t laid;
    int32_t closure;
    int32_t open;
    int32_t buttons;
};

struct mus_placement {
    size_t size;
    double origin[3];
    double rotation[9];
    double bend;
    double bend_x;
    double fold;
};

struct mus_topology {
    size_t size;
    int32_t vertices;
    int32_t edges;
    int32_t faces;
    int32_t euler;
    int32_t components;
    int32_t loops;
    int32_t orientable;
    int32_t manifold;
    int32_t genus;
};

struct mus_homology {
    size_t size;
    int32_t cells[3];
    int32_t rank[2];
    int32_t betti[3];
    int32_t euler;
    int32_t torsion;
};

struct mus_form_def {
    size_t size;
    int32_t mirror;
    int32_t labels;
};

struct mus_cut_def {
    size_t size;
    const char *name;
    const char *seam_name;
    int32_t edge_a;
    int32_t edge_b;
    double s_a;
    double s_b;
    int32_t npiece;
    int32_t nxy;
    const int32_t *kinds;
    const double *xy;
};

struct mus_seam_walk {
    size_t size;
    double length_a;
    double length_b;
    double excess;
    int32_t notches_a;
    int32_t notches_b;
    double notch_off;
    double corner_start;
    double corner_end;
};

struct mus_layout_def {
    size_t size;
    double width;
    double gap;
    double allowance;
    int32_t material;
    int32_t fold;
    int32_t nap;
    double tolerance;
    double stripe;
    int64_t steps;
    int32_t runs;
    int32_t threads;
    uint64_t seed;
    mus_layout_progress_fn progress;
    void *user;
};

struct mus_layout_item {
    size_t size;
    int32_t n;
    const double *xy;
    int32_t count;
    int32_t turn_count;
    const double *turns;
};

struct mus_layout_piece {
    size_t size;
    int32_t panel;
    const char *name;
    int32_t mirrored;
    int32_t turned;
    int32_t layers;
    int32_t on_fold;
    int32_t spare;
    double turn[4];
    double shift[2];
    int32_t n;
    const double *xy;
};

struct mus_draft_def {
    size_t size;
    double ease;
    double length;
    double sleeve;
};

struct mus_fabric {
    size_t size;
    double weight;
    double stretch[2];
    double shear;
    double bend[3];
    double damping;
    double friction;
    double thickness;
    double bend_hysteresis;
    double contraction;
};

struct mus_cloth_def {
    size_t size;
    double spacing;
    const mus_fabric *fabric;
    int32_t bending;
    double paper_curvature;
    int32_t coarser;
    int32_t nodes_most;
};

struct mus_bare {
    size_t size;
    int32_t nodes;
    int32_t springs;
    int32_t bends;
    int32_t pins;
    const double *place;
    const double *mass;
    const int32_t *spring;
    const double *length;
    const double *stiffness;
    const double *dashpot;
    const int32_t *bend;
    const double *bend_stiffness;
    const int32_t *pin;
};

struct mus_integrate_def {
    size_t size;
    int32_t method;
    int32_t guard_every;
    double start;
    double step;
    mus_rate_fn rate;
    mus_energy_fn energy;
    mus_rate32_fn rate32;
    mus_energy32_fn energy32;
    double energy_growth;
    double energy_floor;
    void *user;
};

struct mus_reason {
    size_t size;
    int32_t kind;
    int32_t panel;
    int32_t seam;
    int32_t node;
    int32_t count;
    double value;
    double place[3];
    char text[256];
};

struct mus_drape_def {
    size_t size;
    double gravity[3];
    int32_t precision;
    int32_t threads;
    double collision_distance;
    double clearance;
    double friction;
    double drag;
    double seam_pull;
    double sew_seconds;
    double settle_seconds;
    double settle_residual;
    int32_t integrator;
    double contact_ball;
    int32_t self_contact;
    double thickness;
    double self_friction;
    int32_t sew_once;
    double progress_seconds;
};

struct mus_plane {
    size_t size;
    double point[3];
    double normal[3];
    double velocity[3];
    double spin;
    double friction;
    double reach;
};

struct mus_estimate {
    size_t size;
    double step;
    double step_bound;
    int32_t steps_per_frame;
    int32_t node;
    double node_mass;
    double node_stiffness;
    double bend_share;
    double seconds;
    int64_t node_evaluations;
};

struct mus_progress {
    size_t size;
    const char *phase;
    double progress;
    int32_t coarse;
    int32_t nodes;
    int32_t triangles;
    const double *positions;
    const int32_t *triangle;
};

struct mus_drape_report {
    size_t size;
    int32_t nodes;
    int32_t springs;
    int32_t seams;
    int32_t seams_closed;
    int32_t welded;
    int32_t worst_seam;
    int32_t settled;
    double max_seam_gap;
    double max_penetration;
    double max_strain;
    double residual;
    double max_speed;
    double energy;
    double step;
    double step_bound;
    int64_t steps;
    int64_t spring_evaluations;
    int64_t contact_queries;
    double sew_time;
    double settle_time;
    int32_t step_parts;
    double rest_distance;
    double contact_impulse[3];
    int32_t self_contacts;
    int64_t self_queries;
};

struct mus_dress_def {
    size_t size;
    double spacing;
    const mus_fabric *fabric;
    int32_t self_contact;
    int32_t precision;
    int32_t threads;
    double friction;
    const mus_drape_def *drape;
    int32_t place;
    int32_t retry;
    int32_t open_closures;
    mus_progress_fn progress;
    void *progress_user;
    double progress_seconds;
    int32_t nodes_most;
    double seconds_most;
};

struct mus_dress_report {
    size_t size;
    int32_t found;
    int32_t starts;
    int32_t kept;
    int32_t start_place[8];
    int32_t start_patient[8];
    int32_t start_end[8];
    double start_seconds[8];
    double place_seconds;
    double cut_seconds;
    double sew_seconds;
    double settle_seconds;
};

struct mus_fit_spread {
    size_t size;
    double p50;
    double p95;
    double p99;
    double mean;
    double least;
    double largest;
    int32_t node;
    double area;
};

struct mus_fit_level {
    size_t size;
    int32_t level;
    int32_t right;
    double body;
    double garment;
    double worn;
    double ease;
    double gap;
};

struct mus_worn {
    size_t size;
    int32_t kind;
    int32_t limb;
    int32_t panel;
    int32_t node;
    double value;
    double place[3];
    int32_t through;
    double through_depth;
    double through_area;
    double through_place[3];
    char text[256];
};

struct mus_sheet_def {
    size_t size;
    int32_t paper;
    double allowance;
    double margin;
    double overlap;
    const char *title;
    const char *person;
    int32_t fold;
    const char *language;
    const char *notes;
};

struct mus_sheet_piece {
    size_t size;
    int32_t panel;
    const char *name;
    int32_t copies;
    int32_t mirrored;
    int32_t fold;
    double turn[4];
    double shift[2];
    double box[4];
    int32_t size_index;
    int32_t materials[8];
};

struct mus_sheet_line {
    size_t size;
    int32_t piece;
    int32_t kind;
    int32_t edge;
    int32_t filled;
    int32_t op_count;
    int32_t point_count;
    const uint8_t *ops;
    const double *points;
};

struct mus_sheet_dxf {
    size_t size;
    int32_t dialect;
    int32_t boundary;
    const char *size_name;
    const char *date;
    int32_t nested;
    int32_t size_count;
    const mus_sheet *const *sheets;
    const char *const *size_names;
};

struct mus_sheet_plt {
    size_t size;
    int32_t hpgl2;
    int32_t by_piece;
    int32_t one_pen;
};

struct mus_pattern_dxf {
    size_t size;
    const char *path;
    const char *text;
    size_t text_size;
    const char *rules_path;
    const char *rules;
    size_t rules_size;
    const char *size_name;
};

struct mus_pattern_val {
    size_t size;
    const char *path;
    const char *text;
    size_t text_size;
    const char *measures_path;
    const char *measures;
    size_t measures_size;
    const char *size_name;
};

struct mus_mesh_view {
    size_t size;
    const char *name;
    int32_t vertex_count;
    int32_t triangle_count;
    const double *positions;
    const double *normals;
    const double *texcoords;
    const int32_t *triangles;
    double colour[4];
    int32_t two_sided;
};

struct mus_mesh_motion {
    size_t size;
    const double *positions;
    const double *normals;
};

struct mus_mesh_file {
    size_t size;
    int32_t form;
    int32_t count;
    const mus_mesh_view *meshes;
    const mus_cloth *const *cloths;
    const char *const *materials;
    int32_t keys;
    const double *times;
    const mus_mesh_motion *motion;
};

/* libmuslin */
const char *mus_status_name(mus_status status);
const char *mus_status_text(mus_status status);
void mus_version(int32_t *version);
void mus_context_def_init(mus_context_def *def, size_t size);
mus_status mus_context_create(const mus_context_def *def, mus_context **out);
void mus_context_destroy(mus_context *context);
const char *mus_context_error(const mus_context *context);
size_t mus_context_bytes(const mus_context *context);
uint64_t mus_context_allocations(const mus_context *context);
mus_status mus_context_fail(mus_context *context, mus_status status, const char *text);
void *mus_context_alloc(mus_context *context, void *ptr, size_t new_size);
void mus_context_log(mus_context *context, int32_t level, const char *text);
int32_t mus_language_count(void);
const char *mus_language_tag(int32_t language);
const char *mus_language_name(int32_t language);
int32_t mus_language_is_right_to_left(int32_t language);
int32_t mus_language_find(const char *tag);
int32_t mus_language_row_count(void);
const char *mus_language_row_key(int32_t row);
const char *mus_language_text(int32_t language, const char *key);
int32_t mus_language_compose(int32_t language, const char *kind, const char *words, char *text, size_t size);
int32_t mus_measure_count(void);
const char *mus_measure_name(int32_t measure);
int32_t mus_measure_unit(int32_t measure);
int32_t mus_measure_find(const char *name);
mus_status mus_tape_create(mus_context *context, mus_tape **out);
mus_status mus_tape_copy(const mus_tape *tape, mus_tape **out);
void mus_tape_destroy(mus_tape *tape);
mus_context *mus_tape_context(const mus_tape *tape);
mus_status mus_tape_set_sex(mus_tape *tape, int32_t sex);
int32_t mus_tape_sex(const mus_tape *tape);
mus_status mus_tape_set_name(mus_tape *tape, const char *name);
const char *mus_tape_name(const mus_tape *tape);
mus_status mus_tape_set(mus_tape *tape, int32_t measure, double value, int32_t source);
double mus_tape_value(const mus_tape *tape, int32_t measure);
int32_t mus_tape_source(const mus_tape *tape, int32_t measure);
mus_status mus_tape_set_size(mus_tape *tape, const char *size);
int32_t mus_tape_size_count(void);
const char *mus_tape_size_name(int32_t index);
mus_status mus_tape_complete(mus_tape *tape);
int32_t mus_tape_is_complete(const mus_tape *tape);
int32_t mus_tape_warning_count(const mus_tape *tape);
const char *mus_tape_warning(const mus_tape *tape, int32_t index);
void mus_body_def_init(mus_body_def *def, size_t size);
mus_status mus_body_create(mus_context *context, const mus_tape *tape, const mus_body_def *def, mus_body **out);
void mus_limb_init(mus_limb *limb, size_t size);
mus_status mus_body_create_limbs(mus_context *context, int32_t limbs, const mus_limb *limb, const mus_body_def *def, mus_body **out);
void mus_body_destroy(mus_body *body);
int32_t mus_body_limb_count(const mus_body *body);
const char *mus_body_limb_name(const mus_body *body, int32_t limb);
double mus_body_asked(const mus_body *body, int32_t measure);
double mus_body_made(const mus_body *body, int32_t measure);
int32_t mus_body_source(const mus_body *body, int32_t measure);
double mus_body_volume(const mus_body *body);
int32_t mus_body_vertex_count(const mus_body *body);
int32_t mus_body_triangle_count(const mus_body *body);
const double *mus_body_vertices(const mus_body *body);
const double *mus_body_normals(const mus_body *body);
const int32_t *mus_body_triangles(const mus_body *body);
mus_status mus_body_limb_range(const mus_body *body, int32_t limb, int32_t *range);
int32_t mus_body_contour_count(const mus_body *body, int32_t limb);
const char *mus_body_contour_name(const mus_body *body, int32_t limb, int32_t contour);
mus_status mus_body_contour_points(const mus_body *body, int32_t limb, int32_t contour, int32_t n, double *out);
mus_status mus_body_landmark(const mus_body *body, int32_t landmark, double *out);
mus_status mus_body_depth(const mus_body *body, int32_t n, const double *points, double *depth, double *normal);
void mus_pose_init(mus_pose *pose, size_t size);
const char *mus_joint_name(int32_t joint);
mus_status mus_joint_limits(int32_t joint, int32_t axis, double *low, double *high);
mus_status mus_pose_check(mus_context *context, const mus_pose *pose);
int32_t mus_pose_count(void);
const char *mus_pose_name(int32_t pose);
mus_status mus_pose_named(mus_context *context, const char *name, mus_pose *out);
int32_t mus_pose_feet(const char *name);
mus_status mus_body_pose(const mus_body *body, const mus_pose *pose, mus_body **out);
mus_status mus_body_rest_pose(const mus_body *body, mus_pose *pose);
mus_status mus_body_stance(const mus_body *body, mus_pose *pose);
mus_status mus_body_ground(const mus_body *body, mus_pose *pose);
mus_status mus_body_stand(const mus_body *body, int32_t feet, mus_pose *pose);
mus_status mus_body_clear_arms(const mus_body *body, mus_pose *pose, double gap);
mus_status mus_move_create(mus_context *context, int32_t keys, const double *times, const mus_pose *poses, double period, mus_move **out);
void mus_move_destroy(mus_move *move);
int32_t mus_move_count(void);
const char *mus_move_name(int32_t move);
mus_status mus_move_named(mus_context *context, const char *name, double stature, mus_move **out);
mus_status mus_body_move(const mus_body *body, const char *name, double gap, mus_move **out);
double mus_move_period(const mus_move *move);
double mus_move_duration(const mus_move *move);
mus_status mus_move_at(const mus_move *move, double t, mus_pose *pose);
void mus_scan_def_init(mus_scan_def *def, size_t size);
void mus_scan_report_init(mus_scan_report *report, size_t size);
mus_status mus_body_create_scan(mus_context *context, int32_t vertex_count, const double *vertices, int32_t triangle_count, const int32_t *triangles, const mus_scan_def *def, mus_scan_report *report, mus_body **out);
void mus_manifold_def_init(mus_manifold_def *def, size_t size);
mus_status mus_manifold_create(const mus_body *body, const mus_manifold_def *def, mus_manifold **out);
void mus_manifold_destroy(mus_manifold *manifold);
int32_t mus_manifold_vertex_count(const mus_manifold *manifold);
int32_t mus_manifold_triangle_count(const mus_manifold *manifold);
int32_t mus_manifold_piece_count(const mus_manifold *manifold);
int32_t mus_manifold_cut_count(const mus_manifold *manifold);
double mus_manifold_volume(const mus_manifold *manifold);
const double *mus_manifold_vertices(const mus_manifold *manifold);
const double *mus_manifold_normals(const mus_manifold *manifold);
const int32_t *mus_manifold_triangles(const mus_manifold *manifold);
mus_status mus_pattern_create(mus_context *context, const char *name, mus_pattern **out);
mus_status mus_pattern_copy(const mus_pattern *pattern, mus_pattern **out);
void mus_pattern_destroy(mus_pattern *pattern);
mus_context *mus_pattern_context(const mus_pattern *pattern);
const char *mus_pattern_name(const mus_pattern *pattern);
mus_status mus_pattern_set_name(mus_pattern *pattern, const char *name);
mus_status mus_pattern_add_panel(mus_pattern *pattern, const char *name, int32_t *out);
mus_status mus_pattern_add_point(mus_pattern *pattern, int32_t panel, double x, double y, int32_t *out);
void mus_edge_def_init(mus_edge_def *def, size_t size);
mus_status mus_pattern_add_edge(mus_pattern *pattern, const mus_edge_def *def, int32_t *out);
mus_status mus_pattern_set_outline(mus_pattern *pattern, int32_t panel, int32_t n, const int32_t *edges, const int32_t *directions);
mus_status mus_pattern_set_edge_label(mus_pattern *pattern, int32_t edge, const char *label);
mus_status mus_pattern_set_edge_allowance(mus_pattern *pattern, int32_t edge, double allowance);
const char *mus_hold_name(int32_t level);
int32_t mus_hold_find(const char *name);
mus_status mus_pattern_set_edge_hold(mus_pattern *pattern, int32_t edge, int32_t level, double below);
mus_status mus_pattern_hold_label(mus_pattern *pattern, const char *label, int32_t level, double below, int32_t *count);
mus_status mus_pattern_set_edge_elastic(mus_pattern *pattern, int32_t edge, double ratio, double stiffness);
void mus_seam_def_init(mus_seam_def *def, size_t size);
mus_status mus_pattern_add_seam(mus_pattern *pattern, const mus_seam_def *def, int32_t *out);
mus_status mus_pattern_open_closures(mus_pattern *pattern, int32_t open, int32_t *count);
mus_status mus_pattern_add_notch(mus_pattern *pattern, int32_t edge, double s, int32_t kind, int32_t *out);
mus_status mus_pattern_add_mark(mus_pattern *pattern, int32_t panel, const char *name, int32_t n, const double *xy, int32_t *out);
mus_status mus_pattern_set_grain(mus_pattern *pattern, int32_t panel, double x, double y);
mus_status mus_pattern_set_cut(mus_pattern *pattern, int32_t panel, int32_t count, int32_t mirror_of);
const char *mus_material_name(int32_t material);
int32_t mus_material_find(const char *name);
mus_status mus_pattern_set_material(mus_pattern *pattern, int32_t panel, int32_t material, int32_t count);
mus_status mus_pattern_set_cut_only(mus_pattern *pattern, const mus_pattern *panels);
mus_status mus_pattern_set_panel_name(mus_pattern *pattern, int32_t panel, const char *name);
mus_status mus_pattern_set_panel_label(mus_pattern *pattern, int32_t panel, const char *label);
mus_status mus_pattern_set_panel_sides(mus_pattern *pattern, int32_t panel, int32_t sides);
mus_status mus_pattern_add_opening(mus_pattern *pattern, const char *label);
void mus_placement_init(mus_placement *placement, size_t size);
mus_status mus_pattern_set_placement(mus_pattern *pattern, int32_t panel, const mus_placement *placement);
mus_status mus_pattern_placement(const mus_pattern *pattern, int32_t panel, mus_placement *out);
mus_status mus_pattern_set_layer(mus_pattern *pattern, int32_t panel, int32_t layer);
int32_t mus_pattern_layer(const mus_pattern *pattern, int32_t panel);
mus_status mus_pattern_join(mus_pattern *pattern, const mus_pattern *other, int32_t layer);
int32_t mus_pattern_panel_count(const mus_pattern *pattern);
int32_t mus_pattern_point_count(const mus_pattern *pattern);
int32_t mus_pattern_edge_count(const mus_pattern *pattern);
int32_t mus_pattern_seam_count(const mus_pattern *pattern);
int32_t mus_pattern_notch_count(const mus_pattern *pattern);
int32_t mus_pattern_mark_count(const mus_pattern *pattern);
int32_t mus_pattern_opening_count(const mus_pattern *pattern);
const char *mus_pattern_opening(const mus_pattern *pattern, int32_t opening);
int32_t mus_pattern_find_panel(const mus_pattern *pattern, const char *name);
int32_t mus_pattern_find_edge(const mus_pattern *pattern, int32_t panel, const char *name);
const char *mus_pattern_panel_name(const mus_pattern *pattern, int32_t panel);
const char *mus_pattern_panel_label(const mus_pattern *pattern, int32_t panel);
int32_t mus_pattern_panel_sides(const mus_pattern *pattern, int32_t panel, int32_t *given);
mus_status mus_pattern_outline(const mus_pattern *pattern, int32_t panel, int32_t *n, const int32_t **edges, const int32_t **directions);
mus_status mus_pattern_rim(const mus_pattern *pattern, int32_t panel, int32_t *edges, int32_t *directions, int32_t capacity, int32_t *count);
mus_status mus_pattern_cut_line(const mus_pattern *pattern, int32_t panel, double allowance, mus_cut_line **out);
void mus_cut_line_destroy(mus_cut_line *line);
int32_t mus_cut_line_loop_count(const mus_cut_line *line);
mus_status mus_cut_line_loop(const mus_cut_line *line, int32_t loop, int32_t *n, const double **xy);
int32_t mus_cut_line_dart_count(const mus_cut_line *line);
mus_status mus_cut_line_dart(const mus_cut_line *line, int32_t dart, double *out);
mus_status mus_pattern_grain(const mus_pattern *pattern, int32_t panel, double *out);
mus_status mus_pattern_cut(const mus_pattern *pattern, int32_t panel, int32_t *count, int32_t *mirror_of);
mus_status mus_pattern_material(const mus_pattern *pattern, int32_t panel, int32_t material, int32_t *count, int32_t *mirrored);
const mus_pattern *mus_pattern_cut_only(const mus_pattern *pattern);
mus_status mus_pattern_point(const mus_pattern *pattern, int32_t point, int32_t *panel, double *xy);
int32_t mus_pattern_edge_panel(const mus_pattern *pattern, int32_t edge);
mus_status mus_pattern_edge_ends(const mus_pattern *pattern, int32_t edge, int32_t *start, int32_t *end);
const char *mus_pattern_edge_name(const mus_pattern *pattern, int32_t edge);
const char *mus_pattern_edge_label(const mus_pattern *pattern, int32_t edge);
double mus_pattern_edge_allowance(const mus_pattern *pattern, int32_t edge);
mus_status mus_pattern_edge_hold(const mus_pattern *pattern, int32_t edge, int32_t *level, double *below);
mus_status mus_pattern_edge_elastic(const mus_pattern *pattern, int32_t edge, double *ratio, double *stiffness);
mus_status mus_pattern_edge_pieces(const mus_pattern *pattern, int32_t edge, int32_t *npiece, const int32_t **kinds, int32_t *nxy, const double **xy);
double mus_pattern_edge_length(const mus_pattern *pattern, int32_t edge);
mus_status mus_pattern_edge_at(const mus_pattern *pattern, int32_t edge, int32_t n, const double *t, double *out);
mus_status mus_pattern_edge_polyline(const mus_pattern *pattern, int32_t edge, int32_t chords, double *xy, int32_t capacity, int32_t *count);
double mus_pattern_panel_area(const mus_pattern *pattern, int32_t panel);
double mus_pattern_panel_perimeter(const mus_pattern *pattern, int32_t panel);
mus_status mus_pattern_seam(const mus_pattern *pattern, int32_t seam, mus_seam_def *out);
int32_t mus_pattern_edge_seam(const mus_pattern *pattern, int32_t edge);
mus_status mus_pattern_notch(const mus_pattern *pattern, int32_t notch, int32_t *edge, double *s, int32_t *kind);
mus_status mus_pattern_mark(const mus_pattern *pattern, int32_t mark, int32_t *panel, const char **name, int32_t *n, const double **xy);
void mus_topology_init(mus_topology *topology, size_t size);
mus_status mus_pattern_topology(const mus_pattern *pattern, mus_topology *out);
mus_status mus_pattern_loop(const mus_pattern *pattern, int32_t loop, int32_t *edges, int32_t capacity, int32_t *count, double *length);
mus_status mus_pattern_loop_label(const mus_pattern *pattern, int32_t loop, const char **label);
void mus_homology_init(mus_homology *homology, size_t size);
mus_status mus_pattern_homology(const mus_pattern *pattern, int32_t sewn, mus_homology *out, int32_t *torsion, int32_t capacity);
mus_status mus_pattern_boundary(const mus_pattern *pattern, int32_t sewn, int32_t dimension, int32_t *triples, int32_t capacity, int32_t *count);
void mus_form_def_init(mus_form_def *def, size_t size);
mus_status mus_pattern_form(const mus_pattern *pattern, const mus_form_def *def, uint8_t *bytes, size_t capacity, size_t *count, uint64_t *hash);
mus_status mus_pattern_check(const mus_pattern *pattern, int32_t *count, mus_faults **out);
void mus_faults_destroy(mus_faults *faults);
int32_t mus_faults_count(const mus_faults *faults);
mus_status mus_faults_item(const mus_faults *faults, int32_t index, int32_t *kind, int32_t *panel, int32_t *edge, int32_t *seam);
const char *mus_faults_text(const mus_faults *faults, int32_t index);
mus_status mus_pattern_keep_history(mus_pattern *pattern, int32_t depth);
mus_status mus_pattern_undo(mus_pattern *pattern);
mus_status mus_pattern_redo(mus_pattern *pattern);
int32_t mus_pattern_undo_count(const mus_pattern *pattern);
int32_t mus_pattern_redo_count(const mus_pattern *pattern);
mus_status mus_pattern_dart(const mus_pattern *pattern, int32_t leg, double *angle, double *width, double *depth);
mus_status mus_pattern_add_dart(mus_pattern *pattern, int32_t edge, double s, double width, const double *point, int32_t *leg);
mus_status mus_pattern_rotate_dart(mus_pattern *pattern, int32_t leg, int32_t target, double s, int32_t keep, double fraction, int32_t *out);
mus_status mus_pattern_split_dart(mus_pattern *pattern, int32_t leg, int32_t n, const int32_t *targets, const double *s, const double *fractions, int32_t keep, int32_t *out);
mus_status mus_pattern_merge_darts(mus_pattern *pattern, int32_t leg, int32_t into, int32_t keep, int32_t *out);
mus_status mus_pattern_shorten_dart(mus_pattern *pattern, int32_t leg, double back);
mus_status mus_pattern_release_dart(mus_pattern *pattern, int32_t leg, int32_t *out);
void mus_cut_def_init(mus_cut_def *def, size_t size);
mus_status mus_pattern_separate(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel, int32_t *seam);
mus_status mus_pattern_dart_to_seam(mus_pattern *pattern, const mus_cut_def *def, int32_t *panel, int32_t *seam);
mus_status mus_pattern_join_panels(mus_pattern *pattern, int32_t seam, int32_t *panel);
mus_status mus_pattern_mirror_panel(mus_pattern *pattern, int32_t panel, const char *name, int32_t *out);
mus_status mus_pattern_unfold(mus_pattern *pattern, int32_t fold);
mus_status mus_pattern_add_facing(mus_pattern *pattern, int32_t edge, double width, const char *name, int32_t *panel);
mus_status mus_pattern_add_patch(mus_pattern *pattern, int32_t panel, const char *name, int32_t n, const double *xy, int32_t *out);
mus_status mus_pattern_remove_panel(mus_pattern *pattern, int32_t panel);
mus_status mus_pattern_remove_seam(mus_pattern *pattern, int32_t seam);
mus_status mus_pattern_spread(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b, double w_a, double w_b);
mus_status mus_pattern_flare(mus_pattern *pattern, int32_t hem, int32_t hinge, int32_t n, double amount);
mus_status mus_pattern_pleat(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b, double depth_a, double depth_b);
mus_status mus_pattern_lay_pleats(mus_pattern *pattern, int32_t edge, int32_t n, const double *s, const double *depths);
mus_status mus_pattern_lengthen(mus_pattern *pattern, int32_t panel, const double *point, const double *direction, double amount);
mus_status mus_pattern_move_point(mus_pattern *pattern, int32_t point, double x, double y);
mus_status mus_pattern_move_control(mus_pattern *pattern, int32_t edge, int32_t index, double x, double y);
mus_status mus_pattern_redraw_edge(mus_pattern *pattern, int32_t edge, int32_t npiece, const int32_t *kinds, int32_t nxy, const double *xy);
mus_status mus_pattern_fair_edge(mus_pattern *pattern, int32_t edge, double within);
mus_status mus_pattern_split_edge(mus_pattern *pattern, int32_t edge, double s, const char *name, int32_t *out);
mus_status mus_pattern_merge_edges(mus_pattern *pattern, int32_t edge, int32_t *out);
void mus_seam_walk_init(mus_seam_walk *walk, size_t size);
mus_status mus_pattern_walk_seam(const mus_pattern *pattern, int32_t seam, mus_seam_walk *out);
mus_status mus_pattern_true_seam(mus_pattern *pattern, int32_t seam, int32_t edge, int32_t at_end);
mus_status mus_pattern_notch_seam(mus_pattern *pattern, int32_t edge, double s, int32_t kind);
void mus_layout_def_init(mus_layout_def *def, size_t size);
mus_status mus_layout_create(mus_context *context, const mus_pattern *pattern, const mus_layout_def *def, mus_layout **out);
void mus_layout_item_init(mus_layout_item *item, size_t size);
mus_status mus_layout_create_items(mus_context *context, int32_t count, const mus_layout_item *items, const mus_layout_def *def, mus_layout **out);
void mus_layout_destroy(mus_layout *layout);
mus_context *mus_layout_context(const mus_layout *layout);
double mus_layout_width(const mus_layout *layout);
double mus_layout_length(const mus_layout *layout);
double mus_layout_folded(const mus_layout *layout);
double mus_layout_utilisation(const mus_layout *layout);
int64_t mus_layout_steps(const mus_layout *layout);
void mus_layout_piece_init(mus_layout_piece *piece, size_t size);
int32_t mus_layout_piece_count(const mus_layout *layout);
mus_status mus_layout_piece_get(const mus_layout *layout, int32_t piece, mus_layout_piece *out);
int32_t mus_design_count(void);
const char *mus_design_name(int32_t design);
const char *mus_design_family(int32_t design);
const char *mus_design_title(int32_t design);
const char *mus_design_words(int32_t design);
const char *mus_design_fabric(int32_t design);
int32_t mus_design_groups(int32_t design);
int32_t mus_design_find(const char *name);
mus_status mus_design_search(mus_context *context, const char *phrase, int32_t room, int32_t *designs, double *scores, int32_t *count);
int32_t mus_design_axis_count(void);
const char *mus_design_axis_name(int32_t axis);
int32_t mus_design_option_count(int32_t axis);
const char *mus_design_option_name(int32_t axis, int32_t option);
mus_status mus_design_spell(mus_context *context, const char *words, char *text, size_t size);
void mus_draft_def_init(mus_draft_def *def, size_t size);
mus_status mus_design_draft(mus_context *context, int32_t design, const mus_tape *tape, const mus_draft_def *def, mus_pattern **out);
mus_status mus_design_draft_words(mus_context *context, const char *words, const mus_tape *tape, const mus_draft_def *def, mus_pattern **out);
mus_status mus_design_grade(const mus_pattern *from, const mus_pattern *to, double *rules, int32_t *count);
mus_status mus_design_grade_apply(const mus_pattern *pattern, const double *rules, mus_pattern **out);
mus_status mus_design_ease(const mus_pattern *pattern, const mus_tape *tape, double *ease);
void mus_fabric_init(mus_fabric *fabric, size_t size);
int32_t mus_fabric_count(void);
const char *mus_fabric_name(int32_t index);
const char *mus_fabric_source(int32_t index);
mus_status mus_fabric_find(const char *name, mus_fabric *out);
int32_t mus_fabric_value_count(void);
const char *mus_fabric_value_key(int32_t value);
const char *mus_fabric_value_source(int32_t index, int32_t value);
mus_status mus_fabric_get(const mus_fabric *fabric, int32_t value, double *out);
mus_status mus_fabric_set(mus_context *context, mus_fabric *fabric, int32_t value, double number);
mus_status mus_fabric_check(mus_context *context, const mus_fabric *fabric);
void mus_cloth_def_init(mus_cloth_def *def, size_t size);
mus_status mus_cloth_create(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def, mus_cloth **out);
mus_status mus_cloth_create_grid(mus_context *context, int32_t rows, int32_t columns, const double *cell, const mus_cloth_def *def, mus_cloth **out);
void mus_bare_init(mus_bare *bare, size_t size);
mus_status mus_cloth_create_bare(mus_context *context, const mus_bare *bare, mus_cloth **out);
void mus_cloth_destroy(mus_cloth *cloth);
int32_t mus_cloth_node_count(const mus_cloth *cloth);
int32_t mus_cloth_triangle_count(const mus_cloth *cloth);
int32_t mus_cloth_panel_count(const mus_cloth *cloth);
const char *mus_cloth_name(const mus_cloth *cloth);
const char *mus_cloth_panel_name(const mus_cloth *cloth, int32_t panel);
int32_t mus_cloth_spring_count(const mus_cloth *cloth);
int32_t mus_cloth_pair_count(const mus_cloth *cloth);
double mus_cloth_spacing(const mus_cloth *cloth);
double mus_cloth_mass(const mus_cloth *cloth);
const double *mus_cloth_rest(const mus_cloth *cloth);
const int32_t *mus_cloth_node_panels(const mus_cloth *cloth);
const double *mus_cloth_masses(const mus_cloth *cloth);
const int32_t *mus_cloth_triangles(const mus_cloth *cloth);
const int32_t *mus_cloth_pairs(const mus_cloth *cloth);
const int32_t *mus_cloth_pair_seams(const mus_cloth *cloth);
mus_status mus_cloth_panel_range(const mus_cloth *cloth, int32_t panel, int32_t *range);
mus_status mus_cloth_panel_border(const mus_cloth *cloth, int32_t panel, int32_t *n, const int32_t **nodes);
void mus_integrate_def_init(mus_integrate_def *def, size_t size);
int64_t mus_integrate_work(int32_t method, int64_t n);
mus_status mus_integrate(mus_context *context, const mus_integrate_def *def, int64_t n, double *y, int64_t steps, double *work, int64_t *done);
mus_status mus_integrate_f32(mus_context *context, const mus_integrate_def *def, int64_t n, float *y, int64_t steps, float *work, int64_t *done);
mus_status mus_arrange_pattern(mus_pattern *pattern, const mus_body *body);
void mus_reason_init(mus_reason *reason, size_t size);
const char *mus_reason_name(int32_t kind);
mus_status mus_pattern_reason(const mus_pattern *pattern, mus_reason *out);
void mus_drape_def_init(mus_drape_def *def, size_t size);
mus_status mus_drape_create(mus_context *context, const mus_cloth *cloth, const mus_body *body, const mus_drape_def *def, mus_drape **out);
mus_status mus_drape_create_plain(mus_context *context, const mus_cloth *cloth, const mus_drape_def *def, mus_drape **out);
void mus_drape_destroy(mus_drape *drape);
mus_status mus_drape_place(mus_drape *drape);
mus_status mus_drape_warm(mus_drape *drape, const mus_drape *from);
mus_status mus_drape_set_state(mus_drape *drape, const double *positions, const double *velocities);
mus_status mus_drape_pin(mus_drape *drape, int32_t node, int32_t fixed);
mus_status mus_drape_tack(mus_drape *drape, int32_t a, int32_t b, double stiffness, int32_t *index);
mus_status mus_drape_untack(mus_drape *drape, int32_t index);
mus_status mus_drape_set_gravity(mus_drape *drape, const double *gravity);
double mus_drape_step_bound(const mus_drape *drape);
mus_status mus_drape_step(mus_drape *drape, int32_t steps, double dt);
mus_status mus_drape_evaluate(mus_drape *drape, int32_t times);
mus_status mus_drape_move_body(mus_drape *drape, const double *velocity);
mus_status mus_drape_pose_body(mus_drape *drape, const mus_pose *pose, double duration);
mus_status mus_drape_body_pose(const mus_drape *drape, mus_pose *out);
void mus_plane_init(mus_plane *plane, size_t size);
mus_status mus_drape_add_plane(mus_drape *drape, const mus_plane *plane, int32_t *index);
mus_status mus_drape_move_plane(mus_drape *drape, int32_t index, const double *velocity, double spin);
void mus_estimate_init(mus_estimate *estimate, size_t size);
mus_status mus_drape_estimate(mus_drape *drape, double frame, mus_estimate *out);
mus_status mus_drape_forces(const mus_drape *drape, double *out);
mus_status mus_drape_depth(const mus_drape *drape, int32_t n, const double *points, double *depth, double *normal);
mus_status mus_drape_sew(mus_drape *drape, mus_progress_fn progress, void *user);
mus_status mus_drape_settle(mus_drape *drape, mus_progress_fn progress, void *user);
const double *mus_drape_positions(const mus_drape *drape);
const double *mus_drape_velocities(const mus_drape *drape);
int32_t mus_drape_node_count(const mus_drape *drape);
double mus_drape_time(const mus_drape *drape);
mus_status mus_drape_start(const mus_drape *drape, mus_reason *out);
mus_status mus_drape_reason(const mus_drape *drape, mus_reason *out);
void mus_drape_report_init(mus_drape_report *report, size_t size);
mus_status mus_drape_report_get(const mus_drape *drape, mus_drape_report *out);
const char *mus_drape_skipped(const mus_drape *drape);
uint64_t mus_drape_hash(const mus_drape *drape);
mus_status mus_drape_gaps(const mus_drape *drape, double *out);
mus_status mus_drape_crossings(const mus_drape *drape, int32_t most, int32_t *pairs, int64_t *count);
mus_status mus_drape_untangle(mus_drape *drape, int64_t *left);
mus_status mus_drape_normals(const mus_drape *drape, double *out);
void mus_dress_def_init(mus_dress_def *def, size_t size);
void mus_dress_report_init(mus_dress_report *report, size_t size);
mus_status mus_dress(mus_context *context, const mus_pattern *pattern, const mus_body *body, const mus_dress_def *def, mus_dress_report *report, mus_reason *reason, mus_cloth **cloth, mus_drape **drape);
mus_status mus_fit_create(const mus_drape *drape, const mus_body *body, mus_fit **out);
void mus_fit_destroy(mus_fit *fit);
int32_t mus_fit_node_count(const mus_fit *fit);
const double *mus_fit_warp(const mus_fit *fit);
const double *mus_fit_weft(const mus_fit *fit);
const double *mus_fit_pressure(const mus_fit *fit);
const double *mus_fit_gap(const mus_fit *fit);
const double *mus_fit_area(const mus_fit *fit);
void mus_fit_spread_init(mus_fit_spread *spread, size_t size);
mus_status mus_fit_spread_get(const mus_fit *fit, int32_t quantity, mus_fit_spread *out);
void mus_fit_level_init(mus_fit_level *level, size_t size);
int32_t mus_fit_level_count(const mus_fit *fit);
mus_status mus_fit_level_get(const mus_fit *fit, int32_t index, mus_fit_level *out);
void mus_worn_init(mus_worn *worn, size_t size);
const char *mus_worn_name(int32_t kind);
mus_status mus_fit_worn(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, mus_worn *out);

/* libmuslin-print */
void mus_sheet_def_init(mus_sheet_def *def, size_t size);
mus_status mus_sheet_create(mus_context *context, const mus_pattern *pattern, const mus_sheet_def *def, mus_sheet **out);
mus_status mus_sheet_create_sizes(mus_context *context, int32_t count, const mus_pattern *const *patterns, const char *const *names, const mus_sheet_def *def, mus_sheet **out);
void mus_sheet_destroy(mus_sheet *sheet);
int32_t mus_sheet_page_count(const mus_sheet *sheet);
int32_t mus_sheet_columns(const mus_sheet *sheet);
int32_t mus_sheet_rows(const mus_sheet *sheet);
mus_status mus_sheet_extent(const mus_sheet *sheet, double *out);
mus_status mus_sheet_page(const mus_sheet *sheet, int32_t page, double *out);
void mus_sheet_piece_init(mus_sheet_piece *piece, size_t size);
int32_t mus_sheet_piece_count(const mus_sheet *sheet);
mus_status mus_sheet_piece_get(const mus_sheet *sheet, int32_t piece, mus_sheet_piece *out);
void mus_sheet_line_init(mus_sheet_line *line, size_t size);
int32_t mus_sheet_line_count(const mus_sheet *sheet);
mus_status mus_sheet_line_get(const mus_sheet *sheet, int32_t line, mus_sheet_line *out);
mus_status mus_sheet_write_pdf(const mus_sheet *sheet, const char *path);
mus_status mus_sheet_write_pdf_bytes(const mus_sheet *sheet, char **bytes, size_t *size);
mus_status mus_sheet_write_svg(const mus_sheet *sheet, const char *path);
mus_status mus_sheet_write_svg_bytes(const mus_sheet *sheet, char **bytes, size_t *size);
mus_status mus_pattern_write_instructions(const mus_pattern *pattern, const char *title, const char *path);
mus_status mus_pattern_write_instructions_bytes(const mus_pattern *pattern, const char *title, char **bytes, size_t *size);
mus_status mus_pattern_write_instructions_in(const mus_pattern *pattern, const char *language, const char *title, const char *path);
mus_status mus_pattern_write_instructions_in_bytes(const mus_pattern *pattern, const char *language, const char *title, char **bytes, size_t *size);
mus_status mus_layout_write_svg(const mus_layout *layout, const char *path);
mus_status mus_layout_write_svg_bytes(const mus_layout *layout, char **bytes, size_t *size);
void mus_sheet_dxf_init(mus_sheet_dxf *def, size_t size);
mus_status mus_sheet_write_dxf(const mus_sheet *sheet, const mus_sheet_dxf *def, const char *path);
mus_status mus_sheet_write_dxf_bytes(const mus_sheet *sheet, const mus_sheet_dxf *def, char **bytes, size_t *size);
mus_status mus_sheet_write_rul(const mus_sheet *sheet, const mus_sheet_dxf *def, const char *path);
mus_status mus_sheet_write_rul_bytes(const mus_sheet *sheet, const mus_sheet_dxf *def, char **bytes, size_t *size);
void mus_sheet_plt_init(mus_sheet_plt *def, size_t size);
mus_status mus_sheet_write_plt(const mus_sheet *sheet, const mus_sheet_plt *def, const char *path);
mus_status mus_sheet_write_plt_bytes(const mus_sheet *sheet, const mus_sheet_plt *def, char **bytes, size_t *size);

/* libmuslin-exchange */
mus_status mus_tape_read(mus_context *context, const char *path, const char *row, mus_tape **out);
mus_status mus_tape_read_from(mus_context *context, const char *text, size_t size, const char *name, const char *row, mus_tape **out);
mus_status mus_tape_write(const mus_tape *tape, const char *path);
mus_status mus_tape_write_bytes(const mus_tape *tape, char **bytes, size_t *size);
mus_status mus_pattern_read(mus_context *context, const char *path, mus_pattern **out);
mus_status mus_pattern_read_from(mus_context *context, const char *text, size_t size, const char *name, mus_pattern **out);
void mus_pattern_dxf_init(mus_pattern_dxf *dxf, size_t size);
mus_status mus_pattern_read_dxf(mus_context *context, const mus_pattern_dxf *from, mus_pattern **out);
void mus_pattern_val_init(mus_pattern_val *val, size_t size);
mus_status mus_pattern_read_val(mus_context *context, const mus_pattern_val *from, mus_pattern **out);
mus_status mus_pattern_propose_seams(const mus_pattern *pattern, int32_t *edges, int32_t *chosen, double *confidence, int32_t capacity, int32_t *count);
mus_status mus_pattern_write(const mus_pattern *pattern, const char *path);
mus_status mus_pattern_write_bytes(const mus_pattern *pattern, char **bytes, size_t *size);
mus_status mus_pattern_write_garmentcode(const mus_pattern *pattern, const char *path);
mus_status mus_pattern_write_garmentcode_bytes(const mus_pattern *pattern, char **bytes, size_t *size);
mus_status mus_pattern_write_svg(const mus_pattern *pattern, const char *path);
mus_status mus_pattern_write_svg_bytes(const mus_pattern *pattern, char **bytes, size_t *size);
mus_status mus_fabric_load(mus_context *context, const char *path, mus_fabric *out);
mus_status mus_fabric_load_from(mus_context *context, const char *text, size_t size, const char *name, mus_fabric *out);
mus_status mus_fabric_save(mus_context *context, const mus_fabric *fabric, const char *name, const char *const *sources, const char *path);
mus_status mus_fabric_save_bytes(mus_context *context, const mus_fabric *fabric, const char *name, const char *const *sources, char **bytes, size_t *size);
void mus_mesh_view_init(mus_mesh_view *view, size_t size);
mus_status mus_mesh_write_obj(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes);
mus_status mus_mesh_write_obj_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes, size_t *size);
mus_status mus_mesh_write_glb(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes);
mus_status mus_mesh_write_glb_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes, size_t *size);
void mus_mesh_motion_init(mus_mesh_motion *motion, size_t size);
mus_status mus_mesh_write_glb_motion(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes, int32_t keys, const double *times, const mus_mesh_motion *motion);
mus_status mus_mesh_write_glb_motion_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys, const double *times, const mus_mesh_motion *motion, char **bytes, size_t *size);
void mus_mesh_file_init(mus_mesh_file *file, size_t size);
mus_status mus_mesh_write(mus_context *context, const char *path, const mus_mesh_file *file);
mus_status mus_mesh_write_bytes(mus_context *context, const mus_mesh_file *file, char **bytes, size_t *size);
mus_status mus_mesh_read_obj(mus_context *context, const char *path, mus_mesh **out);
mus_status mus_mesh_read_obj_from(mus_context *context, const char *text, size_t size, const char *name, mus_mesh **out);
void mus_mesh_destroy(mus_mesh *mesh);
int32_t mus_mesh_vertex_count(const mus_mesh *mesh);
int32_t mus_mesh_triangle_count(const mus_mesh *mesh);
const double *mus_mesh_vertices(const mus_mesh *mesh);
const int32_t *mus_mesh_triangles(const mus_mesh *mesh);

/* libmuslin-catalogue */
mus_status mus_catalogue_open(mus_context *context, const char *path, int32_t mode, mus_catalogue **out);
void mus_catalogue_destroy(mus_catalogue *catalogue);
mus_status mus_catalogue_add(mus_catalogue *catalogue, const mus_pattern *pattern, const char *name, int32_t *out);
mus_status mus_catalogue_begin(mus_catalogue *catalogue);
mus_status mus_catalogue_commit(mus_catalogue *catalogue);
mus_status mus_catalogue_rollback(mus_catalogue *catalogue);
int32_t mus_catalogue_count(const mus_catalogue *catalogue);
mus_status mus_catalogue_name(mus_catalogue *catalogue, int32_t id, const char **name);
mus_status mus_catalogue_exact(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t *ids, int32_t capacity, int32_t *count);
mus_status mus_catalogue_nearest(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t capacity, int32_t *ids, double *distances, int32_t *exact, int32_t *count);
mus_status mus_catalogue_explain(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t id, double *parts, char *text, size_t capacity);
mus_status mus_catalogue_containing(mus_catalogue *catalogue, const mus_pattern *part, int32_t *ids, int32_t capacity, int32_t *count);
