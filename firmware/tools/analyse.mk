# Static analysis: clang's warnings as errors, clang-tidy (.clang-tidy), cppcheck with MISRA C:2012 (MISRA.md). Included by
# the Makefile. third_party is not analysed; generated sources only by the compiler and cppcheck.

.PHONY: analyse analyse-clang analyse-tidy analyse-misra

CLANG_TIDY ?= clang-tidy
CPPCHECK ?= cppcheck

# sources for the PC, and those that only the processor's compiler can build
hosted_sources := $(wildcard src/*/*.c ports/models/*.c ports/library/*.c ports/posix/*.c)
cortex_sources := $(wildcard $(addprefix ports/,cortex_m/*.c $(patsubst %,%/*.c,$(machines))))
hosted_flags := -std=c11 $(board_includes) -Iports/library
# headers of the processor's C library come after clang's own, which a freestanding program uses first
cortex_flags := -std=c11 --target=arm-none-eabi -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffreestanding \
  $(arm_includes)
cortex_headers = $(addprefix -idirafter ,$(abspath $(dir $(shell $(ARM_PREFIX)gcc -print-file-name=libc.a 2>/dev/null))../include))
has_cortex = $(shell command -v $(ARM_PREFIX)gcc)
two_at_a_time = xargs -P 2 -n

analyse: analyse-clang analyse-tidy analyse-misra

analyse-clang: $(vectors)
	@$(fuzz_needs_clang)
	@printf '%s\n' $(hosted_sources) $(test_sources) $(wildcard tests/support/*.c tests/tools/*.c) | $(two_at_a_time) 12 \
	  $(CLANG) $(WARNINGS) $(hosted_flags) $(TEST_INCLUDES) -fsyntax-only
	@$(if $(has_cortex),$(CLANG) $(WARNINGS) $(cortex_flags) $(cortex_headers) -fsyntax-only $(cortex_sources),\
	  echo "The sources of the processors' ports are not compiled by clang: $(ARM_PREFIX)gcc is not here.")
	@echo "clang: no warning"

analyse-tidy:
	@mkdir -p $(BUILD)
	@printf '%s\n' $(filter-out %_gen.c,$(hosted_sources)) | $(two_at_a_time) 4 sh -c \
	  '$(CLANG_TIDY) --quiet "$$@" -- $(hosted_flags)' clang-tidy >$(BUILD)/tidy.txt 2>$(BUILD)/tidy-errors.txt \
	  || { cat $(BUILD)/tidy.txt; grep -v 'warnings generated' $(BUILD)/tidy-errors.txt; exit 1; }
	@echo "clang-tidy: no finding in $(words $(filter-out %_gen.c,$(hosted_sources))) files"

analyse-misra:
	@$(PYTHON) tools/check_misra.py $(CPPCHECK) MISRA.md src -- '--suppress=*:third_party/*' '--suppress=*:ports/*' \
	  $(filter-out -std=c11,$(subst -isystem ,-I,$(hosted_flags)))
