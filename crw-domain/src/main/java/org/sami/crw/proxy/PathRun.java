package org.sami.crw.proxy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.spn.value.GeoPoint;

/**
 * Has the boat drive along a path: uploads it as a list under a new id, reads it back, starts it where the command is, and
 * follows its progress. The list holds the whole path, so that its indices are those of the path.
 */
final class PathRun extends CommandRun {

    private enum Phase {
        UPLOADING("the path is being uploaded"),
        READING_BACK("the upload is acknowledged and being read back"),
        STARTING("the upload is read back equal and being started"),
        DRIVING("under way");

        private final String words;

        Phase(String words) {
            this.words = words;
        }
    }

    private final String listId;
    private final Requests requests;
    private final Consumer<Upload> reached;
    private final List<Waypoint> waypoints;
    private Phase phase = Phase.UPLOADING;
    private Optional<Headway> headway = Optional.empty();
    private int starts;

    /**
     * A try.
     *
     * @param reached hears how far the upload has come, once for each state
     */
    PathRun(
            QueuedCommand queued,
            FollowPath path,
            String wireId,
            double cruiseSpeedMps,
            Requests requests,
            Consumer<Upload> reached) {
        super(queued);
        this.reached = reached;
        this.listId = wireId;
        this.requests = requests;
        double speedMps = path.speedMps().orElse(cruiseSpeedMps);
        waypoints = new ArrayList<>(path.points().size());
        for (GeoPoint point : path.points()) {
            waypoints.add(new Waypoint(point.latDeg(), point.lonDeg(), speedMps));
        }
    }

    @Override
    String state() {
        return phase.words;
    }

    @Override
    Optional<Headway> headway() {
        return headway;
    }

    @Override
    boolean isDriving() {
        return phase == Phase.DRIVING;
    }

    @Override
    void begin(long nowMs) {
        reach(Upload.State.SENT);
        requests.send(new UploadWaypoints(listId + "/upload", listId, waypoints), nowMs);
    }

    @Override
    Verdict answered(CommandMessage asked, LinkMessage answer, long nowMs) {
        if (asked instanceof UploadWaypoints) {
            phase = Phase.READING_BACK;
            reach(Upload.State.ACKNOWLEDGED);
            requests.send(new ReadBack(listId + "/readback"), nowMs);
        } else if (answer instanceof HeldWaypoints held) {
            if (!held.listId().equals(listId) || !held.waypoints().equals(waypoints)) {
                return because(Verdict.RETRY, "the boat does not hold the path that was sent");
            }
            reach(Upload.State.READ_BACK_EQUAL);
            start(nowMs);
        } else if (asked instanceof StartWaypoints) {
            phase = Phase.DRIVING;
            headway = Optional.of(new Headway(nowMs));
        }
        return Verdict.GO_ON;
    }

    private void reach(Upload.State state) {
        reached.accept(Upload.of(listId, queued().command().commandId(), waypoints.size(), state));
    }

    private void start(long nowMs) {
        phase = Phase.STARTING;
        headway = Optional.empty();
        String wireId = listId + "/start" + ++starts;
        requests.send(new StartWaypoints(wireId, listId, queued().visited()), nowMs);
    }

    @Override
    boolean isAbout(Progress progress) {
        return progress.listId().equals(listId) && phase.compareTo(Phase.STARTING) >= 0;
    }

    @Override
    Verdict resume(Progress held, long nowMs) {
        if (!isAbout(held)) {
            return because(Verdict.RETRY, "the boat holds another list");
        }
        if (held.completed()) {
            return Verdict.COMPLETED;
        }
        start(nowMs);
        return Verdict.GO_ON;
    }
}
