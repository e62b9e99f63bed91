"""Requests about the two lines and the serial ports."""

from __future__ import annotations

import asyncio
from dataclasses import asdict
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.hil.simulator import Simulator, SimulatorAddress
from epf_gcs.flight.requests.client_names import Table
from epf_gcs.flight.state.lines import Lines
from epf_gcs.link.address import LinkAddress, parse_address
from epf_gcs.link.ports import list_serial_ports


def line_requests(lines: Lines, supervisor: Supervisor, simulator: Simulator) -> Table:
    """lines.ports, lines.open_board {url}, lines.close_board, lines.open_simulator {address}, lines.close_simulator."""

    async def ports(_: Asker, __: dict[str, Any]) -> list[dict[str, Any]]:
        found = await asyncio.to_thread(list_serial_ports)
        return [{**asdict(port), "url": LinkAddress("serial", port.path).url} for port in found]

    async def open_board(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        address = parse_address(arguments["url"])
        await lines.open_board(address)
        return {"state": supervisor.state, "url": address.url}

    async def close_board(_: Asker, __: dict[str, Any]) -> None:
        await lines.close_board()

    async def open_simulator(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        address = SimulatorAddress(**arguments)
        await lines.open_simulator(address)
        return {"state": simulator.state, "url": f"udp://{address.send_host}:{address.send_port}"}

    async def close_simulator(_: Asker, __: dict[str, Any]) -> None:
        await lines.close_simulator()

    return {
        "lines.ports": ports,
        "lines.open_board": open_board,
        "lines.close_board": close_board,
        "lines.open_simulator": open_simulator,
        "lines.close_simulator": close_simulator,
    }
