package org.sami.crw.gui;

import static org.sami.crw.gui.SessionWorld.get;

import java.util.Set;
import java.util.stream.Collectors;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.spn.value.GeoPoint;

/**
 * Five faults at once: a lost link, an address at which nobody answers, a boat that is stopped by itself, two boats with one id, a mission in which a boat
 * cannot go on.
 */
final class FiveFaults {
    private static final int CLOSED_PORT = 1;
    private static final GeoPoint BUOY = GeoPoint.of(25.3588, 51.5302);
    private static final Set<String> FAULTS =
            Set.of("LINK_LOST", "UNREACHED_BOAT", "DUPLICATE_ID", "FLEET_STOP", "MISSION");

    private FiveFaults() {}

    /** Brings them to a session with boats of the {@link BusySituation}, and waits until its health has them. */
    static void bring(Session session, LoopbackFleet fleet) throws Exception {
        fleet.end("boat7");
        session.fleet().connect(new BoatAddress("127.0.0.1", CLOSED_PORT));
        session.fleet().connect(fleet.launchTwin("boat11"));
        get(session.fleet().stop("boat9"));
        PlainDrive.stuck(session, "Look at the buoy", "boat20", BUOY);
        Await.until("five faults are known", () -> faults(session).containsAll(FAULTS));
    }

    /** What is wrong, by the kind of the fault, or of the alarm where it is one. */
    private static Set<String> faults(Session session) {
        return session.models().health().snapshot().entries().stream()
                .map(HealthEntry::fault)
                .map(fault -> fault.kind() == HealthKind.ALARM
                        ? fault.subject().split(" ")[0]
                        : fault.kind().name())
                .collect(Collectors.toSet());
    }
}
