#include "comms/command.h"

command_result_t command_dispatch(const command_t* table, size_t count, void* context, uint32_t type_id,
                                  const uint8_t* payload, size_t payload_size)
{
    size_t low = 0;
    size_t high = count;
    while (low < high)
    {
        const size_t middle = low + (high - low) / 2;
        if (table[middle].type_id < type_id)
        {
            low = middle + 1;
        }
        else
        {
            high = middle;
        }
    }
    if (low == count || table[low].type_id != type_id)
    {
        return command_unknown;
    }
    if (table[low].payload_size != payload_size)
    {
        return command_bad_value;
    }
    return table[low].run(context, table[low].argument, payload);
}
