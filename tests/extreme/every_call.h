/*
 * every_call.h: a row for every public function, X(name, before, (arguments)), in four tables: calls that allocate,
 * of them those that move cloth, calls that give a status and allocate nothing, and the rest, which cannot fail.
 * tests/guard/calls.py holds that no function of include/muslin is without a row.
 *
 * `w` is the world of world.h: w->have the objects that are there, w->made those that a call makes.
 * `before` makes what the call needs besides.
 */
#ifndef MUS_TESTS_EVERY_CALL_H
#define MUS_TESTS_EVERY_CALL_H

#define P w->have.pattern
#define TEXT w->text, w->text_size
#define BYTES &w->bytes, &w->size

/* failing memory is MUS_ERR_MEMORY, and nothing is changed */
#define CALLS_THAT_ALLOCATE(X)                                                                                         \
    X(mus_arrange_pattern, nothing, (P, w->have.body))                                                                 \
    X(mus_pattern_reason, nothing, (P, &w->reason))                                                                    \
    X(mus_context_create, nothing, (&w->context_def, &w->second))                                                      \
    X(mus_body_create, nothing, (w->context, w->have.tape, &w->body_def, &w->made.body))                               \
    X(mus_body_create_limbs, nothing, (w->context, 1, &w->limb, &w->body_def, &w->made.body))                          \
    X(mus_catalogue_add, nothing, (w->have.catalogue, P, "again", w->whole))                                           \
    X(mus_catalogue_nearest, nothing, (w->have.catalogue, P, ROOM, w->whole, w->real, NULL, &w->more))                 \
    X(mus_catalogue_explain, nothing, (w->have.catalogue, P, w->row, w->real, w->line, sizeof w->line))                \
    X(mus_catalogue_containing, nothing, (w->have.catalogue, P, w->whole, ROOM, &w->more))                             \
    X(mus_cloth_create, nothing, (w->context, P, &w->cloth_def, &w->made.cloth))                                       \
    X(mus_cloth_create_grid, nothing, (w->context, 5, 4, (double[2]){0.1, 0.1}, &w->cloth_def, &w->made.cloth))        \
    X(mus_cloth_create_bare, nothing, (w->context, &w->bare, &w->made.cloth))                                          \
    X(mus_design_search, nothing, (w->context, "kids dress", ROOM, w->whole, w->real, &w->more))                       \
    X(mus_design_draft, nothing, (w->context, mus_design_find("skirt"), w->have.tape, NULL, &w->made.pattern))         \
    X(mus_design_draft_words, nothing, (w->context, "top neck=v", w->have.tape, NULL, &w->made.pattern))               \
    X(mus_design_grade_apply, nothing, (P, w->real, &w->made.pattern))                                                 \
    X(mus_drape_create, nothing, (w->context, w->have.cloth, w->have.body, &w->drape_def, &w->made.drape))             \
    X(mus_drape_create_plain, nothing, (w->context, w->have.cloth, NULL, &w->made.drape))                              \
    X(mus_drape_warm, another_drape, (w->have.drape, w->made.drape))                                                   \
    X(mus_drape_tack, nothing, (w->have.drape, 0, 3, 10.0, w->whole))                                                  \
    X(mus_drape_add_plane, nothing, (w->have.drape, NULL, w->whole))                                                   \
    X(mus_drape_estimate, nothing, (w->have.drape, 0.01, &w->estimate))                                                \
    X(mus_drape_start, nothing, (w->have.drape, &w->reason))                                                           \
    X(mus_drape_crossings, nothing, (w->have.drape, 0, NULL, &w->count))                                               \
    X(mus_pattern_keep_history, nothing, (P, 20))                                                                      \
    X(mus_pattern_dart, dart, (P, w->leg, w->real, w->real + 1, w->real + 2))                                          \
    X(mus_pattern_add_dart, nothing, (P, BOTTOM, 0.2, 0.03, (double[2]){0.2, 0.2}, w->whole))                          \
    X(mus_pattern_rotate_dart, dart, (P, w->leg, w->right, 0.2, w->left, 0.5, w->whole))                               \
    X(mus_pattern_split_dart, dart,                                                                                    \
      (P, w->leg, 1, &w->right, (double[1]){0.2}, (double[1]){0.5}, w->left, w->whole))                                \
    X(mus_pattern_merge_darts, two_darts, (P, w->second_leg, w->leg, w->left, w->whole))                               \
    X(mus_pattern_shorten_dart, dart, (P, w->leg, 0.02))                                                               \
    X(mus_pattern_release_dart, dart, (P, w->leg, w->whole))                                                           \
    X(mus_pattern_separate, nothing, (P, &w->cut_def, w->whole, w->whole + 1))                                         \
    X(mus_pattern_dart_to_seam, dart, (P, &w->cut_def, w->whole, w->whole + 1))                                        \
    X(mus_pattern_join_panels, nothing, (P, 0, w->whole))                                                              \
    X(mus_pattern_mirror_panel, nothing, (P, 0, "again", w->whole))                                                    \
    X(mus_pattern_unfold, nothing, (P, LEFT))                                                                          \
    X(mus_pattern_add_facing, nothing, (P, BOTTOM, 0.03, "again", w->whole))                                           \
    X(mus_pattern_add_patch, nothing,                                                                                  \
      (P, 0, "again", 4, (double[8]){0.1, 0.3, 0.1, 0.1, 0.3, 0.1, 0.3, 0.3}, w->whole))                               \
    X(mus_pattern_remove_panel, nothing, (P, 1))                                                                       \
    X(mus_pattern_remove_seam, nothing, (P, 0))                                                                        \
    X(mus_pattern_spread, nothing, (P, RIGHT, 0.2, LEFT, 0.2, 0.02, 0.02))                                             \
    X(mus_pattern_flare, nothing, (P, RIGHT, LEFT, 2, 0.05))                                                           \
    X(mus_pattern_pleat, nothing, (P, RIGHT, 0.2, LEFT, 0.2, 0.02, 0.02))                                              \
    X(mus_pattern_lay_pleats, nothing, (P, BOTTOM, 1, (double[1]){0.2}, (double[1]){0.03}))                            \
    X(mus_pattern_lengthen, nothing, (P, 0, (double[2]){0.2, 0.2}, (double[2]){1.0, 0.0}, 0.05))                       \
    X(mus_pattern_move_point, nothing, (P, 0, -0.01, 0.0))                                                             \
    X(mus_pattern_move_control, curve, (P, RIGHT, 1, 0.45, 0.1))                                                       \
    X(mus_pattern_redraw_edge, nothing,                                                                                \
      (P, RIGHT, 1, (int32_t[1]){MUS_PIECE_QUADRATIC}, 1, (double[2]){0.45, 0.2}))                                     \
    X(mus_pattern_fair_edge, corner, (P, RIGHT, 0.01))                                                                 \
    X(mus_pattern_split_edge, nothing, (P, TOP, 0.1, "again", w->whole))                                               \
    X(mus_pattern_merge_edges, split, (P, BOTTOM, w->whole))                                                           \
    X(mus_pattern_true_seam, untrue, (P, 0, TOP, 1))                                                                   \
    X(mus_pattern_notch_seam, nothing, (P, TOP, 0.1, MUS_NOTCH_SINGLE))                                                \
    X(mus_tape_read, tape_file, (w->context, w->path, NULL, &w->made.tape))                                            \
    X(mus_tape_read_from, tape_file, (w->context, TEXT, "again.tape", NULL, &w->made.tape))                            \
    X(mus_tape_write, nothing, (w->have.tape, w->path))                                                                \
    X(mus_tape_write_bytes, nothing, (w->have.tape, BYTES))                                                            \
    X(mus_pattern_read, pattern_file, (w->context, w->path, &w->made.pattern))                                         \
    X(mus_pattern_read_from, pattern_file, (w->context, TEXT, "again", &w->made.pattern))                              \
    X(mus_pattern_read_dxf, dxf_file, (w->context, &w->dxf, &w->made.pattern))                                         \
    X(mus_pattern_read_val, val_file, (w->context, &w->val, &w->made.pattern))                                         \
    X(mus_pattern_propose_seams, nothing, (P, w->whole, w->whole + ROOM, w->real, 4, &w->more))                        \
    X(mus_pattern_write, nothing, (P, w->path))                                                                        \
    X(mus_pattern_write_bytes, nothing, (P, BYTES))                                                                    \
    X(mus_pattern_write_garmentcode, nothing, (P, w->path))                                                            \
    X(mus_pattern_write_garmentcode_bytes, nothing, (P, BYTES))                                                        \
    X(mus_pattern_write_svg, nothing, (P, w->path))                                                                    \
    X(mus_pattern_write_svg_bytes, nothing, (P, BYTES))                                                                \
    X(mus_fabric_load, fabric_file, (w->context, w->path, &w->fabric))                                                 \
    X(mus_fabric_load_from, fabric_file, (w->context, TEXT, "again", &w->fabric))                                      \
    X(mus_fabric_save, nothing, (w->context, &w->fabric, mus_fabric_name(0), NULL, w->path))                           \
    X(mus_fabric_save_bytes, nothing, (w->context, &w->fabric, mus_fabric_name(0), NULL, BYTES))                       \
    X(mus_mesh_write_obj, nothing, (w->context, w->path, 1, &w->view))                                                 \
    X(mus_mesh_write_obj_bytes, nothing, (w->context, 1, &w->view, BYTES))                                             \
    X(mus_mesh_write_glb, nothing, (w->context, w->path, 1, &w->view))                                                 \
    X(mus_mesh_write_glb_bytes, nothing, (w->context, 1, &w->view, BYTES))                                             \
    X(mus_mesh_write_glb_motion, nothing, (w->context, w->path, 1, &w->view, 1, w->real, &w->motion))                  \
    X(mus_mesh_write_glb_motion_bytes, nothing, (w->context, 1, &w->view, 1, w->real, &w->motion, BYTES))              \
    X(mus_mesh_write, nothing, (w->context, w->path, &w->file))                                                        \
    X(mus_mesh_write_bytes, nothing, (w->context, &w->file, BYTES))                                                    \
    X(mus_mesh_read_obj, mesh_file, (w->context, w->path, &w->made.mesh))                                              \
    X(mus_mesh_read_obj_from, mesh_file, (w->context, TEXT, "again", &w->made.mesh))                                   \
    X(mus_fit_create, nothing, (w->have.drape, w->have.body, &w->made.fit))                                            \
    X(mus_fit_worn, nothing, (w->have.drape, P, w->have.body, &w->worn))                                               \
    X(mus_manifold_create, nothing, (w->have.body, &w->manifold_def, &w->made.manifold))                               \
    X(mus_pattern_create, nothing, (w->context, "again", &w->made.pattern))                                            \
    X(mus_pattern_copy, nothing, (P, &w->made.pattern))                                                                \
    X(mus_pattern_add_panel, full_of_panels, (P, "again", w->whole))                                                   \
    X(mus_pattern_add_point, copied, (P, 0, 0.1, 0.1, w->whole))                                                       \
    X(mus_pattern_add_edge, copied, (P, &w->edge_def, w->whole))                                                       \
    X(mus_pattern_set_outline, loose_edges, (P, 2, 3, (int32_t[3]){8, 9, 10}, (int32_t[3]){1, 1, 1}))                  \
    X(mus_pattern_add_seam, full_of_seams, (P, &w->seam_def, w->whole))                                                \
    X(mus_pattern_add_notch, full_of_notches, (P, BOTTOM, 0.1, MUS_NOTCH_DOUBLE, w->whole))                            \
    X(mus_pattern_add_mark, nothing, (P, 0, "again", 2, (double[4]){0.1, 0.1, 0.2, 0.2}, w->whole))                    \
    X(mus_pattern_set_cut_only, another_pattern, (P, w->made.pattern))                                                 \
    X(mus_pattern_add_opening, nothing, (P, "again"))                                                                  \
    X(mus_pattern_join, another_pattern, (P, w->made.pattern, 1))                                                      \
    X(mus_pattern_rim, nothing, (P, 0, w->whole, w->whole + ROOM, ROOM, &w->more))                                     \
    X(mus_pattern_cut_line, nothing, (P, 0, 0.02, &w->made.cut_line))                                                  \
    X(mus_body_pose, nothing, (w->have.body, &w->pose, &w->made.body))                                                 \
    X(mus_body_stand, nothing, (w->have.body, MUS_FOOT_LEFT, &w->pose))                                                \
    X(mus_move_create, nothing, (w->context, 1, w->real, &w->pose, 0.0, &w->made.move))                                \
    X(mus_move_named, nothing, (w->context, "walk", 1.7, &w->made.move))                                               \
    X(mus_body_move, nothing, (w->have.body, "walk", 0.01, &w->made.move))                                             \
    X(mus_layout_create, nothing, (w->context, P, &w->layout_def, &w->made.layout))                                    \
    X(mus_layout_create_items, nothing,                                                                                \
      (w->context, 1, &w->layout_item, &w->layout_def, &w->made.layout))                                               \
    X(mus_layout_write_svg, nothing, (w->have.layout, w->path))                                                        \
    X(mus_layout_write_svg_bytes, nothing, (w->have.layout, BYTES))                                                    \
    X(mus_sheet_create, nothing, (w->context, P, NULL, &w->made.sheet))                                                \
    X(mus_sheet_create_sizes, nothing,                                                                                 \
      (w->context, 2, (const mus_pattern *[2]){P, P}, (const char *[2]){"a", "b"}, NULL, &w->made.sheet))              \
    X(mus_sheet_write_pdf, nothing, (w->have.sheet, w->path))                                                          \
    X(mus_sheet_write_pdf_bytes, nothing, (w->have.sheet, BYTES))                                                      \
    X(mus_sheet_write_svg, nothing, (w->have.sheet, w->path))                                                          \
    X(mus_sheet_write_svg_bytes, nothing, (w->have.sheet, BYTES))                                                      \
    X(mus_sheet_write_dxf, nothing, (w->have.sheet, NULL, w->path))                                                    \
    X(mus_sheet_write_dxf_bytes, nothing, (w->have.sheet, NULL, BYTES))                                                \
    X(mus_sheet_write_rul, nothing, (w->have.sheet, &w->rul, w->path))                                                 \
    X(mus_sheet_write_rul_bytes, nothing, (w->have.sheet, &w->rul, BYTES))                                             \
    X(mus_sheet_write_plt, nothing, (w->have.sheet, NULL, w->path))                                                    \
    X(mus_sheet_write_plt_bytes, nothing, (w->have.sheet, NULL, BYTES))                                                \
    X(mus_pattern_write_instructions_in, nothing, (P, "de", "title", w->path))                                         \
    X(mus_pattern_write_instructions_in_bytes, nothing, (P, "ja", NULL, BYTES))                                        \
    X(mus_pattern_write_instructions, nothing, (P, "title", w->path))                                                  \
    X(mus_pattern_write_instructions_bytes, nothing, (P, NULL, BYTES))                                                 \
    X(mus_body_create_scan, mesh_of_body,                                                                              \
      (w->context, mus_mesh_vertex_count(w->have.mesh), mus_mesh_vertices(w->have.mesh),                               \
       mus_mesh_triangle_count(w->have.mesh), mus_mesh_triangles(w->have.mesh), &w->scan_def, NULL, &w->made.body))    \
    X(mus_tape_create, nothing, (w->context, &w->made.tape))                                                           \
    X(mus_tape_copy, nothing, (w->have.tape, &w->made.tape))                                                           \
    X(mus_tape_complete, nothing, (w->have.tape))                                                                      \
    X(mus_pattern_topology, nothing, (P, &w->topology))                                                                \
    X(mus_pattern_loop, nothing, (P, 0, w->whole, ROOM, &w->more, w->real))                                            \
    X(mus_pattern_loop_label, nothing, (P, 0, &w->name))                                                               \
    X(mus_pattern_homology, nothing, (P, 1, &w->homology, w->whole, ROOM))                                             \
    X(mus_pattern_boundary, nothing, (P, 1, 2, w->whole, 4, &w->more))                                                 \
    X(mus_pattern_form, nothing, (P, NULL, NULL, 0, &w->size, w->hash))                                                \
    X(mus_pattern_check, nothing, (P, &w->more, &w->made.faults))                                                      \
    X(mus_arrange_pattern, a_shirt, (P, w->have.body))                                                                 \
    X(mus_cloth_create, a_shirt, (w->context, P, &w->cloth_def, &w->made.cloth))                                       \
    X(mus_sheet_create, a_shirt, (w->context, P, NULL, &w->made.sheet))                                                \
    X(mus_pattern_write_svg_bytes, a_shirt, (P, BYTES))                                                                \
    X(mus_pattern_write_garmentcode_bytes, a_shirt, (P, BYTES))                                                        \
    X(mus_pattern_check, a_shirt, (P, &w->more, &w->made.faults))                                                      \
    X(mus_pattern_form, a_shirt, (P, NULL, NULL, 0, &w->size, w->hash))                                                \
    X(mus_catalogue_add, a_shirt, (w->have.catalogue, P, "again", w->whole))                                           \
    X(mus_catalogue_nearest, a_shirt, (w->have.catalogue, P, ROOM, w->whole, w->real, NULL, &w->more))                 \
    X(mus_design_grade_apply, a_shirt, (P, w->real, &w->made.pattern))                                                 \
    X(mus_pattern_reason, faulty, (P, &w->reason))                                                                     \
    X(mus_catalogue_open, nothing, (w->context, w->base, MUS_CATALOGUE_READ, &w->made.catalogue))                      \
    X(mus_catalogue_name, nothing, (w->have.catalogue, w->row, &w->name))                                              \
    X(mus_catalogue_exact, nothing, (w->have.catalogue, P, w->whole, ROOM, &w->more))                                  \
    X(mus_design_ease, nothing, (P, w->have.tape, w->real))                                                            \
    X(mus_drape_pin, nothing, (w->have.drape, 0, 1))                                                                   \
    X(mus_pattern_walk_seam, nothing, (P, 0, &w->walk))                                                                \
    X(mus_fit_spread_get, nothing, (w->have.fit, 0, &w->spread))

/* the same, but the cloth is left as far as it got: it is placed, and `before` made, again */
#define CALLS_THAT_MOVE(X)                                                                                             \
    X(mus_drape_sew, nothing, (w->have.drape, NULL, NULL))                                                             \
    X(mus_drape_settle, sewn, (w->have.drape, NULL, NULL))                                                             \
    X(mus_drape_untangle, sewn, (w->have.drape, &w->count))                                                            \
    X(mus_dress, nothing,                                                                                              \
      (w->context, P, NULL, &w->dress_def, NULL, &w->reason, &w->made.cloth, &w->made.drape))

/* a status, and no memory is asked for */
#define CALLS_THAT_DO_NOT(X)                                                                                           \
    X(mus_body_depth, nothing, (w->have.body, 2, w->real, w->real + 6, w->real + 8))                                   \
    X(mus_catalogue_begin, nothing, (w->have.catalogue))                                                               \
    X(mus_catalogue_commit, begun, (w->have.catalogue))                                                                \
    X(mus_catalogue_rollback, begun, (w->have.catalogue))                                                              \
    X(mus_design_spell, nothing, (w->context, "dress neck=v", w->line, sizeof w->line))                                \
    X(mus_design_grade, nothing, (P, P, w->real, &w->more))                                                            \
    X(mus_drape_place, nothing, (w->have.drape))                                                                       \
    X(mus_drape_set_state, nothing, (w->have.drape, mus_drape_positions(w->have.drape), NULL))                         \
    X(mus_drape_untack, tacked, (w->have.drape, 0))                                                                    \
    X(mus_drape_set_gravity, nothing, (w->have.drape, w->real))                                                        \
    X(mus_drape_step, nothing, (w->have.drape, 2, 0.5 * mus_drape_step_bound(w->have.drape)))                          \
    X(mus_drape_evaluate, nothing, (w->have.drape, 2))                                                                 \
    X(mus_drape_move_body, nothing, (w->have.drape, w->real))                                                          \
    X(mus_drape_pose_body, nothing, (w->have.drape, &w->pose, 0.1))                                                    \
    X(mus_drape_body_pose, nothing, (w->have.drape, &w->pose))                                                         \
    X(mus_drape_move_plane, on_ground, (w->have.drape, 0, w->real, 0.1))                                               \
    X(mus_drape_forces, nothing, (w->have.drape, w->real))                                                             \
    X(mus_drape_depth, nothing, (w->have.drape, 2, w->real, w->real + 6, w->real + 8))                                 \
    X(mus_drape_reason, nothing, (w->have.drape, &w->reason))                                                          \
    X(mus_drape_report_get, nothing, (w->have.drape, &w->report))                                                      \
    X(mus_drape_gaps, nothing, (w->have.drape, w->real))                                                               \
    X(mus_drape_normals, nothing, (w->have.drape, w->real))                                                            \
    X(mus_pattern_undo, edited, (P))                                                                                   \
    X(mus_pattern_redo, undone, (P))                                                                                   \
    X(mus_integrate, nothing, (w->context, &w->motion_law, 2, w->real, 4, w->real + 2, &w->count))                     \
    X(mus_integrate_f32, nothing, (w->context, &w->motion_law, 2, w->single, 4, w->single + 2, &w->count))             \
    X(mus_pattern_set_name, nothing, (P, "again"))                                                                     \
    X(mus_pattern_set_edge_label, nothing, (P, BOTTOM, "again"))                                                       \
    X(mus_pattern_set_edge_allowance, nothing, (P, BOTTOM, 0.02))                                                      \
    X(mus_pattern_set_edge_hold, nothing, (P, BOTTOM, MUS_HOLD_WAIST, 0.1))                                            \
    X(mus_pattern_hold_label, nothing, (P, "hem", MUS_HOLD_WAIST, 0.1, &w->more))                                      \
    X(mus_pattern_set_edge_elastic, nothing, (P, BOTTOM, 0.8, 60.0))                                                   \
    X(mus_pattern_open_closures, nothing, (P, 1, &w->more))                                                            \
    X(mus_pattern_set_grain, nothing, (P, 0, 1.0, 1.0))                                                                \
    X(mus_pattern_set_cut, nothing, (P, 0, 2, MUS_NONE))                                                               \
    X(mus_pattern_set_material, nothing, (P, 0, MUS_MATERIAL_LINING, 2))                                               \
    X(mus_pattern_set_panel_name, nothing, (P, 0, "again"))                                                            \
    X(mus_pattern_set_panel_label, nothing, (P, 0, "again"))                                                           \
    X(mus_pattern_set_panel_sides, nothing, (P, 0, MUS_SIDE_FRONT))                                                    \
    X(mus_pattern_set_placement, nothing, (P, 0, &w->placement))                                                       \
    X(mus_pattern_placement, nothing, (P, 0, &w->placement))                                                           \
    X(mus_pattern_set_layer, nothing, (P, 0, 1))                                                                       \
    X(mus_pattern_outline, nothing, (P, 0, &w->more, &w->index, &w->index))                                            \
    X(mus_cut_line_loop, nothing, (w->have.cut_line, 0, &w->more, &w->xy))                                             \
    X(mus_cut_line_dart, cut_dart, (w->have.cut_line, 0, w->real))                                                     \
    X(mus_pattern_grain, nothing, (P, 0, w->real))                                                                     \
    X(mus_pattern_cut, nothing, (P, 0, w->whole, w->whole + 1))                                                        \
    X(mus_pattern_material, nothing, (P, 0, MUS_MATERIAL_MAIN, w->whole, w->whole + 1))                                \
    X(mus_pattern_point, nothing, (P, 0, w->whole, w->real))                                                           \
    X(mus_pattern_edge_ends, nothing, (P, 0, w->whole, w->whole + 1))                                                  \
    X(mus_pattern_edge_hold, nothing, (P, 0, w->whole, w->real))                                                       \
    X(mus_pattern_edge_elastic, nothing, (P, 0, w->real, w->real + 1))                                                 \
    X(mus_pattern_edge_pieces, nothing, (P, 0, w->whole, &w->index, &w->more, &w->xy))                                 \
    X(mus_pattern_edge_at, nothing, (P, 0, 2, (double[2]){0.1, 0.2}, w->real))                                         \
    X(mus_pattern_edge_polyline, nothing, (P, 0, 3, w->real, ROOM, &w->more))                                          \
    X(mus_pattern_seam, nothing, (P, 0, &w->seam_def))                                                                 \
    X(mus_pattern_notch, nothing, (P, 0, w->whole, w->real, w->whole + 1))                                             \
    X(mus_pattern_mark, nothing, (P, 0, w->whole, &w->name, &w->more, &w->xy))                                         \
    X(mus_joint_limits, nothing, (MUS_JOINT_NECK, MUS_POSE_FLEXION, w->real, w->real + 1))                             \
    X(mus_pose_check, nothing, (w->context, &w->pose))                                                                 \
    X(mus_pose_named, nothing, (w->context, "sit", &w->pose))                                                          \
    X(mus_body_rest_pose, nothing, (w->have.body, &w->pose))                                                           \
    X(mus_body_stance, nothing, (w->have.body, &w->pose))                                                              \
    X(mus_body_ground, nothing, (w->have.body, &w->pose))                                                              \
    X(mus_body_clear_arms, nothing, (w->have.body, &w->pose, 0.03))                                                    \
    X(mus_move_at, nothing, (w->have.move, 0.1, &w->pose))                                                             \
    X(mus_sheet_extent, nothing, (w->have.sheet, w->real))                                                             \
    X(mus_sheet_page, nothing, (w->have.sheet, 1, w->real))                                                            \
    X(mus_layout_piece_get, nothing, (w->have.layout, 0, &w->laid))                                                    \
    X(mus_sheet_piece_get, nothing, (w->have.sheet, 0, &w->piece))                                                     \
    X(mus_sheet_line_get, nothing, (w->have.sheet, 0, &w->stroke))                                                     \
    X(mus_tape_set_sex, nothing, (w->have.tape, MUS_SEX_MALE))                                                         \
    X(mus_tape_set_name, nothing, (w->have.tape, "again"))                                                             \
    X(mus_tape_set, nothing, (w->have.tape, MUS_MEASURE_WAIST, 0.7, MUS_SOURCE_GIVEN))                                 \
    X(mus_tape_set_size, nothing, (w->have.tape, "W44"))                                                               \
    X(mus_faults_item, faulty, (w->have.faults, 0, w->whole, w->whole + 1, w->whole + 2, w->whole + 3))                \
    X(mus_fabric_find, nothing, (mus_fabric_name(0), &w->fabric))                                                      \
    X(mus_fabric_get, nothing, (&w->fabric, 0, w->real))                                                               \
    X(mus_fabric_set, nothing, (w->context, &w->fabric, 0, 0.2))                                                       \
    X(mus_fabric_check, nothing, (w->context, &w->fabric))                                                             \
    X(mus_body_limb_range, nothing, (w->have.body, 0, w->whole))                                                       \
    X(mus_body_contour_points, nothing, (w->have.body, 0, 0, 4, w->real))                                              \
    X(mus_body_landmark, nothing, (w->have.body, 0, w->real))                                                          \
    X(mus_cloth_panel_range, nothing, (w->have.cloth, 0, w->whole))                                                    \
    X(mus_cloth_panel_border, nothing, (w->have.cloth, 0, &w->more, &w->index))

/* what cannot fail, or has nothing to give here; objects are destroyed at the end of each row, where there is no memory
 * either */
#define ANSWERS(X)                                                                                                     \
    X(mus_reason_init, nothing, (&(mus_reason){0}, sizeof(mus_reason)))                                                \
    X(mus_reason_name, nothing, (0))                                                                                   \
    X(mus_status_name, nothing, (MUS_ERR_ARG))                                                                         \
    X(mus_status_text, nothing, (MUS_ERR_ARG))                                                                         \
    X(mus_version, nothing, (w->whole))                                                                                \
    X(mus_context_def_init, nothing, (&(mus_context_def){0}, sizeof(mus_context_def)))                                 \
    X(mus_context_destroy, nothing, (NULL))                                                                            \
    X(mus_context_error, nothing, (w->context))                                                                        \
    X(mus_context_bytes, nothing, (w->context))                                                                        \
    X(mus_context_allocations, nothing, (w->context))                                                                  \
    X(mus_context_log, nothing, (w->context, MUS_LOG_INFO, "again"))                                                   \
    X(mus_body_def_init, nothing, (&(mus_body_def){0}, sizeof(mus_body_def)))                                          \
    X(mus_limb_init, nothing, (&(mus_limb){0}, sizeof(mus_limb)))                                                      \
    X(mus_body_destroy, nothing, (NULL))                                                                               \
    X(mus_body_limb_count, nothing, (w->have.body))                                                                    \
    X(mus_body_limb_name, nothing, (w->have.body, 0))                                                                  \
    X(mus_body_asked, nothing, (w->have.body, 0))                                                                      \
    X(mus_body_made, nothing, (w->have.body, 0))                                                                       \
    X(mus_body_source, nothing, (w->have.body, 0))                                                                     \
    X(mus_body_volume, nothing, (w->have.body))                                                                        \
    X(mus_body_vertex_count, nothing, (w->have.body))                                                                  \
    X(mus_body_triangle_count, nothing, (w->have.body))                                                                \
    X(mus_body_vertices, nothing, (w->have.body))                                                                      \
    X(mus_body_normals, nothing, (w->have.body))                                                                       \
    X(mus_body_triangles, nothing, (w->have.body))                                                                     \
    X(mus_body_contour_count, nothing, (w->have.body, 0))                                                              \
    X(mus_body_contour_name, nothing, (w->have.body, 0, 0))                                                            \
    X(mus_catalogue_destroy, nothing, (NULL))                                                                          \
    X(mus_catalogue_count, nothing, (w->have.catalogue))                                                               \
    X(mus_fabric_init, nothing, (&(mus_fabric){0}, sizeof(mus_fabric)))                                                \
    X(mus_fabric_count, nothing, ())                                                                                   \
    X(mus_fabric_name, nothing, (0))                                                                                   \
    X(mus_fabric_source, nothing, (0))                                                                                 \
    X(mus_fabric_value_count, nothing, ())                                                                             \
    X(mus_fabric_value_key, nothing, (0))                                                                              \
    X(mus_fabric_value_source, nothing, (0, 0))                                                                        \
    X(mus_cloth_def_init, nothing, (&(mus_cloth_def){0}, sizeof(mus_cloth_def)))                                       \
    X(mus_bare_init, nothing, (&(mus_bare){0}, sizeof(mus_bare)))                                                      \
    X(mus_cloth_destroy, nothing, (NULL))                                                                              \
    X(mus_cloth_node_count, nothing, (w->have.cloth))                                                                  \
    X(mus_cloth_triangle_count, nothing, (w->have.cloth))                                                              \
    X(mus_cloth_panel_count, nothing, (w->have.cloth))                                                                 \
    X(mus_cloth_name, nothing, (w->have.cloth))                                                                        \
    X(mus_cloth_panel_name, nothing, (w->have.cloth, 0))                                                               \
    X(mus_cloth_spring_count, nothing, (w->have.cloth))                                                                \
    X(mus_cloth_pair_count, nothing, (w->have.cloth))                                                                  \
    X(mus_cloth_spacing, nothing, (w->have.cloth))                                                                     \
    X(mus_cloth_mass, nothing, (w->have.cloth))                                                                        \
    X(mus_cloth_rest, nothing, (w->have.cloth))                                                                        \
    X(mus_cloth_node_panels, nothing, (w->have.cloth))                                                                 \
    X(mus_cloth_masses, nothing, (w->have.cloth))                                                                      \
    X(mus_cloth_triangles, nothing, (w->have.cloth))                                                                   \
    X(mus_cloth_pairs, nothing, (w->have.cloth))                                                                       \
    X(mus_cloth_pair_seams, nothing, (w->have.cloth))                                                                  \
    X(mus_design_count, nothing, ())                                                                                   \
    X(mus_design_name, nothing, (0))                                                                                   \
    X(mus_design_fabric, nothing, (0))                                                                                 \
    X(mus_design_family, nothing, (0))                                                                                 \
    X(mus_design_title, nothing, (0))                                                                                  \
    X(mus_design_words, nothing, (0))                                                                                  \
    X(mus_design_groups, nothing, (0))                                                                                 \
    X(mus_design_find, nothing, ("again"))                                                                             \
    X(mus_design_axis_count, nothing, ())                                                                              \
    X(mus_design_axis_name, nothing, (0))                                                                              \
    X(mus_design_option_count, nothing, (0))                                                                           \
    X(mus_design_option_name, nothing, (0, 0))                                                                         \
    X(mus_draft_def_init, nothing, (&(mus_draft_def){0}, sizeof(mus_draft_def)))                                       \
    X(mus_drape_def_init, nothing, (&(mus_drape_def){0}, sizeof(mus_drape_def)))                                       \
    X(mus_drape_destroy, nothing, (NULL))                                                                              \
    X(mus_drape_step_bound, nothing, (w->have.drape))                                                                  \
    X(mus_plane_init, nothing, (&(mus_plane){0}, sizeof(mus_plane)))                                                   \
    X(mus_estimate_init, nothing, (&(mus_estimate){0}, sizeof(mus_estimate)))                                          \
    X(mus_drape_positions, nothing, (w->have.drape))                                                                   \
    X(mus_drape_velocities, nothing, (w->have.drape))                                                                  \
    X(mus_drape_node_count, nothing, (w->have.drape))                                                                  \
    X(mus_drape_time, nothing, (w->have.drape))                                                                        \
    X(mus_drape_report_init, nothing, (&(mus_drape_report){0}, sizeof(mus_drape_report)))                              \
    X(mus_drape_skipped, nothing, (w->have.drape))                                                                     \
    X(mus_drape_hash, nothing, (w->have.drape))                                                                        \
    X(mus_dress_def_init, nothing, (&(mus_dress_def){0}, sizeof(mus_dress_def)))                                       \
    X(mus_dress_report_init, nothing, (&(mus_dress_report){0}, sizeof(mus_dress_report)))                              \
    X(mus_pattern_undo_count, nothing, (P))                                                                            \
    X(mus_pattern_redo_count, nothing, (P))                                                                            \
    X(mus_cut_def_init, nothing, (&(mus_cut_def){0}, sizeof(mus_cut_def)))                                             \
    X(mus_seam_walk_init, nothing, (&(mus_seam_walk){0}, sizeof(mus_seam_walk)))                                       \
    X(mus_pattern_dxf_init, nothing, (&(mus_pattern_dxf){0}, sizeof(mus_pattern_dxf)))                                 \
    X(mus_pattern_val_init, nothing, (&(mus_pattern_val){0}, sizeof(mus_pattern_val)))                                 \
    X(mus_mesh_view_init, nothing, (&(mus_mesh_view){0}, sizeof(mus_mesh_view)))                                       \
    X(mus_mesh_motion_init, nothing, (&(mus_mesh_motion){0}, sizeof(mus_mesh_motion)))                                 \
    X(mus_mesh_file_init, nothing, (&(mus_mesh_file){0}, sizeof(mus_mesh_file)))                                       \
    X(mus_mesh_destroy, nothing, (NULL))                                                                               \
    X(mus_mesh_vertex_count, nothing, (w->have.mesh))                                                                  \
    X(mus_mesh_triangle_count, nothing, (w->have.mesh))                                                                \
    X(mus_mesh_vertices, nothing, (w->have.mesh))                                                                      \
    X(mus_mesh_triangles, nothing, (w->have.mesh))                                                                     \
    X(mus_fit_destroy, nothing, (NULL))                                                                                \
    X(mus_fit_node_count, nothing, (w->have.fit))                                                                      \
    X(mus_fit_warp, nothing, (w->have.fit))                                                                            \
    X(mus_fit_weft, nothing, (w->have.fit))                                                                            \
    X(mus_fit_pressure, nothing, (w->have.fit))                                                                        \
    X(mus_fit_gap, nothing, (w->have.fit))                                                                             \
    X(mus_fit_area, nothing, (w->have.fit))                                                                            \
    X(mus_fit_spread_init, nothing, (&(mus_fit_spread){0}, sizeof(mus_fit_spread)))                                    \
    X(mus_fit_level_init, nothing, (&(mus_fit_level){0}, sizeof(mus_fit_level)))                                       \
    X(mus_fit_level_count, nothing, (w->have.fit))                                                                     \
    X(mus_worn_init, nothing, (&(mus_worn){0}, sizeof(mus_worn)))                                                      \
    X(mus_worn_name, nothing, (0))                                                                                     \
    X(mus_integrate_def_init, nothing, (&(mus_integrate_def){0}, sizeof(mus_integrate_def)))                           \
    X(mus_integrate_work, nothing, (MUS_METHOD_RK4, 2))                                                                \
    X(mus_manifold_def_init, nothing, (&(mus_manifold_def){0}, sizeof(mus_manifold_def)))                              \
    X(mus_manifold_destroy, nothing, (NULL))                                                                           \
    X(mus_manifold_vertex_count, nothing, (w->have.manifold))                                                          \
    X(mus_manifold_triangle_count, nothing, (w->have.manifold))                                                        \
    X(mus_manifold_piece_count, nothing, (w->have.manifold))                                                           \
    X(mus_manifold_cut_count, nothing, (w->have.manifold))                                                             \
    X(mus_manifold_volume, nothing, (w->have.manifold))                                                                \
    X(mus_manifold_vertices, nothing, (w->have.manifold))                                                              \
    X(mus_manifold_normals, nothing, (w->have.manifold))                                                               \
    X(mus_manifold_triangles, nothing, (w->have.manifold))                                                             \
    X(mus_pattern_destroy, nothing, (NULL))                                                                            \
    X(mus_pattern_context, nothing, (P))                                                                               \
    X(mus_pattern_name, nothing, (P))                                                                                  \
    X(mus_edge_def_init, nothing, (&(mus_edge_def){0}, sizeof(mus_edge_def)))                                          \
    X(mus_hold_name, nothing, (0))                                                                                     \
    X(mus_hold_find, nothing, ("again"))                                                                               \
    X(mus_seam_def_init, nothing, (&(mus_seam_def){0}, sizeof(mus_seam_def)))                                          \
    X(mus_material_name, nothing, (0))                                                                                 \
    X(mus_material_find, nothing, ("again"))                                                                           \
    X(mus_placement_init, nothing, (&(mus_placement){0}, sizeof(mus_placement)))                                       \
    X(mus_pattern_layer, nothing, (P, 0))                                                                              \
    X(mus_pattern_panel_count, nothing, (P))                                                                           \
    X(mus_pattern_point_count, nothing, (P))                                                                           \
    X(mus_pattern_edge_count, nothing, (P))                                                                            \
    X(mus_pattern_seam_count, nothing, (P))                                                                            \
    X(mus_pattern_notch_count, nothing, (P))                                                                           \
    X(mus_pattern_mark_count, nothing, (P))                                                                            \
    X(mus_pattern_opening_count, nothing, (P))                                                                         \
    X(mus_pattern_opening, nothing, (P, 0))                                                                            \
    X(mus_pattern_find_panel, nothing, (P, "again"))                                                                   \
    X(mus_pattern_find_edge, nothing, (P, 0, "hem"))                                                                   \
    X(mus_pattern_panel_name, nothing, (P, 0))                                                                         \
    X(mus_pattern_panel_label, nothing, (P, 0))                                                                        \
    X(mus_pattern_panel_sides, nothing, (P, 0, w->whole))                                                              \
    X(mus_cut_line_destroy, nothing, (NULL))                                                                           \
    X(mus_cut_line_loop_count, nothing, (w->have.cut_line))                                                            \
    X(mus_cut_line_dart_count, nothing, (w->have.cut_line))                                                            \
    X(mus_pattern_cut_only, nothing, (P))                                                                              \
    X(mus_pattern_edge_panel, nothing, (P, 0))                                                                         \
    X(mus_pattern_edge_name, nothing, (P, 0))                                                                          \
    X(mus_pattern_edge_label, nothing, (P, 0))                                                                         \
    X(mus_pattern_edge_allowance, nothing, (P, 0))                                                                     \
    X(mus_pattern_edge_length, nothing, (P, 0))                                                                        \
    X(mus_pattern_panel_area, nothing, (P, 0))                                                                         \
    X(mus_pattern_panel_perimeter, nothing, (P, 0))                                                                    \
    X(mus_pattern_edge_seam, nothing, (P, 0))                                                                          \
    X(mus_pose_init, nothing, (&(mus_pose){0}, sizeof(mus_pose)))                                                      \
    X(mus_joint_name, nothing, (0))                                                                                    \
    X(mus_pose_count, nothing, ())                                                                                     \
    X(mus_pose_name, nothing, (0))                                                                                     \
    X(mus_pose_feet, nothing, ("again"))                                                                               \
    X(mus_move_destroy, nothing, (NULL))                                                                               \
    X(mus_move_count, nothing, ())                                                                                     \
    X(mus_move_name, nothing, (0))                                                                                     \
    X(mus_move_period, nothing, (w->have.move))                                                                        \
    X(mus_move_duration, nothing, (w->have.move))                                                                      \
    X(mus_layout_def_init, nothing, (&(mus_layout_def){0}, sizeof(mus_layout_def)))                                    \
    X(mus_layout_item_init, nothing, (&(mus_layout_item){0}, sizeof(mus_layout_item)))                                 \
    X(mus_layout_piece_init, nothing, (&(mus_layout_piece){0}, sizeof(mus_layout_piece)))                              \
    X(mus_layout_destroy, nothing, (NULL))                                                                             \
    X(mus_layout_context, nothing, (w->have.layout))                                                                   \
    X(mus_layout_width, nothing, (w->have.layout))                                                                     \
    X(mus_layout_length, nothing, (w->have.layout))                                                                    \
    X(mus_layout_folded, nothing, (w->have.layout))                                                                    \
    X(mus_layout_utilisation, nothing, (w->have.layout))                                                               \
    X(mus_layout_steps, nothing, (w->have.layout))                                                                     \
    X(mus_layout_piece_count, nothing, (w->have.layout))                                                               \
    X(mus_sheet_def_init, nothing, (&(mus_sheet_def){0}, sizeof(mus_sheet_def)))                                       \
    X(mus_sheet_destroy, nothing, (NULL))                                                                              \
    X(mus_sheet_page_count, nothing, (w->have.sheet))                                                                  \
    X(mus_sheet_columns, nothing, (w->have.sheet))                                                                     \
    X(mus_sheet_rows, nothing, (w->have.sheet))                                                                        \
    X(mus_sheet_piece_init, nothing, (&(mus_sheet_piece){0}, sizeof(mus_sheet_piece)))                                 \
    X(mus_sheet_piece_count, nothing, (w->have.sheet))                                                                 \
    X(mus_sheet_line_init, nothing, (&(mus_sheet_line){0}, sizeof(mus_sheet_line)))                                    \
    X(mus_sheet_line_count, nothing, (w->have.sheet))                                                                  \
    X(mus_sheet_dxf_init, nothing, (&(mus_sheet_dxf){0}, sizeof(mus_sheet_dxf)))                                       \
    X(mus_sheet_plt_init, nothing, (&(mus_sheet_plt){0}, sizeof(mus_sheet_plt)))                                       \
    X(mus_scan_def_init, nothing, (&(mus_scan_def){0}, sizeof(mus_scan_def)))                                          \
    X(mus_scan_report_init, nothing, (&(mus_scan_report){0}, sizeof(mus_scan_report)))                                 \
    X(mus_measure_count, nothing, ())                                                                                  \
    X(mus_language_count, nothing, ())                                                                                 \
    X(mus_language_tag, nothing, (0))                                                                                  \
    X(mus_language_name, nothing, (0))                                                                                 \
    X(mus_language_is_right_to_left, nothing, (0))                                                                     \
    X(mus_language_find, nothing, ("de"))                                                                              \
    X(mus_language_row_count, nothing, ())                                                                             \
    X(mus_language_row_key, nothing, (0))                                                                              \
    X(mus_language_text, nothing, (1, "list.comma"))                                                                   \
    X(mus_language_compose, nothing, (1, "panel", "front", (char[8]){0}, 8))                                           \
    X(mus_measure_name, nothing, (0))                                                                                  \
    X(mus_measure_unit, nothing, (0))                                                                                  \
    X(mus_measure_find, nothing, ("again"))                                                                            \
    X(mus_tape_destroy, nothing, (NULL))                                                                               \
    X(mus_tape_context, nothing, (w->have.tape))                                                                       \
    X(mus_tape_sex, nothing, (w->have.tape))                                                                           \
    X(mus_tape_name, nothing, (w->have.tape))                                                                          \
    X(mus_tape_value, nothing, (w->have.tape, 0))                                                                      \
    X(mus_tape_source, nothing, (w->have.tape, 0))                                                                     \
    X(mus_tape_size_count, nothing, ())                                                                                \
    X(mus_tape_size_name, nothing, (0))                                                                                \
    X(mus_tape_is_complete, nothing, (w->have.tape))                                                                   \
    X(mus_tape_warning_count, nothing, (w->have.tape))                                                                 \
    X(mus_tape_warning, nothing, (w->have.tape, 0))                                                                    \
    X(mus_topology_init, nothing, (&(mus_topology){0}, sizeof(mus_topology)))                                          \
    X(mus_homology_init, nothing, (&(mus_homology){0}, sizeof(mus_homology)))                                          \
    X(mus_form_def_init, nothing, (&(mus_form_def){0}, sizeof(mus_form_def)))                                          \
    X(mus_faults_destroy, nothing, (NULL))                                                                             \
    X(mus_faults_count, nothing, (w->have.faults))                                                                     \
    X(mus_faults_text, nothing, (w->have.faults, 0))                                                                   \
    X(mus_context_fail, nothing, (w->context, MUS_ERR_ARG, "again"))                                                   \
    X(mus_fit_level_get, nothing, (w->have.fit, 0, &w->level))

#endif
