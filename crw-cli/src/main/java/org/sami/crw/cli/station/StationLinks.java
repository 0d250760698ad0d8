package org.sami.crw.cli.station;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.mavlink.GroundStationLink;
import org.sami.boat.mavlink.StationAddress;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.mavlink.address.MavlinkAddress;

/** Shows simulated boats to the ground station at an address, each as a vehicle of its own, from the first system id on. Safe for use by several threads. */
public final class StationLinks {
    /** Where a ground station on this machine listens. */
    public static final String USUAL = "udp:127.0.0.1:14550";

    private static final long HEARD_MS = 5_000;
    private static final long SECOND_MS = 1_000;

    private final SimulatedBoatsOnTcp boats;
    private final List<GroundStationLink> links = new ArrayList<>();
    private Optional<String> where = Optional.empty();

    /** Shows nothing yet. */
    public StationLinks(SimulatedBoatsOnTcp boats) {
        this.boats = boats;
    }

    /** Why nothing can be shown at an address; empty where it can. */
    public static Optional<String> whyNot(String address) {
        try {
            return StationAddress.parse(address) instanceof MavlinkAddress.Serial
                    ? Optional.of("a serial port is for one boat: crw boat --mavlink")
                    : Optional.empty();
        } catch (IllegalArgumentException wrong) {
            return Optional.of(String.valueOf(wrong.getMessage()));
        }
    }

    /** Shows all boats at an address, in place of the one before; also those that are added later. */
    public void start(String address) {
        stop();
        MavlinkAddress to = StationAddress.parse(address);
        synchronized (this) {
            where = Optional.of(address);
        }
        boats.accompany((boat, number, clock) -> made(boat, number, to, clock));
    }

    private synchronized BoatCompanion made(String boat, int number, MavlinkAddress to, SteadyClock clock) {
        GroundStationLink link = new GroundStationLink(boat, number, to, clock);
        links.add(link);
        return link;
    }

    /** Shows nothing any longer. Returns at once; the links close on a thread of their own. */
    public void stop() {
        boats.leaveAlone();
        List<GroundStationLink> ended;
        synchronized (this) {
            where = Optional.empty();
            ended = List.copyOf(links);
            links.clear();
        }
        if (!ended.isEmpty()) {
            Thread closing = new Thread(() -> ended.forEach(GroundStationLink::close), "ground station links close");
            closing.setDaemon(true);
            closing.start();
        }
    }

    /** Where boats are shown; empty for nowhere. */
    public synchronized Optional<String> where() {
        return where;
    }

    /** What is shown where and whether somebody looks, in words; empty where nothing is shown. */
    public synchronized Optional<String> words() {
        return where.map(address -> shown() + " shown at " + address + ". " + station());
    }

    private String shown() {
        int count = links.size();
        return switch (count) {
            case 0 -> "No boat is";
            case 1 -> links.get(0).boat() + ", as vehicle 1, is";
            default ->
                count + " boats, " + links.get(0).boat() + " to "
                        + links.get(count - 1).boat() + " as vehicles 1 to " + count + ", are";
        };
    }

    private String station() {
        OptionalLong ago = links.stream()
                .map(GroundStationLink::heardAgoMs)
                .flatMapToLong(OptionalLong::stream)
                .min();
        if (ago.isPresent() && ago.getAsLong() < HEARD_MS) {
            return "A ground station answers.";
        }
        Optional<String> fault = links.stream()
                .flatMap(link -> link.report().stream())
                .flatMap(report -> report.fault().stream())
                .findFirst();
        return fault.map(why -> "The link is broken: " + why + ".")
                .orElseGet(() -> ago.isPresent()
                        ? "The ground station has been silent for " + ago.getAsLong() / SECOND_MS + " s."
                        : "No ground station has answered yet.");
    }
}
