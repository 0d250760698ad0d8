package org.sami.crw.proxy.execution;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.crw.proxy.command.DrivenPath;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.crw.service.path.WaysHome;
import org.sami.spn.value.GeoPoint;

/**
 * Has the boat drive along a path: uploads it as a list under a new id, reads it back, starts it where the command is, and
 * follows its progress. The list holds the whole path, and the points at which the boat turns to keep clear of what is not to be entered.
 * Before the start the boat gets the ways home along the list where straight ones would lead through that (docs/link.md).
 */
final class PathRun extends CommandRun {

    private enum Phase {
        UPLOADING("the path is being uploaded"),
        READING_BACK("the upload is acknowledged and being read back"),
        SENDING_WAYS_HOME("the upload is read back equal, and the ways home from it are being uploaded"),
        STARTING("the upload is read back equal and being started"),
        DRIVING("under way");

        private final String words;

        Phase(String words) {
            this.words = words;
        }
    }

    private final Optional<Underway> earlier;
    private final String wireId; // what is asked in this try has ids of its own, also where the list is an earlier one
    private final String listId;
    private final Optional<Adopted> adopted;
    private final PendingRequests requests;
    private final Consumer<Upload> reached;
    private final FollowPath path;
    private final Supplier<Optional<GeoPoint>> position;
    private final BooleanSupplier flies;
    private final ExpectedWayHome wayHome;
    private final double speedMps;
    private DrivenPath driven;
    private int next; // of the points that are driven along, as the boat said last
    private List<List<List<GeoPoint>>> ways = List.of(); // home, by legs
    private Phase phase = Phase.UPLOADING;
    private Optional<ProgressMonitor> headway = Optional.empty();
    private int starts;
    private int readBacks;

    /**
     * A list that the boat already holds because an earlier process of this base sent it for the same command.
     *
     * @param held the progress that the boat has reported last
     * @param visited receives the number of visited points once the list is known to be this path
     */
    record Adopted(String listId, Supplier<Progress> held, IntConsumer visited) {}

    /**
     * One attempt.
     *
     * @param position position of the boat, if known
     * @param flies whether it takes altitudes
     * @param wayHome learns the ways home that the boat knows
     * @param earlier what the boat drove along before, if it may still be under way
     * @param adopted goes on with the boat's list if it is this path; otherwise the path is sent under a new id
     * @param reached receives each state of the upload once
     */
    PathRun(
            QueuedCommand queued,
            FollowPath path,
            Supplier<Optional<GeoPoint>> position,
            BooleanSupplier flies,
            ExpectedWayHome wayHome,
            Optional<Underway> earlier,
            String wireId,
            Optional<Adopted> adopted,
            double cruiseSpeedMps,
            PendingRequests requests,
            Consumer<Upload> reached) {
        super(queued);
        this.reached = reached;
        this.earlier = earlier;
        this.wireId = wireId;
        this.adopted = adopted;
        this.listId = adopted.map(Adopted::listId).orElse(wireId);
        this.requests = requests;
        this.path = path;
        this.position = position;
        this.flies = flies;
        this.wayHome = wayHome;
        speedMps = path.speedMps().orElse(cruiseSpeedMps);
        driven = DrivenPath.of(path.points(), path.points().size(), Optional.empty(), Optional.empty());
    }

    private DrivenPath way(long nowMs) {
        int visited = queued().visited();
        Optional<GeoPoint> from = position.get();
        boolean isLimited = path.water().filter(water -> !water.isOpen()).isPresent();
        if (earlier.isEmpty()
                || from.isEmpty()
                || !isLimited
                || visited >= path.points().size()) {
            return DrivenPath.of(path.points(), visited, from, path.water());
        }
        Underway.Start start = earlier.get()
                .start(from.get(), path.points().get(visited), path.water().get(), nowMs);
        return DrivenPath.of(path.points(), visited, Optional.of(start.from()), start.before(), path.water());
    }

    private List<Waypoint> waypoints(List<GeoPoint> points) {
        List<Waypoint> waypoints = new ArrayList<>(points.size());
        for (GeoPoint point : points) {
            double altM = flies.getAsBoolean() ? point.altM() : 0;
            waypoints.add(new Waypoint(point.latDeg(), point.lonDeg(), speedMps, altM));
        }
        return waypoints;
    }

    @Override
    public String state() {
        return phase.words;
    }

    @Override
    public Optional<ProgressMonitor> headway() {
        return headway;
    }

    @Override
    Optional<Underway> underway(long nowMs) {
        return isDriving()
                ? Optional.of(new Underway(
                        driven.points()
                                .subList(
                                        Math.min(next, driven.points().size()),
                                        driven.points().size()),
                        speedMps,
                        nowMs))
                : Optional.empty();
    }

    @Override
    public boolean isDriving() {
        return phase == Phase.DRIVING;
    }

    @Override
    void begin(long nowMs) {
        if (adopted.isPresent()) {
            readBack(nowMs);
        } else {
            driven = way(nowMs);
            next = driven.indexAfter(queued().visited());
            reach(Upload.State.SENT);
            requests.send(new UploadWaypoints(wireId + "/upload", listId, waypoints(driven.points())), nowMs);
        }
    }

    @Override
    Verdict answered(CommandMessage asked, LinkMessage answer, long nowMs) {
        if (asked instanceof UploadWaypoints) {
            reach(Upload.State.ACKNOWLEDGED);
            readBack(nowMs);
        } else if (answer instanceof HeldWaypoints held) {
            return readBack(held, nowMs);
        } else if (asked instanceof SetWaysHome) {
            wayHome.has(listId, ways);
            start(nowMs);
        } else if (asked instanceof StartWaypoints started) {
            wayHome.started(listId, started.index());
            phase = Phase.DRIVING;
            headway = Optional.of(new ProgressMonitor(nowMs));
        }
        return Verdict.GO_ON;
    }

    private Verdict readBack(HeldWaypoints held, long nowMs) {
        Optional<DrivenPath> along = adopted.isPresent()
                ? DrivenPath.held(held.waypoints(), waypoints(path.points()))
                : Optional.of(driven).filter(sent -> held.waypoints().equals(waypoints(sent.points())));
        if (!held.listId().equals(listId) || along.isEmpty()) {
            return because(Verdict.RETRY, "the boat does not hold the path that was sent");
        }
        driven = along.get();
        return adopted.isPresent() ? goOn(adopted.get(), nowMs) : startUploaded(nowMs);
    }

    private void readBack(long nowMs) {
        phase = Phase.READING_BACK;
        requests.send(new ReadBack(wireId + "/readback" + (readBacks == 0 ? "" : readBacks)), nowMs);
        readBacks++;
    }

    private Verdict startUploaded(long nowMs) {
        reach(Upload.State.READ_BACK_EQUAL);
        ways = waysHome();
        if (ways.isEmpty()) {
            start(nowMs);
        } else {
            phase = Phase.SENDING_WAYS_HOME;
            List<List<List<Waypoint>>> sent = ways.stream()
                    .map(ofLeg -> ofLeg.stream().map(this::waypoints).toList())
                    .toList();
            requests.send(new SetWaysHome(wireId + "/ways", listId, sent), nowMs);
        }
        return Verdict.GO_ON;
    }

    /** Empty where all of them are straight, or more than a message holds, and for a boat that takes none. */
    private List<List<List<GeoPoint>>> waysHome() {
        Optional<GeoPoint> from = position.get();
        Optional<GeoPoint> home = wayHome.home();
        if (!wayHome.isTaken()
                || from.isEmpty()
                || home.isEmpty()
                || path.water().isEmpty()) {
            return List.of();
        }
        List<List<List<GeoPoint>>> found = WaysHome.of(
                from.get(), driven.points(), next, home.get(), path.water().get());
        long turns = found.stream().flatMap(List::stream).mapToLong(List::size).sum();
        return turns <= SetWaysHome.MOST_TURNS ? found : List.of();
    }

    /** What the boat has visited while nobody commanded it is behind it. */
    private Verdict goOn(Adopted list, long nowMs) {
        phase = Phase.STARTING;
        reach(Upload.State.TAKEN_OVER);
        list.visited().accept(visited(list.held().get()));
        wayHome.has(listId, waysHome()); // the boat has kept those of the earlier process
        return resume(list.held().get(), nowMs);
    }

    private void reach(Upload.State state) {
        reached.accept(Upload.of(listId, queued().command().commandId(), driven.points(), state));
    }

    /** Has the boat drive, from where the command is. */
    void start(long nowMs) {
        phase = Phase.STARTING;
        headway = Optional.empty();
        requests.send(new StartWaypoints(wireId + "/start" + ++starts, listId, firstIndex()), nowMs);
    }

    /** Where on its way the boat is; to its last point it is sent again and again where that is a station. */
    private int firstIndex() {
        int behind = Math.max(next, driven.indexAfter(queued().visited()));
        return Math.min(behind, driven.points().size() - 1);
    }

    @Override
    int visited(Progress progress) {
        next = progress.nextIndex();
        wayHome.drivesTo(next);
        return driven.visited(next);
    }

    @Override
    public Optional<GeoPoint> target() {
        return next < driven.points().size() ? Optional.of(driven.points().get(next)) : Optional.empty();
    }

    @Override
    int targetIndex() {
        return next;
    }

    @Override
    boolean isAbout(Progress progress) {
        return progress.listId().equals(listId) && phase.compareTo(Phase.STARTING) >= 0;
    }

    @Override
    Verdict resume(Progress held, long nowMs) {
        if (phase == Phase.READING_BACK && held.listId().equals(listId)) {
            readBack(nowMs); // the link was lost before the answer came; the boat has the list
            return Verdict.GO_ON;
        }
        if (!isAbout(held)) {
            return because(Verdict.RETRY, "the boat holds another list");
        }
        if (held.completed()) {
            return arrived();
        }
        start(nowMs);
        return Verdict.GO_ON;
    }
}
