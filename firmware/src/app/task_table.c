#include "app/task_table.h"

const task_row_t task_table[task_count] = {
    [task_watch] = {"watchTask", 8, 50, 256, 0, load_control_dsc},
    [task_sensors] = {"sensorTask", 7, 10, 768, 200, load_sensor_dsc},
    [task_control] = {"controlTask", 6, 20, 640, 200, load_control_dsc},
    [task_uart_rx] = {"UartRxTask", 5, 0, 256, 1000, load_control_dsc},
    [task_uart_tx] = {"UartTxTask", 4, 0, 256, 1000, load_control_dsc},
    [task_tty] = {"ttyTask", 3, 0, 1024, 1000, load_control_dsc},
    [task_servos] = {"qServosTask", 2, 0, 512, 1000, load_control_dsc},
    [task_fms] = {"qFMSTask", 1, 0, 512, 1000, load_control_dsc},
    [task_param] = {"qParamTask", 1, 0, 512, 1000, load_control_dsc},
    [task_card] = {"cardTask", 1, 0, 768, 1000, load_control_dsc},
};
