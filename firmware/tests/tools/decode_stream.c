/// Decode standard input with the firmware's decoder, for comparison with the decoders of other languages.
///
///     decode-stream CHUNK board-to-pc|pc-to-board < bytes
///
/// feeds CHUNK bytes at a time and prints `type payload` (decimal, hexadecimal) for each accepted frame, and
/// `damaged N` (refused candidates) at the end.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comms/frame.h"

enum
{
    chunk_max_bytes = 65536
};

static void print_frame(const frame_t* frame)
{
    printf("%lu ", (unsigned long)frame->type_id);
    for (size_t i = 0; i < frame->payload_size; i++)
    {
        printf("%02x", (unsigned int)frame->payload[i]);
    }
    printf("\n");
}

static void decode(frame_decoder_t* decoder, const uint8_t* bytes, size_t size)
{
    while (size > 0)
    {
        const size_t taken = frame_decoder_feed(decoder, bytes, size);
        bytes += taken;
        size -= taken;
        frame_t frame;
        frame_event_t event;
        while ((event = frame_decoder_next(decoder, &frame)) != frame_event_none)
        {
            if (event == frame_event_frame)
            {
                print_frame(&frame);
            }
        }
    }
}

int main(int argc, char** argv)
{
    const long chunk = argc == 3 ? strtol(argv[1], NULL, 10) : 0;
    const frame_dialect_t* const dialect = argc != 3                             ? NULL
                                           : strcmp(argv[2], "board-to-pc") == 0 ? &frame_from_board
                                           : strcmp(argv[2], "pc-to-board") == 0 ? &frame_to_board
                                                                                 : NULL;
    if (chunk < 1 || chunk > chunk_max_bytes || dialect == NULL)
    {
        fprintf(stderr, "usage: %s CHUNK board-to-pc|pc-to-board < bytes (CHUNK 1..%d)\n", argv[0], chunk_max_bytes);
        return 2;
    }
    static uint8_t bytes[chunk_max_bytes];
    frame_decoder_t decoder;
    frame_decoder_init(&decoder, dialect);
    size_t size;
    while ((size = fread(bytes, 1, (size_t)chunk, stdin)) > 0)
    {
        decode(&decoder, bytes, size);
    }
    printf("damaged %lu\n", (unsigned long)frame_decoder_rejected(&decoder));
    return ferror(stdin) != 0 ? 1 : 0;
}
