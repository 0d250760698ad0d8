package org.sami.crw.sim.tcp;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.server.LocalFrame;
import org.sami.crw.sim.report.LinkResult;
import org.sami.crw.sim.run.BoatState;
import org.sami.spn.value.GeoPoint;

/** What the base knows of the boats, by what they told and by how their links went. Safe for use by several threads. */
final class FleetStatus {
    /** A charge that rises by more than this, in percent of full, did not do so by itself. */
    private static final double RECHARGED_PERCENT = 10;

    /** Of a longer silence nobody knows how fast the boat was. */
    private static final long LONGEST_GAP_MS = 5000;

    private final Map<String, Known> boats = new LinkedHashMap<>();

    /**
     * What a boat has told.
     *
     * @param boatTimeMs the boat's clock
     */
    record Told(GeoPoint position, double headingRad, double speedMps, double batteryPercent, long boatTimeMs) {}

    private static final class Known {
        private String address = "";
        private String bootId = "";
        private int lost;
        private int back;
        private boolean linkIsLost;
        private Optional<Told> last = Optional.empty();
        private int recharges;
        private double distanceM;
        private LinkResult.Uploads earlierUploads = LinkResult.Uploads.NONE;
        private LinkResult.Uploads uploads = LinkResult.Uploads.NONE;
        private String why = "";
        private boolean isWanted;
    }

    private Known of(String boat) {
        return boats.computeIfAbsent(boat, id -> new Known());
    }

    /** A boat's link stands. */
    synchronized void linked(String boat, String bootId) {
        Known known = of(boat);
        if (known.linkIsLost) {
            known.back++;
        }
        known.linkIsLost = false;
        known.bootId = bootId;
    }

    /** A boat's link is lost. */
    synchronized void lost(String boat) {
        Known known = of(boat);
        if (!known.linkIsLost) {
            known.lost++;
        }
        known.linkIsLost = true;
    }

    /** The process that had the links has ended; that is no loss of them. */
    synchronized void begunAnew() {
        boats.values().forEach(known -> {
            known.linkIsLost = false;
            known.earlierUploads = known.earlierUploads.and(known.uploads);
            known.uploads = LinkResult.Uploads.NONE;
        });
    }

    /** Where a boat's server listens. Returns whether that is news. */
    synchronized boolean isAt(String boat, String address) {
        boolean news = !of(boat).address.equals(address);
        of(boat).address = address;
        return news;
    }

    /** A boat has said where it is and what charge it has. Distance is its speed over its time, which noise does not lengthen. */
    synchronized void told(String boat, Told now) {
        Known known = of(boat);
        known.last.ifPresent(before -> {
            long gapMs = now.boatTimeMs - before.boatTimeMs;
            if (gapMs > 0 && gapMs <= LONGEST_GAP_MS) {
                known.distanceM += Math.abs(before.speedMps + now.speedMps) / 2 * gapMs / 1000;
            }
            if (now.batteryPercent > before.batteryPercent + RECHARGED_PERCENT) {
                known.recharges++;
            }
        });
        known.last = Optional.of(now);
    }

    /** Where a boat was and how far it had come when an earlier process wrote it down. */
    synchronized void restored(String boat, Told then, double distanceM) {
        told(boat, then);
        of(boat).distanceM = distanceM;
    }

    /** Where the boats are that have said so. */
    synchronized List<GeoPoint> positions() {
        return boats.values().stream()
                .flatMap(known -> known.last.stream())
                .map(Told::position)
                .toList();
    }

    /** What a boat told last. */
    synchronized Optional<Told> last(String boat) {
        return of(boat).last;
    }

    /** How many waypoint lists this process has sent to a boat. Returns whether that is news. */
    synchronized boolean uploaded(String boat, LinkResult.Uploads uploads) {
        boolean news = !of(boat).uploads.equals(uploads);
        of(boat).uploads = uploads;
        return news;
    }

    /**
     * Why a boat moves or does not.
     *
     * @param isWanted whether a mission wants something of it that it can do, now or when nothing keeps it any longer
     */
    synchronized void explained(String boat, String why, boolean isWanted) {
        of(boat).why = why;
        of(boat).isWanted = isWanted;
    }

    /** Whether a mission wants something of any boat that it can do, now or when nothing keeps it any longer. */
    synchronized boolean someoneIsWanted() {
        return boats.values().stream().anyMatch(known -> known.isWanted);
    }

    /** How a boat's link went. */
    synchronized LinkResult link(String boat) {
        Known known = of(boat);
        return new LinkResult(
                ("tcp " + known.address).strip(),
                known.bootId,
                known.lost,
                known.back,
                known.earlierUploads.and(known.uploads),
                known.why);
    }

    /**
     * The boats that have ever said where they are, by name, as they were last.
     *
     * @param plane around the area's centre
     */
    synchronized List<BoatState> states(LocalFrame plane) {
        List<BoatState> states = new ArrayList<>();
        boats.forEach((id, known) -> known.last.ifPresent(told -> states.add(state(id, known, told, plane))));
        states.sort(Comparator.comparing(BoatState::id));
        return states;
    }

    /** One boat, if it has ever said where it is. */
    synchronized List<BoatState> state(String boat, LocalFrame plane) {
        Known known = of(boat);
        return known.last.map(told -> state(boat, known, told, plane)).stream().toList();
    }

    private static BoatState state(String id, Known known, Told told, LocalFrame plane) {
        double latDeg = told.position.latDeg();
        double lonDeg = told.position.lonDeg();
        return new BoatState(
                id,
                plane.eastM(latDeg, lonDeg),
                plane.northM(latDeg, lonDeg),
                latDeg,
                lonDeg,
                told.speedMps,
                told.batteryPercent,
                known.distanceM,
                known.recharges);
    }
}
