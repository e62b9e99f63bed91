/// A memory card at the other end of a serial peripheral bus, byte by byte, with everything that can be wrong with one.
#ifndef SUPPORT_SD_MODEL_H
#define SUPPORT_SD_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/spi.h"

enum
{
    sd_model_sectors = 512, ///< 256 kB
    sd_model_sector_bytes = 512,
    sd_model_always = 1000000
};

/// What the write that the power is cut in leaves of a sector.
typedef enum
{
    sd_cut_before,
    sd_cut_within,
    sd_cut_after,
    sd_cut_unreadable, ///< the card's own correction of errors cannot make it out any more
    sd_cut_count
} sd_cut_t;

typedef struct
{
    uint8_t sectors[sd_model_sectors][sd_model_sector_bytes];
    bool is_unreadable[sd_model_sectors];
    bool is_worn[sd_model_sectors]; ///< refuses to be written

    // What kind of card.
    bool is_first_version;  ///< knows no command 8
    bool is_high_capacity;  ///< addresses are sectors
    bool has_other_voltage; ///< answers command 8 with another pattern
    uint32_t told_sectors;  ///< by its register; 0: as many as it has
    uint8_t csd_version;    ///< 0xFF: of its kind

    // What is wrong with it. Numbers count down and hold for so many times.
    bool is_absent;          ///< nothing is plugged in: the line rests
    bool is_line_low;        ///< the card's line is short-circuited to ground
    size_t bus_fails_from;   ///< bytes at a time, then the processor's own part does not work; 0: it does
    bool stays_idle;         ///< is never ready
    bool is_locked;          ///< its status says so
    bool refuses_crc;        ///< does not know command 59
    bool stays_busy;         ///< after the next write, for ever
    bool has_no_token;       ///< accepts a read and never sends the block
    long damaged_reads;      ///< a bit of the block is wrong
    long damaged_writes;     ///< the card finds the block damaged
    long damaged_commands;   ///< the card finds the command damaged
    long deaf_idles;         ///< does not hear command 0
    long bytes_until_pulled; ///< of the bus, then the card is gone; negative: it stays
    long writes_until_cut;   ///< of sectors, then the power is gone in one; negative: it stays
    sd_cut_t cut;

    // What happened.
    long bytes;    ///< over the bus
    long pauses;   ///< of a millisecond
    long writes;   ///< of sectors
    long bad_crcs; ///< of commands and blocks that came in; has to stay 0
    long too_fast; ///< bytes at the fast clock before the card was ready; has to stay 0
    bool is_fast;
    bool is_selected;

    // Where it is; for the model alone.
    bool is_on; ///< has got a command 0
    bool is_idle;
    bool is_application;
    bool checks_crc;
    uint8_t received[sd_model_sector_bytes + 3];
    size_t received_size;
    size_t wanted_size; ///< 0: waits for a command
    uint32_t write_to;
    bool takes_block;
    uint8_t answer[sd_model_sector_bytes + 24];
    size_t answer_size;
    size_t answer_at;
    long busy_ms;
    bool is_busy_for_ever;

    spi_t spi; ///< to hand to the code under test
} sd_model_t;

/// A card of high capacity that never held anything.
void sd_model_init(sd_model_t* model);

/// The power was off: what the card holds stays, all else begins anew.
void sd_model_restart(sd_model_t* model);

#endif
