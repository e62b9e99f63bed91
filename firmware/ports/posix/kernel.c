#define _GNU_SOURCE // ppoll, sem_clockwait

#include "kernel.h"

#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "FreeRTOS.h"
#include "task.h"

#include "hal/time.h"

// The kernel names these functions; nothing else may call them, so they have no header.
int __wrap_usleep(unsigned int period_us);
uint32_t __wrap_ulPortGetRunTime(void);
void vApplicationIdleHook(void);
void vApplicationTickHook(void);

static const int64_t ns_per_us = 1000;
static const int64_t ns_per_s = 1000000000;

/// After a short hold-up, missed ticks are served 0.25 ms apart. After a longer one (the PC slept) they are dropped and
/// the clock continues from there: a burst of old ticks would make every task run many times.
static const int64_t tick_gap_ns = 250000;
static const int64_t longest_hold_up_ns = 50000000;

static const int64_t idle_nap_ns = 300000;
static const int64_t longest_sleep_ticks = 1000;
static const int64_t tick_ns = 1000000000 / configTICK_RATE_HZ;

static bool (*handlers[kernel_interrupt_count])(void);
static atomic_uint pending;
static atomic_ullong ticks_served;
static atomic_llong clock_started_ns; ///< when tick 0 was due
static atomic_llong asleep_until_ns;  ///< when the idle task's sleep ends; 0: it does not sleep
static sem_t tick_changed;            ///< ends the tick thread's wait

static int64_t monotonic_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * ns_per_s + now.tv_nsec;
}

uint32_t time_ms(void)
{
    return (uint32_t)(monotonic_ns() / (1000 * ns_per_us));
}

/// Run the handlers of all raised interrupts; true when a woken task should run now.
static bool serve_pending(void)
{
    const unsigned int raised = atomic_exchange(&pending, 0U);
    bool woken = false;
    for (unsigned int i = 0; raised != 0U && i < kernel_interrupt_count; i++)
    {
        if ((raised & (1U << i)) != 0U && handlers[i] != NULL && handlers[i]())
        {
            woken = true;
        }
    }
    return woken;
}

static void on_interrupt(int signal_number)
{
    (void)signal_number;
    const int saved_errno = errno;
    taskENTER_CRITICAL();
    if (serve_pending())
    {
        portYIELD();
    }
    taskEXIT_CRITICAL();
    errno = saved_errno;
}

void kernel_init(void)
{
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, NULL);
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_interrupt;
    sigfillset(&action.sa_mask);
    sigaction(SIGUSR2, &action, NULL);
    sem_init(&tick_changed, 0, 0);
}

void kernel_serve(kernel_interrupt_t interrupt, bool (*handler)(void))
{
    handlers[interrupt] = handler;
}

void kernel_raise(kernel_interrupt_t interrupt)
{
    if (atomic_fetch_or(&pending, 1U << (unsigned int)interrupt) == 0U)
    {
        kill(getpid(), SIGUSR2);
    }
}

void vApplicationTickHook(void)
{
    ticks_served++;
    // The kernel switches to woken tasks by itself after this hook.
    (void)serve_pending();
}

/// The idle task calls this before each sleep. The kernel's own sleep lasts at least two ticks; shorter waits are done
/// here.
void vApplicationIdleHook(void)
{
    const struct timespec nap = {.tv_nsec = (long)idle_nap_ns};
    (void)nanosleep(&nap, NULL);
}

static void wait_until(int64_t due_ns)
{
    const struct timespec due = {.tv_sec = (time_t)(due_ns / ns_per_s), .tv_nsec = (long)(due_ns % ns_per_s)};
    (void)sem_clockwait(&tick_changed, CLOCK_MONOTONIC, &due);
}

/// Every task waits, the shortest for `expected_ticks`: until then no tick is needed, only interrupts.
void kernel_sleep(TickType_t expected_ticks)
{
    const int64_t expected = expected_ticks < longest_sleep_ticks ? (int64_t)expected_ticks : longest_sleep_ticks;
    portDISABLE_INTERRUPTS();
    if (eTaskConfirmSleepModeStatus() != eAbortSleep)
    {
        const int64_t end_ns = clock_started_ns + ((int64_t)ticks_served + expected) * tick_ns;
        const int64_t rest_ns = end_ns - monotonic_ns();
        if (rest_ns > 0)
        {
            const struct timespec rest = {.tv_sec = (time_t)(rest_ns / ns_per_s),
                                          .tv_nsec = (long)(rest_ns % ns_per_s)};
            sigset_t none;
            sigemptyset(&none);
            asleep_until_ns = end_ns;
            (void)ppoll(NULL, 0, &rest, &none);
            asleep_until_ns = 0;
        }
        const int64_t now_ns = monotonic_ns();
        const int64_t slept = (now_ns - clock_started_ns) / tick_ns - (int64_t)ticks_served;
        const int64_t stepped = slept < expected ? slept : expected;
        if (stepped > 0)
        {
            ticks_served += (unsigned long long)stepped;
            vTaskStepTick((TickType_t)stepped);
        }
        if (end_ns - now_ns > tick_ns)
        {
            (void)sem_post(&tick_changed); // woken early: the tasks need their ticks again
        }
    }
    portENABLE_INTERRUPTS();
}

/// The tick thread's wait between two ticks. A relative sleep would make the tick about 6 % slow, and a tick sent to a
/// task that is being switched out can be lost; so the deadline is computed from the ticks that were really served.
int __wrap_usleep(unsigned int period_us)
{
    static int64_t served_before = 0;
    (void)period_us;
    int64_t now_ns = monotonic_ns();
    if (clock_started_ns == 0)
    {
        clock_started_ns = now_ns - tick_ns;
    }
    const int64_t earliest_ns = now_ns + tick_gap_ns;
    for (;;)
    {
        // Count the tick that was sent just now as served.
        const int64_t served = (int64_t)ticks_served;
        const int64_t next = (served > served_before ? served : served_before + 1) + 1;
        const int64_t asleep_ns = asleep_until_ns;
        int64_t due_ns = asleep_ns != 0 ? asleep_ns + tick_ns : clock_started_ns + next * tick_ns;
        if (asleep_ns == 0 && now_ns - due_ns > longest_hold_up_ns)
        {
            clock_started_ns += now_ns - due_ns;
        }
        due_ns = due_ns > earliest_ns ? due_ns : earliest_ns;
        if (now_ns >= due_ns)
        {
            break;
        }
        wait_until(due_ns);
        now_ns = monotonic_ns();
    }
    served_before = (int64_t)ticks_served;
    return 0;
}

/// Microseconds, for the kernel's run-time statistics. The port's own counter is the CPU time of the whole process, in
/// steps of 10 ms.
uint32_t __wrap_ulPortGetRunTime(void)
{
    return (uint32_t)(monotonic_ns() / ns_per_us);
}

void kernel_assert_failed(const char* file, int line)
{
    char text[16];
    size_t at = sizeof text;
    text[--at] = '\n';
    for (int rest = line; rest > 0 && at > 0; rest /= 10)
    {
        text[--at] = (char)('0' + rest % 10);
    }
    static const char begin[] = "epf-board: assertion failed: ";
    // The program ends: a failing write cannot be reported any more.
    if (write(STDERR_FILENO, begin, sizeof begin - 1) < 0 || write(STDERR_FILENO, file, strlen(file)) < 0 ||
        write(STDERR_FILENO, ":", 1) < 0 || write(STDERR_FILENO, text + at, sizeof text - at) < 0)
    {
    }
    abort();
}
