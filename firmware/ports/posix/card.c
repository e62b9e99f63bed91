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

#include "kernel.h"

typedef enum
{
    card_read,
    card_replace
} card_operation_t;

/// One order to the card's thread. A task fills it in, the thread answers in it.
typedef struct
{
    card_operation_t operation;
    const char* name;
    uint8_t* into;
    const uint8_t* from;
    size_t size; ///< bytes to write, room to read into, then bytes read
    storage_status_t status;
} card_order_t;

static struct
{
    const char* folder;
    storage_t storage;
    card_order_t order;
    sem_t ordered;          ///< the thread waits for it
    SemaphoreHandle_t done; ///< the task waits for it
    StaticSemaphore_t done_memory;
    pthread_mutex_t at_work; ///< between the device threads only; no task ever takes it
} card = {.at_work = PTHREAD_MUTEX_INITIALIZER};

static bool path_of(const char* name, const char* ending, char* path, size_t path_bytes)
{
    const int length = snprintf(path, path_bytes, "%s/%s%s", card.folder, name, ending);
    return length > 0 && (size_t)length < path_bytes;
}

/// The name itself must be on the disk too: it is written when its folder is.
static bool sync_folder(void)
{
    const int folder = open(card.folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
    {
        return false;
    }
    const bool done = fsync(folder) == 0;
    (void)close(folder);
    return done;
}

static bool write_whole(int file, const uint8_t* data, size_t size)
{
    while (size > 0)
    {
        const ssize_t count = write(file, data, size);
        if (count <= 0)
        {
            return false;
        }
        data += count;
        size -= (size_t)count;
    }
    return fsync(file) == 0;
}

static storage_status_t read_file(const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    char path[4096];
    if (!path_of(name, "", path, sizeof path))
    {
        return storage_failed;
    }
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
    {
        return errno == ENOENT ? storage_missing : storage_failed;
    }
    size_t held = 0;
    ssize_t count = 0;
    while (held < capacity && (count = read(file, data + held, capacity - held)) > 0)
    {
        held += (size_t)count;
    }
    uint8_t beyond;
    const bool fits = count >= 0 && read(file, &beyond, 1) == 0;
    (void)close(file);
    *size = held;
    return fits ? storage_ok : storage_failed;
}

/// A new file beside the old one takes its name only when it is whole and on the disk.
static storage_status_t replace_file(const char* name, const uint8_t* data, size_t size)
{
    char path[4096];
    char new_path[4096];
    if (!path_of(name, "", path, sizeof path) || !path_of(name, ".new", new_path, sizeof new_path))
    {
        return storage_failed;
    }
    const int file = open(new_path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0)
    {
        return storage_failed;
    }
    const bool written = write_whole(file, data, size);
    const bool closed = close(file) == 0;
    if (!written || !closed || rename(new_path, path) != 0)
    {
        (void)unlink(new_path);
        return storage_failed;
    }
    return sync_folder() ? storage_ok : storage_failed;
}

static void work(card_order_t* order)
{
    order->status = order->operation == card_read ? read_file(order->name, order->into, order->size, &order->size)
                                                  : replace_file(order->name, order->from, order->size);
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

bool card_start(const char* folder, char* error, size_t error_bytes)
{
    struct stat there;
    if ((mkdir(folder, 0755) != 0 && errno != EEXIST) || stat(folder, &there) != 0 || !S_ISDIR(there.st_mode) ||
        access(folder, R_OK | W_OK | X_OK) != 0)
    {
        (void)snprintf(error, error_bytes,
                       "--card %s: not a folder that the board can write to: %s. Choose another one.", folder,
                       errno == EEXIST ? "there is a file of that name" : strerror(errno));
        return false;
    }
    card.folder = folder;
    card.storage = (storage_t){.context = NULL, .read = storage_read, .replace = storage_replace};
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
