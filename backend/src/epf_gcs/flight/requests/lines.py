"""Requests about the two lines and the serial ports."""

from __future__ import annotations

import asyncio
from dataclasses import asdict

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handlers
from epf_gcs.contract.answers import LinkResult, PortState
from epf_gcs.contract.requests import CloseBoard, CloseSimulator, OpenBoard, OpenSimulator, ReadPorts
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.hil.simulator import Simulator, SimulatorAddress
from epf_gcs.flight.state.lines import Lines
from epf_gcs.link.address import LinkAddress, parse_address
from epf_gcs.link.ports import list_serial_ports


def line_requests(lines: Lines, supervisor: Supervisor, simulator: Simulator) -> Handlers:
    """Open and close both lines, and list what a board can be plugged into."""

    async def read_ports(_: ReadPorts, __: Asker) -> list[PortState]:
        found = await asyncio.to_thread(list_serial_ports)
        return [
            PortState(port.path, LinkAddress("serial", port.path).url, port.description, port.identity)
            for port in found
        ]

    async def open_board(request: OpenBoard, _: Asker) -> LinkResult:
        address = parse_address(request.url)
        await lines.open_board(address)
        return LinkResult(supervisor.state, address.url)

    async def close_board(_: CloseBoard, __: Asker) -> None:
        await lines.close_board()

    async def open_simulator(request: OpenSimulator, _: Asker) -> LinkResult:
        address = SimulatorAddress(**asdict(request))
        await lines.open_simulator(address)
        return LinkResult(simulator.state, f"udp://{address.send_host}:{address.send_port}")

    async def close_simulator(_: CloseSimulator, __: Asker) -> None:
        await lines.close_simulator()

    return {
        ReadPorts: read_ports,
        OpenBoard: open_board,
        CloseBoard: close_board,
        OpenSimulator: open_simulator,
        CloseSimulator: close_simulator,
    }
