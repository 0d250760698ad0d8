package org.sami.crw.session.archive;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.session.record.CommandJson;
import org.sami.session.record.SessionTelemetry;

/**
 * Records in the journal, besides positions, what the operator saw of the boats: commands and their ends, the link, the commander, the battery's
 * class, and why each boat moved or did not. A replay shows it again. For the fleet's thread.
 */
public final class BoatLog {
    /** Each command, once. */
    static final String COMMAND = "command";

    /** What stands in a boat's queue from now on, by the ids of commands. */
    static final String QUEUE = "queue";

    /** How many points of a path are behind a boat. */
    static final String PROGRESS = "progress";

    /** How far a path has come on its way to a boat; with what it drives along, where that is not the path itself. */
    static final String UPLOAD = "upload";

    /** How a command ended. */
    static final String CONCLUDED = "concluded";

    /** What else is known of a boat, where it has changed. */
    static final String STATE = "state";

    /** The boat is no longer among those of the base. */
    static final String REMOVED = "removed";

    /** In a boat's state: how far it may be off its ways, as the base plans for it. */
    private static final String ERROR = "crossTrackError";

    private static final ObjectMapper JSON = new ObjectMapper();

    private final Supplier<ProxyRegistry> boats;
    private final CrossTrackError stated;
    private final MissionTitles titles;
    private final SessionTelemetry telemetry;
    private final LongSupplier nowMillis;
    private final Set<String> written = new HashSet<>(); // commands
    private final Map<String, String> states = new HashMap<>();
    private final Map<String, String> lists = new HashMap<>(); // by boat, that which was written last
    private volatile boolean closed;

    /** A log of boats as these models show them, into that telemetry. */
    public BoatLog(
            Supplier<ProxyRegistry> boats,
            CrossTrackError stated,
            MissionTitles titles,
            SessionTelemetry telemetry,
            LongSupplier nowMillis) {
        this.boats = boats;
        this.stated = stated;
        this.titles = titles;
        this.telemetry = telemetry;
        this.nowMillis = nowMillis;
    }

    /** Notes nothing from now on: what becomes of links is the session's own doing. From any thread. */
    public void close() {
        closed = true;
    }

    /** Looks at a boat again after an event, unless the event was only a position or a measurement. */
    public void take(FleetEvent event) {
        note(event);
        if (!(event instanceof FleetEvent.StatusReported || event instanceof FleetEvent.Measured)) {
            boats.get().find(event.boat()).ifPresent(this::look);
        }
    }

    private void note(FleetEvent event) {
        if (event instanceof FleetEvent.QueueChanged changed) {
            queue(changed.boat(), changed.queue());
        } else if (event instanceof FleetEvent.Progressed progressed) {
            add(progressed.boat(), PROGRESS, of(progressed.command()).put("visited", progressed.visited()));
        } else if (event instanceof FleetEvent.UploadAdvanced advanced) {
            upload(advanced.boat(), advanced.upload());
        } else if (event instanceof FleetEvent.CommandCompleted done) {
            add(done.boat(), CONCLUDED, of(done.command()).put("end", "completed"));
        } else if (event instanceof FleetEvent.CommandFailed failed) {
            add(
                    failed.boat(),
                    CONCLUDED,
                    of(failed.command()).put("end", "failed").put("why", failed.reason()));
        } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
            add(
                    withdrawn.boat(),
                    CONCLUDED,
                    of(withdrawn.command())
                            .put("end", "withdrawn")
                            .put("why", withdrawn.why().name()));
        } else if (event instanceof FleetEvent.Removed removed) {
            states.remove(removed.boat());
            lists.remove(removed.boat());
            add(removed.boat(), REMOVED, JSON.createObjectNode());
        }
    }

    /** What the boat drives along is written once for each list, where it is not the command's path. */
    private void upload(String boat, Upload upload) {
        ObjectNode json = JSON.createObjectNode()
                .put("command", upload.commandId())
                .put("list", upload.listId())
                .put("state", upload.state().name());
        if (!upload.why().isEmpty()) {
            json.put("why", upload.why());
        }
        boolean isNew = !upload.listId().equals(lists.put(boat, upload.listId()));
        boolean isPath = boats.get()
                .find(boat)
                .flatMap(proxy -> proxy.commands().current())
                .filter(command -> command.commandId().equals(upload.commandId())
                        && command.points().equals(upload.way()))
                .isPresent();
        if (isNew && !isPath) {
            CommandJson.write(upload.way(), json.putArray("way"));
        }
        add(boat, UPLOAD, json);
    }

    private ObjectNode of(BoatCommand command) {
        return JSON.createObjectNode().put("command", command.commandId());
    }

    private void queue(String boat, CommandQueueSnapshot queue) {
        Stream.concat(queue.current().stream(), queue.waiting().stream())
                .map(CommandQueueSnapshot.Entry::command)
                .filter(command -> written.add(command.commandId() + " " + command.hashCode()))
                .forEach(command -> add(boat, COMMAND, CommandJson.write(command)));
        ObjectNode json = JSON.createObjectNode();
        queue.current().ifPresent(entry -> json.set("current", entry(entry)));
        ArrayNode waiting = json.putArray("waiting");
        queue.waiting().forEach(entry -> waiting.add(entry(entry)));
        queue.blockedBy().ifPresent(mission -> json.put("blockedBy", mission));
        add(boat, QUEUE, json);
    }

    private ObjectNode entry(CommandQueueSnapshot.Entry entry) {
        return of(entry.command())
                .put("visited", entry.visited())
                .put("why", entry.why().words(titles));
    }

    /** Notes what has changed by itself; to be called once a second. */
    public void look() {
        boats.get().all().forEach(this::look);
    }

    private void look(BoatProxy boat) {
        BoatStatus status = boat.status();
        BoatExplanation why = boat.explain(titles);
        ObjectNode json = JSON.createObjectNode().put("link", status.link().name());
        status.mode().ifPresent(mode -> json.put("mode", mode.name()));
        status.battery()
                .ifPresent(battery -> json.put("battery", battery.level().name()));
        json.put("byHand", boat.isTakenOver())
                .put("commanded", boat.isCommanding())
                .put("shouldMove", why.shouldMove())
                .put("cause", why.cause().name());
        CrossTrackError error = boat.errorOr(stated);
        json.putArray(ERROR).add(error.steeringM()).add(error.positionM()).add(error.driftMps());
        if (!boat.wayHome().isEmpty()) {
            CommandJson.write(boat.wayHome(), json.putArray("wayHome"));
        }
        String words = why.text().replaceAll("[0-9]+", "#"); // whatever is counted in it is no news
        if (!(json + words).equals(states.put(boat.boatId(), json + words))) {
            add(boat.boatId(), STATE, json.put("why", why.text()));
        }
    }

    private void add(String boat, String kind, ObjectNode json) {
        if (!closed) {
            telemetry.add(nowMillis.getAsLong(), boat, kind, json);
        }
    }
}
