# The board as images of Cortex-M4F processors, built by Debian's ARM compiler: build/<machine>/epf-board.elf (and .bin)
# for the processor itself, build/<machine>/epf-board-qemu.elf for QEMU, with a folder of the computer as its memory card.
# Included by the Makefile, whose warnings it uses.

.PHONY: images size report

ARM_PREFIX ?= arm-none-eabi-
machines := stm32f405 lm3s6965evb

arm_flags := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -Os -g -ffp-contract=off -fno-common \
  -ffunction-sections -fdata-sections
arm_kernel_sources := $(addprefix $(kernel_folder)/,tasks.c queue.c list.c portable/GCC/ARM_CM4F/port.c)
arm_includes := $(littlefs_flags) -Isrc -Iports/models -Iports/cortex_m -isystem $(kernel_folder)/include \
  -isystem $(kernel_folder)/portable/GCC/ARM_CM4F
none_sources := ports/cortex_m/host_none.c src/volume/volume.c $(card_sources) $(littlefs_sources)
emulator_sources := $(addprefix ports/cortex_m/,host_semihosting.c host_card.c semihosting.c) src/volume/volume.c \
  $(littlefs_sources)
# objects that every machine's image contains
arm_sources := $(pure_sources) $(wildcard src/app/*.c ports/models/*.c) \
  $(filter-out $(none_sources) $(emulator_sources),$(wildcard ports/cortex_m/*.c))
arm_object = $(1:%.c=$(BUILD)/cortex_m/object/%.o)
arm_objects := $(call arm_object,$(arm_sources) $(arm_kernel_sources))

images: $(foreach machine,$(machines),$(BUILD)/$(machine)/epf-board.bin $(BUILD)/$(machine)/epf-board-qemu.elf)

size: $(foreach machine,$(machines),$(BUILD)/$(machine)/epf-board.elf)
	@$(ARM_PREFIX)size $^

# memory of every target; stack, processor time and HIL round trip of the images, flown in QEMU for SECONDS=20
report: images board
	@$(PYTHON) tools/report.py $(BUILD) $(ARM_PREFIX)size $(SECONDS)

# say what is missing before the first file fails
$(BUILD)/cortex_m/compiler:
	@mkdir -p $(@D)
	@command -v $(ARM_PREFIX)gcc >$@ || { echo "make: the ARM compiler ($(ARM_PREFIX)gcc) is not here: on Debian or Ubuntu" \
	  "install gcc-arm-none-eabi and libnewlib-arm-none-eabi." >&2; exit 1; }

$(BUILD)/cortex_m/object/$(kernel_folder)/%.o: $(kernel_folder)/%.c ports/cortex_m/FreeRTOSConfig.h | $(BUILD)/cortex_m/compiler
	@mkdir -p $(@D)
	@echo "  CC $< (Cortex-M4F)"
	@$(ARM_PREFIX)gcc -std=gnu11 -w $(arm_flags) -Iports/cortex_m -I$(kernel_folder)/include \
	  -I$(kernel_folder)/portable/GCC/ARM_CM4F -c $< -o $@

$(BUILD)/cortex_m/object/$(littlefs_folder)/%.o: $(littlefs_folder)/%.c ports/littlefs.mk | $(BUILD)/cortex_m/compiler
	@mkdir -p $(@D)
	@echo "  CC $< (Cortex-M4F)"
	@$(ARM_PREFIX)gcc -std=c11 -w $(arm_flags) $(littlefs_flags) -c $< -o $@

$(BUILD)/cortex_m/object/%.o: %.c ports/cortex_m/images.mk | $(BUILD)/cortex_m/compiler
	@mkdir -p $(@D)
	@echo "  CC $< (Cortex-M4F)"
	@$(ARM_PREFIX)gcc $(WARNINGS) $(arm_flags) $(arm_includes) $(DEPENDENCIES) -c $< -o $@

# $(1): machine, $(2): end of the image's name, $(3): sources of its card and options
define arm_image
$(BUILD)/$(1)/epf-board$(2).elf: $$(arm_objects) $$(call arm_object,$$(wildcard ports/$(1)/*.c) $(3)) \
  ports/$(1)/memory.ld ports/cortex_m/sections.ld
	@mkdir -p $$(@D)
	@echo "  LD $$@"
	@$(ARM_PREFIX)gcc $$(arm_flags) -nostartfiles --specs=nano.specs -Wl,--gc-sections -Wl,--fatal-warnings \
	  -Wl,-Map=$$(@:.elf=.map) -T ports/$(1)/memory.ld -o $$@ $$(filter %.o,$$^) -lm
endef
$(foreach machine,$(machines),$(eval $(call arm_image,$(machine),,$(none_sources))))
$(foreach machine,$(machines),$(eval $(call arm_image,$(machine),-qemu,$(emulator_sources))))

%.bin: %.elf
	@$(ARM_PREFIX)objcopy -O binary $< $@
