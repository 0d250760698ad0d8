"""A ground station on pymavlink: sees a boat, sends it a fence and a mission, has it carried out, stops it. Prints a line for each step."""
import sys
import time

from pymavlink import mavutil

station = mavutil.mavlink_connection('udpin:127.0.0.1:' + sys.argv[1], source_system=255, source_component=190)
LAT, LON = 454000000, 109000000
ITEMS = [(0, 16, 0, LAT, LON), (3, 16, 0, LAT + 1000, LON), (3, 16, 0, LAT + 2000, LON)]
EDGE = 5000
FENCE = [(0, 5001, 4, LAT + north * EDGE, LON + east * EDGE) for north, east in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
FENCE.append((0, 5004, 20, LAT - 3000, LON))
beaten = [0.0]


def until(kinds, fits=lambda message: True):
    """The next message of these kinds that fits, while heartbeats are sent."""
    end = time.time() + 60
    while time.time() < end:
        if time.time() - beaten[0] > 1:
            beaten[0] = time.time()
            station.mav.heartbeat_send(6, 8, 0, 0, 4)
        message = station.recv_match(blocking=True, timeout=0.2)
        if message is not None and message.get_type() in kinds and fits(message):
            return message
    sys.exit('no ' + ' or '.join(kinds))


def of_boat(message):
    return message.get_srcSystem() == 7


until(['HEARTBEAT'], of_boat)
print('sees', mavutil.mode_string_v10(station.messages['HEARTBEAT']))
boat = (7, 1)
station.mav.param_request_read_send(*boat, b'CRUISE_SPEED', -1)
print('reads', until(['PARAM_VALUE']).param_value)



def upload(items, kind):
    """Sends a list; how the boat answers it."""
    station.mav.mission_count_send(*boat, len(items), kind)
    while True:
        answer = until(['MISSION_REQUEST_INT', 'MISSION_ACK'], lambda message: message.mission_type == kind)
        if answer.get_type() == 'MISSION_ACK':
            return answer.type
        frame, command, param1, lat, lon = items[answer.seq]
        station.mav.mission_item_int_send(*boat, answer.seq, frame, command, 0, 1, param1, 0, 0, 0, lat, lon, 0, kind)


def download(kind):
    """Reads a list back, item by item."""
    station.mav.mission_request_list_send(*boat, kind)
    count = until(['MISSION_COUNT'], lambda message: message.mission_type == kind).count
    items = []
    for seq in range(count):
        station.mav.mission_request_int_send(*boat, seq, kind)
        item = until(['MISSION_ITEM_INT'], lambda message: message.mission_type == kind and message.seq == seq)
        items.append((item.frame, item.command, item.param1, item.x, item.y))
    return items


print('fence', upload(FENCE, 1), download(1) == FENCE)
print('half a fence', upload(FENCE[:3], 1), download(1) == FENCE)
print('sent', upload(ITEMS, 0))
station.target_system, station.target_component = boat
station.set_mode('AUTO')
station.mav.command_long_send(*boat, 400, 0, 1, 0, 0, 0, 0, 0, 0)
print('arms', until(['COMMAND_ACK'], lambda ack: ack.command == 400).result)
print('reaches', until(['MISSION_ITEM_REACHED'], lambda reached: reached.seq == 2).seq)
until(['HEARTBEAT'], lambda beat: of_boat(beat) and mavutil.mode_string_v10(beat) == 'LOITER')
station.mav.command_long_send(*boat, 400, 0, 0, 0, 0, 0, 0, 0, 0)
until(['HEARTBEAT'], lambda beat: of_boat(beat) and not beat.base_mode & 128)
print('stopped')
