package org.sami.crw.sim.tcp;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.session.Fleet;

/**
 * Waits, for a bounded time, until every boat has answered, takes commands from this base, and has reported its position. For the
 * thread that starts the run.
 */
final class FleetReadiness {
    private static final long POLL_MS = 50;

    private final Fleet fleet;
    private final List<BoatAddress> addresses;
    private final List<String> simulated;

    /**
     * Waits for nobody yet.
     *
     * @param simulated the boats that this process simulates besides, by name
     */
    FleetReadiness(Fleet fleet, List<BoatAddress> addresses, List<String> simulated) {
        this.fleet = fleet;
        this.addresses = addresses;
        this.simulated = simulated;
    }

    /**
     * Connects to all and waits.
     *
     * @param clockMs milliseconds that never run back
     * @return what keeps boats from being ready, in words that name the boat or its address; empty if nothing does
     * @throws InterruptedException if somebody wants an end
     */
    List<String> await(LongSupplier clockMs, long withinMs) throws InterruptedException {
        addresses.forEach(fleet::connect);
        long end = clockMs.getAsLong() + withinMs;
        List<String> missing = look();
        while (!missing.isEmpty() && clockMs.getAsLong() < end) {
            Thread.sleep(POLL_MS);
            missing = look();
        }
        return missing;
    }

    /** What keeps boats from being ready. */
    List<String> look() {
        List<LinkReport> links = links();
        List<String> missing = new ArrayList<>();
        for (BoatAddress address : addresses) {
            Optional<LinkReport> link = links.stream()
                    .filter(report -> isAt(report.address(), address))
                    .findFirst();
            Optional<String> boat = link.flatMap(LinkReport::boatId);
            String obstacle = boat.map(this::obstacle)
                    .orElse("does not answer"
                            + link.map(FleetReadiness::lastEvent).orElse(""));
            if (!obstacle.isEmpty()) {
                missing.add(boat.map(id -> id + " at " + address + ": ").orElse(address + " ") + obstacle);
            }
        }
        for (String boat : simulated) {
            String obstacle = obstacle(boat);
            if (!obstacle.isEmpty()) {
                missing.add(boat + ": " + obstacle);
            }
        }
        return missing;
    }

    /** The boats that have answered, in the order of their addresses, then the simulated ones. */
    List<String> boats() {
        List<LinkReport> links = links();
        Stream<String> connected = addresses.stream()
                .flatMap(address -> links.stream()
                        .filter(report -> isAt(report.address(), address))
                        .flatMap(report -> report.boatId().stream()));
        return Stream.concat(connected, simulated.stream()).distinct().toList(); // a boat may have two links
    }

    /** Each robot that has answered and that plans cannot command, as {@code mav111 is a boat, and this session flies copters}. */
    List<String> unfit() {
        List<String> there = boats();
        return fleet.ask(boats -> there.stream()
                        .flatMap(boat -> boats.find(boat).stream())
                        .flatMap(boat -> boat.unfit().map(why -> boat.boatId() + " " + why).stream())
                        .toList())
                .toCompletableFuture()
                .join();
    }

    private static boolean isAt(InetSocketAddress known, BoatAddress address) {
        return address.leadsTo(BoatAddress.of(known));
    }

    private static String lastEvent(LinkReport link) {
        if (link.connected()) {
            return " (something listens there, and says nothing that a boat would say)";
        }
        return link.lastEvent().isEmpty() ? "" : " (" + link.lastEvent() + ")";
    }

    private List<LinkReport> links() {
        return fleet.links().toCompletableFuture().join();
    }

    private String obstacle(String boat) {
        return fleet.ask(boats -> boats.find(boat).map(FleetReadiness::obstacle).orElse("it is gone"))
                .toCompletableFuture()
                .join();
    }

    private static String obstacle(BoatProxy boat) {
        if (!boat.isCommanding()) {
            return boat.explain().text();
        }
        return boat.status().pose().isEmpty() ? "it has not said where it is" : "";
    }
}
