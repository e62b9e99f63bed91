# libFuzzer on the frame layer, the interpreter and the mission transfer; needs clang with its run-time library.
# `make fuzz` runs each target RUNS times (or for FUZZ_MINUTES); `make fuzz-test` runs briefly and checks that planted bugs
# are found.
# Included by the Makefile, whose warnings and sources it uses.

.PHONY: fuzz fuzz-test fuzz-build

RUNS ?= 1000000
FUZZ_MINUTES ?=
# the newest one that is installed; empty: none
CLANG ?= $(notdir $(firstword $(foreach name,clang-19 clang-18 clang-17 clang-16 clang-15 clang-14 clang,\
  $(wildcard $(addsuffix /$(name),$(subst :, ,$(PATH)))))))

fuzz_targets := frame interpreter mission
fuzz_flags := -O1 -g -ffp-contract=off -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
fuzz_folder := $(BUILD)/fuzz
fuzz_sources := $(filter-out third_party/cmocka/%,$(tested_sources))
fuzz_object = $(1:%.c=$(fuzz_folder)/object/%.o)
fuzz_programs := $(fuzz_targets:%=$(fuzz_folder)/fuzz_%)
fuzz_compile = $(CLANG) $(WARNINGS) $(fuzz_flags) -fsanitize=fuzzer-no-link $(TEST_INCLUDES) -Ifuzz
fuzz_link = $(CLANG) $(fuzz_flags) -fsanitize=fuzzer

# say what is missing before the first file fails
fuzz_needs_clang = test -n "$(CLANG)" || { echo "make: fuzzing needs clang with its run-time library, which is not here:" \
  "on Debian or Ubuntu install clang-14 and libclang-rt-14-dev." >&2; exit 1; }

fuzz: fuzz-build
	@$(PYTHON) fuzz/run.py long $(fuzz_folder) $(if $(FUZZ_MINUTES),--minutes $(FUZZ_MINUTES),--runs $(RUNS))

# a bug is planted by compiling a changed copy of a source with the same options
fuzz-test: fuzz-build
	@$(PYTHON) fuzz/run.py short $(fuzz_folder) --results "$(RESULTS)"
	@$(PYTHON) fuzz/run.py planted $(fuzz_folder) --results "$(RESULTS)" --compile "$(fuzz_compile)" --link "$(fuzz_link)"

fuzz-build: $(fuzz_programs) $(fuzz_folder)/make_seeds
	@rm -rf $(fuzz_folder)/seeds && mkdir -p $(fuzz_folder)/seeds
	@$(fuzz_folder)/make_seeds $(fuzz_folder)/seeds

$(fuzz_folder)/object/third_party/%.o: third_party/%.c
	@$(fuzz_needs_clang)
	@mkdir -p $(@D)
	@echo "  CC $< (fuzz)"
	@$(CLANG) -std=gnu11 -w $(fuzz_flags) -fsanitize=fuzzer-no-link $(TEST_INCLUDES) -c $< -o $@

$(fuzz_folder)/object/%.o: %.c | $(vectors)
	@$(fuzz_needs_clang)
	@mkdir -p $(@D)
	@echo "  CC $< (fuzz)"
	@$(fuzz_compile) $(DEPENDENCIES) -c $< -o $@

$(fuzz_folder)/tested.a: $(call fuzz_object,$(fuzz_sources) fuzz/fuzz.c)
	@rm -f $@ && $(AR) rcs $@ $^

# the mutator must be linked as an object: the linker would not take it from an archive
$(fuzz_folder)/fuzz_%: $(call fuzz_object,fuzz/fuzz_%.c fuzz/line_mutator.c) $(fuzz_folder)/tested.a
	@echo "  LD $@"
	@$(fuzz_link) -o $@ $^ -lm

$(fuzz_folder)/make_seeds: $(fuzz_folder)/object/fuzz/make_seeds.o $(fuzz_folder)/tested.a
	@echo "  LD $@"
	@$(CLANG) $(fuzz_flags) -o $@ $^ -lm
