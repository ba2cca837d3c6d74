/*
 * muslin/exchange.h: readers and writers of files (libmuslin-exchange).
 *
 * Tapes: muslin's own text form, GarmentCode body yaml, Valentina/Seamly .vit, a row of a csv table. Patterns:
 * muslin's own JSON (exact round trip), GarmentCode specifications, FreeSewing dumps. Fabrics: muslin's own JSON.
 * Meshes: OBJ and binary glTF 2.0.
 * Outside dependencies: jansson, libyaml, expat.
 *
 * When a reader fails, mus_context_error() has one sentence with the file, the line or byte, and the expected content.
 * Memory is bounded by the size of the file, and files above 256 MiB are refused. A writer that fails leaves no half
 * file.
 *
 * Each reader of a file has a twin that reads a text in memory (`_from`); each writer has one that writes to memory
 * (`_bytes`). The `name` of a `_from` call stands in place of the path: messages show it, a tape or pattern without a
 * name of its own gets it, and its ending tells the form where a path's ending would. *bytes of a `_bytes` call is an
 * allocation of *size bytes. It belongs to the caller, who frees it with mus_context_alloc(context, bytes, 0); it is
 * NULL after a failure.
 */
#ifndef MUSLIN_EXCHANGE_H
#define MUSLIN_EXCHANGE_H

#include "muslin/base.h"
#include "muslin/body.h"
#include "muslin/cloth.h"
#include "muslin/drape.h"
#include "muslin/pattern.h"
#include "muslin/tape.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read a tape.
 *
 * The ending of the name tells the form: .tape or .txt (one measure a line), .yaml or .yml (GarmentCode body), .vit
 * (Valentina), .csv (table; `row` is the name of the row in its first column). `row` is NULL for the other forms.
 * The tape is not completed. Entries that muslin has no use for are ignored, and one log line lists them; another
 * program's file that has nothing else is MUS_ERR_FORMAT, with these names.
 * Errors: MUS_ERR_FILE, MUS_ERR_FORMAT, MUS_ERR_TAPE (a value out of range), MUS_ERR_UNSUPPORTED (a formula in a
 *         .vit, by its name), MUS_ERR_ARG (row missing), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_tape_read(mus_context *context, const char *path, const char *row, mus_tape **out);

/** Read a tape from `size` bytes of text; the ending of `name` ("me.tape", "table.csv") tells the form.
 * Errors: as mus_tape_read(), but for MUS_ERR_FILE */
MUS_API mus_status mus_tape_read_from(mus_context *context, const char *text, size_t size, const char *name,
                                      const char *row, mus_tape **out);

/** Write a tape in muslin's own text form: given measures as lines, derived measures as comments. path "-" writes to
 * standard output. Errors: MUS_ERR_ARG, MUS_ERR_FILE, MUS_ERR_MEMORY */
MUS_API mus_status mus_tape_write(const mus_tape *tape, const char *path);

/** Write a tape as mus_tape_write() does, into memory. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY */
MUS_API mus_status mus_tape_write_bytes(const mus_tape *tape, char **bytes, size_t *size);

/**
 * Read a pattern: muslin JSON, GarmentCode specification, FreeSewing dump, DXF, SVG or Valentina. The content tells
 * the form. A DXF is read as by mus_pattern_read_dxf() in its sample size; an SVG by the convention of
 * muslin_pattern(5); a .val or .sm2d without measurements, as by mus_pattern_read_val().
 *
 * Errors: MUS_ERR_FILE, MUS_ERR_FORMAT, MUS_ERR_PATTERN, MUS_ERR_UNSUPPORTED (GarmentCode: control points that are not
 *         relative, normalised translations), MUS_ERR_LIMIT (above 256 MiB or 10000 panels), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_pattern_read(mus_context *context, const char *path, mus_pattern **out);

/** Read a pattern from `size` bytes of text, in any of the forms of mus_pattern_read().
 * Errors: as mus_pattern_read(), but for MUS_ERR_FILE */
MUS_API mus_status mus_pattern_read_from(mus_context *context, const char *text, size_t size, const char *name,
                                         mus_pattern **out);

/** A DXF of the garment trade to read, with the grade rules beside it. */
typedef struct mus_pattern_dxf {
    size_t size;
    const char *path;       /* of the DXF; with `text` its name in messages */
    const char *text;       /* (text_size) the DXF in memory; NULL (default): read the file */
    size_t text_size;
    const char *rules_path; /* of the RUL file, NULL (default): none; with `rules` its name in messages */
    const char *rules;      /* (rules_size) the RUL in memory; NULL (default): read the file */
    size_t rules_size;
    const char *size_name;  /* wanted size ("40"); NULL (default): the sample size */
} mus_pattern_dxf;

/** Write the defaults: no file, no rules, the sample size. */
MUS_API void mus_pattern_dxf_init(mus_pattern_dxf *dxf, size_t size);

/**
 * Read the pieces of a DXF (AAMA, ASTM D6673, as Gerber, CLO and Valentina write them) as a pattern without seams.
 *
 * A block with an outline on layer 1 is a panel. The sew line (14; in Valentina's AAMA the first closed line of 8) is
 * its outline, and the distance to the cut line the allowance of each edge; without a sew line the boundary is the
 * outline, with allowance 0. Edges begin at turn points (2) and where polylines end; without either, at corners of
 * more than 30 degrees. Notches (4), grain (7), lines inside (8, 11) and drill points (13) are kept; half a piece
 * with a mirror line (6) is unfolded; a piece that is cut in pairs ("Quantity: 1,1") gets its mirror image. A size
 * without blocks of its own is made from the sample by the rules, linearly by arc length between graded points.
 * Units:  metre; the file's are millimetres, or inches with "Units: ENGLISH"
 * Errors: MUS_ERR_FILE, MUS_ERR_FORMAT (the message has file, line and the expected content), MUS_ERR_UNSUPPORTED (an
 *         arc or a spline in an outline), MUS_ERR_ARG (a size that the file has not: the message lists its sizes),
 *         MUS_ERR_LIMIT (above 256 MiB, 10000 blocks, 20000 points of an outline), MUS_ERR_VERSION, MUS_ERR_MEMORY
 * Source: ANSI/AAMA-292-1993; ASTM D6673-10
 */
MUS_API mus_status mus_pattern_read_dxf(mus_context *context, const mus_pattern_dxf *from, mus_pattern **out);

/** A pattern of Valentina or Seamly to read, with the measurements that its formulas name. */
typedef struct mus_pattern_val {
    size_t size;
    const char *path;          /* of the .val or .sm2d; with `text` its name in messages */
    const char *text;          /* (text_size) the pattern in memory; NULL (default): read the file */
    size_t text_size;
    const char *measures_path; /* of the .vit, .smis or .vst, NULL (default): none; with `measures` its name in
                                * messages */
    const char *measures;      /* (measures_size) the measurements in memory; NULL (default): read the file */
    size_t measures_size;
    const char *size_name;     /* of a .vst "SIZE_HEIGHT" in its unit ("500_1760"); NULL (default): its base */
} mus_pattern_val;

/** Write the defaults: no file, no measurements. */
MUS_API void mus_pattern_val_init(mus_pattern_val *val, size_t size);

/**
 * Read a pattern of Valentina or Seamly: its drawing is evaluated, and its pieces become panels without seams.
 *
 * Points, lines, splines, arcs, cuts, true darts and operations are drawn; formulas may use measurements, increments,
 * and lengths and angles of the drawing. An outline keeps its curves; allowance, grain, passmarks (as notches), lines
 * inside and numbers of copies are kept. Not known: elliptical arcs, points where two curves cross, pieces that a tool
 * unites; not read: labels, placement on a fold, forms of corners, allowances that change along an edge.
 * Errors: MUS_ERR_FILE, MUS_ERR_FORMAT (the message has file, line, the formula and the part at fault),
 *         MUS_ERR_UNSUPPORTED (a tool that is not known, by name), MUS_ERR_PATTERN (lines that do not meet),
 *         MUS_ERR_ARG (size_name), MUS_ERR_LIMIT (above 256 MiB, 500000 elements, ids above 1000000),
 *         MUS_ERR_VERSION, MUS_ERR_MEMORY
 * Source: the formats as Valentina 0.7 writes them (versions 0.2.4 to 0.8.12 of the pattern's form were tried)
 */
MUS_API mus_status mus_pattern_read_val(mus_context *context, const mus_pattern_val *from, mus_pattern **out);

/**
 * Propose the seams of a pattern whose file has none (a DXF): pairs of edges, each with a confidence.
 *
 * Edges are judged by lengths, curvature, notches, grain, mirror symmetry and names of panels, and by the surface that
 * the whole sewing makes. Of names the words front, back, left, right and those of a part (torso, sleeve, cuff, collar,
 * hood, waistband, skirt, godet, leg and others) count: no seam goes from one arm to the other side. First come the
 * seams of the sewing that was found best, where each edge is in one seam at most, then second choices of edges, each
 * group by falling confidence. All are MUS_SEAM_REVERSED. Seams that the pattern has are kept and not listed, so that a
 * corrected part improves the rest: sew the right ones by mus_pattern_add_seam() and call again. Lines inside a panel,
 * and one edge against a part of another, are not sought.
 * `make seams` prints how many are right.
 * Shapes: edges (capacity x 2), chosen and confidence (capacity), each may be NULL; *count is how many there are, twice
 *         the edges of the pattern at most. chosen is 1 in the sewing, 0 of a second choice; confidence is 0 to 1
 * Errors: MUS_ERR_ARG, MUS_ERR_LIMIT (above 500 edges), MUS_ERR_PATTERN, MUS_ERR_MEMORY
 * Memory: 8 bytes for each pair of edges, and less for the rest, during the call
 * Cost:   0.1 s for 25 edges, 0.6 s for 60, 4 s for 170, minutes for 500
 * Source: ours: a linear score of a sewing, its weights by conditional logit, its search by annealing (lib/seam)
 */
MUS_API mus_status mus_pattern_propose_seams(const mus_pattern *pattern, int32_t *edges, int32_t *chosen,
                                             double *confidence, int32_t capacity, int32_t *count);

/** Write a pattern as muslin JSON. path "-" writes to standard output. Numbers have up to 17 digits, so that reading
 * the file back gives the same pattern, bit for bit. Errors: MUS_ERR_ARG, MUS_ERR_FILE, MUS_ERR_MEMORY */
MUS_API mus_status mus_pattern_write(const mus_pattern *pattern, const char *path);

/** Write a pattern as mus_pattern_write() does, into memory. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY */
MUS_API mus_status mus_pattern_write_bytes(const mus_pattern *pattern, char **bytes, size_t *size);

/**
 * Write a pattern as a GarmentCode specification (JSON, centimetres and degrees); path "-" writes to standard output.
 *
 * Each piece of an edge becomes an edge of its own; the edges of a seam are cut where either has a joint, at equal
 * relative arc lengths, and their parts are stitched one by one. Not held: lines inside panels, a second seam of an
 * edge, ease, closures, notches, marks, grain, allowances, quantities, bends of placements, layers.
 * Errors: MUS_ERR_ARG, MUS_ERR_PATTERN (a panel without outline), MUS_ERR_UNSUPPORTED (an edge that ends where it
 *         starts), MUS_ERR_FILE, MUS_ERR_MEMORY
 * Source: Korosteleva and Sorkine-Hornung, GarmentCode: Programming Parametric Sewing Patterns, 2023
 */
MUS_API mus_status mus_pattern_write_garmentcode(const mus_pattern *pattern, const char *path);

/** Write the specification into memory. Errors: as mus_pattern_write_garmentcode(), but for MUS_ERR_FILE */
MUS_API mus_status mus_pattern_write_garmentcode_bytes(const mus_pattern *pattern, char **bytes, size_t *size);

/**
 * Write a pattern as an SVG that drawing programs edit and mus_pattern_read() reads back; path "-" writes to standard
 * output. Millimetres; curves as they are; a layer a panel; muslin_pattern(5) has the convention.
 *
 * Not held: attachments of edges to the body, elastics, openings, places of panels round the body, sides that a name
 * does not tell. Points come back within 1e-9 m, the middle of a flat arc within 0.01 mm.
 * Errors: MUS_ERR_ARG, MUS_ERR_FILE, MUS_ERR_MEMORY
 * Source: W3C, Scalable Vector Graphics 1.1 (2011)
 */
MUS_API mus_status mus_pattern_write_svg(const mus_pattern *pattern, const char *path);

/** Write the SVG into memory. Errors: as mus_pattern_write_svg(), but for MUS_ERR_FILE */
MUS_API mus_status mus_pattern_write_svg_bytes(const mus_pattern *pattern, char **bytes, size_t *size);

/**
 * Read a fabric file (JSON, muslin_fabric(5)). Each value stands under a key that names the unit, as a number and its
 * source.
 *
 * `out` (its size set by mus_fabric_init()) gets all ten values; after a failure it is unchanged.
 * Errors: MUS_ERR_FILE, MUS_ERR_FORMAT (the message has file, line and fault: not JSON, a missing value or source, an
 *         unknown key, a number out of the range of mus_fabric_check()), MUS_ERR_LIMIT (above 256 MiB),
 *         MUS_ERR_VERSION (size of out), MUS_ERR_ARG, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_fabric_load(mus_context *context, const char *path, mus_fabric *out);

/** Read a fabric from `size` bytes of text. Errors: as mus_fabric_load(), but for MUS_ERR_FILE */
MUS_API mus_status mus_fabric_load_from(mus_context *context, const char *text, size_t size, const char *name,
                                        mus_fabric *out);

/**
 * Write a fabric file; path "-" writes to standard output. Reading it back gives the same values, bit for bit.
 *
 * Shapes: sources (values) one text for each value, in the order of mus_fabric_value_key(); NULL takes the sources of
 *         the named fabric `name`
 * Errors: MUS_ERR_ARG (a value out of range; name or a source empty or too long; no sources and no such named fabric),
 *         MUS_ERR_VERSION, MUS_ERR_FILE, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_fabric_save(mus_context *context, const mus_fabric *fabric, const char *name,
                                   const char *const *sources, const char *path);

/** Write a fabric as mus_fabric_save() does, into memory. Errors: as mus_fabric_save(), but for MUS_ERR_FILE */
MUS_API mus_status mus_fabric_save_bytes(mus_context *context, const mus_fabric *fabric, const char *name,
                                         const char *const *sources, char **bytes, size_t *size);

/** A triangle mesh to write: positions, and optional normals and texture coordinates. The arrays are borrowed during
 * the call. */
typedef struct mus_mesh_view {
    size_t size;
    const char *name;
    int32_t vertex_count;
    int32_t triangle_count;
    const double *positions;  /* (vertices x 3) [m] */
    const double *normals;    /* (vertices x 3) or NULL */
    const double *texcoords;  /* (vertices x 2) or NULL; of cloth the position in the panel [m] */
    const int32_t *triangles; /* (triangles x 3) vertex indices from 0 */
    double colour[4];         /* linear RGBA, 0..1, default light grey */
    int32_t two_sided;        /* nonzero for cloth */
} mus_mesh_view;

/** Zero `view`, write the defaults and its size. */
MUS_API void mus_mesh_view_init(mus_mesh_view *view, size_t size);

/** Write n meshes as one Wavefront OBJ, one `o` object for each. path "-" writes to standard output. Errors:
 * MUS_ERR_ARG (a number is not finite, an index is out of range), MUS_ERR_VERSION, MUS_ERR_FILE, MUS_ERR_MEMORY */
MUS_API mus_status mus_mesh_write_obj(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes);

/** Write n meshes as mus_mesh_write_obj() does, into memory. Errors: as mus_mesh_write_obj(), but for MUS_ERR_FILE */
MUS_API mus_status mus_mesh_write_obj_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes,
                                            size_t *size);

/** Write n meshes as one binary glTF 2.0. path "-" writes to standard output. Errors: MUS_ERR_ARG (a number is not
 * finite, an index is out of range), MUS_ERR_VERSION, MUS_ERR_LIMIT (a file above 4 GiB), MUS_ERR_FILE,
 * MUS_ERR_MEMORY */
MUS_API mus_status mus_mesh_write_glb(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes);

/** Write n meshes as mus_mesh_write_glb() does, into memory. Errors: as mus_mesh_write_glb(), but for MUS_ERR_FILE */
MUS_API mus_status mus_mesh_write_glb_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes,
                                            size_t *size);

/** A mesh in motion: positions of its vertices at each key (a time of the animation). */
typedef struct mus_mesh_motion {
    size_t size;
    const double *positions; /* (keys x vertices x 3) [m]; NULL: the mesh stands still */
    const double *normals;   /* (keys x vertices x 3), only of a mesh with normals; NULL: its normals do not change */
} mus_mesh_motion;

/** Zero `motion` and write its size. The motion is that of a mesh that stands still. */
MUS_API void mus_mesh_motion_init(mus_mesh_motion *motion, size_t size);

/**
 * Write meshes in motion as one binary glTF 2.0: one morph target for each key, and an animation that blends from key
 * to key.
 *
 * Shapes:  meshes (n) at rest; times (keys) ascending from 0 on [s]; motion (n)
 * Errors:  MUS_ERR_ARG (as mus_mesh_write_glb; keys not 1 to 4096; times not ascending), MUS_ERR_VERSION,
 *          MUS_ERR_LIMIT (a file above 4 GiB), MUS_ERR_FILE, MUS_ERR_MEMORY
 * Memory:  the whole file: 24 bytes for each vertex and key, 4 keys^2 bytes for each moving mesh
 */
MUS_API mus_status mus_mesh_write_glb_motion(mus_context *context, const char *path, int32_t n,
                                             const mus_mesh_view *meshes, int32_t keys, const double *times,
                                             const mus_mesh_motion *motion);

/** Write meshes in motion as mus_mesh_write_glb_motion() does, into memory. Errors: the same, but for MUS_ERR_FILE */
MUS_API mus_status mus_mesh_write_glb_motion_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes,
                                                   int32_t keys, const double *times, const mus_mesh_motion *motion,
                                                   char **bytes, size_t *size);

/** Forms of a mesh file. */
#define MUS_MESH_OBJ 0  /* Wavefront OBJ; a panel is a group with a material of its own, in an .mtl beside the file */
#define MUS_MESH_GLB 1  /* binary glTF 2.0; a panel is a node, mesh and material */
#define MUS_MESH_USDA 2 /* Universal Scene Description as text; a panel is a Mesh under the garment's Xform */
#define MUS_MESH_PLY 3  /* PLY, binary; vertices and triangles have the number of their panel, comments its name */
#define MUS_MESH_PC2 4  /* point cache: the positions of one mesh at each key */

/** Meshes to write, with the cloths that they are of and their motion. All arrays are borrowed during the call. */
typedef struct mus_mesh_file {
    size_t size;
    int32_t form;                   /* MUS_MESH_OBJ (default) to MUS_MESH_PC2 */
    int32_t count;                  /* number of meshes, 1 or more; of a point cache 1 */
    const mus_mesh_view *meshes;    /* (count) */
    const mus_cloth *const *cloths; /* (count) the cloth whose nodes and triangles a mesh has, NULL for another mesh;
                                     * NULL (default): no mesh is of a cloth */
    const char *const *materials;   /* (count) names of the materials ("jersey"), NULL without one; NULL (default) */
    int32_t keys;                   /* times of the motion, 0 (default): nothing moves. OBJ and PLY have no motion */
    const double *times;            /* (keys) ascending from 0 on [s] */
    const mus_mesh_motion *motion;  /* (count) */
} mus_mesh_file;

/** Zero `file` and write its size: an OBJ without meshes. */
MUS_API void mus_mesh_file_init(mus_mesh_file *file, size_t size);

/**
 * Write meshes in one of the forms; path "-" writes to standard output.
 *
 * The mesh of a cloth is divided into its panels, by name, and its seams become lines (not in a point cache). Its first
 * texture coordinates are the flat panels at one scale, packed in the unit square without overlap; glTF and USDA hold
 * view->texcoords, the same in metres, as the second. The material of a panel is "jersey.front". A mesh without a cloth
 * is written whole.
 * Errors:  MUS_ERR_ARG (form; as mus_mesh_write_glb() and mus_mesh_write_glb_motion(); a mesh that has not the nodes
 *          and triangles of its cloth; a point cache of other than one mesh in motion), MUS_ERR_VERSION,
 *          MUS_ERR_LIMIT (a .glb above 4 GiB), MUS_ERR_FILE, MUS_ERR_MEMORY
 * Memory:  the whole file, and 20 bytes for each vertex
 * Source:  Wavefront, Advanced Visualizer appendix B1; Khronos, glTF 2.0; Pixar, USD; Turk, PLY, 1994
 */
MUS_API mus_status mus_mesh_write(mus_context *context, const char *path, const mus_mesh_file *file);

/** Write meshes as mus_mesh_write() does, into memory; the materials of an OBJ are left out.
 * Errors: as mus_mesh_write(), but for MUS_ERR_FILE */
MUS_API mus_status mus_mesh_write_bytes(mus_context *context, const mus_mesh_file *file, char **bytes, size_t *size);

/** A triangle mesh that was read from a file. */
typedef struct mus_mesh mus_mesh;

/**
 * Read a Wavefront OBJ as one triangle mesh: positions and faces of all its objects.
 *
 * A face of more than three corners becomes a fan of triangles. The numbers are unchanged, since an OBJ has neither a
 * unit nor an upward axis. mus_body_create_scan() makes a body from the mesh.
 * Errors: MUS_ERR_FILE, MUS_ERR_FORMAT (the message has file, line and the expected content), MUS_ERR_LIMIT (above
 *         256 MiB or 16 million triangles), MUS_ERR_ARG, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_mesh_read_obj(mus_context *context, const char *path, mus_mesh **out);

/** Read a Wavefront OBJ from `size` bytes of text. Errors: as mus_mesh_read_obj(), but for MUS_ERR_FILE */
MUS_API mus_status mus_mesh_read_obj_from(mus_context *context, const char *text, size_t size, const char *name,
                                          mus_mesh **out);

/** Free a mesh. NULL is accepted. */
MUS_API void mus_mesh_destroy(mus_mesh *mesh);

/** Number of vertices. */
MUS_API int32_t mus_mesh_vertex_count(const mus_mesh *mesh);

/** Number of triangles. */
MUS_API int32_t mus_mesh_triangle_count(const mus_mesh *mesh);

/** Positions (vertex_count x 3) in the unit of the file; borrowed until the mesh is destroyed. */
MUS_API const double *mus_mesh_vertices(const mus_mesh *mesh);

/** Vertices of each triangle (triangle_count x 3); borrowed until the mesh is destroyed. */
MUS_API const int32_t *mus_mesh_triangles(const mus_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
