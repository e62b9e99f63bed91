/// What each task does.
#ifndef APP_TASK_BODIES_H
#define APP_TASK_BODIES_H

#include "app/task_table.h"

/// In the order of `task_id_t`; a body takes the `application_t` and never returns.
extern void (*const task_bodies[task_count])(void* application);

#endif
