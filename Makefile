# Makefile of muslin: one, not recursive (a second pass only after packages were installed).
#
#   make            libraries (static and shared) and programs, in build/
#   make lib        libmuslin alone: needs a C compiler and nothing else
#   make dress      from a tape to a dressed person, a picture and a printed pattern, in build/out/
#   make check      every test; the last line counts them
#   make bench      speed table
#   make install    DESTDIR= PREFIX= LIBDIR= are respected
#   make corpus     every GarmentCode specification of $(MUSLIN_DATA), a table in build/corpus/ (CORPUS='--spacing 20'
#                   hands options to tests/corpus/run.py)
#   make page       24 GarmentCode garments at 15 mm with cloth on cloth as two pages of pictures, in build/page/
#                   (PAGE='--spacing 25' hands options to tests/corpus/page.py)
#   make layers     garments worn over one another, a row each with CPU seconds (LAYERS='--spacing 25 --only 1')
#   make girths     girths of the three scanned bodies of $(MUSLIN_DATA): their yaml, the meshes' own sections, muslin
#   make motion     T-shirt and skirt in every named pose and over a walk of 240 frames (MOTION='--film ...' hands
#                   options to tests/motion/run.py)
#   make wear       every named design dressed on the sizes of its groups, 100 of them on ten people (WEAR='--every 7')
#   make people     the 3034 people of ANSUR II in $(MUSLIN_DATA) and the table sizes made and measured, a page of figures
#                   (PEOPLE='--csv FILE --each 10': a row a person, each tenth of them)
#   make designs    every named design drafted for every table size of its groups and for 200 people: refusals by reason,
#                   seams, darts, time (DESIGNS='--family blouse --list': each refusal of a family)
#   make catalogue-bench  a catalogue of the named designs in five sizes, the GarmentCode specifications and 100,000
#                   variants (COUNT=1000): time of searches, and whether the same design on another body is found first
#   make same       digests of scenes, designs, paper and files against tests/same/*.table: says whether a result moved
#                   (SAME='scenes tshirt': rows whose names have both; SAME='write ...' writes them into the tables)
#   make check-omit the C tests once without each module, and once without all that can be left out
#   make check-ports  figures of the library built by other compilers and for other machines, 32-bit and big-endian
#                   ones under qemu-user, against this machine's (PORTS='clang s390x' picks some)
#   make report     error against run time: page, table and pictures of tests/report anew, 20 minutes (QUICK=1: small
#                   scenes, into build/report, under a minute; REPORT='--only sheet speed' measures some jobs anew)
#   make check-large  a sheet of a million nodes and eight million springs (0.7 GB)
#   make check-self-off  a build whose steps know nothing of cloth on cloth: the same bits, the same time within 1 %
#   make sizes      the table of module sizes (tests/guard/sizes.table) anew
#   make check-glb  the Khronos validator on the .glb of `make dress` (needs node)
#
# config=release (default) | debug | sanitize | coverage; werror=1 makes warnings errors.
# OMIT="print design" leaves modules, and what stands on them, out of `make` and `make install`; there are no programs
# then. One can leave out: print, exchange, catalogue, design, integrate, drape, cloth, scan, pattern, body.
# CC, CFLAGS, LDFLAGS, PYTHON are the user's.

config ?= release
PREFIX ?= /usr/local
LIBDIR ?= lib
PYTHON ?= /usr/bin/python3
PKG_CONFIG ?= pkg-config
MUSLIN_DATA ?= ../shared/data
JOBS ?= $(shell nproc 2>/dev/null || echo 1)
OUT ?= $(if $(filter release,$(config)),build,build/$(config))

ifeq ($(filter $(config),release debug sanitize coverage),)
$(error config=$(config) is unknown: release, debug, sanitize or coverage)
endif

# the version stands in base.h and nowhere else
version_part = $(shell sed -n 's/^.define MUS_VERSION_$(1) //p' include/muslin/base.h)
MAJOR := $(call version_part,MAJOR)
VERSION := $(MAJOR).$(call version_part,MINOR).$(call version_part,PATCH)

# ---- flags ----

OPTIMISE_release = -O2 -g
OPTIMISE_debug = -O0 -g -DMUS_DEBUG
OPTIMISE_sanitize = -O1 -g -DMUS_DEBUG -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=undefined
OPTIMISE_coverage = -O0 -g --coverage
LINK_sanitize = -fsanitize=address,undefined
LINK_coverage = --coverage

WARN = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Wstrict-prototypes -Wundef -Wvla \
       -Wcast-qual -Wwrite-strings $(if $(werror),-Werror)
TEST_WARN = -Wall -Wextra -Wshadow -Wstrict-prototypes -Wvla $(if $(werror),-Werror)
FLAGS = -std=c11 -Iinclude -Ilib -fPIC -fvisibility=hidden -ffunction-sections -fdata-sections -pthread
# the loops that a drape spends its time in: -O3 vectorises them (numbers: muslin bench), and sqrt without errno
# is one instruction; debug builds keep their own level
HOT_release = -O3 -fno-math-errno
# the same bits from every compiler: no fused multiply-add, whatever CFLAGS say
HOT =
SAME_BITS = -ffp-contract=off
COMPILE = $(CC) -MMD -MP $(FLAGS) $(OPTIMISE_$(config)) $(HOT) $(CPPFLAGS) $(CFLAGS) $(SAME_BITS)
LINK = $(CC) -pthread $(OPTIMISE_$(config)) $(CFLAGS) $(LINK_$(config)) $(LDFLAGS)
SHARED = -shared -Wl,-z,defs -Wl,-soname,$(1).so.$(MAJOR) -Wl,--version-script=$(2)

pkg_flags = $(shell $(PKG_CONFIG) --cflags $(1) 2>/dev/null)
pkg_libs = $(shell $(PKG_CONFIG) --libs $(1) 2>/dev/null)
PRINT_PKG = cairo
EXCHANGE_PKG = jansson yaml-0.1 expat
CATALOGUE_PKG = sqlite3
EXAMPLE_PKG = libpng
TEST_PKG = check

# ---- what is left out: a module goes with all that calls it ----

OMIT_print = print
OMIT_exchange = exchange
OMIT_catalogue = catalogue
OMIT_design = block half style design
OMIT_integrate = integrate
OMIT_drape = arrange sim drape dress fit contact
OMIT_cloth = cloth arrange sim drape dress fit contact exchange
OMIT_pattern = pattern topology board edit block half style design cloth arrange sim drape dress fit contact print exchange catalogue
OMIT_scan = scan
OMIT_body = limb body pose scan block half style design exchange
LEFT_OUT := $(foreach m,$(OMIT),$(or $(OMIT_$(m)),$(error OMIT=$(m): it is none of print, exchange, catalogue, design, integrate, \
  drape, cloth, scan, pattern, body)))
space := $(subst ,, )
ifneq ($(and $(OMIT),$(filter check tests dress bench corpus,$(MAKECMDGOALS))),)
$(error with OMIT there are libraries alone: `make check-omit` runs the tests of what is left)
endif
INTO := $(OUT)$(if $(OMIT),/omit-$(subst $(space),-,$(strip $(OMIT))))

# ---- what there is ----

# files of the folders of lib/ that are not left out
sources = $(wildcard $(patsubst %,lib/%/*.c,$(filter-out $(LEFT_OUT),$(1))))
CORE := $(call sources,base geom integrate tape limb body pose scan pattern topology board edit block half style design cloth contact arrange sim drape dress fit)
PRINT := $(call sources,print)
EXCHANGE := $(call sources,exchange)
CATALOGUE := $(call sources,catalogue)
COMMAND := $(wildcard examples/muslin/*.c)
RENDER := $(wildcard examples/render/*.c)
RENDER_SHARED := $(filter-out examples/render/main.c,$(RENDER))
TESTS := tests/main.c tests/support.c $(sort $(wildcard tests/*/test_*.c))
# what test files of one folder share; an archive, since one of them may be a program that a Python test compiles
TEST_PARTS := $(filter-out $(TESTS),$(wildcard tests/*/*.c))
SUITES := $(patsubst test_%,%,$(basename $(notdir $(wildcard tests/*/test_*.c))))
# parts of the programs that have C tests
TESTED_EXAMPLES := examples/muslin/bench_plain.c examples/muslin/bench_tree.c
objects = $(patsubst %.c,$(OUT)/obj/%.o,$(1))

LIB := $(INTO)/lib
BIN := $(INTO)/bin
A_CORE := $(LIB)/libmuslin.a
A_PRINT := $(LIB)/libmuslin-print.a
A_EXCHANGE := $(LIB)/libmuslin-exchange.a
A_CATALOGUE := $(LIB)/libmuslin-catalogue.a
SO_CORE := $(LIB)/libmuslin.so.$(VERSION)
SO_PRINT := $(LIB)/libmuslin-print.so.$(VERSION)
SO_EXCHANGE := $(LIB)/libmuslin-exchange.so.$(VERSION)
SO_CATALOGUE := $(LIB)/libmuslin-catalogue.so.$(VERSION)
A_TESTS := $(OUT)/obj/tests/parts.a
PROGRAMS := $(BIN)/muslin $(BIN)/muslin-render
ALL := $(A_CORE) $(SO_CORE) $(if $(PRINT),$(A_PRINT) $(SO_PRINT)) $(if $(EXCHANGE),$(A_EXCHANGE) $(SO_EXCHANGE)) \
       $(if $(CATALOGUE),$(A_CATALOGUE) $(SO_CATALOGUE)) \
       $(if $(OMIT),,$(PROGRAMS))

.PHONY: all lib packages dress dress-now check check-now tests bench install corpus corpus-now page page-now layers layers-now girths girths-now motion motion-now sheet sheet-now wear wear-now people people-now designs designs-now catalogue-bench catalogue-bench-now same same-now check-glb check-omit \
        check-omit-now check-ports check-large check-self-off report report-now sizes clean FORCE \
        need-print need-exchange need-catalogue need-example need-test
.DELETE_ON_ERROR:

all: $(ALL)
lib: $(A_CORE) $(SO_CORE)

# ---- compile ----

# one sentence instead of a missing header
need-print need-exchange need-catalogue need-example need-test: need-%:
	@for p in $($(shell echo $* | tr a-z A-Z)_PKG); do $(PKG_CONFIG) --exists $$p || { \
	  echo "muslin: $$p is not installed; \`make packages\` installs what is missing, \`make lib\` needs none" >&2; exit 1; }; done

$(OUT)/obj/lib/sim/sim_f%.o: HOT = $(HOT_$(config))
$(OUT)/obj/lib/contact/%.o: HOT = $(HOT_$(config))
$(OUT)/obj/examples/muslin/bench_plain.o: HOT = $(HOT_$(config))
$(OUT)/obj/examples/muslin/bench_tree.o: HOT = $(HOT_$(config))
$(OUT)/obj/lib/integrate/%.o: HOT = $(HOT_$(config))
$(call objects,$(PRINT)): PACKAGE := $(call pkg_flags,$(PRINT_PKG))
$(call objects,$(PRINT)): | need-print
$(call objects,$(EXCHANGE)): PACKAGE := $(call pkg_flags,$(EXCHANGE_PKG))
$(call objects,$(EXCHANGE)): | need-exchange
$(call objects,$(CATALOGUE)): PACKAGE := $(call pkg_flags,$(CATALOGUE_PKG))
$(call objects,$(CATALOGUE)): | need-catalogue
$(call objects,$(COMMAND) $(RENDER)): PACKAGE := $(call pkg_flags,$(EXAMPLE_PKG)) -Iexamples
$(call objects,$(COMMAND) $(RENDER)): | need-example
$(call objects,$(TESTS) $(TEST_PARTS)): PACKAGE := $(call pkg_flags,$(TEST_PKG) $(PRINT_PKG) $(EXCHANGE_PKG) $(CATALOGUE_PKG)) -Itests -Iexamples -I$(OUT)
$(call objects,$(TESTS) $(TEST_PARTS)): WARN := $(TEST_WARN)
$(call objects,$(TESTS) $(TEST_PARTS)): | need-test
$(call objects,tests/main.c): $(OUT)/suites.h

$(OUT)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(COMPILE) $(WARN) $(PACKAGE) -c $< -o $@

# ---- libraries ----

$(A_CORE): $(call objects,$(CORE))
$(A_PRINT): $(call objects,$(PRINT))
$(A_EXCHANGE): $(call objects,$(EXCHANGE))
$(A_CATALOGUE): $(call objects,$(CATALOGUE))
$(A_TESTS): $(call objects,$(TEST_PARTS))
$(A_CORE) $(A_PRINT) $(A_EXCHANGE) $(A_CATALOGUE) $(A_TESTS):
	@mkdir -p $(@D)
	@rm -f $@
	$(AR) rcsD $@ $^

# links in the build folder, so that -lmuslin and the loader find the library there
shared_links = ln -sf $(notdir $@) $(LIB)/$(1).so.$(MAJOR) && ln -sf $(1).so.$(MAJOR) $(LIB)/$(1).so
$(SO_CORE): $(call objects,$(CORE)) lib/muslin.map
	@mkdir -p $(@D)
	$(LINK) $(call SHARED,libmuslin,lib/muslin.map) $(filter %.o,$^) -lm -o $@
	@$(call shared_links,libmuslin)
$(SO_PRINT): $(call objects,$(PRINT)) lib/muslin-print.map $(SO_CORE)
	$(LINK) $(call SHARED,libmuslin-print,lib/muslin-print.map) $(filter %.o,$^) -L$(LIB) -lmuslin \
	  $(call pkg_libs,$(PRINT_PKG)) -lm -o $@
	@$(call shared_links,libmuslin-print)
$(SO_EXCHANGE): $(call objects,$(EXCHANGE)) lib/muslin-exchange.map $(SO_CORE)
	$(LINK) $(call SHARED,libmuslin-exchange,lib/muslin-exchange.map) $(filter %.o,$^) -L$(LIB) -lmuslin \
	  $(call pkg_libs,$(EXCHANGE_PKG)) -lm -o $@
	@$(call shared_links,libmuslin-exchange)
$(SO_CATALOGUE): $(call objects,$(CATALOGUE)) lib/muslin-catalogue.map $(SO_CORE)
	$(LINK) $(call SHARED,libmuslin-catalogue,lib/muslin-catalogue.map) $(filter %.o,$^) -L$(LIB) -lmuslin \
	  $(call pkg_libs,$(CATALOGUE_PKG)) -lm -o $@
	@$(call shared_links,libmuslin-catalogue)

# ---- programs: linked with the archives, so that they run from anywhere ----

ARCHIVES = $(A_PRINT) $(A_EXCHANGE) $(A_CATALOGUE) $(A_CORE)
OUTSIDE = $(call pkg_libs,$(PRINT_PKG) $(EXCHANGE_PKG) $(CATALOGUE_PKG) $(EXAMPLE_PKG)) -ldl -lm
$(BIN)/muslin: $(call objects,$(COMMAND) $(RENDER_SHARED)) $(ARCHIVES)
$(BIN)/muslin-render: $(call objects,$(RENDER)) $(ARCHIVES)
$(BIN)/tests: $(call objects,$(TESTS) $(TESTED_EXAMPLES)) $(A_TESTS) $(ARCHIVES)
$(BIN)/tests: ARCHIVES := $(A_TESTS) $(ARCHIVES)
$(BIN)/tests: OUTSIDE := $(call pkg_libs,$(TEST_PKG)) $(OUTSIDE)
$(BIN)/people: $(call objects,tests/people/people.c) $(A_TESTS) $(A_CORE)
$(BIN)/people: ARCHIVES := $(A_TESTS) $(A_CORE)
$(BIN)/people: OUTSIDE := -lm
$(BIN)/designs: $(call objects,tests/designs/designs.c) $(A_TESTS) $(A_CORE)
$(BIN)/designs: ARCHIVES := $(A_TESTS) $(A_CORE)
$(BIN)/designs: OUTSIDE := -lm
$(BIN)/catalogue-bench: $(call objects,tests/catalogue/bench.c) $(A_EXCHANGE) $(A_CATALOGUE) $(A_CORE)
$(BIN)/catalogue-bench: ARCHIVES := $(A_EXCHANGE) $(A_CATALOGUE) $(A_CORE)
$(BIN)/catalogue-bench: OUTSIDE := $(call pkg_libs,$(EXCHANGE_PKG) $(CATALOGUE_PKG)) -lm
$(BIN)/same: $(call objects,$(wildcard tests/same/*.c)) $(ARCHIVES)
$(BIN)/figures: $(call objects,tests/ports/figures.c) $(A_CORE)
$(PROGRAMS) $(BIN)/tests $(BIN)/people $(BIN)/designs $(BIN)/catalogue-bench $(BIN)/same $(BIN)/figures:
	@mkdir -p $(@D)
	$(LINK) $(filter %.o,$^) $(ARCHIVES) $(OUTSIDE) -o $@

# the list of suites, written anew only when a test file came or went
$(OUT)/suites.h: FORCE
	@mkdir -p $(@D)
	@{ echo '/* made by the Makefile from the names of tests/NOUN/test_*.c */'; echo '#define SUITES(X) \'; \
	  for s in $(SUITES); do echo "    X($$s) \\"; done; echo; } > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@
FORCE:

# ---- walk through the house ----

# a second make, so that pkg-config sees what was just installed
again = $(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS)) $(1)

packages:
	@sh tests/guard/packages.sh build test

dress:
	@sh tests/guard/packages.sh build
	@$(call again,dress-now)

TAPE := examples/tapes/w40.tape
dress-now: all
	@mkdir -p $(OUT)/out
	$(BIN)/muslin dress --design tshirt --tape $(TAPE) --png $(OUT)/out/tshirt.png --glb $(OUT)/out/tshirt.glb \
	  --report $(OUT)/out/report.json
	$(BIN)/muslin print --design tshirt --tape $(TAPE) --pdf $(OUT)/out/tshirt.pdf
	@echo "look at $(OUT)/out: tshirt.png, tshirt.pdf, tshirt.glb, report.json"

# ---- check ----

check:
	@sh tests/guard/packages.sh build test
	@$(call again,check-now)

tests: $(BIN)/tests
check-now: all tests
	@MUSLIN_DATA='$(MUSLIN_DATA)' CC='$(CC)' sh tests/guard/total.sh '$(OUT)' '$(PYTHON)'

bench: all
	$(BIN)/muslin bench

corpus:
	@sh tests/guard/packages.sh build
	@$(call again,corpus-now)
corpus-now: all
	$(PYTHON) tests/corpus/run.py --command $(BIN)/muslin --data '$(MUSLIN_DATA)' --out $(OUT)/corpus --jobs $(JOBS) $(CORPUS)

page:
	@sh tests/guard/packages.sh build report
	@$(call again,page-now)
page-now: all
	$(PYTHON) tests/corpus/page.py --command $(BIN)/muslin --data '$(MUSLIN_DATA)' --out $(OUT)/page --jobs $(JOBS) $(PAGE)

layers:
	@sh tests/guard/packages.sh build
	@$(call again,layers-now)
layers-now: all
	$(PYTHON) tests/layers/run.py --command $(BIN)/muslin --out $(OUT)/layers $(LAYERS)

girths:
	@sh tests/guard/packages.sh build report
	@$(call again,girths-now)
girths-now: all
	$(PYTHON) tests/scan/girths.py --command $(BIN)/muslin --data '$(MUSLIN_DATA)'

motion:
	@sh tests/guard/packages.sh build
	@$(call again,motion-now)
motion-now: all
	$(PYTHON) tests/motion/run.py --command $(BIN)/muslin --out $(OUT)/motion $(MOTION)

# 100 designs on one body; one design on 10 women, 8 men and 2 children
SHEET_SIZES = W34,W36,W38,W40,W42,W44,W46,W48,W50,W52,M46,M48,M50,M52,M54,M56,M58,M60,C116,C152
sheet:
	@sh tests/guard/packages.sh build
	@$(call again,sheet-now)
sheet-now: all
	@mkdir -p $(OUT)/out
	$(BIN)/muslin sheet --designs all:100 --tapes W40 --png $(OUT)/out/designs.png --jobs 2 $(SHEET)
	$(BIN)/muslin sheet --designs tshirt --tapes $(SHEET_SIZES) --png $(OUT)/out/bodies.png --jobs 2 $(SHEET)

wear:
	@sh tests/guard/packages.sh build
	@$(call again,wear-now)
wear-now: all
	$(PYTHON) tests/designs/wear.py --command $(BIN)/muslin --data '$(MUSLIN_DATA)' --out $(OUT)/wear --jobs $(JOBS) $(WEAR)

people:
	@sh tests/guard/packages.sh build test
	@$(call again,people-now)
people-now: $(BIN)/people
	$(BIN)/people '$(MUSLIN_DATA)/anthropometry/ansur2_garment_cm.csv' $(PEOPLE)

designs:
	@sh tests/guard/packages.sh build test
	@$(call again,designs-now)
designs-now: $(BIN)/designs
	$(BIN)/designs '$(MUSLIN_DATA)/anthropometry/ansur2_garment_cm.csv' $(DESIGNS)

catalogue-bench:
	@sh tests/guard/packages.sh build test
	@$(call again,catalogue-bench-now)
catalogue-bench-now: $(BIN)/catalogue-bench
	@mkdir -p $(OUT)/out
	$(BIN)/catalogue-bench '$(MUSLIN_DATA)' $(OUT)/out/bench.db $(COUNT)

same:
	@sh tests/guard/packages.sh build test
	@$(call again,same-now)
same-now: $(BIN)/same $(BIN)/figures
	@$(BIN)/same . '$(MUSLIN_DATA)' $(SAME)

check-glb: dress
	@sh tests/guard/glb.sh $(OUT)/out/tshirt.glb

# each time the libraries without a module, and the C tests of what is left; CHECK_OMIT="design print+exchange" picks some
CHECK_OMIT := print exchange catalogue design integrate drape cloth scan pattern body pattern+body+integrate
check-omit:
	@sh tests/guard/packages.sh build test
	@$(call again,check-omit-now)
check-omit-now: $(BIN)/tests
	@MAKE='$(MAKE)' CC='$(CC)' PKG_CONFIG='$(PKG_CONFIG)' MUSLIN_DATA='$(MUSLIN_DATA)' \
	  PARTS='$(A_TESTS) $(call objects,$(TESTED_EXAMPLES))' \
	  sh tests/guard/omit.sh '$(OUT)' $(CHECK_OMIT)

check-self-off: lib
	@CC='$(CC)' sh tests/guard/self_off.sh '$(OUT)'

check-large: $(BIN)/tests
	MUSLIN_LARGE=1000 CK_RUN_SUITE=large $(BIN)/tests

check-ports:
	@sh tests/guard/packages.sh build ports
	@CC='$(CC)' PYTHON='$(PYTHON)' sh tests/ports/ports.sh '$(OUT)' $(PORTS)

# numbers of every run lie in build/report/rows; the page is written into the repository by the full run alone
report:
	@sh tests/guard/packages.sh build report
	@$(call again,report-now)
report-now: all
	@CC='$(CC)' REPORT_FLAGS='$(strip $(FLAGS) $(OPTIMISE_$(config)) $(SAME_BITS) $(CFLAGS)), kernels $(HOT_$(config))' \
	  MUSLIN_LIB='$(SO_CORE)' $(PYTHON) tests/report/report.py $(if $(QUICK),--quick --out $(OUT)/report/quick,\
	  --out $(OUT)/report --page tests/report) $(REPORT)

sizes: all
	@sh tests/guard/sizes.sh '$(OUT)' write

install: all
	@sh lib/install.sh '$(INTO)' '$(DESTDIR)' '$(PREFIX)' '$(LIBDIR)' '$(VERSION)'

clean:
	rm -rf build

-include $(patsubst %.o,%.d,$(call objects,$(CORE) $(PRINT) $(EXCHANGE) $(CATALOGUE) $(COMMAND) $(RENDER) $(TESTS) $(TEST_PARTS)))
