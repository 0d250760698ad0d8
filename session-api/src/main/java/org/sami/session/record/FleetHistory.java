package org.sami.session.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.boat.link.BatteryDefaults;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.spn.value.GeoPoint;

/**
 * A session's history of its boats over all its processes: distances, recharges, links, and last reports. {@link org.sami.crw.operator.FleetModel}
 * has their present state. Safe for use by several threads.
 */
public final class FleetHistory {
    /** Of a longer silence nobody knows how fast the boat was. */
    private static final long LONGEST_GAP_MS = 5000;

    private final Map<String, Known> boats = new LinkedHashMap<>();

    /**
     * What a boat has reported.
     *
     * @param boatTimeMs the boat's clock
     */
    public record Report(
            GeoPoint position, double headingRad, double speedMps, double batteryPercent, long boatTimeMs) {}

    /**
     * The last state of a boat.
     *
     * @param distanceM metres driven since the session began, as reported to the base
     * @param recharges number of recharges
     */
    public record Boat(String id, Report report, double distanceM, int recharges) {}

    /**
     * How a boat's link went.
     *
     * @param address where its server listens; empty while that is not known
     * @param bootId names the last start of the boat's server; empty if it never answered
     * @param lost how often the link was lost
     * @param reconnected how often it came back
     * @param uploads of waypoint lists
     * @param why why the boat moves or does not, in words
     */
    public record Link(String address, String bootId, int lost, int reconnected, UploadCount uploads, String why) {}

    private static final class Known {
        private String address = "";
        private String bootId = "";
        private int lost;
        private int back;
        private boolean linkIsLost;
        private Optional<Report> last = Optional.empty();
        private int recharges;
        private double distanceM;
        private UploadCount earlierUploads = UploadCount.NONE;
        private UploadCount uploads = UploadCount.NONE;
        private String why = "";
    }

    private Known of(String boat) {
        return boats.computeIfAbsent(boat, id -> new Known());
    }

    /** A boat's link stands. */
    public synchronized void linked(String boat, String bootId) {
        Known known = of(boat);
        if (known.linkIsLost) {
            known.back++;
        }
        known.linkIsLost = false;
        known.bootId = bootId;
    }

    /** A boat's link is lost. */
    public synchronized void lost(String boat) {
        Known known = of(boat);
        if (!known.linkIsLost) {
            known.lost++;
        }
        known.linkIsLost = true;
    }

    /** The process that had the links has ended; that is no loss of them. */
    public synchronized void processBegan() {
        boats.values().forEach(known -> {
            known.linkIsLost = false;
            known.earlierUploads = known.earlierUploads.and(known.uploads);
            known.uploads = UploadCount.NONE;
        });
    }

    /** Where a boat's server listens. Returns whether that is news. */
    public synchronized boolean isAt(String boat, String address) {
        boolean news = !of(boat).address.equals(address);
        of(boat).address = address;
        return news;
    }

    /** A boat has said where it is and what charge it has. Distance is its speed over its time, which noise does not lengthen. */
    public synchronized void reported(String boat, Report now) {
        Known known = of(boat);
        known.last.ifPresent(before -> {
            long gapMs = now.boatTimeMs - before.boatTimeMs;
            if (gapMs > 0 && gapMs <= LONGEST_GAP_MS) {
                known.distanceM += Math.abs(before.speedMps + now.speedMps) / 2 * gapMs / 1000;
            }
            if (now.batteryPercent > before.batteryPercent + BatteryDefaults.RECHARGED_PERCENT) {
                known.recharges++;
            }
        });
        known.last = Optional.of(now);
    }

    /** Where a boat was and how far it had come when an earlier process wrote it down. */
    public synchronized void restored(String boat, Report then, double distanceM) {
        reported(boat, then);
        of(boat).distanceM = distanceM;
    }

    /** Where the boats are that have said so. */
    public synchronized List<GeoPoint> positions() {
        return boats.values().stream()
                .flatMap(known -> known.last.stream())
                .map(Report::position)
                .toList();
    }

    /** What a boat reported last. */
    public synchronized Optional<Report> last(String boat) {
        return of(boat).last;
    }

    /** How many waypoint lists this process has sent to a boat. Returns whether that is news. */
    public synchronized boolean uploaded(String boat, UploadCount uploads) {
        boolean news = !of(boat).uploads.equals(uploads);
        of(boat).uploads = uploads;
        return news;
    }

    /** Why a boat moves or does not. */
    public synchronized void explained(String boat, String why) {
        of(boat).why = why;
    }

    /** How a boat's link went. */
    public synchronized Link link(String boat) {
        Known known = of(boat);
        return new Link(
                known.address,
                known.bootId,
                known.lost,
                known.back,
                known.earlierUploads.and(known.uploads),
                known.why);
    }

    /** The boats that have ever said where they are, by name, as they were last. */
    public synchronized List<Boat> boats() {
        List<Boat> reported = new ArrayList<>();
        new TreeMap<>(boats).keySet().forEach(id -> boat(id).ifPresent(reported::add));
        return reported;
    }

    /** One boat, if it has ever said where it is. */
    public synchronized Optional<Boat> boat(String boat) {
        Known known = of(boat);
        return known.last.map(report -> new Boat(boat, report, known.distanceM, known.recharges));
    }
}
