/// What the shell shows of the board.
#ifndef APP_SHELL_REPORTS_H
#define APP_SHELL_REPORTS_H

#include "app/shell_call.h"
#include "comms/telemetry.h"

/// Names of the streams, in the order of `telemetry_stream_t`, and of the tasks that send them.
extern const char* const shell_stream_names[telemetry_stream_count];
extern const char* const shell_task_names[telemetry_task_count];

/// Greet a person at the start with what is wrong with the card; with nothing when it is sound.
void shell_greet(const board_card_t* card, text_t* reply);

void shell_show_version(const shell_call_t* call);
void shell_show_status(const shell_call_t* call);
void shell_show_tasks(const shell_call_t* call);
void shell_show_sensors(const shell_call_t* call);
void shell_show_receiver(const shell_call_t* call);
void shell_show_servos(const shell_call_t* call);
void shell_show_hil(const shell_call_t* call);
void shell_show_flight_plan(const shell_call_t* call);
void shell_show_streams(const shell_call_t* call);

#endif
