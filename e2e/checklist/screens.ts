/** What stands on each tab: by its role and accessible name, with the words that have to be read in it. */
export interface Part {
  readonly role:
    | "application"
    | "button"
    | "combobox"
    | "group"
    | "img"
    | "region"
    | "slider"
    | "spinbutton"
    | "tabpanel"
    | "textbox"
    | "toolbar";
  readonly name: string | RegExp;
  /** Labels, units and ranges in it. */
  readonly reads?: readonly (string | RegExp)[];
  /** So many of them. */
  readonly count?: number;
}

export interface Screen {
  readonly tab: string;
  /** Sub tab, where the parts stand on one. */
  readonly sub?: string;
  readonly parts: readonly Part[];
}

const GAINS = [
  ...["k_elev", "k_int_pitch", "k_div_Q_init", "k_div_Q_speed", "k_pitch", "k_altura", "k_int_altura", "k_VVI"],
  ...["k_airln", "k_div_P_init", "k_div_P_speed", "k_roll", "k_heading"],
  ...["k_rudder", "k_div_R_init", "k_div_R_speed", "k_div_velocidad"],
];

export const GAIN_NAMES: readonly string[] = GAINS;

const GPS_READINGS = ["Latitud", "Longitud", "Altura", "Speed", "Rumbo"];
const FMS_READINGS = ["Rumbo", "Altura", "Speed", "Distancia", "Waypoint", "Previous", "Next"];
const CONTROLS = ["Elevator", "Aileron", "Rudder", "Throttle"];

/** On every tab. */
export const FRAME: readonly Part[] = [
  { role: "img", name: "Indicador de actitud" },
  { role: "img", name: "Indicador de rumbo" },
  { role: "region", name: "AHRS Board", reads: ["Heading", "Pitch", "Roll"] },
  { role: "region", name: "Controles", reads: [...CONTROLS, "Autopilot", "Autotrim"] },
  { role: "img", name: "Camino de la señal de control" },
  { role: "group", name: "Autopilot", reads: ["On", "Off"] },
  { role: "group", name: "Autotrim", reads: ["On", "Off"] },
  { role: "group", name: "X-Plane", reads: ["Manual", "Ordenador de a bordo"] },
  { role: "group", name: "Fuente", reads: ["Joystick", "RC"] },
];

const FLIGHT = "Datos de vuelo";

/** The six round instruments, by what a screen reader calls each. */
const SIX: readonly Part[] = [
  ...["Velocidad", "Indicador de actitud", "Altímetro barométrico"],
  ...["Altímetro GPS", "Indicador de rumbo", "Velocidad vertical"],
].map((name) => ({ role: "img", name }));

export const SCREENS: readonly Screen[] = [
  {
    tab: FLIGHT,
    parts: [
      {
        role: "region",
        name: "State report",
        reads: ["Analog", "Inerciales", "AHRS", "Stat", "GPS", "Servos", "Autotrim", "Autopilot"],
      },
      { role: "button", name: "Read All" },
      { role: "region", name: "Gyros", reads: ["P", "Q", "R", "°/s"] },
      { role: "region", name: "Acelerómetros", reads: ["X", "Y", "Z"] },
      { role: "region", name: "Magnetómetros", reads: ["X", "Y", "Z"] },
      { role: "region", name: "Analog", reads: ["Temp", "Vbatt", "Baro", "Altura", "Pitot", "Speed"] },
    ],
  },
  { tab: FLIGHT, sub: "Fast GPS", parts: [{ role: "tabpanel", name: "Fast GPS", reads: GPS_READINGS }] },
  {
    tab: FLIGHT,
    sub: "GPS status",
    parts: [{ role: "tabpanel", name: "GPS status", reads: ["GPSPositionFix", "SatellitesUsed"] }],
  },
  {
    tab: FLIGHT,
    sub: "Uso de la CPU",
    parts: [{ role: "tabpanel", name: "Uso de la CPU", reads: ["SensorDSC", "ControlDSC", "%"] }],
  },
  { tab: FLIGHT, sub: "FMS", parts: [{ role: "tabpanel", name: "FMS", reads: FMS_READINGS }] },
  {
    tab: FLIGHT,
    sub: "GPS",
    parts: [{ role: "tabpanel", name: "GPS", reads: [...GPS_READINGS, "GPSPositionFix", "SatellitesUsed"] }],
  },
  { tab: FLIGHT, sub: "ServosIn", parts: [{ role: "tabpanel", name: "ServosIn", reads: ["1", "6", "12"] }] },
  { tab: FLIGHT, sub: "ServosOut", parts: [{ role: "slider", name: /^Servo \d+$/, count: 20 }] },
  { tab: FLIGHT, sub: "Fly-by-wire", parts: [{ role: "tabpanel", name: "Fly-by-wire", reads: CONTROLS }] },
  {
    tab: FLIGHT,
    sub: "Refresco",
    parts: [
      { role: "textbox", name: "Parámetros" },
      { role: "textbox", name: "FMS" },
      { role: "textbox", name: "Servos" },
      {
        role: "tabpanel",
        name: "Refresco",
        reads: [
          "De 20 a 10000 ms; por defecto 100",
          "De 50 a 10000 ms; por defecto 100",
          "De 20 a 10000 ms; por defecto 20",
        ],
      },
    ],
  },
  {
    tab: "Standard Six",
    parts: SIX,
  },
  {
    tab: "Autopilot Param",
    parts: [
      ...["Control de altura", "Control de rumbo", "Control de rudder", "Control de Velocidad"].map(
        (name): Part => ({ role: "region", name }),
      ),
      ...GAINS.map((name): Part => ({ role: "textbox", name })),
      ...["Load", "Store", "Guardar en archivo", "Abrir archivo"].map(
        (name): Part => ({ role: "button", name: new RegExp(`^${name}`) }),
      ),
    ],
  },
  {
    tab: "HIL",
    parts: [
      { role: "region", name: "AHRS", reads: ["Heading", "Pitch", "Roll"] },
      { role: "region", name: "ADS", reads: ["Vind", "Altura"] },
      { role: "region", name: "Fly-by-wire", reads: CONTROLS },
      { role: "region", name: "GPS", reads: ["Latitud", "Longitud", "Altura"] },
      { role: "region", name: "Gyros", reads: ["Q", "P", "R"] },
      { role: "region", name: "AoA, paths", reads: ["AoA", "beta", "hding", "vpath"] },
      { role: "region", name: "Mach, VVI, Gload", reads: ["Mach", "VVI", "Gnorml", "Gaxial", "Gside"] },
      { role: "region", name: "Parámetros del Flight Management System", reads: FMS_READINGS },
    ],
  },
  {
    tab: "HIL Standard Six",
    parts: SIX,
  },
  ...["Plan de vuelo (FMS)", "Plan HIL"].map(
    (sub): Screen => ({
      tab: "Planes de vuelo",
      sub,
      parts: [
        ...["Descargar de la placa", "Enviar a la placa", "Previous", "Next", "Ir al waypoint", "Importar", "Exportar"],
        ...["Insertar", "Quitar", "Subir", "Bajar", "Deshacer", "Rehacer"],
      ].map((name): Part => ({ role: "button", name })),
    }),
  ),
  {
    tab: "AHRS 3D",
    sub: "Actitud",
    parts: [
      { role: "application", name: "Avión en 3D" },
      { role: "region", name: "Actitud y velocidades angulares", reads: ["Heading", "Pitch", "Roll", "P", "Q", "R"] },
      ...["Alinear", "Quitar alineación", "Empezar la prueba AHRS"].map((name): Part => ({ role: "button", name })),
      { role: "group", name: "Cámara", reads: ["Detrás", "Frente", "Arriba", "Lado"] },
    ],
  },
  {
    tab: "AHRS 3D",
    sub: "Calibración del magnetómetro",
    parts: ["Empezar a recoger", "Borrar", "Copiar", "Guardar CSV"].map((name): Part => ({ role: "button", name })),
  },
  {
    tab: "Mensajes",
    sub: "Placa",
    parts: [
      { role: "region", name: "Consejos" },
      { role: "region", name: "Mensajes de la placa" },
      ...["heartbeat", "ahrs", "inertial", "analog", "servos_in", "fly_by_wire", "gps", "hil_surfaces"].map(
        (name): Part => ({ role: "button", name }),
      ),
    ],
  },
  { tab: "Mensajes", sub: "X-Plane", parts: [{ role: "tabpanel", name: "X-Plane" }] },
  { tab: "Mensajes", sub: "Enlace", parts: [{ role: "tabpanel", name: "Enlace", reads: ["RX", "TX", "p50", "p99"] }] },
  {
    tab: "Gráficas",
    parts: [
      { role: "toolbar", name: "Gráficas", reads: ["Disposición", "Comparar con"] },
      { role: "region", name: "Señales", reads: ["Señal calculada"] },
      ...[1, 2, 3].map(
        (number): Part => ({ role: "region", name: `Gráfica ${number}`, reads: ["Mín.", "Media", "Máx."] }),
      ),
      ...["Acercar", "Alejar", "Todo el vuelo", "Último minuto", "Añadir una gráfica"].map(
        (name): Part => ({ role: "button", name }),
      ),
      ...["Guardar lo que se ve como CSV", "Guardar lo que se ve como imagen"].map(
        (name): Part => ({ role: "button", name }),
      ),
    ],
  },
  {
    tab: "Alarmas",
    parts: [
      { role: "region", name: "Activas" },
      { role: "region", name: "Pasadas" },
      { role: "region", name: "Sonido y voz", reads: ["Sonido", "Voz", "Volumen"] },
      { role: "region", name: "Umbrales", reads: ["0 a 60 V", "1 a 100 %", "0.1 a 100 %", "0.5 a 30 s", "0.2 a 10 s"] },
    ],
  },
  {
    tab: "Setup",
    parts: [
      { role: "region", name: "Comunicación con el Piloto Automático" },
      { role: "combobox", name: "Puerto" },
      { role: "combobox", name: "Velocidad" },
      { role: "button", name: "Actualizar" },
      { role: "region", name: "XPlane", reads: [/#\d+ Tramas/, "IP XPlane"] },
      { role: "textbox", name: "IP XPlane" },
      { role: "textbox", name: "Puerto Tx" },
      { role: "textbox", name: "Puerto Rx" },
      { role: "button", name: "Open", count: 2 },
      { role: "button", name: "Close", count: 2 },
      { role: "region", name: "Palanca del piloto", reads: ["Joystick de X-Plane", "Mando de este navegador"] },
      { role: "region", name: "Envío y recepción de mensajes por el puerto serie" },
      { role: "textbox", name: "Línea para la placa" },
      { role: "button", name: "Enviar" },
      { role: "region", name: "Tramas de X-Plane en vivo" },
    ],
  },
  // Beyond the old station: after its tabs.
  {
    tab: "Vuelos",
    parts: [
      ...["Importar…", "Papelera"].map((name): Part => ({ role: "button", name })),
      ...["Etiqueta", "Placa", "Ordenar por"].map((name): Part => ({ role: "combobox", name })),
      { role: "region", name: "Grabándose ahora", reads: ["B", "Ver desde el principio"] },
      { role: "region", name: "Disco", reads: ["Si falta sitio, borrar los vuelos más antiguos"] },
    ],
  },
];
