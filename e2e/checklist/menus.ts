/** Every entry of every menu, in the words that users know; `sends` names the captured action whose bytes it sends. */
export interface Entry {
  readonly role: "menuitem" | "menuitemcheckbox" | "menuitemradio";
  readonly name: string;
  /** Name of the group in which it stands, where two entries share a name. */
  readonly group?: string;
  /** Actions of protocol/vectors/commands.jsonl: one, or the two of a switch in either order. */
  readonly sends?: readonly string[];
  /** A question that has to be answered first: its button. */
  readonly confirm?: string;
  /** Only a board with extensions takes it; a legacy one leaves it disabled, with the reason. */
  readonly extension?: true;
  /** Why it is disabled, which stands in it behind its name. */
  readonly reason?: string;
}

export interface Menu {
  readonly name: string;
  readonly entries: readonly Entry[];
}

const item = (name: string, ...sends: string[]): Entry => ({ role: "menuitem", name, sends });
const stream = (name: string, action: string): Entry => ({
  role: "menuitemcheckbox",
  name,
  sends: [`${action}On`, `${action}Off`],
});
const source = (group: string, name: string): Entry => ({ role: "menuitemradio", name, group, extension: true });

/** After it the gateway switches the streams on again that the board had: whoever counts bytes does it last. */
export const RESET: Entry = { ...item("Reset", "actionAutopilotReset"), confirm: "Reiniciar" };

export const MENUS: readonly Menu[] = [
  {
    name: "Control Aeronave",
    entries: [
      item("Plane RC", "actionPlane_RC"),
      // Last of the two: with RC as source the transmitter's own switches decide, and the autopilot's entries are off.
      item("Plane Joystick", "actionPlane_Joystick"),
      { role: "menuitem", name: "Joystick de X-Plane (filas 8 y 25)" },
      {
        role: "menuitem",
        name: "Mando de este navegador",
        reason: "Ningún mando a la vista: conéctalo y pulsa uno de sus botones.",
      },
      { role: "menuitem", name: "Palanca en la pantalla" },
      { role: "menuitem", name: "Ajustar el mando…" },
      { ...item("Fly-by-wire", "actionServos_Control_Mode_FBW"), group: "Control ServosOut" },
      { ...item("HIL", "actionServos_Control_Mode_HIL"), group: "Control ServosOut" },
    ],
  },
  {
    name: "Parámetros",
    entries: [
      item("Stop", "actionParamStop"),
      item("Start", "actionParamStart"),
      stream("Sensores Analógicos", "actionAnalog"),
      stream("Sensores Inerciales", "actionInercial"),
      stream("AHRS", "actionAHRS"),
      stream("Estadísticas", "actionSTAT"),
      stream("GPS", "actionGPS"),
      stream("ServosIn", "actionServos"),
      stream("Fly-by-wire", "actionFBW"),
      item("FMS Fly plan On", "actionFMSFlyPlanOn"),
      item("FMS Fly plan Off", "actionFMSFlyPlanOff"),
      item("FMS HIL Fly plan On", "actionFMSHILFlyPlanOn"),
      item("FMS HIL Fly plan Off", "actionFMSHILFlyPlanOff"),
      { role: "menuitemcheckbox", name: "Emulación" },
    ],
  },
  {
    name: "XPlane",
    entries: [
      item("HIL Load Gando", "actionHIL_Load_Gando"),
      item("HIL Load Ruta Isla", "actionHIL_Load_Ruta_Isla"),
      item("HIL Load Alternativa", "actionHIL_Load_Alternativa"),
      item("HIL Load Vuelo", "actionHIL_Load_Vuelo"),
      item("HIL Next Waypoint", "actionHIL_NEXT_WAYPOINT"),
      item("HIL Prev Waypoint", "actionHIL_PREV_WAYPOINT"),
      // The path is the station's own: as in the captured station, the board is told nothing.
      item("Joystick", "actionHILControlJoystick"),
      item("Fly-by-wire", "actionHILControlRC"),
    ],
  },
  {
    name: "Autopilot",
    entries: [
      item("On", "actionAutopilot_On"),
      item("Off", "actionAutopilot_off"),
      item("Autotrim On", "actionAutotrim_On"),
      item("Autotrim Off", "actionAutotrim_Off"),
      source("Selector de velocidad", "GPS"),
      source("Selector de velocidad", "Tubo Pitot"),
      source("Selector de altura", "GPS"),
      source("Selector de altura", "Baro"),
      RESET,
    ],
  },
  {
    name: "Google Earth",
    entries: [
      { ...item("Reset", "actionGoogleReset"), confirm: "Borrar el recorrido" },
      { role: "menuitem", name: "Recuperar el recorrido anterior" },
      { role: "menuitem", name: "Abrir en Google Earth" },
      { role: "menuitem", name: "Exportar KML" },
    ],
  },
  {
    name: "Ver",
    entries: [
      { role: "menuitemradio", name: "Oscuro" },
      { role: "menuitemradio", name: "Claro" },
      { role: "menuitemradio", name: "Sol" },
      { role: "menuitemradio", name: "Español" },
      { role: "menuitemradio", name: "English" },
      { role: "menuitem", name: "Registro" },
      { role: "menuitem", name: "Lista antes del despegue" },
      { role: "menuitem", name: "Abrir esta pestaña en una tableta" },
      { role: "menuitem", name: "Barras a su sitio" },
      { role: "menuitem", name: "Ajustes" },
    ],
  },
  {
    name: "Ayuda",
    entries: [
      { role: "menuitem", name: "Guía" },
      { role: "menuitem", name: "Atajos de teclado" },
      { role: "menuitem", name: "Acerca de" },
    ],
  },
];
