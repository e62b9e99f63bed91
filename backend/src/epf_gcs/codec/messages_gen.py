# Made by protocol/generator (emit_python.py). Do not edit: change protocol/definition and run `make generate`.
"""The wire's tables: every message, command, parameter, simulator row and route."""

from __future__ import annotations

from collections.abc import Mapping
from math import nan
from struct import Struct
from types import MappingProxyType
from typing import Final

from epf_gcs.codec.tables import Confirm, Message, Parameter, Route, Row, RowValue, Value, Waypoint

TO_PC_HEADER: Final = b'\rQT,'
TO_BOARD_HEADER: Final = b'#QT,'
END: Final = b'\r\n\r\n'
TO_PC_TYPE_BIT: Final = 0x80000000
FORBIDDEN_TYPE_BITS: Final = 0x70000000
OPEN_BINARY_MODE: Final = b'#QT\n'

DATAGRAM_MAGIC: Final = b'DATA'
TAG_FROM_SIMULATOR: Final = 0x40
TAG_TO_SIMULATOR: Final = 0x00
VALUES_PER_ROW: Final = 8
NO_VALUE: Final = -999.0
RECEIVE_PORT: Final = 49003
SEND_PORT: Final = 49000
PROFILES: Final = ('xp10', 'xp12')

_MESSAGES: Final = (
    Message(
        id=0, name='heartbeat', doc="State of the streams and of the autopilots. Always sent in binary mode, at the parameter task's rate.",
        source='header, capture; chapter, figure 30', extension=False, topic=True,
        struct=Struct("<bbbbbbbbbbbb"),
        values=(
            Value('autopilot', 'boolean', 0, 'flag', 'Autopilot of the real aircraft is on.', minimum=0, maximum=1),
            Value('autotrim', 'boolean', 1, 'flag', 'Elevator autotrim of the real aircraft is on.', minimum=0, maximum=1),
            Value('auto_switch', 'boolean', 2, 'flag', 'The transmitter\'s "automatic" switch is on.', minimum=0, maximum=1),
            Value('servos', 'boolean', 3, 'flag', 'Stream servos_in is on.', minimum=0, maximum=1),
            Value('gps', 'boolean', 4, 'flag', 'Stream gps is on.', minimum=0, maximum=1),
            Value('statistics', 'boolean', 5, 'flag', 'Stream statistics is on.', minimum=0, maximum=1),
            Value('ahrs', 'boolean', 6, 'flag', 'Stream ahrs is on.', minimum=0, maximum=1),
            Value('inertial', 'boolean', 7, 'flag', 'Stream inertial is on.', minimum=0, maximum=1),
            Value('analog', 'boolean', 8, 'flag', 'Stream analog is on.', minimum=0, maximum=1),
            Value('fly_by_wire', 'boolean', 9, 'flag', 'Stream fly_by_wire is on.', minimum=0, maximum=1),
            Value('autopilot_hil', 'boolean', 10, 'bit', 'Autopilot of the HIL aircraft is on.', minimum=0, maximum=3, bit=0),
            Value('source_joystick', 'boolean', 10, 'bit', 'Control source is the joystick; otherwise the RC transmitter.', minimum=0, maximum=3, bit=1),
            Value('autotrim_hil', 'boolean', 11, 'flag', 'Elevator autotrim of the HIL aircraft is on.', minimum=0, maximum=1),
        ),
    ),
    Message(
        id=1, name='ahrs', doc='Attitude estimate of the airframe relative to local north-east-down.',
        source='header, capture; chapter, figure 31', extension=False, topic=True,
        struct=Struct("<fff"),
        values=(
            Value('yaw_deg', 'number', 0, 'plain', 'Heading; boards send 0..360 or -180..180. Shown as 0..360.', unit='deg', minimum=-360.0, maximum=360.0, sign='clockwise from north, seen from above'),
            Value('pitch_deg', 'number', 1, 'plain', 'Pitch angle.', unit='deg', minimum=-90.0, maximum=90.0, sign='nose up'),
            Value('roll_deg', 'number', 2, 'plain', 'Roll angle.', unit='deg', minimum=-180.0, maximum=180.0, sign='right wing down'),
        ),
    ),
    Message(
        id=2, name='inertial', doc='Calibrated inertial sensors in body axes: x forward, y right, z down.',
        source='header, capture; chapter, figure 32', extension=False, topic=True,
        struct=Struct("<fffffffff"),
        values=(
            Value('gx_rad_s', 'number', 0, 'plain', 'Roll rate P.', unit='rad/s', minimum=-40.0, maximum=40.0, sign='right wing going down'),
            Value('gy_rad_s', 'number', 1, 'plain', 'Pitch rate Q.', unit='rad/s', minimum=-40.0, maximum=40.0, sign='nose going up'),
            Value('gz_rad_s', 'number', 2, 'plain', 'Yaw rate R.', unit='rad/s', minimum=-40.0, maximum=40.0, sign='nose going right'),
            Value('accx_m_s2', 'number', 3, 'plain', 'Specific force along x.', unit='m/s2', minimum=-200.0, maximum=200.0, sign='forward'),
            Value('accy_m_s2', 'number', 4, 'plain', 'Specific force along y.', unit='m/s2', minimum=-200.0, maximum=200.0, sign='right'),
            Value('accz_m_s2', 'number', 5, 'plain', 'Specific force along z.', unit='m/s2', minimum=-200.0, maximum=200.0, sign='down; level flight gives -9.81'),
            Value('magx', 'number', 6, 'plain', 'Magnetic field along x, normalised to the calibration sphere.', minimum=-2.0, maximum=2.0, sign='forward'),
            Value('magy', 'number', 7, 'plain', 'Magnetic field along y, normalised to the calibration sphere.', minimum=-2.0, maximum=2.0, sign='right'),
            Value('magz', 'number', 8, 'plain', 'Magnetic field along z, normalised to the calibration sphere.', minimum=-2.0, maximum=2.0, sign='down'),
        ),
    ),
    Message(
        id=3, name='analog', doc='Analog sensors and air data. A value that the board does not measure is NaN: valid, shown as "no data".',
        source='header, capture; chapter, figure 33', extension=False, topic=True,
        struct=Struct("<ffffffffff"),
        values=(
            Value('baro_hpa', 'number', 0, 'plain', 'Static pressure.', unit='hPa', minimum=300.0, maximum=1100.0, absent=nan),
            Value('altitude_m', 'number', 1, 'plain', 'Barometric altitude above mean sea level.', unit='m', minimum=-500.0, maximum=20000.0, sign='up', absent=nan),
            Value('altitude_external_m', 'number', 2, 'plain', 'Altitude of the external sensor.', unit='m', minimum=-500.0, maximum=20000.0, sign='up', absent=nan),
            Value('pitot_pa', 'number', 3, 'plain', 'Differential pressure of the Pitot tube; noise makes it slightly negative at rest.', unit='Pa', minimum=-2000.0, maximum=20000.0, sign='total above static', absent=nan),
            Value('calibrated_airspeed_kt', 'number', 4, 'plain', 'Calibrated airspeed; sensor noise makes it slightly negative at rest.', unit='kt', minimum=-10.0, maximum=500.0, sign='forward', absent=nan),
            Value('alpha_deg', 'number', 5, 'plain', 'Angle of attack.', unit='deg', minimum=-180.0, maximum=180.0, sign='air from below', absent=nan),
            Value('beta_deg', 'number', 6, 'plain', 'Side-slip angle.', unit='deg', minimum=-180.0, maximum=180.0, sign='air from the right', absent=nan),
            Value('temperature_degc', 'number', 7, 'plain', 'Temperature at the board.', unit='degC', minimum=-60.0, maximum=125.0, sign='above freezing', absent=nan),
            Value('battery_v', 'number', 8, 'plain', 'Battery voltage.', unit='V', minimum=0.0, maximum=60.0, absent=nan),
            Value('vvi_ft_min', 'number', 9, 'plain', 'Vertical speed.', unit='ft/min', minimum=-20000.0, maximum=20000.0, sign='climb', absent=nan),
        ),
    ),
    Message(
        id=4, name='servos_in', doc='Channels of the RC receiver: 0 aileron, 1 elevator, 2 throttle, 3 rudder, the rest free.',
        source='header, capture; chapter, figure 34', extension=False, topic=True,
        struct=Struct("<ffffffffffff"),
        values=(
            Value('channel_0', 'number', 0, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_1', 'number', 1, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_2', 'number', 2, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_3', 'number', 3, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_4', 'number', 4, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_5', 'number', 5, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_6', 'number', 6, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_7', 'number', 7, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_8', 'number', 8, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_9', 'number', 9, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_10', 'number', 10, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
            Value('channel_11', 'number', 11, 'plain', 'Position of the channel; throttle is 0..1 of its useful half.', minimum=-1.0, maximum=1.0, sign='stick right, back, full power or right pedal'),
        ),
    ),
    Message(
        id=5, name='fly_by_wire', doc='The four controls as the fly-by-wire law puts them out. Mind the order: throttle is second.',
        source='header, capture; chapter, figure 35', extension=False, topic=True,
        struct=Struct("<ffff"),
        values=(
            Value('aileron', 'number', 0, 'plain', 'Aileron deflection.', minimum=-1.0, maximum=1.0, sign='right wing down'),
            Value('throttle', 'number', 1, 'plain', "Throttle; the deployed board's field is -1..+1, a throttle uses 0..1 of it.", minimum=-1.0, maximum=1.0, sign='more power'),
            Value('elevator', 'number', 2, 'plain', 'Elevator deflection.', minimum=-1.0, maximum=1.0, sign='nose up'),
            Value('rudder', 'number', 3, 'plain', 'Rudder deflection.', minimum=-1.0, maximum=1.0, sign='nose right'),
        ),
    ),
    Message(
        id=6, name='fms_plan', doc='What the flight management system of the real aircraft asks for. Without a plan all of it is absent, without a position bearing and distance are.',
        source='header, capture; chapter, figure 36', extension=False, topic=True,
        struct=Struct("<fffii"),
        values=(
            Value('bearing_deg', 'number', 0, 'plain', 'Great-circle bearing to the waypoint. Shown as 0..360.', unit='deg', minimum=-360.0, maximum=360.0, sign='clockwise from north, seen from above', absent=nan),
            Value('altitude_ft', 'number', 1, 'plain', 'Altitude asked for, above mean sea level.', unit='ft', minimum=-2000.0, maximum=60000.0, sign='up', absent=nan),
            Value('speed_kt', 'number', 2, 'plain', 'Indicated airspeed asked for.', unit='kt', minimum=0.0, maximum=500.0, sign='forward', absent=nan),
            Value('distance_m', 'integer', 3, 'plain', 'Great-circle distance to the waypoint; the limit is half way round the earth.', unit='m', minimum=0, maximum=20100000, absent=-1),
            Value('waypoint', 'integer', 4, 'plain', 'Index of the waypoint, from 0.', minimum=0, maximum=99, absent=-1),
        ),
    ),
    Message(
        id=7, name='fms_hil_plan', doc='What the flight management system of the HIL aircraft asks for; fields as fms_plan.',
        source='header, capture; chapter, figure 36', extension=False, topic=True,
        struct=Struct("<fffii"),
        values=(
            Value('bearing_deg', 'number', 0, 'plain', 'Great-circle bearing to the waypoint. Shown as 0..360.', unit='deg', minimum=-360.0, maximum=360.0, sign='clockwise from north, seen from above', absent=nan),
            Value('altitude_ft', 'number', 1, 'plain', 'Altitude asked for, above mean sea level.', unit='ft', minimum=-2000.0, maximum=60000.0, sign='up', absent=nan),
            Value('speed_kt', 'number', 2, 'plain', 'Indicated airspeed asked for.', unit='kt', minimum=0.0, maximum=500.0, sign='forward', absent=nan),
            Value('distance_m', 'integer', 3, 'plain', 'Great-circle distance to the waypoint; the limit is half way round the earth.', unit='m', minimum=0, maximum=20100000, absent=-1),
            Value('waypoint', 'integer', 4, 'plain', 'Index of the waypoint, from 0.', minimum=0, maximum=99, absent=-1),
        ),
    ),
    Message(
        id=8, name='statistics', doc="Load of the board's two processors.",
        source='header, capture; chapter, figure 37', extension=False, topic=True,
        struct=Struct("<hh"),
        values=(
            Value('sensor_dsc_percent', 'integer', 0, 'plain', 'CPU load of the sensor processor.', unit='%', minimum=0, maximum=100),
            Value('control_dsc_percent', 'integer', 1, 'plain', 'CPU load of the control processor.', unit='%', minimum=0, maximum=100),
        ),
    ),
    Message(
        id=9, name='gps', doc="Position of the GPS receiver. Single precision resolves 1-2 m: the board's limit.",
        source='header, capture; chapter, figure 38', extension=False, topic=True,
        struct=Struct("<fffffiii"),
        values=(
            Value('latitude_deg', 'number', 0, 'plain', 'Geodetic latitude, WGS84.', unit='deg', minimum=-90.0, maximum=90.0, sign='north'),
            Value('longitude_deg', 'number', 1, 'plain', 'Longitude, WGS84.', unit='deg', minimum=-180.0, maximum=180.0, sign='east'),
            Value('altitude_m', 'number', 2, 'plain', 'Altitude above mean sea level.', unit='m', minimum=-500.0, maximum=20000.0, sign='up'),
            Value('speed_kt', 'number', 3, 'plain', 'Ground speed.', unit='kt', minimum=0.0, maximum=500.0),
            Value('heading_deg', 'number', 4, 'plain', 'Ground track. Shown as 0..360.', unit='deg', minimum=-360.0, maximum=360.0, sign='clockwise from north, seen from above'),
            Value('satellites', 'integer', 5, 'ascii_digits', 'Satellites used: ASCII digits as received, units in the low byte, tens in the next (\'8\' is 0x38, "12" is 0x3132).', minimum=0, maximum=99),
            Value('fix', 'integer', 6, 'ascii_digits', "Kind of position fix: an ASCII digit, '0' for none.", minimum=0, maximum=9),
            Value('valid', 'boolean', 7, 'ascii_flag', "Receiver status: ASCII 'A' valid, 'V' void.", letters=('A', 'V')),
        ),
    ),
    Message(
        id=10, name='hil_surfaces', doc="What the board wants the simulator's surfaces to be.",
        source='header, capture', extension=False, topic=True,
        struct=Struct("<ffff"),
        values=(
            Value('elevator', 'number', 0, 'plain', 'Elevator deflection.', minimum=-1.0, maximum=1.0, sign='nose up'),
            Value('aileron', 'number', 1, 'plain', 'Aileron deflection.', minimum=-1.0, maximum=1.0, sign='right wing down'),
            Value('rudder', 'number', 2, 'plain', 'Rudder deflection.', minimum=-1.0, maximum=1.0, sign='nose right'),
            Value('throttle', 'number', 3, 'plain', 'Throttle.', minimum=0.0, maximum=1.0, sign='more power'),
        ),
    ),
    Message(
        id=11, name='autopilot_parameters', doc='The 17 gains, in answer to load_autopilot_parameters. One of them is an integer.',
        source='header, capture', extension=False, topic=True,
        struct=Struct("<ffffffiffffffffff"),
        values=(
            Value('k_int_altura', 'number', 0, 'plain', 'Integral gain of the altitude loop, per second, times k_altura.', minimum=0.0, maximum=99.99, default=0.06),
            Value('k_altura', 'number', 1, 'plain', 'Pitch asked for, deg, for each foot of altitude error.', minimum=0.0, maximum=99.99, default=0.06),
            Value('k_VVI', 'number', 2, 'plain', 'Altitude lead, ft, for each ft/min of vertical speed.', minimum=0.0, maximum=99.99, default=0.1),
            Value('k_pitch', 'number', 3, 'plain', 'Elevator command for each radian of pitch error.', minimum=0.0, maximum=99.99, default=2.0),
            Value('k_heading', 'number', 4, 'plain', 'Roll asked for, deg, for each degree of track error.', minimum=0.0, maximum=99.99, default=0.8),
            Value('k_roll', 'number', 5, 'plain', 'Aileron command for each radian of roll error.', minimum=0.0, maximum=99.99, default=2.0),
            Value('k_div_velocidad', 'integer', 6, 'plain', 'Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire.', minimum=10, maximum=10000, default=700),
            Value('k_div_P_init', 'number', 7, 'plain', 'Divider of the roll rate at rest.', minimum=0.1, maximum=99.99, default=0.5),
            Value('k_div_P_speed', 'number', 8, 'plain', 'Airspeed, kt, which adds 1 to the roll-rate divider.', minimum=10.0, maximum=99.99, default=30.0),
            Value('k_div_Q_init', 'number', 9, 'plain', 'Divider of the pitch rate at rest.', minimum=0.1, maximum=99.99, default=0.2),
            Value('k_div_Q_speed', 'number', 10, 'plain', 'Airspeed, kt, which adds 1 to the pitch-rate divider.', minimum=10.0, maximum=99.99, default=40.0),
            Value('k_div_R_init', 'number', 11, 'plain', 'Divider of the yaw rate at rest.', minimum=0.1, maximum=99.99, default=0.1),
            Value('k_div_R_speed', 'number', 12, 'plain', 'Airspeed, kt, which adds 1 to the yaw-rate divider.', minimum=10.0, maximum=99.99, default=35.0),
            Value('k_int_pitch', 'number', 13, 'plain', 'Autotrim: integral gain of the pitch-rate loop, per second.', minimum=0.0, maximum=99.99, default=0.6),
            Value('k_elev', 'number', 14, 'plain', 'Proportional gain of the pitch-rate loop.', minimum=0.0, maximum=99.99, default=1.0),
            Value('k_airln', 'number', 15, 'plain', 'Gain of the roll-rate loop.', minimum=0.0, maximum=99.99, default=0.6),
            Value('k_rudder', 'number', 16, 'plain', 'Gain of the yaw-rate loop.', minimum=0.0, maximum=99.99, default=1.0),
        ),
    ),
    Message(
        id=0x100, name='capabilities', doc='Answer to the command capabilities.',
        source='extension', extension=True, topic=False,
        struct=Struct("<ii16s16si"),
        values=(
            Value('protocol_version', 'integer', 0, 'plain', 'Version of the extensions; 1.', minimum=1, maximum=65535),
            Value('has_acknowledgements', 'boolean', 1, 'bit', 'Commands are acknowledged.', minimum=0, maximum=2147483647, bit=0),
            Value('has_store', 'boolean', 1, 'bit', "Parameters can be stored on the board's card.", minimum=0, maximum=2147483647, bit=1),
            Value('has_sources', 'boolean', 1, 'bit', 'Airspeed and altitude sources can be selected.', minimum=0, maximum=2147483647, bit=2),
            Value('has_missions', 'boolean', 1, 'bit', 'Missions can be written and read.', minimum=0, maximum=2147483647, bit=3),
            Value('has_card_alarm', 'boolean', 1, 'bit', 'What the card holds cannot be used, or could not be stored. When this changes the board sends capabilities again.', minimum=0, maximum=2147483647, bit=4),
            Value('has_hil_steps', 'boolean', 1, 'bit', 'The times of the steps of the HIL loop can be told (hil_steps_on).', minimum=0, maximum=2147483647, bit=5),
            Value('describes_itself', 'boolean', 1, 'bit', 'The board tells its own gains and topics: their names, units and ranges (describe), and their values (own_gain_get, own_gain_set).', minimum=0, maximum=2147483647, bit=6),
            Value('firmware_name', 'text', 2, 'text', 'Name of the firmware, zero padded.'),
            Value('firmware_version', 'text', 3, 'text', 'Version of the firmware, zero padded.'),
            Value('uptime_ms', 'integer', 4, 'plain', 'Time since the board started.', unit='ms', minimum=0, maximum=2147483647),
        ),
    ),
    Message(
        id=0x101, name='acknowledgement', doc='Result of a command; sent for every command but do_nothing and xplane_info once the station has asked for capabilities.',
        source='extension', extension=True, topic=False,
        struct=Struct("<ii"),
        values=(
            Value('command_type', 'integer', 0, 'plain', 'Type of the command which this answers.', minimum=-2147483648, maximum=2147483647),
            Value('result', 'integer', 1, 'plain', 'What became of it.', minimum=0, maximum=4, names=MappingProxyType({'done': 0, 'bad_value': 1, 'bad_state': 2, 'unknown': 3, 'storage_failed': 4})),
        ),
    ),
    Message(
        id=0x102, name='board_status', doc='State that the heartbeat has no room for; once a second.',
        source='extension', extension=True, topic=True,
        struct=Struct("<iiiiII"),
        values=(
            Value('airspeed_source', 'integer', 0, 'plain', 'Where the airspeed comes from.', minimum=0, maximum=1, names=MappingProxyType({'gps': 0, 'pitot': 1})),
            Value('altitude_source', 'integer', 1, 'plain', 'Where the altitude comes from.', minimum=0, maximum=1, names=MappingProxyType({'gps': 0, 'barometer': 1})),
            Value('servos_control_mode', 'integer', 2, 'plain', 'What drives the servo outputs.', minimum=0, maximum=1, names=MappingProxyType({'fly_by_wire': 0, 'hil': 1})),
            Value('hil_plan_name', 'integer', 3, 'plain', 'Which of the four routes the HIL plan is; none for an uploaded or absent plan.', minimum=-1, maximum=3, names=MappingProxyType({'none': -1, 'gando': 0, 'ruta_isla': 1, 'alternativa': 2, 'vuelo': 3})),
            Value('frames_received', 'integer', 4, 'plain', 'Good frames since the start of the board.', minimum=0, maximum=4294967295),
            Value('frames_rejected', 'integer', 5, 'plain', 'Refused frames since the start of the board.', minimum=0, maximum=4294967295),
        ),
    ),
    Message(
        id=0x103, name='mission_item', doc='One waypoint, in answer to mission_read, after mission_count.',
        source='extension', extension=True, topic=False,
        struct=Struct("<iiddff"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
            Value('index', 'integer', 1, 'plain', 'Place in the plan, from 0.', minimum=0, maximum=99),
            Value('latitude_deg', 'number', 2, 'plain', 'Geodetic latitude, WGS84.', unit='deg', minimum=-90.0, maximum=90.0, sign='north'),
            Value('longitude_deg', 'number', 3, 'plain', 'Longitude, WGS84.', unit='deg', minimum=-180.0, maximum=180.0, sign='east'),
            Value('altitude_ft', 'number', 4, 'plain', 'Altitude above mean sea level.', unit='ft', minimum=-2000.0, maximum=60000.0, sign='up'),
            Value('speed_kt', 'number', 5, 'plain', 'Indicated airspeed.', unit='kt', minimum=0.0, maximum=500.0, sign='forward'),
        ),
    ),
    Message(
        id=0x104, name='mission_count', doc='Number of waypoints that follow, in answer to mission_read.',
        source='extension', extension=True, topic=False,
        struct=Struct("<ii"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
            Value('count', 'integer', 1, 'plain', 'Waypoints of the plan; 0 for an empty one.', minimum=0, maximum=100),
        ),
    ),
    Message(
        id=0x105, name='hil_step', doc='When and by how much the HIL loop was stepped; after each hil_surfaces, from hil_steps_on until the line is opened again. With it a recording can be flown again to the last bit.',
        source='extension', extension=True, topic=False,
        struct=Struct("<If"),
        values=(
            Value('clock_ms', 'integer', 0, 'plain', "The board's clock when it took the command 50 which hil_surfaces answered.", unit='ms', minimum=0, maximum=4294967295),
            Value('step_s', 'number', 1, 'plain', 'Time that the laws integrated; 0 for a repeat, a refused command, and a step after a pause.', unit='s', minimum=0.0, maximum=1.0),
        ),
    ),
    Message(
        id=0x106, name='description', doc='What the board says about itself, in answer to describe. A station that has the table with this checksum asks for no block of it.',
        source='extension', extension=True, topic=False,
        struct=Struct("<iI"),
        values=(
            Value('table_size', 'integer', 0, 'plain', 'Bytes of the table of rows.', minimum=0, maximum=131072),
            Value('table_crc32', 'integer', 1, 'plain', 'CRC-32 (IEEE 802.3) of the table.', minimum=0, maximum=4294967295),
        ),
    ),
    Message(
        id=0x107, name='description_block', doc='128 bytes of the table of rows, in answer to describe_blocks. The table changes with the firmware alone.',
        source='extension', extension=True, topic=False,
        struct=Struct("<iIIIIIIIIIIIIIIIIIIIIIIIIIIIIIIII"),
        values=(
            Value('block', 'integer', 0, 'plain', 'Its number, from 0.', minimum=0, maximum=1023),
            Value('words_0', 'integer', 1, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_1', 'integer', 2, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_2', 'integer', 3, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_3', 'integer', 4, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_4', 'integer', 5, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_5', 'integer', 6, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_6', 'integer', 7, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_7', 'integer', 8, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_8', 'integer', 9, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_9', 'integer', 10, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_10', 'integer', 11, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_11', 'integer', 12, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_12', 'integer', 13, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_13', 'integer', 14, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_14', 'integer', 15, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_15', 'integer', 16, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_16', 'integer', 17, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_17', 'integer', 18, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_18', 'integer', 19, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_19', 'integer', 20, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_20', 'integer', 21, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_21', 'integer', 22, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_22', 'integer', 23, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_23', 'integer', 24, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_24', 'integer', 25, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_25', 'integer', 26, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_26', 'integer', 27, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_27', 'integer', 28, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_28', 'integer', 29, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_29', 'integer', 30, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_30', 'integer', 31, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
            Value('words_31', 'integer', 32, 'plain', "The table's bytes in their order; zeros behind its end.", minimum=0, maximum=4294967295),
        ),
    ),
    Message(
        id=0x108, name='own_gain', doc="The value that one of the board's own gains has, in answer to own_gain_get and own_gain_set, after a refused one too.",
        source='extension', extension=True, topic=False,
        struct=Struct("<if"),
        values=(
            Value('row', 'integer', 0, 'plain', "The gain's row in the description.", minimum=0, maximum=65535),
            Value('value', 'number', 1, 'plain', "In the row's unit; of an enum, the place of its text, from 0.", minimum=-1e+30, maximum=1e+30, sign='as the row says'),
        ),
    ),
)
TELEMETRY: Final[Mapping[int, Message]] = MappingProxyType({m.id: m for m in _MESSAGES})
TELEMETRY_BY_NAME: Final[Mapping[str, Message]] = MappingProxyType({m.name: m for m in _MESSAGES})

_COMMANDS: Final = (
    Message(
        id=0, name='do_nothing', doc='Nothing; never acknowledged.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=1, name='stop', doc='All streams off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'ahrs': False, 'inertial': False, 'analog': False, 'statistics': False, 'gps': False, 'servos': False, 'fly_by_wire': False})),
    ),
    Message(
        id=2, name='start', doc='All streams on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'ahrs': True, 'inertial': True, 'analog': True, 'statistics': True, 'gps': True, 'servos': True, 'fly_by_wire': True})),
    ),
    Message(
        id=3, name='read_all', doc='Send every stream once.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=4, name='reset', doc='Reset the autopilot.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=5, name='ahrs_on', doc='Stream ahrs on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'ahrs': True})),
    ),
    Message(
        id=6, name='ahrs_off', doc='Stream ahrs off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'ahrs': False})),
    ),
    Message(
        id=7, name='inertial_on', doc='Stream inertial on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'inertial': True})),
    ),
    Message(
        id=21, name='inertial_off', doc='Stream inertial off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'inertial': False})),
    ),
    Message(
        id=22, name='analog_on', doc='Stream analog on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'analog': True})),
    ),
    Message(
        id=23, name='analog_off', doc='Stream analog off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'analog': False})),
    ),
    Message(
        id=24, name='statistics_on', doc='Stream statistics on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'statistics': True})),
    ),
    Message(
        id=25, name='statistics_off', doc='Stream statistics off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'statistics': False})),
    ),
    Message(
        id=26, name='gps_on', doc='Stream gps on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'gps': True})),
    ),
    Message(
        id=27, name='gps_off', doc='Stream gps off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'gps': False})),
    ),
    Message(
        id=28, name='servos_in_on', doc='Stream servos_in on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'servos': True})),
    ),
    Message(
        id=29, name='servos_in_off', doc='Stream servos_in off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'servos': False})),
    ),
    Message(
        id=30, name='fly_by_wire_on', doc='Stream fly_by_wire on.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'fly_by_wire': True})),
    ),
    Message(
        id=31, name='fly_by_wire_off', doc='Stream fly_by_wire off.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'fly_by_wire': False})),
    ),
    Message(
        id=33, name='fms_plan_on', doc='Stream fms_plan on. The heartbeat has no flag for it.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('frame', message='fms_plan'),
    ),
    Message(
        id=34, name='fms_plan_off', doc='Stream fms_plan off. The heartbeat has no flag for it.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=35, name='fms_hil_plan_on', doc='Stream fms_hil_plan on. The heartbeat has no flag for it.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('frame', message='fms_hil_plan'),
    ),
    Message(
        id=36, name='fms_hil_plan_off', doc='Stream fms_hil_plan off. The heartbeat has no flag for it.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=37, name='autopilot_on', doc="HIL autopilot on; with RC as the control source the transmitter's switch rules instead.",
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'autopilot_hil': True})),
    ),
    Message(
        id=38, name='autopilot_off', doc="HIL autopilot off; with RC as the control source the transmitter's switch rules instead.",
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'autopilot_hil': False})),
    ),
    Message(
        id=39, name='autotrim_on', doc="HIL elevator autotrim on; with RC as the control source the transmitter's switch rules instead.",
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'autotrim_hil': True})),
    ),
    Message(
        id=40, name='autotrim_off', doc="HIL elevator autotrim off; with RC as the control source the transmitter's switch rules instead.",
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'autotrim_hil': False})),
    ),
    Message(
        id=41, name='fms_next_waypoint', doc='The real plan goes to its next waypoint.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_plan', move='next'),
    ),
    Message(
        id=42, name='fms_previous_waypoint', doc='The real plan goes to its previous waypoint.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_plan', move='previous'),
    ),
    Message(
        id=43, name='hil_fms_next_waypoint', doc='The HIL plan goes to its next waypoint.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_hil_plan', move='next'),
    ),
    Message(
        id=45, name='hil_fms_previous_waypoint', doc='The HIL plan goes to its previous waypoint.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_hil_plan', move='previous'),
    ),
    Message(
        id=46, name='set_parameter_task_rate', doc='Period of the task that sends heartbeat, ahrs, inertial and analog.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<i"),
        values=(
            Value('period_ms', 'integer', 0, 'plain', 'Time between two runs of the task.', unit='ms', minimum=20, maximum=10000, default=100),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=47, name='set_fms_task_rate', doc='Period of the task that sends fms_plan, fms_hil_plan, statistics and gps.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<i"),
        values=(
            Value('period_ms', 'integer', 0, 'plain', 'Time between two runs of the task.', unit='ms', minimum=50, maximum=10000, default=100),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=48, name='set_servos_task_rate', doc='Period of the task that sends servos_in and fly_by_wire.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<i"),
        values=(
            Value('period_ms', 'integer', 0, 'plain', 'Time between two runs of the task.', unit='ms', minimum=20, maximum=10000, default=20),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=49, name='exit_binary_mode', doc='Back to text mode; nothing more is sent.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=50, name='xplane_info', doc="The simulator's state for the HIL loop; answered by hil_surfaces, never acknowledged.",
        source='header, capture; chapter, figure 28', extension=False, topic=True,
        struct=Struct("<fffffffffffffff"),
        values=(
            Value('elevator', 'number', 0, 'plain', "The pilot's stick.", minimum=-1.0, maximum=1.0, sign='nose up'),
            Value('aileron', 'number', 1, 'plain', "The pilot's stick.", minimum=-1.0, maximum=1.0, sign='right wing down'),
            Value('rudder', 'number', 2, 'plain', "The pilot's pedals.", minimum=-1.0, maximum=1.0, sign='nose right'),
            Value('throttle', 'number', 3, 'plain', "The pilot's throttle.", minimum=0.0, maximum=1.0, sign='more power'),
            Value('gx_rad_s', 'number', 4, 'plain', 'Roll rate P, body axes.', unit='rad/s', minimum=-40.0, maximum=40.0, sign='right wing going down'),
            Value('gy_rad_s', 'number', 5, 'plain', 'Pitch rate Q, body axes.', unit='rad/s', minimum=-40.0, maximum=40.0, sign='nose going up'),
            Value('gz_rad_s', 'number', 6, 'plain', 'Yaw rate R, body axes.', unit='rad/s', minimum=-40.0, maximum=40.0, sign='nose going right'),
            Value('yaw_deg', 'number', 7, 'plain', 'Ground track where the simulator gives it, else true heading.', unit='deg', minimum=-360.0, maximum=360.0, sign='clockwise from north, seen from above'),
            Value('pitch_deg', 'number', 8, 'plain', 'Pitch angle.', unit='deg', minimum=-90.0, maximum=90.0, sign='nose up'),
            Value('roll_deg', 'number', 9, 'plain', 'Roll angle.', unit='deg', minimum=-180.0, maximum=180.0, sign='right wing down'),
            Value('altitude_ft', 'number', 10, 'plain', 'Indicated altitude.', unit='ft', minimum=-2000.0, maximum=100000.0, sign='up'),
            Value('vvi_ft_min', 'number', 11, 'plain', 'Vertical speed.', unit='ft/min', minimum=-50000.0, maximum=50000.0, sign='climb'),
            Value('speed_kt', 'number', 12, 'plain', 'Indicated airspeed.', unit='kt', minimum=-100.0, maximum=1500.0, sign='forward'),
            Value('latitude_deg', 'number', 13, 'plain', 'Geodetic latitude.', unit='deg', minimum=-90.0, maximum=90.0, sign='north'),
            Value('longitude_deg', 'number', 14, 'plain', 'Longitude.', unit='deg', minimum=-180.0, maximum=180.0, sign='east'),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=51, name='hil_load_gando', doc='The HIL plan becomes the route Gando.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_hil_plan', move='first'),
    ),
    Message(
        id=52, name='hil_load_ruta_isla', doc='The HIL plan becomes the route Ruta Isla.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_hil_plan', move='first'),
    ),
    Message(
        id=53, name='hil_load_alternativa', doc='The HIL plan becomes the route Alternativa.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_hil_plan', move='first'),
    ),
    Message(
        id=54, name='hil_load_vuelo', doc='The HIL plan becomes the route Vuelo.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('plan', message='fms_hil_plan', move='first'),
    ),
    Message(
        id=55, name='control_source', doc='Where stick, autopilot and autotrim come from.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<i"),
        values=(
            Value('source', 'integer', 0, 'plain', 'Control source.', minimum=0, maximum=1, names=MappingProxyType({'rc': 0, 'joystick': 1})),
        ),
        confirm=Confirm('heartbeat', flags=MappingProxyType({'source_joystick': 'argument'})),
    ),
    Message(
        id=56, name='servos_control_mode_fly_by_wire', doc='The servo outputs follow the fly-by-wire law of the real aircraft.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=57, name='servos_control_mode_hil', doc='The servo outputs follow the HIL loop.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=58, name='servo_out', doc='Move one servo output.',
        source='header, capture; chapter, figure 29', extension=False, topic=False,
        struct=Struct("<if"),
        values=(
            Value('servo', 'integer', 0, 'plain', 'Which output.', minimum=0, maximum=19),
            Value('position', 'number', 1, 'plain', 'Where to.', minimum=-1.0, maximum=1.0, sign="up; the old station's slider number had the opposite sign"),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=59, name='load_autopilot_parameters', doc='Ask for the 17 parameters; answered by autopilot_parameters.',
        source='header, capture; chapter, table 2', extension=False, topic=False,
        struct=Struct("<"),
        confirm=Confirm('frame', message='autopilot_parameters'),
    ),
    Message(
        id=60, name='set_k_elev', doc='Set the parameter k_elev.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Proportional gain of the pitch-rate loop.', minimum=0.0, maximum=99.99, default=1.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_elev',
    ),
    Message(
        id=61, name='set_k_airln', doc='Set the parameter k_airln.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Gain of the roll-rate loop.', minimum=0.0, maximum=99.99, default=0.6),
        ),
        confirm=Confirm('read_back'),
        parameter='k_airln',
    ),
    Message(
        id=62, name='set_k_rudder', doc='Set the parameter k_rudder.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Gain of the yaw-rate loop.', minimum=0.0, maximum=99.99, default=1.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_rudder',
    ),
    Message(
        id=63, name='set_k_int_pitch', doc='Set the parameter k_int_pitch.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Autotrim: integral gain of the pitch-rate loop, per second.', minimum=0.0, maximum=99.99, default=0.6),
        ),
        confirm=Confirm('read_back'),
        parameter='k_int_pitch',
    ),
    Message(
        id=64, name='set_k_div_P_init', doc='Set the parameter k_div_P_init.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Divider of the roll rate at rest.', minimum=0.1, maximum=99.99, default=0.5),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_P_init',
    ),
    Message(
        id=65, name='set_k_div_P_speed', doc='Set the parameter k_div_P_speed.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Airspeed, kt, which adds 1 to the roll-rate divider.', minimum=10.0, maximum=99.99, default=30.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_P_speed',
    ),
    Message(
        id=66, name='set_k_div_Q_init', doc='Set the parameter k_div_Q_init.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Divider of the pitch rate at rest.', minimum=0.1, maximum=99.99, default=0.2),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_Q_init',
    ),
    Message(
        id=67, name='set_k_div_Q_speed', doc='Set the parameter k_div_Q_speed.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Airspeed, kt, which adds 1 to the pitch-rate divider.', minimum=10.0, maximum=99.99, default=40.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_Q_speed',
    ),
    Message(
        id=68, name='set_k_div_R_init', doc='Set the parameter k_div_R_init.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Divider of the yaw rate at rest.', minimum=0.1, maximum=99.99, default=0.1),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_R_init',
    ),
    Message(
        id=69, name='set_k_div_R_speed', doc='Set the parameter k_div_R_speed.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Airspeed, kt, which adds 1 to the yaw-rate divider.', minimum=10.0, maximum=99.99, default=35.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_R_speed',
    ),
    Message(
        id=70, name='set_k_div_velocidad', doc='Set the parameter k_div_velocidad.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<i"),
        values=(
            Value('value', 'integer', 0, 'plain', 'Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire.', minimum=10, maximum=10000, default=700),
        ),
        confirm=Confirm('read_back'),
        parameter='k_div_velocidad',
    ),
    Message(
        id=71, name='set_k_roll', doc='Set the parameter k_roll.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Aileron command for each radian of roll error.', minimum=0.0, maximum=99.99, default=2.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_roll',
    ),
    Message(
        id=72, name='set_k_heading', doc='Set the parameter k_heading.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Roll asked for, deg, for each degree of track error.', minimum=0.0, maximum=99.99, default=0.8),
        ),
        confirm=Confirm('read_back'),
        parameter='k_heading',
    ),
    Message(
        id=73, name='set_k_pitch', doc='Set the parameter k_pitch.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Elevator command for each radian of pitch error.', minimum=0.0, maximum=99.99, default=2.0),
        ),
        confirm=Confirm('read_back'),
        parameter='k_pitch',
    ),
    Message(
        id=74, name='set_k_VVI', doc='Set the parameter k_VVI.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Altitude lead, ft, for each ft/min of vertical speed.', minimum=0.0, maximum=99.99, default=0.1),
        ),
        confirm=Confirm('read_back'),
        parameter='k_VVI',
    ),
    Message(
        id=75, name='set_k_altura', doc='Set the parameter k_altura.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Pitch asked for, deg, for each foot of altitude error.', minimum=0.0, maximum=99.99, default=0.06),
        ),
        confirm=Confirm('read_back'),
        parameter='k_altura',
    ),
    Message(
        id=76, name='set_k_int_altura', doc='Set the parameter k_int_altura.',
        source='header, capture', extension=False, topic=False,
        struct=Struct("<f"),
        values=(
            Value('value', 'number', 0, 'plain', 'Integral gain of the altitude loop, per second, times k_altura.', minimum=0.0, maximum=99.99, default=0.06),
        ),
        confirm=Confirm('read_back'),
        parameter='k_int_altura',
    ),
    Message(
        id=0x100, name='capabilities', doc='Ask what the board can do. No answer in 500 ms means a deployed board: legacy mode.',
        source='extension', extension=True, topic=False,
        struct=Struct("<"),
        confirm=Confirm('frame', message='capabilities'),
    ),
    Message(
        id=0x101, name='store_parameters', doc="Store the parameters on the board's card, whole or not at all.",
        source='extension', extension=True, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x102, name='select_airspeed_source', doc='Where the airspeed comes from.',
        source='extension', extension=True, topic=False,
        struct=Struct("<i"),
        values=(
            Value('source', 'integer', 0, 'plain', 'Airspeed source.', minimum=0, maximum=1, names=MappingProxyType({'gps': 0, 'pitot': 1})),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x103, name='select_altitude_source', doc='Where the altitude comes from.',
        source='extension', extension=True, topic=False,
        struct=Struct("<i"),
        values=(
            Value('source', 'integer', 0, 'plain', 'Altitude source.', minimum=0, maximum=1, names=MappingProxyType({'gps': 0, 'barometer': 1})),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x104, name='mission_begin', doc='Start to write a plan; the plan in use stays until mission_commit.',
        source='extension', extension=True, topic=False,
        struct=Struct("<ii"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
            Value('count', 'integer', 1, 'plain', 'Waypoints that will follow.', minimum=1, maximum=100),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x105, name='mission_item', doc='One waypoint of the plan being written.',
        source='extension', extension=True, topic=False,
        struct=Struct("<iiddff"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
            Value('index', 'integer', 1, 'plain', 'Place in the plan, from 0.', minimum=0, maximum=99),
            Value('latitude_deg', 'number', 2, 'plain', 'Geodetic latitude, WGS84.', unit='deg', minimum=-90.0, maximum=90.0, sign='north'),
            Value('longitude_deg', 'number', 3, 'plain', 'Longitude, WGS84.', unit='deg', minimum=-180.0, maximum=180.0, sign='east'),
            Value('altitude_ft', 'number', 4, 'plain', 'Altitude above mean sea level.', unit='ft', minimum=-2000.0, maximum=60000.0, sign='up'),
            Value('speed_kt', 'number', 5, 'plain', 'Indicated airspeed.', unit='kt', minimum=0.0, maximum=500.0, sign='forward'),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x106, name='mission_commit', doc='The written plan replaces the one in use, whole or not at all; a board with a card keeps it there afterwards.',
        source='extension', extension=True, topic=False,
        struct=Struct("<i"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x107, name='mission_read', doc='Ask for a plan; answered by mission_count and its mission_items.',
        source='extension', extension=True, topic=False,
        struct=Struct("<i"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
        ),
        confirm=Confirm('frame', message='mission_count'),
    ),
    Message(
        id=0x108, name='go_to_waypoint', doc='The plan goes to this waypoint.',
        source='extension', extension=True, topic=False,
        struct=Struct("<ii"),
        values=(
            Value('plan', 'integer', 0, 'plain', 'Which plan.', minimum=0, maximum=1, names=MappingProxyType({'flight': 0, 'hil': 1})),
            Value('index', 'integer', 1, 'plain', 'Which waypoint, from 0.', minimum=0, maximum=99),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x109, name='hil_steps_on', doc='Send hil_step after each hil_surfaces, until the line is opened again.',
        source='extension', extension=True, topic=False,
        struct=Struct("<"),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x10A, name='describe', doc='Ask what the board says about itself; answered by description.',
        source='extension', extension=True, topic=False,
        struct=Struct("<"),
        confirm=Confirm('frame', message='description'),
    ),
    Message(
        id=0x10B, name='describe_blocks', doc="Ask for blocks of the description's table; each is answered by description_block. Blocks that lie behind its end are a bad value.",
        source='extension', extension=True, topic=False,
        struct=Struct("<ii"),
        values=(
            Value('first', 'integer', 0, 'plain', 'Which block first, from 0.', minimum=0, maximum=1023),
            Value('count', 'integer', 1, 'plain', 'How many.', minimum=1, maximum=8),
        ),
        confirm=Confirm('frame', message='description_block'),
    ),
    Message(
        id=0x10C, name='own_gain_get', doc="Ask for the value of one of the board's own gains; answered by own_gain. A row that is no gain is a bad value.",
        source='extension', extension=True, topic=False,
        struct=Struct("<i"),
        values=(
            Value('row', 'integer', 0, 'plain', "The gain's row in the description.", minimum=0, maximum=65535),
        ),
        confirm=Confirm('frame', message='own_gain'),
    ),
    Message(
        id=0x10D, name='own_gain_set', doc="Set one of the board's own gains; answered by own_gain with the value that the board has now, then by the acknowledgement. A value that is out of range, not finite or, in an enum, not whole is a bad value and changes nothing.",
        source='extension', extension=True, topic=False,
        struct=Struct("<if"),
        values=(
            Value('row', 'integer', 0, 'plain', "The gain's row in the description.", minimum=0, maximum=65535),
            Value('value', 'number', 1, 'plain', "In the row's unit; of an enum, the place of its text, from 0.", minimum=-1e+30, maximum=1e+30, sign='as the row says'),
        ),
        confirm=Confirm('none'),
    ),
    Message(
        id=0x10E, name='own_topics', doc="Send the board's own topics, each at the period that its row says, until they are switched off or the line is opened again.",
        source='extension', extension=True, topic=False,
        struct=Struct("<i"),
        values=(
            Value('on', 'integer', 0, 'plain', 'Whether they are sent.', minimum=0, maximum=1, names=MappingProxyType({'off': 0, 'on': 1})),
        ),
        confirm=Confirm('none'),
    ),
)
COMMANDS: Final[Mapping[str, Message]] = MappingProxyType({c.name: c for c in _COMMANDS})
COMMANDS_BY_ID: Final[Mapping[int, Message]] = MappingProxyType({c.id: c for c in _COMMANDS})

PARAMETERS: Final[tuple[Parameter, ...]] = (
    Parameter('k_int_altura', 'altitude', 76, False, 0.0, 99.99, 0.001, 0.06, 'Integral gain of the altitude loop, per second, times k_altura.'),
    Parameter('k_altura', 'altitude', 75, False, 0.0, 99.99, 0.001, 0.06, 'Pitch asked for, deg, for each foot of altitude error.'),
    Parameter('k_VVI', 'altitude', 74, False, 0.0, 99.99, 0.01, 0.1, 'Altitude lead, ft, for each ft/min of vertical speed.'),
    Parameter('k_pitch', 'altitude', 73, False, 0.0, 99.99, 0.1, 2.0, 'Elevator command for each radian of pitch error.'),
    Parameter('k_heading', 'heading', 72, False, 0.0, 99.99, 0.01, 0.8, 'Roll asked for, deg, for each degree of track error.'),
    Parameter('k_roll', 'heading', 71, False, 0.0, 99.99, 0.1, 2.0, 'Aileron command for each radian of roll error.'),
    Parameter('k_div_velocidad', 'speed', 70, True, 10, 10000, 10, 700, 'Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire.'),
    Parameter('k_div_P_init', 'heading', 64, False, 0.1, 99.99, 0.01, 0.5, 'Divider of the roll rate at rest.'),
    Parameter('k_div_P_speed', 'heading', 65, False, 10.0, 99.99, 1.0, 30.0, 'Airspeed, kt, which adds 1 to the roll-rate divider.'),
    Parameter('k_div_Q_init', 'altitude', 66, False, 0.1, 99.99, 0.1, 0.2, 'Divider of the pitch rate at rest.'),
    Parameter('k_div_Q_speed', 'altitude', 67, False, 10.0, 99.99, 1.0, 40.0, 'Airspeed, kt, which adds 1 to the pitch-rate divider.'),
    Parameter('k_div_R_init', 'rudder', 68, False, 0.1, 99.99, 0.01, 0.1, 'Divider of the yaw rate at rest.'),
    Parameter('k_div_R_speed', 'rudder', 69, False, 10.0, 99.99, 1.0, 35.0, 'Airspeed, kt, which adds 1 to the yaw-rate divider.'),
    Parameter('k_int_pitch', 'altitude', 63, False, 0.0, 99.99, 0.01, 0.6, 'Autotrim: integral gain of the pitch-rate loop, per second.'),
    Parameter('k_elev', 'altitude', 60, False, 0.0, 99.99, 0.1, 1.0, 'Proportional gain of the pitch-rate loop.'),
    Parameter('k_airln', 'heading', 61, False, 0.0, 99.99, 0.01, 0.6, 'Gain of the roll-rate loop.'),
    Parameter('k_rudder', 'rudder', 62, False, 0.0, 99.99, 0.1, 1.0, 'Gain of the yaw-rate loop.'),
)

_ROWS_XP10: Final = (
    Row(3, 'speeds', 'Speeds.', False, (
        RowValue(0, 'indicated_airspeed_kt', 'kt', -100.0, 1500.0, 'forward', 'Indicated airspeed.'),
        RowValue(3, 'ground_speed_kt', 'kt', -100.0, 5000.0, 'forward', "Speed over ground. Only the simulator's pace is judged by it: it may be absent."),
    )),
    Row(4, 'mach_vvi_g', 'Mach number, vertical speed and load factors.', False, (
        RowValue(0, 'mach', '1', -1.0, 10.0, 'forward', 'Mach number.'),
        RowValue(2, 'vvi_ft_min', 'ft/min', -50000.0, 50000.0, 'climb', 'Vertical speed.'),
        RowValue(4, 'g_normal', '1', -100.0, 100.0, 'up; level flight gives 1', 'Normal load factor.'),
        RowValue(5, 'g_axial', '1', -100.0, 100.0, 'forward', 'Axial load factor.'),
        RowValue(6, 'g_side', '1', -100.0, 100.0, 'right', 'Side load factor.'),
    )),
    Row(6, 'atmosphere', 'Ambient air; shown only.', False, (
        RowValue(0, 'ambient_pressure_inhg', 'inHg', 0.0, 40.0, 'none', 'Ambient pressure.'),
        RowValue(1, 'ambient_temperature_degc', 'degC', -120.0, 80.0, 'above freezing', 'Ambient temperature.'),
    )),
    Row(8, 'joystick', "The pilot's stick.", False, (
        RowValue(0, 'stick_elevator', '1', -1.0, 1.0, 'nose up', 'Stick, fore and aft.'),
        RowValue(1, 'stick_aileron', '1', -1.0, 1.0, 'right wing down', 'Stick, sideways.'),
        RowValue(2, 'stick_rudder', '1', -1.0, 1.0, 'nose right', 'Pedals.'),
    )),
    Row(11, 'flight_controls', 'Surfaces: shown when received; sent to move them, the other five values -999.', True, (
        RowValue(0, 'surface_elevator', '1', -1.0, 1.0, 'nose up', 'Elevator.'),
        RowValue(1, 'surface_aileron', '1', -1.0, 1.0, 'right wing down', 'Aileron.'),
        RowValue(2, 'surface_rudder', '1', -1.0, 1.0, 'nose right', 'Rudder.'),
    )),
    Row(16, 'angular_velocities', 'Rotation in body axes. The order and the unit differ between the profiles.', False, (
        RowValue(0, 'q_rad_s', 'rad/s', -40.0, 40.0, 'nose going up', 'Pitch rate Q.'),
        RowValue(1, 'p_rad_s', 'rad/s', -40.0, 40.0, 'right wing going down', 'Roll rate P.'),
        RowValue(2, 'r_rad_s', 'rad/s', -40.0, 40.0, 'nose going right', 'Yaw rate R.'),
    )),
    Row(17, 'attitude', 'Attitude of the airframe.', False, (
        RowValue(0, 'pitch_deg', 'deg', -90.0, 90.0, 'nose up', 'Pitch angle.'),
        RowValue(1, 'roll_deg', 'deg', -180.0, 180.0, 'right wing down', 'Roll angle.'),
        RowValue(2, 'true_heading_deg', 'deg', -360.0, 360.0, 'clockwise from north, seen from above', 'True heading.'),
    )),
    Row(18, 'alpha_beta_paths', "Angles of the air and of the path. Its ground track wins over row 17's heading for yaw.", False, (
        RowValue(0, 'alpha_deg', 'deg', -180.0, 180.0, 'air from below', 'Angle of attack.'),
        RowValue(1, 'beta_deg', 'deg', -180.0, 180.0, 'air from the right', 'Side-slip angle.'),
        RowValue(2, 'horizontal_path_deg', 'deg', -360.0, 360.0, 'clockwise from north, seen from above', 'Ground track.'),
        RowValue(3, 'vertical_path_deg', 'deg', -90.0, 90.0, 'climb', 'Vertical path angle.'),
    )),
    Row(20, 'position', 'Position and altitudes.', False, (
        RowValue(0, 'latitude_deg', 'deg', -90.0, 90.0, 'north', 'Geodetic latitude.'),
        RowValue(1, 'longitude_deg', 'deg', -180.0, 180.0, 'east', 'Longitude.'),
        RowValue(2, 'altitude_msl_ft', 'ft', -2000.0, 400000.0, 'up', 'True altitude above mean sea level.'),
        RowValue(5, 'altitude_indicated_ft', 'ft', -2000.0, 100000.0, 'up', 'Indicated altitude.'),
    )),
    Row(25, 'throttle', 'Throttle command: the first engine is used when received; sent as eight times the one throttle.', True, (
        RowValue(0, 'throttle_command', '1', 0.0, 1.0, 'more power', 'Throttle command.'),
    )),
)
_ROWS_XP12: Final = (
    Row(3, 'speeds', 'Speeds.', False, (
        RowValue(0, 'indicated_airspeed_kt', 'kt', -100.0, 1500.0, 'forward', 'Indicated airspeed.'),
        RowValue(3, 'ground_speed_kt', 'kt', -100.0, 5000.0, 'forward', "Speed over ground. Only the simulator's pace is judged by it: it may be absent."),
    )),
    Row(4, 'mach_vvi_g', 'Mach number, vertical speed and load factors.', False, (
        RowValue(0, 'mach', '1', -1.0, 10.0, 'forward', 'Mach number.'),
        RowValue(2, 'vvi_ft_min', 'ft/min', -50000.0, 50000.0, 'climb', 'Vertical speed.'),
        RowValue(4, 'g_normal', '1', -100.0, 100.0, 'up; level flight gives 1', 'Normal load factor.'),
        RowValue(5, 'g_axial', '1', -100.0, 100.0, 'forward', 'Axial load factor.'),
        RowValue(6, 'g_side', '1', -100.0, 100.0, 'right', 'Side load factor.'),
    )),
    Row(6, 'atmosphere', 'Ambient air; shown only.', False, (
        RowValue(0, 'ambient_pressure_inhg', 'inHg', 0.0, 40.0, 'none', 'Ambient pressure.'),
        RowValue(1, 'ambient_temperature_degc', 'degC', -120.0, 80.0, 'above freezing', 'Ambient temperature.'),
    )),
    Row(8, 'joystick', "The pilot's stick.", False, (
        RowValue(0, 'stick_elevator', '1', -1.0, 1.0, 'nose up', 'Stick, fore and aft.'),
        RowValue(1, 'stick_aileron', '1', -1.0, 1.0, 'right wing down', 'Stick, sideways.'),
        RowValue(2, 'stick_rudder', '1', -1.0, 1.0, 'nose right', 'Pedals.'),
    )),
    Row(11, 'flight_controls', 'Surfaces: shown when received; sent to move them, the other five values -999.', True, (
        RowValue(0, 'surface_elevator', '1', -1.0, 1.0, 'nose up', 'Elevator.'),
        RowValue(1, 'surface_aileron', '1', -1.0, 1.0, 'right wing down', 'Aileron.'),
        RowValue(2, 'surface_rudder', '1', -1.0, 1.0, 'nose right', 'Rudder.'),
    )),
    Row(16, 'angular_velocities', 'Rotation in body axes. The order and the unit differ between the profiles.', False, (
        RowValue(0, 'p_deg_s', 'deg/s', -2300.0, 2300.0, 'right wing going down', 'Roll rate P.'),
        RowValue(1, 'q_deg_s', 'deg/s', -2300.0, 2300.0, 'nose going up', 'Pitch rate Q.'),
        RowValue(2, 'r_deg_s', 'deg/s', -2300.0, 2300.0, 'nose going right', 'Yaw rate R.'),
    )),
    Row(17, 'attitude', 'Attitude of the airframe.', False, (
        RowValue(0, 'pitch_deg', 'deg', -90.0, 90.0, 'nose up', 'Pitch angle.'),
        RowValue(1, 'roll_deg', 'deg', -180.0, 180.0, 'right wing down', 'Roll angle.'),
        RowValue(2, 'true_heading_deg', 'deg', -360.0, 360.0, 'clockwise from north, seen from above', 'True heading.'),
    )),
    Row(18, 'alpha_beta_paths', "Angles of the air and of the path. Its ground track wins over row 17's heading for yaw.", False, (
        RowValue(0, 'alpha_deg', 'deg', -180.0, 180.0, 'air from below', 'Angle of attack.'),
        RowValue(1, 'beta_deg', 'deg', -180.0, 180.0, 'air from the right', 'Side-slip angle.'),
        RowValue(2, 'horizontal_path_deg', 'deg', -360.0, 360.0, 'clockwise from north, seen from above', 'Ground track.'),
        RowValue(3, 'vertical_path_deg', 'deg', -90.0, 90.0, 'climb', 'Vertical path angle.'),
    )),
    Row(20, 'position', 'Position and altitudes.', False, (
        RowValue(0, 'latitude_deg', 'deg', -90.0, 90.0, 'north', 'Geodetic latitude.'),
        RowValue(1, 'longitude_deg', 'deg', -180.0, 180.0, 'east', 'Longitude.'),
        RowValue(2, 'altitude_msl_ft', 'ft', -2000.0, 400000.0, 'up', 'True altitude above mean sea level.'),
        RowValue(5, 'altitude_indicated_ft', 'ft', -2000.0, 100000.0, 'up', 'Indicated altitude.'),
    )),
    Row(25, 'throttle', 'Throttle command: the first engine is used when received; sent as eight times the one throttle.', True, (
        RowValue(0, 'throttle_command', '1', 0.0, 1.0, 'more power', 'Throttle command.'),
    )),
)
XPLANE_ROWS: Final[Mapping[str, Mapping[int, Row]]] = MappingProxyType(
    {"xp10": MappingProxyType({r.id: r for r in _ROWS_XP10}), "xp12": MappingProxyType({r.id: r for r in _ROWS_XP12})}
)

ROUTES: Final[Mapping[str, Route]] = MappingProxyType(
    {
        'gando': Route('gando', 'Gando', 0, 51, True, 'Circuit of Gran Canaria airport, from climb-out to final.', (
            Waypoint(27.9515, -15.3741, 700.0, 55.0),
            Waypoint(27.9503, -15.3573, 1000.0, 55.0),
            Waypoint(27.9239, -15.3707, 1000.0, 60.0),
            Waypoint(27.9004, -15.3857, 1000.0, 60.0),
            Waypoint(27.895, -15.3997, 800.0, 50.0),
            Waypoint(27.9045, -15.4041, 600.0, 48.0),
            Waypoint(27.9202, -15.3941, 350.0, 45.0),
            Waypoint(27.9319, -15.3866, 250.0, 50.0),
        )),
        'ruta_isla': Route('ruta_isla', 'Ruta Isla', 1, 52, False, 'Round the island of Gran Canaria.', (
            Waypoint(27.99, -15.34, 1000.0, 60.0),
            Waypoint(28.06, -15.39, 1200.0, 60.0),
            Waypoint(28.13, -15.38, 1500.0, 60.0),
            Waypoint(28.2, -15.41, 1500.0, 60.0),
            Waypoint(28.17, -15.47, 1500.0, 60.0),
            Waypoint(28.175, -15.55, 1500.0, 60.0),
            Waypoint(28.185, -15.64, 1800.0, 60.0),
            Waypoint(28.175, -15.735, 1800.0, 60.0),
            Waypoint(28.1, -15.745, 2000.0, 60.0),
            Waypoint(28.045, -15.82, 2500.0, 60.0),
            Waypoint(28.0, -15.865, 2500.0, 60.0),
            Waypoint(27.88, -15.84, 2500.0, 60.0),
            Waypoint(27.8, -15.79, 2000.0, 60.0),
            Waypoint(27.765, -15.735, 1500.0, 60.0),
            Waypoint(27.735, -15.69, 1500.0, 60.0),
            Waypoint(27.715, -15.6, 1200.0, 60.0),
            Waypoint(27.745, -15.53, 1200.0, 60.0),
            Waypoint(27.775, -15.45, 1000.0, 60.0),
            Waypoint(27.85, -15.36, 1000.0, 60.0),
            Waypoint(27.9319, -15.3866, 800.0, 55.0),
        )),
        'alternativa': Route('alternativa', 'Alternativa', 2, 53, False, 'South along the coast and back to the airport.', (
            Waypoint(27.88, -15.365, 800.0, 55.0),
            Waypoint(27.845, -15.365, 1000.0, 60.0),
            Waypoint(27.8, -15.41, 1200.0, 60.0),
            Waypoint(27.775, -15.47, 1500.0, 60.0),
            Waypoint(27.74, -15.545, 1500.0, 65.0),
            Waypoint(27.715, -15.6, 1500.0, 65.0),
            Waypoint(27.7, -15.52, 1200.0, 65.0),
            Waypoint(27.76, -15.4, 1200.0, 60.0),
            Waypoint(27.84, -15.33, 1000.0, 60.0),
            Waypoint(27.91, -15.34, 800.0, 55.0),
            Waypoint(27.9319, -15.3866, 600.0, 50.0),
        )),
        'vuelo': Route('vuelo', 'Vuelo', 3, 54, False, 'Over the sea east of the airport, at changing altitudes and speeds.', (
            Waypoint(27.96, -15.36, 800.0, 50.0),
            Waypoint(27.985, -15.325, 1200.0, 55.0),
            Waypoint(27.965, -15.285, 1600.0, 60.0),
            Waypoint(27.93, -15.3, 2000.0, 65.0),
            Waypoint(27.905, -15.34, 2000.0, 70.0),
            Waypoint(27.87, -15.33, 1600.0, 60.0),
            Waypoint(27.865, -15.285, 1200.0, 55.0),
            Waypoint(27.895, -15.27, 1000.0, 50.0),
            Waypoint(27.92, -15.31, 800.0, 45.0),
            Waypoint(27.9319, -15.3866, 600.0, 50.0),
        )),
    }
)
