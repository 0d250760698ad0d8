package org.sami.crw.mavlink;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import org.sami.spn.protocol.Priority;

/**
 * What an operator is told of the links of a vehicle.
 *
 * @param weight how urgent it is
 */
record LinkNews(Priority weight, String text) {

    /** What a base that has just connected to a vehicle is told: the links besides the one that is used, and those of another vehicle with its id. */
    static List<LinkNews> of(String vehicle, VehicleSnapshot now) {
        MavlinkAddress used = now.links().get(0);
        Stream<VehicleEvent> further =
                now.links().stream().skip(1).map(link -> new VehicleEvent.LinkJoined(now.id(), link));
        Stream<VehicleEvent> others =
                now.others().stream().map(link -> new VehicleEvent.OtherVehicle(now.id(), link, used));
        Stream<VehicleEvent> shared = Stream.of(now)
                .filter(seen -> seen.health().sharesId())
                .map(seen -> new VehicleEvent.SharedId(seen.id(), used));
        return Stream.of(further, others, shared)
                .flatMap(events -> events)
                .flatMap(event -> of(vehicle, event).stream())
                .toList();
    }

    /** The news of an event; empty for one that is not about links. */
    static Optional<LinkNews> of(String vehicle, VehicleEvent event) {
        if (event instanceof VehicleEvent.LinkJoined joined) {
            return Optional.of(new LinkNews(Priority.LOW, vehicle + " is heard on " + joined.link() + " too"));
        }
        if (event instanceof VehicleEvent.LinkChanged changed) {
            return Optional.of(new LinkNews(
                    Priority.MEDIUM,
                    vehicle + " is commanded over " + changed.now() + " from now on: " + changed.before() + " "
                            + changed.why()));
        }
        if (event instanceof VehicleEvent.OtherVehicle other) {
            return Optional.of(new LinkNews(
                    Priority.HIGH,
                    "another vehicle has the id of " + vehicle + ": one is heard on " + other.own() + ", the other on "
                            + other.link() + ", which is not commanded. Give each a system id of its own"));
        }
        if (event instanceof VehicleEvent.SharedId shared) {
            return Optional.of(new LinkNews(
                    Priority.CRITICAL,
                    "two vehicles answer as " + vehicle + " on " + shared.link() + ": as long as they do, motors are"
                            + " stopped on the ground, and nothing else is sent there, to one in the air not even a stop:"
                            + " take its radio control. Give each a system id of its own (ArduPilot: MAV_SYSID or"
                            + " SYSID_THISMAV)"));
        }
        return Optional.empty();
    }
}
