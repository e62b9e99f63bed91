#define _POSIX_C_SOURCE 200809L

#include "card.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "FreeRTOS.h"
#include "semphr.h"
#include "task.h"

#include "card_image.h"
#include "card_layout.h"
#include "kernel.h"
#include "volume/volume.h"

typedef enum
{
    card_read,
    card_replace
} card_operation_t;

/// One order to the card's thread, which writes its answer into it.
typedef struct
{
    card_operation_t operation;
    const char* name;
    uint8_t* into;
    const uint8_t* from;
    size_t size; ///< bytes to write, or capacity to read into and then bytes read
    storage_status_t status;
} card_order_t;

static struct
{
    const char* folder;
    storage_t storage; ///< used by the tasks; the thread uses `volume`
    volume_t volume;
    card_order_t order;
    sem_t ordered;          ///< wakes the thread
    SemaphoreHandle_t done; ///< wakes the task
    StaticSemaphore_t done_memory;
    pthread_mutex_t at_work; ///< between device threads only, never locked by a task
} card = {.at_work = PTHREAD_MUTEX_INITIALIZER};

static bool path_of(const char* name, char* path, size_t path_bytes)
{
    const int length = snprintf(path, path_bytes, "%s/%s", card.folder, name);
    return length > 0 && (size_t)length < path_bytes;
}

/// Read a record as earlier boards kept it: in a file of its own beside the card's image.
static storage_status_t read_older(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    (void)context;
    *size = 0;
    char path[4096];
    if (!path_of(name, path, sizeof path))
    {
        return storage_failed;
    }
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
    {
        return errno == ENOENT ? storage_missing : storage_failed;
    }
    ssize_t count = 0;
    while (*size < capacity && (count = read(file, data + *size, capacity - *size)) > 0)
    {
        *size += (size_t)count;
    }
    uint8_t beyond;
    const ssize_t rest = count < 0 ? -1 : read(file, &beyond, 1);
    (void)close(file);
    if (rest < 0)
    {
        return storage_failed;
    }
    return rest == 0 ? storage_ok : storage_too_long;
}

/// Remove the older files of a record that is in the image now: it must not reappear if the image is damaged later.
static void remove_older(const char* name)
{
    static const char* const endings[] = CARD_LAYOUT_OLDER_ENDINGS;
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++)
    {
        char path[4096];
        const int length = snprintf(path, sizeof path, "%s/%s%s", card.folder, name, endings[i]);
        if (length > 0 && (size_t)length < sizeof path)
        {
            (void)unlink(path);
        }
    }
}

static void work(card_order_t* order)
{
    const storage_t* const files = &card.volume.storage;
    const bool writes = order->operation == card_replace;
    if (!card_image_open(card.folder, writes))
    {
        order->status = storage_failed;
        return;
    }
    if (writes)
    {
        order->status = files->replace(files->context, order->name, order->from, order->size);
        if (order->status == storage_ok)
        {
            remove_older(order->name);
        }
    }
    else
    {
        order->status = files->read(files->context, order->name, order->into, order->size, &order->size);
    }
    card_image_close();
}

static void* run(void* unused)
{
    (void)unused;
    for (;;)
    {
        if (sem_wait(&card.ordered) == 0)
        {
            (void)pthread_mutex_lock(&card.at_work);
            work(&card.order);
            (void)pthread_mutex_unlock(&card.at_work);
            kernel_raise(kernel_interrupt_card);
        }
    }
    return NULL;
}

static bool on_done(void)
{
    BaseType_t woken = pdFALSE;
    (void)xSemaphoreGiveFromISR(card.done, &woken);
    return woken != pdFALSE;
}

static storage_status_t do_order(void)
{
    if (xTaskGetSchedulerState() == taskSCHEDULER_NOT_STARTED)
    {
        work(&card.order);
        return card.order.status;
    }
    (void)sem_post(&card.ordered);
    while (xSemaphoreTake(card.done, portMAX_DELAY) == pdFALSE)
    {
    }
    return card.order.status;
}

// NOLINTNEXTLINE(readability-non-const-parameter): the card's thread, which gets its address, writes it
static storage_status_t storage_read(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    (void)context;
    card.order = (card_order_t){.operation = card_read, .name = name, .into = data, .size = capacity};
    const storage_status_t status = do_order();
    *size = card.order.size;
    return status;
}

static storage_status_t storage_replace(void* context, const char* name, const uint8_t* data, size_t size)
{
    (void)context;
    card.order = (card_order_t){.operation = card_replace, .name = name, .from = data, .size = size};
    return do_order();
}

/// Make the folder if it does not exist. Returns what is wrong with it, or NULL.
static const char* folder_problem(const char* folder)
{
    struct stat there;
    if ((mkdir(folder, 0755) != 0 && errno != EEXIST) || stat(folder, &there) != 0)
    {
        return strerror(errno);
    }
    if (!S_ISDIR(there.st_mode))
    {
        return "there is a file of that name";
    }
    return access(folder, R_OK | W_OK | X_OK) == 0 ? NULL : strerror(errno);
}

bool card_start(const char* folder, char* error, size_t error_bytes)
{
    const char* const problem = folder_problem(folder);
    if (problem != NULL)
    {
        (void)snprintf(error, error_bytes,
                       "--card %s: not a folder that the board can write to: %s. Choose another one.", folder, problem);
        return false;
    }
    card.folder = folder;
    card.storage = (storage_t){.context = NULL, .read = storage_read, .replace = storage_replace};
    static const storage_t older = {.context = NULL, .read = read_older, .replace = NULL};
    volume_init(&card.volume, card_image_device(), &older);
    card.done = xSemaphoreCreateBinaryStatic(&card.done_memory);
    kernel_serve(kernel_interrupt_card, on_done);
    pthread_t thread;
    if (sem_init(&card.ordered, 0, 0) != 0 || pthread_create(&thread, NULL, run, NULL) != 0)
    {
        (void)snprintf(error, error_bytes, "--card %s: no thread for the card: %s.", folder, strerror(errno));
        return false;
    }
    return true;
}

const storage_t* card_storage(void)
{
    return card.folder == NULL ? NULL : &card.storage;
}

void card_settle(void)
{
    (void)pthread_mutex_lock(&card.at_work);
}
