package org.sami.mavlink.base;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleTable;

/**
 * Asks each vehicle for the number of its autopilot, when it is heard first and after a silence or a restart, as another one may answer then. Asks what speaks with a known vehicle's id on a further link who it is: for the number of its autopilot and for its position with the time since its start. A
 * radio on which nobody asked for anything carries heartbeats alone. Used by one thread.
 */
final class LinkRecognition {
    private static final int REQUEST_MESSAGE = 512;
    private static final int AUTOPILOT_VERSION = 148;
    private static final int POSITION = 33;
    private static final long EVERY_MS = 1_000;
    private static final long SELDOM_MS = 10_000; // where it was not recognized
    private static final int TRIES = 10;
    private static final long SILENT_MS = 3_000;

    private final VehicleTable table;
    private final Ask ask;
    private final Map<Asked, Times> asked = new HashMap<>();

    /** Sends a command to a vehicle on a link; may lose it. */
    interface Ask {
        void send(VehicleId vehicle, MavlinkAddress link, VehicleCommand command);
    }

    private record Asked(VehicleId vehicle, MavlinkAddress link) {}

    private record Times(int often, long lastMs) {
        boolean isDue(long nowMs) {
            return often == 0 || nowMs - lastMs >= (often < TRIES ? EVERY_MS : SELDOM_MS);
        }
    }

    LinkRecognition(VehicleTable table, Ask ask) {
        this.table = table;
        this.ask = ask;
    }

    /** Asks where it is due. */
    void tick(long nowMs) {
        Set<Asked> open = new HashSet<>();
        for (VehicleId vehicle : List.copyOf(table.ids())) {
            List<MavlinkAddress> unsettled = table.unsettled(vehicle);
            for (MavlinkAddress link : unsettled) {
                open.add(new Asked(vehicle, link));
            }
            if (table.isNumberOpen(vehicle) && isHeard(vehicle, nowMs)) {
                table.linkOf(vehicle).ifPresent(link -> open.add(new Asked(vehicle, link)));
            }
        }
        asked.keySet().retainAll(open);
        for (Asked one : open) {
            Times times = asked.getOrDefault(one, new Times(0, nowMs));
            boolean isSecond = table.isForeign(one.vehicle(), one.link());
            if (times.isDue(nowMs) && (isSecond || times.often() < TRIES)) {
                asked.put(one, new Times(times.often() + 1, nowMs));
                send(one, AUTOPILOT_VERSION);
                if (isSecond || !table.unsettled(one.vehicle()).isEmpty()) {
                    send(one, POSITION);
                }
            }
        }
    }

    /** One that is silent is asked anew once it is back. */
    private boolean isHeard(VehicleId vehicle, long nowMs) {
        return table.vehicle(vehicle)
                .filter(known -> nowMs - known.heardMs() <= SILENT_MS)
                .isPresent();
    }

    private void send(Asked to, int message) {
        ask.send(to.vehicle(), to.link(), VehicleCommand.of(REQUEST_MESSAGE, "send message " + message, message));
    }
}
