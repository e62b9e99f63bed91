import aboutEn from "../features/about/about.en.json";
import aboutEs from "../features/about/about.es.json";
import accessEn from "../features/access/access.en.json";
import accessEs from "../features/access/access.es.json";
import ahrsEn from "../features/ahrs/ahrs.en.json";
import ahrsEs from "../features/ahrs/ahrs.es.json";
import alarmsEn from "../features/alarms/alarms.en.json";
import alarmsEs from "../features/alarms/alarms.es.json";
import checklistEn from "../features/checklist/checklist.en.json";
import checklistEs from "../features/checklist/checklist.es.json";
import controlsEn from "../features/controls/controls.en.json";
import controlsEs from "../features/controls/controls.es.json";
import emulationEn from "../features/emulation/emulation.en.json";
import emulationEs from "../features/emulation/emulation.es.json";
import faultsEn from "../features/faults/faults.en.json";
import faultsEs from "../features/faults/faults.es.json";
import fieldEn from "../features/field/field.en.json";
import fieldEs from "../features/field/field.es.json";
import flightEn from "../features/flight/flight.en.json";
import flightEs from "../features/flight/flight.es.json";
import flightsEn from "../features/flights/flights.en.json";
import flightsEs from "../features/flights/flights.es.json";
import flyEn from "../features/fly/fly.en.json";
import flyEs from "../features/fly/fly.es.json";
import gamepadEn from "../features/gamepad/gamepad.en.json";
import gamepadEs from "../features/gamepad/gamepad.es.json";
import guideEn from "../features/guide/guide.en.json";
import guideEs from "../features/guide/guide.es.json";
import logEn from "../features/log/log.en.json";
import logEs from "../features/log/log.es.json";
import mapEn from "../features/map/map.en.json";
import mapEs from "../features/map/map.es.json";
import messagesEn from "../features/messages/messages.en.json";
import messagesEs from "../features/messages/messages.es.json";
import parametersEn from "../features/parameters/parameters.en.json";
import parametersEs from "../features/parameters/parameters.es.json";
import playbackEn from "../features/playback/playback.en.json";
import playbackEs from "../features/playback/playback.es.json";
import plotsEn from "../features/plots/plots.en.json";
import plotsEs from "../features/plots/plots.es.json";
import reportEn from "../features/report/report.en.json";
import reportEs from "../features/report/report.es.json";
import servosEn from "../features/servos/servos.en.json";
import servosEs from "../features/servos/servos.es.json";
import setupEn from "../features/setup/setup.en.json";
import setupEs from "../features/setup/setup.es.json";
import sixEn from "../features/six/six.en.json";
import sixEs from "../features/six/six.es.json";
import tuningEn from "../features/tuning/tuning.en.json";
import tuningEs from "../features/tuning/tuning.es.json";
import saidEn from "../i18n/said.en.json";
import saidEs from "../i18n/said.es.json";
import sharedEn from "../i18n/shared.en.json";
import sharedEs from "../i18n/shared.es.json";
import missionsEn from "../missions/missions.en.json";
import missionsEs from "../missions/missions.es.json";
import appEn from "./app.en.json";
import appEs from "./app.es.json";

/** All words of the page: the shared ones and those of each feature. */
export const CATALOGUES = {
  es: {
    ...appEs,
    ...aboutEs,
    ...accessEs,
    ...ahrsEs,
    ...alarmsEs,
    ...checklistEs,
    ...controlsEs,
    ...emulationEs,
    ...faultsEs,
    ...fieldEs,
    ...flightEs,
    ...flightsEs,
    ...flyEs,
    ...gamepadEs,
    ...guideEs,
    ...logEs,
    ...mapEs,
    ...messagesEs,
    ...parametersEs,
    ...playbackEs,
    ...plotsEs,
    ...reportEs,
    ...servosEs,
    ...setupEs,
    ...sixEs,
    ...tuningEs,
    ...saidEs,
    ...sharedEs,
    ...missionsEs,
  },
  en: {
    ...appEn,
    ...aboutEn,
    ...accessEn,
    ...ahrsEn,
    ...alarmsEn,
    ...checklistEn,
    ...controlsEn,
    ...emulationEn,
    ...faultsEn,
    ...fieldEn,
    ...flightEn,
    ...flightsEn,
    ...flyEn,
    ...gamepadEn,
    ...guideEn,
    ...logEn,
    ...mapEn,
    ...messagesEn,
    ...parametersEn,
    ...playbackEn,
    ...plotsEn,
    ...reportEn,
    ...servosEn,
    ...setupEn,
    ...sixEn,
    ...tuningEn,
    ...saidEn,
    ...sharedEn,
    ...missionsEn,
  },
} as const;
