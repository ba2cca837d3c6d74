/* printed.c: a pattern of one panel, drawn by hand, checked and printed. */
#include <muslin/muslin.h>
#include <muslin/print.h>

int main(int argc, char **argv)
{
    mus_context *context = NULL;
    mus_pattern *pattern = NULL;
    mus_sheet *sheet = NULL;
    const double corner[3][2] = {{0.0, 0.0}, {0.3, 0.0}, {0.3, 0.5}};
    const int32_t along[3] = {1, 1, 1};
    int32_t count = 0, panel = 0, point[3], edge[3];
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) status = mus_pattern_create(context, "gusset", &pattern);
    if (status == MUS_OK) status = mus_pattern_add_panel(pattern, "gusset", &panel);
    for (int32_t i = 0; i < 3 && status == MUS_OK; i++)
        status = mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]);
    for (int32_t i = 0; i < 3 && status == MUS_OK; i++)
        status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                               .end = point[(i + 1) % 3]}, &edge[i]);
    if (status == MUS_OK) status = mus_pattern_set_outline(pattern, panel, 3, edge, along);
    if (status == MUS_OK) status = mus_pattern_check(pattern, &count, NULL);
    if (status == MUS_OK) status = mus_sheet_create(context, pattern, NULL, &sheet);
    if (status == MUS_OK && argc > 1) status = mus_sheet_write_pdf(sheet, argv[1]);
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    mus_context_destroy(context);
    return status;
}
