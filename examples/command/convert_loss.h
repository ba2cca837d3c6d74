/* convert_loss.h: what a form of a file cannot hold of a pattern. */
#ifndef MUSLIN_CONVERT_LOSS_H
#define MUSLIN_CONVERT_LOSS_H

#include "muslin/pattern.h"

/* Prints a line on standard error for each thing of the pattern that the form ("dxf", "svg", ...) does not hold. */
void convert_tell_losses(const mus_pattern *pattern, const char *form);

#endif
