# Makefile of muslin: one file, not recursive. `make help` prints this head.
#
#   make            libraries (static and shared) and programs, in build/
#   make lib        libmuslin alone: needs a C compiler and nothing else
#   make dress      from a tape to a dressed person, a picture and a printed pattern, in build/out/
#   make check      every test; the last line counts them
#   make bench      speed table
#   make install    DESTDIR, PREFIX and LIBDIR are respected
#   make packages   the Debian packages that a build and its tests need
#   make NAME       a study of tests/study/studies.mk (corpus, wear ...); CONTRIBUTING.md says what each one measures
#
# Quiet by default: one line a file. V=1 shows the commands, V=0 libraries and programs only.
# config=release (default) | debug | sanitize | tsan | coverage; werror=1 makes warnings errors; OUT=FOLDER builds there.
# OMIT="print design" leaves modules, and those that need them, out. CC, CPPFLAGS, CFLAGS, LDFLAGS, PYTHON are yours.

config ?= release
PREFIX ?= /usr/local
LIBDIR ?= lib
PYTHON ?= /usr/bin/python3
PKG_CONFIG ?= pkg-config
MUSLIN_DATA ?= ../shared/data
JOBS ?= $(shell nproc 2>/dev/null || echo 1)
OUT ?= $(if $(filter release,$(config)),build,build/$(config))
# the version stands in base.h and nowhere else
VERSION := $(shell sed -n 's/^.define MUS_VERSION_\(MAJOR\|MINOR\|PATCH\) //p' include/muslin/base.h | paste -sd.)
ABI := $(shell sed -n 's/^.define MUS_ABI //p' include/muslin/base.h)

# ---- flags ----
OPTIMISE_release = -O2 -g
OPTIMISE_debug = -O0 -g -DMUS_DEBUG
OPTIMISE_sanitize = -O1 -g -DMUS_DEBUG -fno-omit-frame-pointer -fno-sanitize-recover=undefined -fsanitize=address,undefined
OPTIMISE_tsan = -O0 -g -fsanitize=thread
OPTIMISE_coverage = -O0 -g --coverage
$(if $(OPTIMISE_$(config)),,$(error config=$(config) is unknown: release, debug, sanitize, tsan or coverage))
# for the loops that a drape spends its time in: -O3 vectorises them, and a square root without errno is one
# instruction; these flags follow the user's CFLAGS, since an -O2 there would make a drape 2.3 times slower
KERNEL_release = -O3 -fno-math-errno
# gcc 12 selects between two numbers in a vector only where no comparison traps: the same bits, and a third less time
# with self-contact. Elsewhere it brought more code, and no speed that could be measured
SELECTING_release = -fno-trapping-math
KERNEL =
FORTIFY = $(if $(findstring FORTIFY,$(CPPFLAGS) $(CFLAGS))$(filter -O0,$(CFLAGS)),,-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
HARDEN_release = -fstack-protector-strong $(FORTIFY) # outside the kernels
# no fused multiply-add, for equal bits: gcc 12 makes vfmaddsub of pairs where FMA or AVX-512 is; the clones have none
SAME_BITS := $(foreach f,-mno-fma -mno-fma4 -mno-avx512f,$(if $(shell $(CC) $f -E -x c /dev/null 2>/dev/null),$f)) -ffp-contract=off
WARN = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Wstrict-prototypes -Wundef -Wvla \
       -Wcast-qual -Wwrite-strings $(if $(werror),-Werror)
TEST_WARN = -Wall -Wextra -Wshadow -Wstrict-prototypes -Wvla $(if $(werror),-Werror)
FLAGS = -std=c11 -Iinclude -Ilib -fPIC -fvisibility=hidden -ffunction-sections -fdata-sections -pthread
COMPILE = $(CC) -MMD -MP $(FLAGS) $(OPTIMISE_$(config)) $(HARDEN_$(config)) $(CPPFLAGS) $(CFLAGS) $(KERNEL) $(SAME_BITS)
LINK = $(CC) -pthread $(OPTIMISE_$(config)) -Wl,-z,relro,-z,now $(CFLAGS) $(LDFLAGS)
silent := $(findstring s,$(filter-out --%,$(firstword $(MAKEFLAGS))))
Q := $(if $(filter 1,$(V)),,@)
say = $(if $(or $(silent),$(filter $(if $(filter CC,$(1)),0) 1,$(V))),,@echo '  $(1)  $(2)')

# ---- rooms of lib/: every folder is one. OMIT=NAME leaves out the rooms of its row, and files that need them ----
ROOMS := $(patsubst lib/%/,%,$(wildcard lib/*/))
$(foreach m,print exchange catalogue integrate scan manifold,$(eval OMIT_$(m) := $(m)))$(eval OMIT_layout := layout nest cutter/layout_svg sewing)
OMIT_design = block half closure style pocket finish design
OMIT_drape = drape dress fit arrange sim contact selfcontact
OMIT_cloth = cloth $(OMIT_drape) exchange
OMIT_pattern = pattern topology board edit $(OMIT_layout) $(OMIT_design) $(OMIT_cloth) print catalogue
OMIT_body = body limb pose scan manifold fit $(OMIT_design) exchange dress/dress dress/dress_start dress/hood_back drape/scene_pose \
  arrange/arrange $(addprefix arrange/arrange_,clear from_pattern limb ring)
LEFT_OUT := $(foreach m,$(OMIT),$(or $(OMIT_$(m)),$(error OMIT=$(m): no such module; man muslin(3) lists them)))
INTO := $(OUT)$(if $(OMIT),/omit-$(shell echo $(OMIT) | tr ' ' -))
# ---- sources; a library of its own, and everything else, names its outside packages ----
OWN_LIBRARY = print exchange catalogue
PKG_print = cairo $(if $(filter 0,$(PANGO)),,pangocairo) # PANGO=0: all text in strokes
PKG_exchange = jansson yaml-0.1 expat
PKG_catalogue = sqlite3
PKG_examples = libpng
PKG_tests = check $(PKG_print) $(PKG_exchange) $(PKG_catalogue)
pkg = $(shell $(PKG_CONFIG) $(1) $(2) 2>/dev/null)
room = $(filter-out $(LEFT_OUT:%=lib/%.c),$(wildcard $(patsubst %,lib/%/*.c,$(filter-out $(LEFT_OUT),$(1)))))
SRC_muslin := $(call room,$(filter-out file drawing cutter paperfile sewing meshfile trade seam valentina $(OWN_LIBRARY),$(ROOMS)))
$(foreach l,$(OWN_LIBRARY),$(eval SRC_$(l) := $(call room,$(l))))
$(foreach l,print exchange,$(if $(SRC_$(l)),$(eval SRC_$(l) += $(call room,file $(if $(filter exchange,$(l)),meshfile trade seam valentina,drawing cutter paperfile sewing))))) # and base's: objects_of
SRC_examples := $(wildcard examples/*.c examples/*/*.c)
TEST_FILES := $(sort $(wildcard tests/*/test_*.c))
TEST_PARTS := $(filter-out $(TEST_FILES) tests/same/% tests/study/elementary/%,$(wildcard tests/*/*.c tests/study/*/*.c))
SRC_tests := tests/main.c tests/support.c $(TEST_FILES) $(TEST_PARTS) $(wildcard tests/same/*.c)
TESTED_EXAMPLES := examples/bench/edge_list.c examples/bench/triangle_tree.c
KERNELS := $(wildcard lib/*/*_f32.c lib/*/*_f64.c lib/contact/*.c lib/selfcontact/*.c lib/integrate/*.c) $(TESTED_EXAMPLES)
SELECTING := $(wildcard lib/selfcontact/*.c lib/contact/plane_cache_*.c)

objects = $(patsubst %.c,$(OUT)/obj/%.o,$(1))
objects_of = $(call objects,$(SRC_$(1)) $(if $(filter $(OWN_LIBRARY),$(1)),lib/base/elementary.c lib/base/sort.c))
LIB := $(INTO)/lib
BIN := $(INTO)/bin
library = $(LIB)/libmuslin$(if $(filter-out muslin,$(1)),-$(1))
LIBRARIES := muslin $(foreach l,$(OWN_LIBRARY),$(if $(SRC_$(l)),$(l)))
ARCHIVES := $(foreach l,$(OWN_LIBRARY) muslin,$(call library,$(l)).a)
SHARED := $(foreach l,$(LIBRARIES),$(call library,$(l)).so.$(VERSION))
A_TESTS := $(OUT)/obj/tests/parts.a
PROGRAMS := $(BIN)/muslin $(BIN)/muslin-render
EXAMPLES := $(patsubst examples/%.c,$(OUT)/examples/%,$(wildcard examples/*.c))

NEED := $(addprefix need-,$(OWN_LIBRARY) examples tests)
.PHONY: all lib tests examples packages install clean help FORCE $(NEED)
.DELETE_ON_ERROR .SECONDEXPANSION:

all: $(foreach l,$(LIBRARIES),$(call library,$(l)).a) $(SHARED) $(if $(OMIT),,$(PROGRAMS))
lib: $(call library,muslin).a $(call library,muslin).so.$(VERSION)
tests: $(BIN)/tests $(EXAMPLES)
examples: $(EXAMPLES)
# ---- compile ----
$(NEED): need-%:
	@for p in $(PKG_$*); do $(PKG_CONFIG) --exists $$p || { echo "muslin: $$p is not installed; \`make packages\` \
	installs what is missing, \`make lib\` needs none" >&2; exit 1; }; done

define needs_packages
$$(call objects,$$(SRC_$(1))): CFLAGS_OUTSIDE := $(call pkg,--cflags,$(PKG_$(1))) $(2)
$$(call objects,$$(SRC_$(1))): | need-$(1)
endef
$(foreach l,$(OWN_LIBRARY),$(eval $(call needs_packages,$(l),$(if $(filter 0,$(PANGO)),-DMUS_STROKES_ONLY))))
$(eval $(call needs_packages,examples,-Iexamples))
$(eval $(call needs_packages,tests,-Itests -Iexamples -I$(OUT)))
$(call objects,$(SRC_tests)): WARN := $(TEST_WARN)
$(call objects,$(KERNELS)): KERNEL = $(KERNEL_$(config))
$(call objects,$(SELECTING)): KERNEL += $(SELECTING_$(config))
$(call objects,$(KERNELS)): HARDEN_release =
$(call objects,tests/main.c): $(OUT)/suites.h

$(OUT)/obj/%.o: %.c
	$(call say,CC,$<)
	@mkdir -p $(@D)
	$(Q)$(COMPILE) $(WARN) $(CFLAGS_OUTSIDE) -c $< -o $@

# the list of suites, written anew only when a test file came or went
$(OUT)/suites.h: FORCE
	@mkdir -p $(@D)
	@echo '#define SUITES(X) $(patsubst test_%.c,X(%),$(notdir $(TEST_FILES)))' > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# ---- libraries: a static and a shared one from the same objects ----
$(A_TESTS): $(call objects,$(TEST_PARTS) $(filter-out %/main.c,$(wildcard examples/command/*.c examples/render/*.c)))
$(foreach l,$(LIBRARIES),$(eval $(call library,$(l)).a: $(call objects_of,$(l))))
$(sort $(ARCHIVES) $(A_TESTS)):
	$(call say,AR,$@)
	@mkdir -p $(@D)
	@rm -f $@
	$(Q)$(AR) rcsD $@ $^

# links in the build folder, so that -lmuslin and the loader find the library there
$(foreach l,$(LIBRARIES),$(eval $(call library,$(l)).so.$(VERSION): $(call objects_of,$(l))))
$(filter-out $(call library,muslin).so.%,$(SHARED)): $(call library,muslin).so.$(VERSION)
$(SHARED): $(LIB)/lib%.so.$(VERSION): lib/%.map
	$(call say,LD,$@)
	@mkdir -p $(@D)
	$(Q)$(LINK) -shared -Wl,-z,defs -Wl,-soname,lib$*.so.$(ABI) -Wl,--version-script=$< $(filter %.o,$^) \
	  $(if $(filter-out muslin,$*),-L$(LIB) -lmuslin $(call pkg,--libs,$(PKG_$(*:muslin-%=%)))) -lm -o $@
	@ln -sf $(@F) $(LIB)/lib$*.so.$(ABI) && ln -sf lib$*.so.$(ABI) $(LIB)/lib$*.so
# ---- programs: linked with the archives, so that they run from anywhere ----
OUTSIDE = $(call pkg,--libs,$(foreach l,$(OWN_LIBRARY) examples,$(PKG_$(l))))
STUDY_PROGRAMS := $(addprefix $(BIN)/,people slips outside manifold designs worn catalogue-bench seams day same figures)
parts = $(call objects,$(wildcard $(patsubst %,examples/%/*.c,$(1))))
$(BIN)/muslin: $(filter-out %/render/main.o,$(call parts,command verify bench render))
$(BIN)/muslin-render: $(call parts,render)
$(BIN)/tests: $(call objects,tests/main.c tests/support.c $(TEST_FILES) $(TESTED_EXAMPLES)) $(A_TESTS)
$(addprefix $(BIN)/,people slips outside manifold designs worn catalogue-bench seams day): $(BIN)/%: $(OUT)/obj/tests/study/$$*/$$*.o $(A_TESTS)
$(BIN)/same: $(call objects,$(wildcard tests/same/*.c))
$(BIN)/figures: $(OUT)/obj/tests/study/ports/figures.o
$(BIN)/tests: OUTSIDE = $(call pkg,--libs,$(PKG_tests) $(PKG_examples))
$(EXAMPLES): $(OUT)/examples/%: $(OUT)/obj/examples/%.o
$(PROGRAMS) $(BIN)/tests $(STUDY_PROGRAMS) $(EXAMPLES): $(ARCHIVES)
	$(call say,LD,$@)
	@mkdir -p $(@D)
	$(Q)$(LINK) $(filter %.o,$^) $(filter $(A_TESTS),$^) $(ARCHIVES) $(OUTSIDE) -ldl -lm -o $@

-include tests/study/studies.mk

packages:; @sh tests/guard/packages.sh build test
install: all; @sh lib/install.sh '$(INTO)' '$(DESTDIR)' '$(PREFIX)' '$(LIBDIR)' '$(VERSION)' '$(ABI)'
clean:; rm -rf build
help:; @sed -n '/^$$/q; s/^# \{0,1\}//p' Makefile; echo "Studies: $(sort $(STUDIES))"

-include $(patsubst %.c,$(OUT)/obj/%.d,$(SRC_muslin) $(foreach l,$(OWN_LIBRARY) examples tests,$(SRC_$(l))))
