# studies.mk: the table of studies, a part of the Makefile. `make NAME` runs RUN_NAME with its variable NAME, after
# NEEDS_NAME; APT_GROUP is what apt must have. A source distribution of the library alone is built without this file.
#
ON_DATA = --command $(BIN)/muslin --data '$(MUSLIN_DATA)'
ANSUR = '$(MUSLIN_DATA)/anthropometry/ansur2_garment_cm.csv'
TAPE := examples/tapes/w40.tape
same check attack check-hosts check-omit check-large people slips outside manifold designs worn catalogue-bench day: APT_GROUP = test
report page girths trade drapes fabric: APT_GROUP = report
check-ports elementary: APT_GROUP = ports
gallery: APT_GROUP = report test
RUN_dress = $(BIN)/muslin dress --design tshirt --tape $(TAPE) --png $(OUT)/out/tshirt.png --glb $(OUT)/out/tshirt.glb \
  --report $(OUT)/out/report.json && $(BIN)/muslin print --design tshirt --tape $(TAPE) --fold --pdf $(OUT)/out/tshirt.pdf \
  --instructions $(OUT)/out/tshirt.txt && echo "look at $(OUT)/out: tshirt.png, tshirt.pdf, tshirt.txt, tshirt.glb, report.json"
RUN_check = MUSLIN_DATA='$(MUSLIN_DATA)' CC='$(CC)' sh tests/guard/total.sh '$(OUT)' '$(PYTHON)'
RUN_same = $(BIN)/same . '$(MUSLIN_DATA)' $(SAME)
RUN_bench = $(BIN)/muslin bench $(BENCH)
RUN_corpus = $(PYTHON) tests/study/corpus/run.py $(ON_DATA) --out $(OUT)/corpus --jobs $(JOBS) $(CORPUS)
RUN_paper = $(PYTHON) tests/study/paper/paper.py --command $(BIN)/muslin --jobs $(JOBS) $(PAPER)
RUN_page = $(PYTHON) tests/study/corpus/page.py $(ON_DATA) --out $(OUT)/page --jobs $(JOBS) $(PAGE)
RUN_wear = $(PYTHON) tests/study/designs/wear.py $(ON_DATA) --out $(OUT)/wear --jobs $(JOBS) $(WEAR)
RUN_layers = $(PYTHON) tests/study/layers/run.py --command $(BIN)/muslin --out $(OUT)/layers $(LAYERS)
RUN_motion = $(PYTHON) tests/study/motion/run.py --command $(BIN)/muslin --out $(OUT)/motion $(MOTION)
RUN_feet = $(PYTHON) tests/study/feet/feet.py --command $(BIN)/muslin $(FEET)
RUN_girths = $(PYTHON) tests/study/girths/girths.py $(ON_DATA)
RUN_trade = MUSLIN_LIB='$(LIB)/libmuslin.so' $(PYTHON) tests/study/trade/trade.py --data '$(MUSLIN_DATA)' $(TRADE)
RUN_drapes = MUSLIN_LIB='$(LIB)/libmuslin.so' $(PYTHON) tests/study/trade/drapes.py $(ON_DATA) --out $(OUT)/drapes $(DRAPES)
RUN_layout = MUSLIN_LIB='$(LIB)/libmuslin.so' $(PYTHON) tests/study/layout/layout.py --data '$(MUSLIN_DATA)' $(LAYOUT)
RUN_gallery = MUSLIN_LIB='$(LIB)/libmuslin.so' $(PYTHON) examples/gallery/gallery.py --bin $(BIN) --out $(OUT)/gallery --strip examples/gallery/strip.png
RUN_fabric = $(PYTHON) tests/study/fabric/fabric.py --csv $(OUT)/out/fabric.csv $(FABRIC)
RUN_people = $(BIN)/people $(ANSUR) $(PEOPLE)
RUN_slips = $(BIN)/slips $(ANSUR) $(SLIPS)
RUN_outside = $(BIN)/outside $(ANSUR) $(OUT)/out $(RULER)
RUN_manifold = $(BIN)/manifold $(ANSUR) $(OUT)/out $(MANIFOLD)
RUN_designs = $(BIN)/designs $(ANSUR) $(DESIGNS)
RUN_worn = $(BIN)/worn '$(MUSLIN_DATA)' $(WORN)
RUN_seams = $(BIN)/seams '$(MUSLIN_DATA)' $(SEAMS)
RUN_catalogue-bench = $(BIN)/catalogue-bench '$(MUSLIN_DATA)' $(OUT)/out/bench.db $(COUNT)
SHEET_SIZES = W34,W36,W38,W40,W42,W44,W46,W48,W50,W52,M46,M48,M50,M52,M54,M56,M58,M60,C116,C152
RUN_sheet = $(BIN)/muslin sheet --designs all:100 --tapes W40 --png $(OUT)/out/designs.png --jobs $(JOBS) $(SHEET) && \
  $(BIN)/muslin sheet --designs tshirt --tapes $(SHEET_SIZES) --png $(OUT)/out/bodies.png --jobs $(JOBS) $(SHEET)
RUN_report = CC='$(CC)' MUSLIN_LIB='$(call library,muslin).so.$(VERSION)' \
  REPORT_FLAGS='$(strip $(FLAGS) $(OPTIMISE_$(config)) $(HARDEN_$(config)) $(CFLAGS) $(SAME_BITS)), kernels $(KERNEL_$(config))' \
  $(PYTHON) tests/study/report/report.py $(if $(QUICK),--quick --out $(OUT)/report/quick,--out $(OUT)/report \
  --page tests/study/report) $(REPORT)
RUN_check-omit = MAKEFLAGS=-j$(JOBS) MAKE='$(MAKE)' CC='$(CC)' PKG_CONFIG='$(PKG_CONFIG)' MUSLIN_DATA='$(MUSLIN_DATA)' \
  PARTS='$(A_TESTS) $(call objects,$(TESTED_EXAMPLES))' sh tests/guard/omit.sh '$(OUT)'
RUN_check-ports = CC='$(CC)' sh tests/study/ports/ports.sh '$(OUT)' $(PORTS)
RUN_fuzz = JOBS=$(JOBS) sh tests/fuzz/run.sh '$(OUT)' $(or $(SECONDS),10) $(TARGET)
$(foreach s,attack day hardening coverage check-faults,$(eval RUN_$(s) = MAKE='$$(MAKE)' PYTHON='$$(PYTHON)' sh tests/study/trust.sh $(s) '$$(OUT)'))
RUN_phrases = MUSLIN_LIB='$(call library,muslin).so.$(VERSION)' $(PYTHON) tests/design/phrases.py $(PHRASES)
RUN_elementary = CC='$(CC)' sh tests/study/elementary/run.sh '$(OUT)' $(COUNT)
$(foreach h,wheel web web-serve extensions debian $(addprefix check-,hosts wheel web agent cluster inkscape blender),$(eval \
  RUN_$(h) = MUSLIN_OUT='$$(abspath $$(OUT))' $$(PYTHON) bindings/run.py $(h) $$(HOSTS)))
RUN_check-large = MUSLIN_LARGE=1000 CK_RUN_SUITE=large $(BIN)/tests
RUN_check-threads = CC='$(CC)' sh tests/guard/threads.sh '$(OUT)' $(OPTIMISE_$(config))
RUN_check-self-off = CC='$(CC)' sh tests/guard/self_off.sh '$(OUT)'
RUN_check-glb = MUSLIN_OUT='$(abspath $(OUT))' $(PYTHON) tests/study/trade/meshes.py --command $(BIN)/muslin
RUN_sizes = sh tests/guard/sizes.sh '$(OUT)' write
RUN_house = $(PYTHON) tests/guard/house.py '$(OUT)' && CC='$(CC)' sh tests/guard/carried.sh '$(LIB)'

NEEDS = check:all check:tests attack:all attack:tests same:$(BIN)/same same:$(BIN)/figures check-omit:tests check-large:tests check-threads:lib elementary:lib fuzz:lib
$(foreach n,$(NEEDS),$(eval NEEDS_$(subst :, += ,$(n))))
STUDIES := $(foreach v,$(filter RUN_%,$(.VARIABLES)),$(if $(filter file,$(origin $(v))),$(v:RUN_%=%)))
$(if $(and $(OMIT),$(filter $(STUDIES) tests examples,$(MAKECMDGOALS))),$(error with OMIT there are libraries alone))
.PHONY: $(STUDIES) $(STUDIES:%=run-%)
$(STUDIES): %: # by a second make, so that pkg-config sees what was just installed
	@sh tests/guard/packages.sh build $(APT_GROUP)
	@$(if $(wildcard $(BIN)/muslin),,echo "muslin: building in $(OUT), a minute or a few (V=1 shows the commands)")
	@$(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS)) V=$(or $(V),0) run-$@
$(STUDIES:%=run-%): run-%: $$(or $$(NEEDS_$$*),$$(filter $(BIN)/$$*,$(STUDY_PROGRAMS)),all)
	@mkdir -p $(OUT)/out
	$(Q)$(RUN_$*)
