package org.sami.session.follow;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatMode;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.ReplayFeed;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.TurnWait;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.session.api.BoatStart;
import org.sami.session.record.CommandJson;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.OperatorLogRows;
import org.sami.session.record.PictureRows;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionPictures;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.value.GeoPoint;

/** Gives models a journal's telemetry as news of boats. For the replay's thread. */
public final class RecordedBoats implements SessionTelemetry.Reader {
    private final ReplayFeed feed;
    private final MessageSink messages;
    private final Optional<PictureRows> pictures;
    private final Map<String, Recorded> boats = new LinkedHashMap<>();
    private final Map<String, BoatCommand> commands = new HashMap<>();
    private long nowMillis;

    private static final class Recorded {
        private LinkState link = LinkState.CONNECTING;
        private OptionalLong heardAtMillis = OptionalLong.empty();
        private Optional<BoatPose> pose = Optional.empty();
        private long poseAtMillis;
        private double percent = 100;
        private Optional<BatteryLevel> level = Optional.empty();
        private Optional<BoatMode> mode = Optional.empty();
        private Commander commander = Commander.UNKNOWN;
        private CommandQueueSnapshot queue = CommandQueueSnapshot.EMPTY;
        private String list = ""; // that went to it last
        private List<GeoPoint> way = List.of(); // along that list
        private List<GeoPoint> wayHome = List.of();
        private Optional<CrossTrackError> error = Optional.empty();
        private boolean flew; // reported an altitude
        private Optional<BoatSample> live = Optional.empty(); // of a session that is followed
        private BoatExplanation why = new BoatExplanation(false, Cause.NO_COMMAND, "not known: the journal is old");
    }

    /**
     * Knows no boat.
     *
     * @param messages takes the messages to the operator
     * @param pictures where those of the session are kept; empty where they cannot be had
     */
    public RecordedBoats(ReplayFeed feed, MessageSink messages, Optional<SessionPictures> pictures) {
        this.pictures = pictures.map(PictureRows::new);
        this.feed = feed;
        this.messages = messages;
    }

    /** Starts again. */
    public void clear() {
        boats.clear();
        commands.clear();
    }

    /** One row of the journal. */
    public void take(TelemetryRow row) {
        nowMillis = row.atMillis();
        SessionTelemetry.read(List.of(row), this);
    }

    /** What a session that is followed knows of a boat at this moment. */
    public void sample(BoatSample sample) {
        nowMillis = Math.max(nowMillis, sample.atMillis());
        Recorded boat = of(sample.boat());
        boat.live = Optional.of(sample);
        boat.link = sample.link();
        seen(sample.boat(), boat);
    }

    /** Shows boats that are linked as heard of now: the journal notes no message in which nothing changed. */
    public void show(long atMillis) {
        nowMillis = atMillis;
        boats.forEach((id, boat) -> {
            if (boat.link == LinkState.LINKED) {
                feed.stillSeen(snapshot(id, boat));
            }
        });
    }

    /** What a way of a boat depends on; empty where it is not known where it is, or the journal is from before errors were noted. */
    public Optional<BoatStart> start(String id) {
        return Optional.ofNullable(boats.get(id))
                .flatMap(boat ->
                        boat.pose.flatMap(pose -> boat.error.map(error -> new BoatStart(pose.position(), error))));
    }

    private Recorded of(String boat) {
        return boats.computeIfAbsent(boat, id -> {
            feed.happened(new FleetEvent.Found(id), nowMillis);
            return new Recorded();
        });
    }

    private void seen(String id, Recorded boat) {
        feed.seen(snapshot(id, boat));
    }

    private BoatSnapshot snapshot(String id, Recorded boat) {
        return boat.live.map(sample -> snapshot(boat, sample)).orElseGet(() -> asRecorded(id, boat));
    }

    private static BoatSnapshot snapshot(Recorded boat, BoatSample sample) {
        Optional<CommandQueueSnapshot.Entry> current = boat.queue.current();
        return new BoatSnapshot(
                sample.boat(),
                boat.link,
                sample.heardAtMillis(),
                sample.pose(),
                sample.poseAtMillis(),
                sample.battery(),
                boat.mode.or(sample::mode),
                sample.commander(),
                current.map(CommandQueueSnapshot.Entry::command),
                current.map(CommandQueueSnapshot.Entry::visited).orElse(0),
                current.map(CommandQueueSnapshot.Entry::points).orElse(0),
                new BoatExplanation(sample.shouldMove(), boat.why.cause(), sample.why()),
                Optional.empty(),
                sample.stop(),
                boat.wayHome,
                sample.settings(),
                sample.flies());
    }

    private BoatSnapshot asRecorded(String id, Recorded boat) {
        if (boat.link == LinkState.LINKED) {
            boat.heardAtMillis = OptionalLong.of(nowMillis);
            boat.poseAtMillis = nowMillis;
        }
        Optional<CommandQueueSnapshot.Entry> current = boat.queue.current();
        Optional<BatteryState> battery = boat.pose.isEmpty() && boat.level.isEmpty()
                ? Optional.empty()
                : Optional.of(new BatteryState(boat.percent, boat.level.orElse(BatteryLevel.NOMINAL)));
        return new BoatSnapshot(
                        id,
                        boat.link,
                        boat.heardAtMillis,
                        boat.pose,
                        boat.pose.isPresent() ? boat.poseAtMillis : 0,
                        battery,
                        boat.mode,
                        boat.commander,
                        current.map(CommandQueueSnapshot.Entry::command),
                        current.map(CommandQueueSnapshot.Entry::visited).orElse(0),
                        current.map(CommandQueueSnapshot.Entry::points).orElse(0),
                        boat.why,
                        boat.wayHome)
                .flying(boat.flew);
    }

    // ---- what sessions of all versions wrote

    /** The links of the process before ended with it. */
    @Override
    public void begun() {
        List.copyOf(boats.keySet()).forEach(this::gone);
    }

    @Override
    public void pose(long atMillis, String id, FleetHistory.Report report, double distanceM) {
        Recorded boat = of(id);
        boat.pose = Optional.of(
                new BoatPose(report.position(), report.headingRad(), report.speedMps(), report.boatTimeMs()));
        boat.flew |= report.position().altM() != 0;
        boat.poseAtMillis = atMillis;
        boat.percent = report.batteryPercent();
        seen(id, boat);
    }

    @Override
    public void linked(String id, String bootId) {
        Recorded boat = of(id);
        boat.link = LinkState.LINKED;
        seen(id, boat);
    }

    @Override
    public void lost(String id) {
        Recorded boat = of(id);
        boat.link = LinkState.LOST;
        seen(id, boat);
    }

    @Override
    public void message(OperatorMessage message) {
        messages.tell(message);
    }

    @Override
    public void reading(SensorValue reading) {
        feed.happened(
                new FleetEvent.Measured(
                        reading.boat(),
                        new BoatReading(
                                reading.sensor(),
                                reading.channel(),
                                reading.values(),
                                reading.unit(),
                                reading.position(),
                                reading.atMillis())),
                nowMillis);
    }

    // ---- what the session notes of what was shown of boats

    @Override
    public void other(TelemetryRow row, JsonNode json) {
        String id = row.proxy();
        switch (row.kind()) {
            case "command" -> commands.put(json.required("id").asText(), CommandJson.read(json));
            case "queue" -> queue(id, json);
            case "progress" -> progress(id, json);
            case "upload" -> upload(id, json);
            case "concluded" -> concluded(id, json);
            case "state" -> state(id, json);
            case "removed" -> gone(id);
            case PictureRows.TAKEN, PictureRows.PICTURE ->
                pictures.flatMap(kept -> kept.event(row, json)).ifPresent(event -> feed.happened(event, nowMillis));
            case OperatorLogRows.KIND -> feed.logged(OperatorLogRows.read(List.of(row)));
            default -> {
                // whoever wrote it did so for itself
            }
        }
    }

    private void queue(String id, JsonNode json) {
        Recorded boat = of(id);
        List<CommandQueueSnapshot.Entry> waiting = new ArrayList<>();
        json.path("waiting").forEach(entry -> entry(entry).ifPresent(waiting::add));
        boat.queue = new CommandQueueSnapshot(
                entry(json.path("current")),
                waiting,
                json.has("blockedBy") ? OptionalLong.of(json.get("blockedBy").asLong()) : OptionalLong.empty());
        feed.happened(new FleetEvent.QueueChanged(id, boat.queue), nowMillis);
        seen(id, boat);
    }

    private Optional<CommandQueueSnapshot.Entry> entry(JsonNode json) {
        return command(json)
                .map(command -> new CommandQueueSnapshot.Entry(
                        command,
                        json.path("visited").asInt(),
                        points(command),
                        TurnWait.because(json.path("why").asText())));
    }

    private Optional<BoatCommand> command(JsonNode json) {
        return Optional.ofNullable(commands.get(json.path("command").asText()));
    }

    private static int points(BoatCommand command) {
        return command instanceof FollowPath path ? path.points().size() : 0;
    }

    private void progress(String id, JsonNode json) {
        Recorded boat = of(id);
        int visited = json.required("visited").asInt();
        command(json).ifPresent(command -> {
            boat.queue = new CommandQueueSnapshot(
                    boat.queue
                            .current()
                            .map(entry -> entry.command().equals(command) ? entry.withVisited(visited) : entry),
                    boat.queue.waiting(),
                    boat.queue.blockedBy());
            feed.happened(new FleetEvent.Progressed(id, command, visited), nowMillis);
            seen(id, boat);
        });
    }

    private void upload(String id, JsonNode json) {
        Recorded boat = of(id);
        String list = json.required("list").asText();
        if (json.has("way")) {
            boat.way = CommandJson.points(json.get("way"));
        } else if (!list.equals(boat.list)) {
            boat.way = command(json).map(BoatCommand::points).orElse(List.of());
        }
        boat.list = list;
        Upload upload = new Upload(
                list,
                json.required("command").asText(),
                boat.way,
                Upload.State.valueOf(json.required("state").asText()),
                json.path("why").asText());
        feed.happened(new FleetEvent.UploadAdvanced(id, upload), nowMillis);
    }

    private void concluded(String id, JsonNode json) {
        String why = json.path("why").asText();
        command(json)
                .ifPresent(command -> feed.happened(
                        switch (json.required("end").asText()) {
                            case "completed" -> new FleetEvent.CommandCompleted(id, command);
                            case "failed" -> new FleetEvent.CommandFailed(id, command, why);
                            case "withdrawn" -> new FleetEvent.CommandWithdrawn(id, command, Withdrawal.valueOf(why));
                            default -> throw new IllegalArgumentException("a command ended '" + json + "'");
                        },
                        nowMillis));
    }

    private void state(String id, JsonNode json) {
        Recorded boat = of(id);
        boat.link = LinkState.valueOf(json.required("link").asText());
        boat.mode =
                json.has("mode") ? Optional.of(BoatMode.valueOf(json.get("mode").asText())) : Optional.empty();
        if (json.has("battery")) {
            boat.level = Optional.of(BatteryLevel.valueOf(json.get("battery").asText()));
        }
        boat.why = new BoatExplanation(
                json.required("shouldMove").asBoolean(),
                Cause.valueOf(json.required("cause").asText()),
                json.required("why").asText());
        boat.wayHome = CommandJson.points(json.path("wayHome"));
        boat.error = error(json.path("crossTrackError"));
        commander(id, boat, json);
        seen(id, boat);
    }

    private static Optional<CrossTrackError> error(JsonNode json) {
        return json.size() == 3
                ? Optional.of(new CrossTrackError(
                        json.get(0).asDouble(),
                        json.get(1).asDouble(),
                        json.get(2).asDouble()))
                : Optional.empty();
    }

    private void commander(String id, Recorded boat, JsonNode json) {
        boolean byHand = json.required("byHand").asBoolean();
        boolean wasByHand = boat.commander == Commander.BY_HAND;
        if (byHand != wasByHand) {
            feed.happened(byHand ? new FleetEvent.TakenOver(id) : new FleetEvent.HandedBack(id), nowMillis);
        }
        boat.commander = byHand
                ? Commander.BY_HAND
                : json.required("commanded").asBoolean()
                        ? Commander.THIS_BASE
                        : boat.why.cause() == Cause.COMMANDED_ELSEWHERE ? Commander.SOMEBODY_ELSE : Commander.UNKNOWN;
    }

    /** There is that boat no longer. */
    void gone(String id) {
        if (boats.remove(id) == null) {
            return;
        }
        feed.gone(id);
        feed.happened(new FleetEvent.Removed(id), nowMillis);
    }
}
