#include "app/mailbox.h"

void mailbox_init(mailbox_t* mailbox)
{
    byte_ring_init(&mailbox->ring, mailbox->bytes, sizeof mailbox->bytes);
    mailbox->mutex = xSemaphoreCreateMutexStatic(&mailbox->mutex_memory);
    mailbox->reader = NULL;
    mailbox->refused = 0;
}

bool mailbox_put(mailbox_t* mailbox, const uint8_t* bytes, size_t size)
{
    (void)xSemaphoreTake(mailbox->mutex, portMAX_DELAY);
    const bool fits = byte_ring_room(&mailbox->ring) >= size;
    if (fits)
    {
        (void)byte_ring_put(&mailbox->ring, bytes, size);
    }
    else
    {
        mailbox->refused++;
    }
    (void)xSemaphoreGive(mailbox->mutex);
    if (fits)
    {
        (void)xTaskNotifyGive(mailbox->reader);
    }
    return fits;
}

bool mailbox_is_all_but_empty(const mailbox_t* mailbox)
{
    return byte_ring_room(&mailbox->ring) >= sizeof mailbox->bytes - (size_t)mailbox_rest_bytes;
}
