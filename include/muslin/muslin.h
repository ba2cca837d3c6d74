/*
 * muslin/muslin.h: the headers of libmuslin in reading order. muslin/print.h and muslin/exchange.h belong to
 * libraries of their own (libmuslin-print, libmuslin-exchange) and are included by those who link them.
 */
#ifndef MUSLIN_MUSLIN_H
#define MUSLIN_MUSLIN_H

#include "muslin/base.h"
#include "muslin/language.h"
#include "muslin/tape.h"
#include "muslin/body.h"
#include "muslin/pose.h"
#include "muslin/scan.h"
#include "muslin/manifold.h"
#include "muslin/pattern.h"
#include "muslin/topology.h"
#include "muslin/edit.h"
#include "muslin/layout.h"
#include "muslin/design.h"
#include "muslin/cloth.h"
#include "muslin/arrange.h"
#include "muslin/integrate.h"
#include "muslin/drape.h"
#include "muslin/dress.h"
#include "muslin/fit.h"

#endif
