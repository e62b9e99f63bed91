"""The doctor's sentences in Spanish, by the English ones."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

_CHOOSE_FOLDER: Final = "(o elige otra carpeta con --data-dir)"

SPANISH: Final[Mapping[str, str]] = {
    "Nothing keeps the station from working.": "Nada impide que la estación funcione.",
    "{count} to mend.": "Por arreglar: {count}.",
    "A check failed: {error}.": "Una comprobación ha fallado: {error}.",
    "Tell this to whoever looks after the computer.": "Díselo a quien lleve este ordenador.",
    "epf-gcs {version}, Python {python}, {system}; packages in {folder}": (
        "epf-gcs {version}, Python {python}, {system}; paquetes en {folder}"
    ),
    "Python's packages are not those that epf-gcs was tried with: {packages}.": (
        "Los paquetes de Python no son los que se probaron con epf-gcs: {packages}."
    ),
    "Install epf-gcs again in an environment of its own: pipx install --force FILE.whl": (
        "Vuelve a instalar epf-gcs en un entorno propio: pipx install --force FICHERO.whl"
    ),
    "The disk of the data folder {data} is mounted read-only.": (
        "El disco de la carpeta de datos {data} está montado en solo lectura."
    ),
    "sudo mount -o remount,rw $(df --output=target {place} | tail -1)   (or choose another folder with --data-dir)": (
        "sudo mount -o remount,rw $(df --output=target {place} | tail -1)   " + _CHOOSE_FOLDER
    ),
    "{path} in the data folder {data} may not be written by this user.": (
        "Este usuario no puede escribir {path} en la carpeta de datos {data}."
    ),
    "The data folder {data} may not be written by this user.": (
        "Este usuario no puede escribir en la carpeta de datos {data}."
    ),
    'sudo chown -R "$USER" {whose}   (or choose another folder with --data-dir)': (
        'sudo chown -R "$USER" {whose}   ' + _CHOOSE_FOLDER
    ),
    "{sentence}": "{sentence}",
    "Install epf-gcs {version}": "Instala epf-gcs {version}",
    "Install the newest epf-gcs": "Instala el epf-gcs más nuevo",
    "{data} is of format {number}: the next start brings it to {to}.": (
        "{data} es del formato {number}: el próximo arranque lo pasa al {to}."
    ),
    "Data folder {data}": "Carpeta de datos {data}",
    "The disk of {data} has {free} GB free: recordings stop when it is full.": (
        "El disco de {data} tiene {free} GB libres: lleno, se deja de grabar."
    ),
    "Delete old flights in the tab Vuelos, or choose another disk with --data-dir.": (
        "Borra vuelos antiguos en la pestaña Vuelos, o elige otro disco con --data-dir."
    ),
    "{free} GB free on its disk": "{free} GB libres en su disco",
    "A station runs with this data folder: its ports are its own": (
        "Hay una estación en marcha con esta carpeta de datos: los puertos son suyos"
    ),
    "TCP port {port} is taken by {who}.": "El puerto TCP {port} lo tiene {who}.",
    "End that program, or: epf-gcs --port {other}": "Cierra ese programa, o: epf-gcs --port {other}",
    "epf-gcs --port {other}": "epf-gcs --port {other}",
    "TCP port {port} for the page is free": "El puerto TCP {port} de la página está libre",
    "UDP port {port}, where X-Plane sends to, is taken by another program.": (
        "El puerto UDP {port}, al que envía el X-Plane, lo tiene otro programa."
    ),
    "sudo ss -ulpn 'sport = :{port}'   (shows which; end it, or choose another port in Setup)": (
        "sudo ss -ulpn 'sport = :{port}'   (muestra cuál; ciérralo, o elige otro puerto en Setup)"
    ),
    "UDP port {port} for X-Plane is free": "El puerto UDP {port} del X-Plane está libre",
    "The clock says {time}: recordings would be filed under that day.": (
        "El reloj dice {time}: las grabaciones llevarían esa fecha."
    ),
    'sudo date -u -s "2026-01-31 12:00"   (with the right time)': (
        'sudo date -u -s "2026-01-31 12:00"   (con la hora correcta)'
    ),
    "The clock says {time}, and no time server vouches for it: recordings say so.": (
        "El reloj dice {time}, y ningún servidor de hora lo confirma: las grabaciones lo dicen."
    ),
    "sudo timedatectl set-ntp true   (with a network; else compare it with your watch)": (
        "sudo timedatectl set-ntp true   (con red; si no, compáralo con tu reloj)"
    ),
    "The clock says {time}": "El reloj dice {time}",
    "The page is in {folder}": "La página está en {folder}",
    "Only the demonstration needs it.": "Solo lo necesita la demostración.",
    "The demonstration's board does not run here: {error}.": "La placa de demostración no funciona aquí: {error}.",
    "Connect a real board.": "Conecta una placa de verdad.",
    "The demonstration's board runs": "La placa de demostración funciona",
    "{what}: {modules} not installed.": "{what}: falta instalar {modules}.",
    "{what} fails: {error}.": "{what}: falla ({error}).",
    "{what}: {modules}": "{what}: {modules}",
    "The embedded simulator": "El simulador incluido",
    "Importing heights": "Importar alturas",
    "Looking into recorded flights": "Mirar los vuelos grabados",
    "{command}": "{command}",
    "sudo apt install libexpat1   (on Debian and Ubuntu)": "sudo apt install libexpat1   (en Debian y Ubuntu)",
    "The flight process may go before all other programs": (
        "El proceso de vuelo puede ir por delante de los demás programas"
    ),
    "The flight process has no right to go before other programs; on a busy computer the loop may be late.": (
        "El proceso de vuelo no puede ir por delante de los demás programas; en un ordenador cargado, el lazo puede "
        "retrasarse."
    ),
    'echo "@dialout - rtprio 10" | sudo tee /etc/security/limits.d/epf-gcs.conf   (then log in again)': (
        'echo "@dialout - rtprio 10" | sudo tee /etc/security/limits.d/epf-gcs.conf   (después, vuelve a entrar)'
    ),
    "No serial port is here.": "No hay ningún puerto serie.",
    "Plug the board in; a PTY or TCP address needs none.": (
        "Enchufa la placa; una dirección PTY o TCP no necesita ninguno."
    ),
    "Serial port {path} can be opened": "El puerto serie {path} se puede abrir",
    "ModemManager runs: it writes to each new serial port for some seconds, and the board hears it.": (
        "ModemManager está en marcha: escribe unos segundos en cada puerto serie nuevo, y la placa lo recibe."
    ),
    "sudo systemctl disable --now ModemManager   (or, with a mobile modem: packaging/linux/70-epf-gcs.rules)": (
        "sudo systemctl disable --now ModemManager   (o, si hay un módem móvil: packaging/linux/70-epf-gcs.rules)"
    ),
    "brltty runs: it takes some USB adapters for a Braille display, and their port goes away.": (
        "brltty está en marcha: toma algunos adaptadores USB por una pantalla Braille, y su puerto desaparece."
    ),
    "sudo systemctl disable --now brltty brltty-udev   (if nobody reads this computer by Braille)": (
        "sudo systemctl disable --now brltty brltty-udev   (si nadie usa Braille en este ordenador)"
    ),
    "Serial port {path} may not be opened by this user, who is in its group {group} only after the next login.": (
        "Este usuario no puede abrir el puerto serie {path}: estará en su grupo {group} cuando vuelva a entrar."
    ),
    "Log out and in again.": "Cierra la sesión y vuelve a entrar.",
    "Serial port {path} may not be opened by this user.": "Este usuario no puede abrir el puerto serie {path}.",
    'sudo usermod -a -G {group} "$USER"   (then log out and in again)': (
        'sudo usermod -a -G {group} "$USER"   (después, cierra la sesión y vuelve a entrar)'
    ),
}
