// Made by protocol/generator (emit_c.py). Do not edit: change protocol/definition and run `make generate`.
#include "protocol_gen.h"

#include <string.h>

uint16_t protocol_get_u16(const uint8_t* const in)
{
    return (uint16_t)((uint32_t)in[0] | ((uint32_t)in[1] << 8));
}

uint32_t protocol_get_u32(const uint8_t* const in)
{
    return (uint32_t)in[0] | ((uint32_t)in[1] << 8) | ((uint32_t)in[2] << 16) | ((uint32_t)in[3] << 24);
}

int32_t protocol_get_i32(const uint8_t* const in)
{
    return (int32_t)protocol_get_u32(in);
}

float protocol_get_f32(const uint8_t* const in)
{
    const uint32_t bits = protocol_get_u32(in);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double protocol_get_f64(const uint8_t* const in)
{
    const uint64_t bits = (uint64_t)protocol_get_u32(in) | ((uint64_t)protocol_get_u32(in + 4) << 32);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

void protocol_put_u16(uint8_t* const out, const uint16_t value)
{
    out[0] = (uint8_t)(value & 0xFFu);
    out[1] = (uint8_t)(value >> 8);
}

void protocol_put_u32(uint8_t* const out, const uint32_t value)
{
    out[0] = (uint8_t)(value & 0xFFu);
    out[1] = (uint8_t)((value >> 8) & 0xFFu);
    out[2] = (uint8_t)((value >> 16) & 0xFFu);
    out[3] = (uint8_t)(value >> 24);
}

void protocol_put_i32(uint8_t* const out, const int32_t value)
{
    protocol_put_u32(out, (uint32_t)value);
}

void protocol_put_f32(uint8_t* const out, const float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    protocol_put_u32(out, bits);
}

void protocol_put_f64(uint8_t* const out, const double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    protocol_put_u32(out, (uint32_t)(bits & 0xFFFFFFFFu));
    protocol_put_u32(out + 4, (uint32_t)(bits >> 32));
}

void message_heartbeat_pack(const message_heartbeat_t* const values, uint8_t* const payload)
{
    payload[0] = (uint8_t)values->autopilot;
    payload[1] = (uint8_t)values->autotrim;
    payload[2] = (uint8_t)values->auto_switch;
    payload[3] = (uint8_t)values->servos;
    payload[4] = (uint8_t)values->gps;
    payload[5] = (uint8_t)values->statistics;
    payload[6] = (uint8_t)values->ahrs;
    payload[7] = (uint8_t)values->inertial;
    payload[8] = (uint8_t)values->analog;
    payload[9] = (uint8_t)values->fly_by_wire;
    payload[10] = (uint8_t)values->autopilot_hil;
    payload[11] = (uint8_t)values->autotrim_hil;
}

void message_heartbeat_unpack(message_heartbeat_t* const values, const uint8_t* const payload)
{
    values->autopilot = (int8_t)payload[0];
    values->autotrim = (int8_t)payload[1];
    values->auto_switch = (int8_t)payload[2];
    values->servos = (int8_t)payload[3];
    values->gps = (int8_t)payload[4];
    values->statistics = (int8_t)payload[5];
    values->ahrs = (int8_t)payload[6];
    values->inertial = (int8_t)payload[7];
    values->analog = (int8_t)payload[8];
    values->fly_by_wire = (int8_t)payload[9];
    values->autopilot_hil = (int8_t)payload[10];
    values->autotrim_hil = (int8_t)payload[11];
}

void message_ahrs_pack(const message_ahrs_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->yaw_deg);
    protocol_put_f32(payload + 4, values->pitch_deg);
    protocol_put_f32(payload + 8, values->roll_deg);
}

void message_ahrs_unpack(message_ahrs_t* const values, const uint8_t* const payload)
{
    values->yaw_deg = protocol_get_f32(payload + 0);
    values->pitch_deg = protocol_get_f32(payload + 4);
    values->roll_deg = protocol_get_f32(payload + 8);
}

void message_inertial_pack(const message_inertial_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->gx_rad_s);
    protocol_put_f32(payload + 4, values->gy_rad_s);
    protocol_put_f32(payload + 8, values->gz_rad_s);
    protocol_put_f32(payload + 12, values->accx_m_s2);
    protocol_put_f32(payload + 16, values->accy_m_s2);
    protocol_put_f32(payload + 20, values->accz_m_s2);
    protocol_put_f32(payload + 24, values->magx);
    protocol_put_f32(payload + 28, values->magy);
    protocol_put_f32(payload + 32, values->magz);
}

void message_inertial_unpack(message_inertial_t* const values, const uint8_t* const payload)
{
    values->gx_rad_s = protocol_get_f32(payload + 0);
    values->gy_rad_s = protocol_get_f32(payload + 4);
    values->gz_rad_s = protocol_get_f32(payload + 8);
    values->accx_m_s2 = protocol_get_f32(payload + 12);
    values->accy_m_s2 = protocol_get_f32(payload + 16);
    values->accz_m_s2 = protocol_get_f32(payload + 20);
    values->magx = protocol_get_f32(payload + 24);
    values->magy = protocol_get_f32(payload + 28);
    values->magz = protocol_get_f32(payload + 32);
}

void message_analog_pack(const message_analog_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->baro_hpa);
    protocol_put_f32(payload + 4, values->altitude_m);
    protocol_put_f32(payload + 8, values->altitude_external_m);
    protocol_put_f32(payload + 12, values->pitot_pa);
    protocol_put_f32(payload + 16, values->calibrated_airspeed_kt);
    protocol_put_f32(payload + 20, values->alpha_deg);
    protocol_put_f32(payload + 24, values->beta_deg);
    protocol_put_f32(payload + 28, values->temperature_degc);
    protocol_put_f32(payload + 32, values->battery_v);
    protocol_put_f32(payload + 36, values->vvi_ft_min);
}

void message_analog_unpack(message_analog_t* const values, const uint8_t* const payload)
{
    values->baro_hpa = protocol_get_f32(payload + 0);
    values->altitude_m = protocol_get_f32(payload + 4);
    values->altitude_external_m = protocol_get_f32(payload + 8);
    values->pitot_pa = protocol_get_f32(payload + 12);
    values->calibrated_airspeed_kt = protocol_get_f32(payload + 16);
    values->alpha_deg = protocol_get_f32(payload + 20);
    values->beta_deg = protocol_get_f32(payload + 24);
    values->temperature_degc = protocol_get_f32(payload + 28);
    values->battery_v = protocol_get_f32(payload + 32);
    values->vvi_ft_min = protocol_get_f32(payload + 36);
}

void message_servos_in_pack(const message_servos_in_t* const values, uint8_t* const payload)
{
    for (uint32_t i = 0; i < 12u; i++)
    {
        protocol_put_f32(payload + 4u * i, values->channel[i]);
    }
}

void message_servos_in_unpack(message_servos_in_t* const values, const uint8_t* const payload)
{
    for (uint32_t i = 0; i < 12u; i++)
    {
        values->channel[i] = protocol_get_f32(payload + 4u * i);
    }
}

void message_fly_by_wire_pack(const message_fly_by_wire_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->aileron);
    protocol_put_f32(payload + 4, values->throttle);
    protocol_put_f32(payload + 8, values->elevator);
    protocol_put_f32(payload + 12, values->rudder);
}

void message_fly_by_wire_unpack(message_fly_by_wire_t* const values, const uint8_t* const payload)
{
    values->aileron = protocol_get_f32(payload + 0);
    values->throttle = protocol_get_f32(payload + 4);
    values->elevator = protocol_get_f32(payload + 8);
    values->rudder = protocol_get_f32(payload + 12);
}

void message_fms_plan_pack(const message_fms_plan_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->bearing_deg);
    protocol_put_f32(payload + 4, values->altitude_ft);
    protocol_put_f32(payload + 8, values->speed_kt);
    protocol_put_i32(payload + 12, values->distance_m);
    protocol_put_i32(payload + 16, values->waypoint);
}

void message_fms_plan_unpack(message_fms_plan_t* const values, const uint8_t* const payload)
{
    values->bearing_deg = protocol_get_f32(payload + 0);
    values->altitude_ft = protocol_get_f32(payload + 4);
    values->speed_kt = protocol_get_f32(payload + 8);
    values->distance_m = protocol_get_i32(payload + 12);
    values->waypoint = protocol_get_i32(payload + 16);
}

void message_fms_hil_plan_pack(const message_fms_hil_plan_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->bearing_deg);
    protocol_put_f32(payload + 4, values->altitude_ft);
    protocol_put_f32(payload + 8, values->speed_kt);
    protocol_put_i32(payload + 12, values->distance_m);
    protocol_put_i32(payload + 16, values->waypoint);
}

void message_fms_hil_plan_unpack(message_fms_hil_plan_t* const values, const uint8_t* const payload)
{
    values->bearing_deg = protocol_get_f32(payload + 0);
    values->altitude_ft = protocol_get_f32(payload + 4);
    values->speed_kt = protocol_get_f32(payload + 8);
    values->distance_m = protocol_get_i32(payload + 12);
    values->waypoint = protocol_get_i32(payload + 16);
}

void message_statistics_pack(const message_statistics_t* const values, uint8_t* const payload)
{
    protocol_put_u16(payload + 0, (uint16_t)values->sensor_dsc_percent);
    protocol_put_u16(payload + 2, (uint16_t)values->control_dsc_percent);
}

void message_statistics_unpack(message_statistics_t* const values, const uint8_t* const payload)
{
    values->sensor_dsc_percent = (int16_t)protocol_get_u16(payload + 0);
    values->control_dsc_percent = (int16_t)protocol_get_u16(payload + 2);
}

void message_gps_pack(const message_gps_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->latitude_deg);
    protocol_put_f32(payload + 4, values->longitude_deg);
    protocol_put_f32(payload + 8, values->altitude_m);
    protocol_put_f32(payload + 12, values->speed_kt);
    protocol_put_f32(payload + 16, values->heading_deg);
    protocol_put_i32(payload + 20, values->satellites);
    protocol_put_i32(payload + 24, values->fix);
    protocol_put_i32(payload + 28, values->valid);
}

void message_gps_unpack(message_gps_t* const values, const uint8_t* const payload)
{
    values->latitude_deg = protocol_get_f32(payload + 0);
    values->longitude_deg = protocol_get_f32(payload + 4);
    values->altitude_m = protocol_get_f32(payload + 8);
    values->speed_kt = protocol_get_f32(payload + 12);
    values->heading_deg = protocol_get_f32(payload + 16);
    values->satellites = protocol_get_i32(payload + 20);
    values->fix = protocol_get_i32(payload + 24);
    values->valid = protocol_get_i32(payload + 28);
}

void message_hil_surfaces_pack(const message_hil_surfaces_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->elevator);
    protocol_put_f32(payload + 4, values->aileron);
    protocol_put_f32(payload + 8, values->rudder);
    protocol_put_f32(payload + 12, values->throttle);
}

void message_hil_surfaces_unpack(message_hil_surfaces_t* const values, const uint8_t* const payload)
{
    values->elevator = protocol_get_f32(payload + 0);
    values->aileron = protocol_get_f32(payload + 4);
    values->rudder = protocol_get_f32(payload + 8);
    values->throttle = protocol_get_f32(payload + 12);
}

void message_autopilot_parameters_pack(const message_autopilot_parameters_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->k_int_altura);
    protocol_put_f32(payload + 4, values->k_altura);
    protocol_put_f32(payload + 8, values->k_VVI);
    protocol_put_f32(payload + 12, values->k_pitch);
    protocol_put_f32(payload + 16, values->k_heading);
    protocol_put_f32(payload + 20, values->k_roll);
    protocol_put_i32(payload + 24, values->k_div_velocidad);
    protocol_put_f32(payload + 28, values->k_div_P_init);
    protocol_put_f32(payload + 32, values->k_div_P_speed);
    protocol_put_f32(payload + 36, values->k_div_Q_init);
    protocol_put_f32(payload + 40, values->k_div_Q_speed);
    protocol_put_f32(payload + 44, values->k_div_R_init);
    protocol_put_f32(payload + 48, values->k_div_R_speed);
    protocol_put_f32(payload + 52, values->k_int_pitch);
    protocol_put_f32(payload + 56, values->k_elev);
    protocol_put_f32(payload + 60, values->k_airln);
    protocol_put_f32(payload + 64, values->k_rudder);
}

void message_autopilot_parameters_unpack(message_autopilot_parameters_t* const values, const uint8_t* const payload)
{
    values->k_int_altura = protocol_get_f32(payload + 0);
    values->k_altura = protocol_get_f32(payload + 4);
    values->k_VVI = protocol_get_f32(payload + 8);
    values->k_pitch = protocol_get_f32(payload + 12);
    values->k_heading = protocol_get_f32(payload + 16);
    values->k_roll = protocol_get_f32(payload + 20);
    values->k_div_velocidad = protocol_get_i32(payload + 24);
    values->k_div_P_init = protocol_get_f32(payload + 28);
    values->k_div_P_speed = protocol_get_f32(payload + 32);
    values->k_div_Q_init = protocol_get_f32(payload + 36);
    values->k_div_Q_speed = protocol_get_f32(payload + 40);
    values->k_div_R_init = protocol_get_f32(payload + 44);
    values->k_div_R_speed = protocol_get_f32(payload + 48);
    values->k_int_pitch = protocol_get_f32(payload + 52);
    values->k_elev = protocol_get_f32(payload + 56);
    values->k_airln = protocol_get_f32(payload + 60);
    values->k_rudder = protocol_get_f32(payload + 64);
}

void message_capabilities_pack(const message_capabilities_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->protocol_version);
    protocol_put_i32(payload + 4, values->features);
    memcpy(payload + 8, values->firmware_name, 16);
    memcpy(payload + 24, values->firmware_version, 16);
    protocol_put_i32(payload + 40, values->uptime_ms);
}

void message_capabilities_unpack(message_capabilities_t* const values, const uint8_t* const payload)
{
    values->protocol_version = protocol_get_i32(payload + 0);
    values->features = protocol_get_i32(payload + 4);
    memcpy(values->firmware_name, payload + 8, 16);
    memcpy(values->firmware_version, payload + 24, 16);
    values->uptime_ms = protocol_get_i32(payload + 40);
}

void message_acknowledgement_pack(const message_acknowledgement_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->command_type);
    protocol_put_i32(payload + 4, values->result);
}

void message_acknowledgement_unpack(message_acknowledgement_t* const values, const uint8_t* const payload)
{
    values->command_type = protocol_get_i32(payload + 0);
    values->result = protocol_get_i32(payload + 4);
}

void message_board_status_pack(const message_board_status_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->airspeed_source);
    protocol_put_i32(payload + 4, values->altitude_source);
    protocol_put_i32(payload + 8, values->servos_control_mode);
    protocol_put_i32(payload + 12, values->hil_plan_name);
    protocol_put_u32(payload + 16, values->frames_received);
    protocol_put_u32(payload + 20, values->frames_rejected);
}

void message_board_status_unpack(message_board_status_t* const values, const uint8_t* const payload)
{
    values->airspeed_source = protocol_get_i32(payload + 0);
    values->altitude_source = protocol_get_i32(payload + 4);
    values->servos_control_mode = protocol_get_i32(payload + 8);
    values->hil_plan_name = protocol_get_i32(payload + 12);
    values->frames_received = protocol_get_u32(payload + 16);
    values->frames_rejected = protocol_get_u32(payload + 20);
}

void message_mission_item_pack(const message_mission_item_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
    protocol_put_i32(payload + 4, values->index);
    protocol_put_f64(payload + 8, values->latitude_deg);
    protocol_put_f64(payload + 16, values->longitude_deg);
    protocol_put_f32(payload + 24, values->altitude_ft);
    protocol_put_f32(payload + 28, values->speed_kt);
}

void message_mission_item_unpack(message_mission_item_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
    values->index = protocol_get_i32(payload + 4);
    values->latitude_deg = protocol_get_f64(payload + 8);
    values->longitude_deg = protocol_get_f64(payload + 16);
    values->altitude_ft = protocol_get_f32(payload + 24);
    values->speed_kt = protocol_get_f32(payload + 28);
}

void message_mission_count_pack(const message_mission_count_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
    protocol_put_i32(payload + 4, values->count);
}

void message_mission_count_unpack(message_mission_count_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
    values->count = protocol_get_i32(payload + 4);
}

void message_hil_step_pack(const message_hil_step_t* const values, uint8_t* const payload)
{
    protocol_put_u32(payload + 0, values->clock_ms);
    protocol_put_f32(payload + 4, values->step_s);
}

void message_hil_step_unpack(message_hil_step_t* const values, const uint8_t* const payload)
{
    values->clock_ms = protocol_get_u32(payload + 0);
    values->step_s = protocol_get_f32(payload + 4);
}

void message_description_pack(const message_description_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->table_size);
    protocol_put_u32(payload + 4, values->table_crc32);
}

void message_description_unpack(message_description_t* const values, const uint8_t* const payload)
{
    values->table_size = protocol_get_i32(payload + 0);
    values->table_crc32 = protocol_get_u32(payload + 4);
}

void message_description_block_pack(const message_description_block_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->block);
    for (uint32_t i = 0; i < 32u; i++)
    {
        protocol_put_u32(payload + 4u + 4u * i, values->words[i]);
    }
}

void message_description_block_unpack(message_description_block_t* const values, const uint8_t* const payload)
{
    values->block = protocol_get_i32(payload + 0);
    for (uint32_t i = 0; i < 32u; i++)
    {
        values->words[i] = protocol_get_u32(payload + 4u + 4u * i);
    }
}

void message_own_gain_pack(const message_own_gain_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->row);
    protocol_put_f32(payload + 4, values->value);
}

void message_own_gain_unpack(message_own_gain_t* const values, const uint8_t* const payload)
{
    values->row = protocol_get_i32(payload + 0);
    values->value = protocol_get_f32(payload + 4);
}

void command_set_parameter_task_rate_pack(const command_set_parameter_task_rate_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->period_ms);
}

void command_set_parameter_task_rate_unpack(command_set_parameter_task_rate_t* const values, const uint8_t* const payload)
{
    values->period_ms = protocol_get_i32(payload + 0);
}

void command_set_fms_task_rate_pack(const command_set_fms_task_rate_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->period_ms);
}

void command_set_fms_task_rate_unpack(command_set_fms_task_rate_t* const values, const uint8_t* const payload)
{
    values->period_ms = protocol_get_i32(payload + 0);
}

void command_set_servos_task_rate_pack(const command_set_servos_task_rate_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->period_ms);
}

void command_set_servos_task_rate_unpack(command_set_servos_task_rate_t* const values, const uint8_t* const payload)
{
    values->period_ms = protocol_get_i32(payload + 0);
}

void command_xplane_info_pack(const command_xplane_info_t* const values, uint8_t* const payload)
{
    protocol_put_f32(payload + 0, values->elevator);
    protocol_put_f32(payload + 4, values->aileron);
    protocol_put_f32(payload + 8, values->rudder);
    protocol_put_f32(payload + 12, values->throttle);
    protocol_put_f32(payload + 16, values->gx_rad_s);
    protocol_put_f32(payload + 20, values->gy_rad_s);
    protocol_put_f32(payload + 24, values->gz_rad_s);
    protocol_put_f32(payload + 28, values->yaw_deg);
    protocol_put_f32(payload + 32, values->pitch_deg);
    protocol_put_f32(payload + 36, values->roll_deg);
    protocol_put_f32(payload + 40, values->altitude_ft);
    protocol_put_f32(payload + 44, values->vvi_ft_min);
    protocol_put_f32(payload + 48, values->speed_kt);
    protocol_put_f32(payload + 52, values->latitude_deg);
    protocol_put_f32(payload + 56, values->longitude_deg);
}

void command_xplane_info_unpack(command_xplane_info_t* const values, const uint8_t* const payload)
{
    values->elevator = protocol_get_f32(payload + 0);
    values->aileron = protocol_get_f32(payload + 4);
    values->rudder = protocol_get_f32(payload + 8);
    values->throttle = protocol_get_f32(payload + 12);
    values->gx_rad_s = protocol_get_f32(payload + 16);
    values->gy_rad_s = protocol_get_f32(payload + 20);
    values->gz_rad_s = protocol_get_f32(payload + 24);
    values->yaw_deg = protocol_get_f32(payload + 28);
    values->pitch_deg = protocol_get_f32(payload + 32);
    values->roll_deg = protocol_get_f32(payload + 36);
    values->altitude_ft = protocol_get_f32(payload + 40);
    values->vvi_ft_min = protocol_get_f32(payload + 44);
    values->speed_kt = protocol_get_f32(payload + 48);
    values->latitude_deg = protocol_get_f32(payload + 52);
    values->longitude_deg = protocol_get_f32(payload + 56);
}

void command_control_source_pack(const command_control_source_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->source);
}

void command_control_source_unpack(command_control_source_t* const values, const uint8_t* const payload)
{
    values->source = protocol_get_i32(payload + 0);
}

void command_servo_out_pack(const command_servo_out_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->servo);
    protocol_put_f32(payload + 4, values->position);
}

void command_servo_out_unpack(command_servo_out_t* const values, const uint8_t* const payload)
{
    values->servo = protocol_get_i32(payload + 0);
    values->position = protocol_get_f32(payload + 4);
}

void command_select_airspeed_source_pack(const command_select_airspeed_source_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->source);
}

void command_select_airspeed_source_unpack(command_select_airspeed_source_t* const values, const uint8_t* const payload)
{
    values->source = protocol_get_i32(payload + 0);
}

void command_select_altitude_source_pack(const command_select_altitude_source_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->source);
}

void command_select_altitude_source_unpack(command_select_altitude_source_t* const values, const uint8_t* const payload)
{
    values->source = protocol_get_i32(payload + 0);
}

void command_mission_begin_pack(const command_mission_begin_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
    protocol_put_i32(payload + 4, values->count);
}

void command_mission_begin_unpack(command_mission_begin_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
    values->count = protocol_get_i32(payload + 4);
}

void command_mission_item_pack(const command_mission_item_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
    protocol_put_i32(payload + 4, values->index);
    protocol_put_f64(payload + 8, values->latitude_deg);
    protocol_put_f64(payload + 16, values->longitude_deg);
    protocol_put_f32(payload + 24, values->altitude_ft);
    protocol_put_f32(payload + 28, values->speed_kt);
}

void command_mission_item_unpack(command_mission_item_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
    values->index = protocol_get_i32(payload + 4);
    values->latitude_deg = protocol_get_f64(payload + 8);
    values->longitude_deg = protocol_get_f64(payload + 16);
    values->altitude_ft = protocol_get_f32(payload + 24);
    values->speed_kt = protocol_get_f32(payload + 28);
}

void command_mission_commit_pack(const command_mission_commit_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
}

void command_mission_commit_unpack(command_mission_commit_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
}

void command_mission_read_pack(const command_mission_read_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
}

void command_mission_read_unpack(command_mission_read_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
}

void command_go_to_waypoint_pack(const command_go_to_waypoint_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->plan);
    protocol_put_i32(payload + 4, values->index);
}

void command_go_to_waypoint_unpack(command_go_to_waypoint_t* const values, const uint8_t* const payload)
{
    values->plan = protocol_get_i32(payload + 0);
    values->index = protocol_get_i32(payload + 4);
}

void command_describe_blocks_pack(const command_describe_blocks_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->first);
    protocol_put_i32(payload + 4, values->count);
}

void command_describe_blocks_unpack(command_describe_blocks_t* const values, const uint8_t* const payload)
{
    values->first = protocol_get_i32(payload + 0);
    values->count = protocol_get_i32(payload + 4);
}

void command_own_gain_get_pack(const command_own_gain_get_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->row);
}

void command_own_gain_get_unpack(command_own_gain_get_t* const values, const uint8_t* const payload)
{
    values->row = protocol_get_i32(payload + 0);
}

void command_own_gain_set_pack(const command_own_gain_set_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->row);
    protocol_put_f32(payload + 4, values->value);
}

void command_own_gain_set_unpack(command_own_gain_set_t* const values, const uint8_t* const payload)
{
    values->row = protocol_get_i32(payload + 0);
    values->value = protocol_get_f32(payload + 4);
}

void command_own_topics_pack(const command_own_topics_t* const values, uint8_t* const payload)
{
    protocol_put_i32(payload + 0, values->on);
}

void command_own_topics_unpack(command_own_topics_t* const values, const uint8_t* const payload)
{
    values->on = protocol_get_i32(payload + 0);
}

int32_t protocol_telemetry_size(const uint32_t id)
{
    switch (id)
    {
    case MESSAGE_STATISTICS_ID:
        return 4;
    case MESSAGE_ACKNOWLEDGEMENT_ID:
    case MESSAGE_MISSION_COUNT_ID:
    case MESSAGE_HIL_STEP_ID:
    case MESSAGE_DESCRIPTION_ID:
    case MESSAGE_OWN_GAIN_ID:
        return 8;
    case MESSAGE_HEARTBEAT_ID:
    case MESSAGE_AHRS_ID:
        return 12;
    case MESSAGE_FLY_BY_WIRE_ID:
    case MESSAGE_HIL_SURFACES_ID:
        return 16;
    case MESSAGE_FMS_PLAN_ID:
    case MESSAGE_FMS_HIL_PLAN_ID:
        return 20;
    case MESSAGE_BOARD_STATUS_ID:
        return 24;
    case MESSAGE_GPS_ID:
    case MESSAGE_MISSION_ITEM_ID:
        return 32;
    case MESSAGE_INERTIAL_ID:
        return 36;
    case MESSAGE_ANALOG_ID:
        return 40;
    case MESSAGE_CAPABILITIES_ID:
        return 44;
    case MESSAGE_SERVOS_IN_ID:
        return 48;
    case MESSAGE_AUTOPILOT_PARAMETERS_ID:
        return 68;
    case MESSAGE_DESCRIPTION_BLOCK_ID:
        return 132;
    default:
        return -1;
    }
}

int32_t protocol_command_size(const uint32_t id)
{
    switch (id)
    {
    case COMMAND_DO_NOTHING_ID:
    case COMMAND_STOP_ID:
    case COMMAND_START_ID:
    case COMMAND_READ_ALL_ID:
    case COMMAND_RESET_ID:
    case COMMAND_AHRS_ON_ID:
    case COMMAND_AHRS_OFF_ID:
    case COMMAND_INERTIAL_ON_ID:
    case COMMAND_INERTIAL_OFF_ID:
    case COMMAND_ANALOG_ON_ID:
    case COMMAND_ANALOG_OFF_ID:
    case COMMAND_STATISTICS_ON_ID:
    case COMMAND_STATISTICS_OFF_ID:
    case COMMAND_GPS_ON_ID:
    case COMMAND_GPS_OFF_ID:
    case COMMAND_SERVOS_IN_ON_ID:
    case COMMAND_SERVOS_IN_OFF_ID:
    case COMMAND_FLY_BY_WIRE_ON_ID:
    case COMMAND_FLY_BY_WIRE_OFF_ID:
    case COMMAND_FMS_PLAN_ON_ID:
    case COMMAND_FMS_PLAN_OFF_ID:
    case COMMAND_FMS_HIL_PLAN_ON_ID:
    case COMMAND_FMS_HIL_PLAN_OFF_ID:
    case COMMAND_AUTOPILOT_ON_ID:
    case COMMAND_AUTOPILOT_OFF_ID:
    case COMMAND_AUTOTRIM_ON_ID:
    case COMMAND_AUTOTRIM_OFF_ID:
    case COMMAND_FMS_NEXT_WAYPOINT_ID:
    case COMMAND_FMS_PREVIOUS_WAYPOINT_ID:
    case COMMAND_HIL_FMS_NEXT_WAYPOINT_ID:
    case COMMAND_HIL_FMS_PREVIOUS_WAYPOINT_ID:
    case COMMAND_EXIT_BINARY_MODE_ID:
    case COMMAND_HIL_LOAD_GANDO_ID:
    case COMMAND_HIL_LOAD_RUTA_ISLA_ID:
    case COMMAND_HIL_LOAD_ALTERNATIVA_ID:
    case COMMAND_HIL_LOAD_VUELO_ID:
    case COMMAND_SERVOS_CONTROL_MODE_FLY_BY_WIRE_ID:
    case COMMAND_SERVOS_CONTROL_MODE_HIL_ID:
    case COMMAND_LOAD_AUTOPILOT_PARAMETERS_ID:
    case COMMAND_CAPABILITIES_ID:
    case COMMAND_STORE_PARAMETERS_ID:
    case COMMAND_HIL_STEPS_ON_ID:
    case COMMAND_DESCRIBE_ID:
        return 0;
    case COMMAND_SET_PARAMETER_TASK_RATE_ID:
    case COMMAND_SET_FMS_TASK_RATE_ID:
    case COMMAND_SET_SERVOS_TASK_RATE_ID:
    case COMMAND_CONTROL_SOURCE_ID:
    case COMMAND_SET_K_ELEV_ID:
    case COMMAND_SET_K_AIRLN_ID:
    case COMMAND_SET_K_RUDDER_ID:
    case COMMAND_SET_K_INT_PITCH_ID:
    case COMMAND_SET_K_DIV_P_INIT_ID:
    case COMMAND_SET_K_DIV_P_SPEED_ID:
    case COMMAND_SET_K_DIV_Q_INIT_ID:
    case COMMAND_SET_K_DIV_Q_SPEED_ID:
    case COMMAND_SET_K_DIV_R_INIT_ID:
    case COMMAND_SET_K_DIV_R_SPEED_ID:
    case COMMAND_SET_K_DIV_VELOCIDAD_ID:
    case COMMAND_SET_K_ROLL_ID:
    case COMMAND_SET_K_HEADING_ID:
    case COMMAND_SET_K_PITCH_ID:
    case COMMAND_SET_K_VVI_ID:
    case COMMAND_SET_K_ALTURA_ID:
    case COMMAND_SET_K_INT_ALTURA_ID:
    case COMMAND_SELECT_AIRSPEED_SOURCE_ID:
    case COMMAND_SELECT_ALTITUDE_SOURCE_ID:
    case COMMAND_MISSION_COMMIT_ID:
    case COMMAND_MISSION_READ_ID:
    case COMMAND_OWN_GAIN_GET_ID:
    case COMMAND_OWN_TOPICS_ID:
        return 4;
    case COMMAND_SERVO_OUT_ID:
    case COMMAND_MISSION_BEGIN_ID:
    case COMMAND_GO_TO_WAYPOINT_ID:
    case COMMAND_DESCRIBE_BLOCKS_ID:
    case COMMAND_OWN_GAIN_SET_ID:
        return 8;
    case COMMAND_MISSION_ITEM_ID:
        return 32;
    case COMMAND_XPLANE_INFO_ID:
        return 60;
    default:
        return -1;
    }
}
