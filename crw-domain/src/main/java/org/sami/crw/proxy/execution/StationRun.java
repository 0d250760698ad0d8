package org.sami.crw.proxy.execution;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** Has the boat go to its station as along a path of one point, and again whenever it is found too far away. */
public final class StationRun extends CommandRun {
    private final KeepStation station;
    private final PathRun way;
    private boolean there;

    StationRun(
            QueuedCommand queued,
            KeepStation station,
            Supplier<Optional<GeoPoint>> position,
            BooleanSupplier flies,
            ExpectedWayHome wayHome,
            Optional<Underway> earlier,
            String wireId,
            double cruiseSpeedMps,
            PendingRequests requests,
            Consumer<Upload> reached) {
        super(queued);
        this.station = station;
        way = new PathRun(
                queued,
                station.way(),
                position,
                flies,
                wayHome,
                earlier,
                wireId,
                Optional.empty(),
                cruiseSpeedMps,
                requests,
                reached);
    }

    /** Whether the boat has come to its station, and has not left it since. */
    public boolean isThere() {
        return there;
    }

    @Override
    public String state() {
        return there ? "keeping its station" : way.state();
    }

    @Override
    public Optional<ProgressMonitor> headway() {
        return there ? Optional.empty() : way.headway();
    }

    @Override
    Optional<Underway> underway(long nowMs) {
        return there ? Optional.empty() : way.underway(nowMs);
    }

    @Override
    public boolean isDriving() {
        return !there && way.isDriving();
    }

    @Override
    void begin(long nowMs) {
        way.begin(nowMs);
    }

    @Override
    Verdict answered(CommandMessage asked, LinkMessage answer, long nowMs) {
        return because(way.answered(asked, answer, nowMs), way.why());
    }

    @Override
    boolean isAbout(Progress progress) {
        return way.isAbout(progress);
    }

    @Override
    int visited(Progress progress) {
        return way.visited(progress);
    }

    @Override
    public Optional<GeoPoint> target() {
        return way.target();
    }

    @Override
    int targetIndex() {
        return way.targetIndex();
    }

    /** The boat has arrived, and goes on to keep its station. */
    @Override
    Verdict arrived() {
        there = true;
        return Verdict.GO_ON;
    }

    @Override
    Verdict at(GeoPoint position, long nowMs) {
        if (there && Geodesy.distanceM(position, station.point()) > station.radiusM()) {
            there = false;
            way.start(nowMs);
        }
        return Verdict.GO_ON;
    }

    /** Starts the way again, as the boat may have drifted meanwhile; one that is there arrives at once. */
    @Override
    Verdict resume(Progress held, long nowMs) {
        there = false;
        if (!way.isAbout(held)) {
            return because(Verdict.RETRY, "the boat holds another list");
        }
        way.start(nowMs);
        return Verdict.GO_ON;
    }
}
