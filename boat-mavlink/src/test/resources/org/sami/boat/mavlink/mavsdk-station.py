"""A ground station on MAVSDK: sees a boat, sends it a mission, has it carried out, stops it. Prints a line for each step."""
import asyncio
import sys

from mavsdk import System
from mavsdk.mission import MissionItem, MissionPlan

LAT, LON = 45.4, 10.9
NONE = float('nan')


def place(north):
    return MissionItem(LAT + north, LON, 0, 1.0, True, NONE, NONE, MissionItem.CameraAction.NONE, NONE, NONE, NONE, NONE, NONE,
                       MissionItem.VehicleAction.NONE)


async def first(reports, fits):
    async for report in reports:
        if fits(report):
            return report


async def run():
    boat = System(port=int(sys.argv[2]))
    await boat.connect(system_address='udpin://127.0.0.1:' + sys.argv[1])
    await first(boat.core.connection_state(), lambda state: state.is_connected)
    print('sees', await first(boat.telemetry.flight_mode(), lambda mode: True))
    print('reads', await boat.param.get_param_float('CRUISE_SPEED'))
    await boat.mission.upload_mission(MissionPlan([place(1e-4), place(2e-4)]))
    print('holds', len((await boat.mission.download_mission()).mission_items))
    await boat.action.arm()
    print('armed', await first(boat.telemetry.armed(), lambda armed: armed))
    await boat.mission.start_mission()
    done = await first(boat.mission.mission_progress(), lambda progress: progress.current == progress.total)
    print('reaches', done.current)
    await boat.action.hold()
    await boat.action.disarm()
    print('stopped', await first(boat.telemetry.armed(), lambda armed: not armed))


asyncio.run(asyncio.wait_for(run(), 120))
