package org.sami.mavlink.vehicle;

import java.util.List;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * What is known of a vehicle at some moment.
 *
 * @param autopilot the firmware's name, {@code ArduPilot} or another
 * @param mode the autopilot's mode as pilots write it, such as {@code HOLD}
 * @param armed whether its motors may turn
 * @param located whether its filter has an absolute position that it trusts; before that it refuses to drive by itself. Also
 *     false once it has not said for 5 s where it is, while it goes on speaking
 * @param currentItem the item of its mission that it carries out, or would in mode AUTO; empty where it does not say
 * @param itemsHeld how many items its mission has, home included; empty where it does not say
 * @param heardOn on which links it is heard, the one on which it is spoken to first
 * @param others links on which another vehicle has its id
 * @param unsettled links on which something speaks with its id that is not recognized: these, and those where that is not known yet
 * @param texts what it has said last, oldest first
 * @param heardMs when it was heard last, on the base's clock
 * @param stations the system ids of other ground stations that were heard on its links within the last 5 s, ascending; one with the base's own id counts too
 * @param number the number of its autopilot; empty text where it has none, empty where it has not said it since it was heard first, was silent or has started
 *     again
 */
public record VehicleSnapshot(
        VehicleId id,
        VehicleKind kind,
        String autopilot,
        String mode,
        boolean armed,
        boolean located,
        Optional<VehiclePosition> position,
        Optional<VehicleBattery> battery,
        Optional<GpsState> gps,
        VehicleHealth health,
        Optional<Integer> currentItem,
        Optional<Integer> itemsHeld,
        List<HeardLink> heardOn,
        List<MavlinkAddress> others,
        List<MavlinkAddress> unsettled,
        List<StatusText> texts,
        long heardMs,
        List<Integer> stations,
        Optional<String> number) {

    /** The links on which it is heard, the one on which it is spoken to first. */
    public List<MavlinkAddress> links() {
        return heardOn.stream().map(HeardLink::link).toList();
    }
}
