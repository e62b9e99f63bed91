#include "app/task_table.h"

const task_row_t task_table[task_count] = {
    [task_sensors] = {"sensorTask", 7, 10, load_sensor_dsc}, [task_control] = {"controlTask", 6, 20, load_control_dsc},
    [task_uart_rx] = {"UartRxTask", 5, 0, load_control_dsc}, [task_uart_tx] = {"UartTxTask", 4, 0, load_control_dsc},
    [task_tty] = {"ttyTask", 3, 0, load_control_dsc},        [task_servos] = {"qServosTask", 2, 0, load_control_dsc},
    [task_fms] = {"qFMSTask", 1, 0, load_control_dsc},       [task_param] = {"qParamTask", 1, 0, load_control_dsc},
    [task_card] = {"cardTask", 1, 0, load_control_dsc},
};
