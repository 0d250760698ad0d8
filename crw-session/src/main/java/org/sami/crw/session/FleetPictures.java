package org.sami.crw.session;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.PictureModel;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.crw.session.picture.PictureFetcher;
import org.sami.crw.session.picture.PictureLimits;
import org.sami.session.record.PictureRows;
import org.sami.session.record.SessionPictures;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/** The pictures of a session's boats: fetched, written down in the journal, and reported to the operator. For the fleet's thread, but where said. */
final class FleetPictures implements Closeable {
    private static final int MOST_REASONS = 3;

    private final SessionPictures folder;
    private final PictureRows rows;
    private final PictureFetcher fetcher;
    private final SessionTelemetry telemetry;
    private final SessionMessages messages;
    private final SessionThreads threads;
    private final Map<String, List<FleetEvent.PictureMissed>> missed =
            new LinkedHashMap<>(); // by boat, not yet reported
    private final Executor fleet;
    private volatile boolean closed;

    FleetPictures(
            SessionPictures folder,
            SessionThreads threads,
            FleetConnector connector,
            FleetEvents events,
            SessionTelemetry telemetry,
            SessionMessages messages) {
        this.folder = folder;
        this.telemetry = telemetry;
        this.messages = messages;
        this.threads = threads;
        fleet = connector.executor();
        rows = new PictureRows(folder);
        fetcher = new PictureFetcher(
                connector::pictures,
                folder,
                PictureLimits.STANDARD,
                connector.executor(),
                threads.fetching(),
                events::publish,
                threads::nowMs);
        events.subscribe(this::take);
    }

    /** Where a session keeps pictures; empty where nobody would look at them. */
    static Optional<SessionPictures> folder(SessionSetup setup) {
        return setup.pictures()
                .or(() -> setup.journal().file().map(SessionPictures::besides))
                .or(() -> setup.runtime() instanceof SessionRuntime.RealTime
                                && setup.onFault().equals(FaultPolicy.ATTENDED)
                        ? Optional.of(SessionPictures.temporary())
                        : Optional.empty());
    }

    private void take(FleetEvent event) {
        if (closed) {
            return;
        }
        rows.write(telemetry, threads.nowMs(), event);
        if (event instanceof FleetEvent.PanoramaTaken taken && !taken.files().isEmpty()) {
            fleet.execute(() -> tell(taken)); // after the models know the pictures
        } else if (event instanceof FleetEvent.PictureMissed one) {
            missed.computeIfAbsent(one.boat(), boat -> new ArrayList<>()).add(one);
            if (!threads.isRealTime()) {
                tellMissed();
            }
        }
        fetcher.take(event);
    }

    /** In simulated time nobody looks while it runs. */
    private void tell(FleetEvent.PanoramaTaken taken) {
        if (threads.isRealTime()) {
            int count = taken.files().size();
            messages.tell(new OperatorMessage(
                    threads.nowMs(),
                    taken.command().mission(),
                    OperatorMessage.Source.DOMAIN,
                    Priority.LOW,
                    taken.boat() + " took " + count + (count == 1 ? " picture" : " pictures"),
                    List.of(taken.boat()),
                    "",
                    MapRelevance.ofPictures(List.of(taken.boat()))));
        }
    }

    /** To be called once a second. */
    void look() {
        if (!closed) {
            fetcher.look();
            tellMissed();
        }
    }

    /** One message for all pictures that a boat does not give. */
    private void tellMissed() {
        missed.forEach((boat, all) -> {
            List<String> reasons = all.stream()
                    .map(FleetEvent.PictureMissed::reason)
                    .distinct()
                    .toList();
            int more = reasons.size() - MOST_REASONS;
            String text = String.join("; ", reasons.subList(0, Math.min(MOST_REASONS, reasons.size())))
                    + (more > 0 ? "; and " + more + " pictures more that do not come" : "");
            messages.tell(new OperatorMessage(
                    threads.nowMs(),
                    Ids.NONE,
                    OperatorMessage.Source.DOMAIN,
                    Priority.MEDIUM,
                    text,
                    List.of(boat),
                    ""));
        });
        missed.clear();
    }

    /** Takes up the pictures of earlier processes; before boats are linked. From any thread. */
    void restore(List<TelemetryRow> earlier, PictureModel model, FleetConnector connector) {
        rows.read(earlier, (event, atMillis) -> {
            model.restore(event, atMillis);
            connector.executor().execute(() -> fetcher.restore(event));
        });
    }

    /** Completes on the fleet's thread when no picture is open that could come. From any thread. */
    CompletionStage<Void> done() {
        return fetcher.done();
    }

    /** Stops fetching, recording and reporting. From any thread. */
    void listenNoLonger() {
        closed = true;
        fetcher.close();
    }

    @Override
    public void close() throws IOException {
        folder.close();
    }
}
