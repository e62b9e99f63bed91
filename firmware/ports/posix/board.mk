# The board as a process of this computer: build/posix/epf-board, and build/posix-asan/epf-board with the address and
# undefined-behaviour sanitizers. Included by the Makefile, whose warnings and flags it uses.

.PHONY: board-asan board-static

kernel_folder := third_party/freertos
kernel_sources := $(addprefix $(kernel_folder)/,tasks.c queue.c list.c portable/ThirdParty/GCC/Posix/port.c \
  portable/ThirdParty/GCC/Posix/utils/wait_for_event.c)
# sources that need no kernel, so that tests can run them
board_tested_sources := $(addprefix src/app/,load.c shell.c shell_commands.c shell_reply.c shell_reports.c task_table.c text.c tty.c watch.c)
board_sources := $(pure_sources) src/volume/volume.c $(wildcard src/app/*.c ports/models/*.c ports/posix/*.c)
# as system headers, so that the kernel's headers raise no warnings
board_includes := $(littlefs_flags) -Isrc -Iports/models -Iports/posix -isystem $(kernel_folder)/include \
  -isystem $(kernel_folder)/portable/ThirdParty/GCC/Posix
# the port's tick and run-time counter are replaced by those of ports/posix/kernel.c
board_link := -pthread -Wl,--wrap=usleep -Wl,--wrap=ulPortGetRunTime -lm

board: $(BUILD)/posix/epf-board
board-asan: $(BUILD)/posix-asan/epf-board
# Needs no library of the computer it runs on: for packages that are installed on any Linux.
board-static: $(BUILD)/static/epf-board

# $(1): folder, $(2): its flags
define board_flavour
$(BUILD)/$(1)/object/$(kernel_folder)/%.o: $(kernel_folder)/%.c ports/posix/FreeRTOSConfig.h
	@mkdir -p $$(@D)
	@echo "  CC $$<"
	@$$(CC) -std=gnu11 -w $(2) -pthread -Iports/posix -I$(kernel_folder)/include \
	  -I$(kernel_folder)/portable/ThirdParty/GCC/Posix -c $$< -o $$@

$(BUILD)/$(1)/object/$(littlefs_folder)/%.o: $(littlefs_folder)/%.c ports/littlefs.mk
	@mkdir -p $$(@D)
	@echo "  CC $$<"
	@$$(CC) -std=c11 -w $(2) $(littlefs_flags) -c $$< -o $$@

$(BUILD)/$(1)/object/%.o: %.c
	@mkdir -p $$(@D)
	@echo "  CC $$<"
	@$$(CC) $$(WARNINGS) $(2) -pthread $$(board_includes) $$(DEPENDENCIES) -c $$< -o $$@

$(BUILD)/$(1)/epf-board: $(patsubst %.c,$(BUILD)/$(1)/object/%.o,$(board_sources) $(kernel_sources) $(littlefs_sources))
	@mkdir -p $$(@D)
	@echo "  LD $$@"
	@$$(CC) $(2) -o $$@ $$^ $$(board_link)
endef
$(eval $(call board_flavour,posix,$(OPTIMISED)))
$(eval $(call board_flavour,posix-asan,$(SANITIZED)))

$(BUILD)/static/epf-board: $(BUILD)/posix/epf-board
	@mkdir -p $(@D)
	@echo "  LD $@"
	@$(CC) $(OPTIMISED) -static -s -o $@ $(patsubst %.c,$(BUILD)/posix/object/%.o,$(board_sources) $(kernel_sources) $(littlefs_sources)) $(board_link)
