package org.sami.crw.mavlink;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MessagePlan;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.vehicle.HeardLink;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** The links of a vehicle, as its base shows them. */
final class VehicleLinkStatuses {
    private VehicleLinkStatuses() {}

    /**
     * The links on which a vehicle is heard, the one in use first.
     *
     * @param links all links of the base
     * @param plans what vehicles are asked for on each
     */
    static List<LinkStatus> of(
            VehicleSnapshot vehicle,
            List<MavlinkLinkReport> links,
            Map<MavlinkAddress, MessagePlan> plans,
            long nowMs) {
        return vehicle.heardOn().stream()
                .map(heard -> status(
                        heard,
                        heard.link().equals(vehicle.links().get(0)),
                        links.stream()
                                .filter(link -> link.address().equals(heard.link()))
                                .findFirst(),
                        Optional.ofNullable(plans.get(heard.link())),
                        vehicle.id().system(),
                        nowMs))
                .toList();
    }

    private static LinkStatus status(
            HeardLink heard,
            boolean used,
            Optional<MavlinkLinkReport> link,
            Optional<MessagePlan> plan,
            int system,
            long nowMs) {
        return new LinkStatus(
                heard.link().toString(),
                used,
                heard.lost(),
                nowMs - heard.heardMs(),
                link.flatMap(one -> one.fault()
                        .or(() -> Optional.ofNullable(one.senders().get(system))
                                .map(fault -> "the vehicle " + fault.words()))),
                link.flatMap(MavlinkLinkReport::rssi),
                link.flatMap(MavlinkLinkReport::remoteRssi),
                used ? plan.map(MessagePlan::bytesPerVehicle).orElse(0.0) : 0,
                plan.map(MessagePlan::filledPart).orElse(OptionalDouble.empty()));
    }
}
