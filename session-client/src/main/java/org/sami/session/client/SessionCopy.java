package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import org.sami.crw.operator.FollowFeed;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.session.follow.BoatSample;
import org.sami.session.follow.FollowJson;
import org.sami.session.follow.FollowedSession;
import org.sami.spn.engine.RuleVersion;
import org.sami.spn.host.HostState;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.json.UnreadableJsonException;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** This process's copy of a session in another process. The server's first message makes it, later messages update it. For the link's thread, except the clock. */
final class SessionCopy {
    private final JournalHeader header;
    private final FollowedSession followed;
    private final RemotePictures pictures;
    private final LinkTables tables = new LinkTables();
    private final Set<String> boats = new HashSet<>();
    private final Map<String, BoatTuning> settings = new HashMap<>(); // by boat
    private String id = "";
    private long reached; // number of the last item of the server's feed
    private volatile long clockMillis; // of the session, at the next
    private volatile long clockNanos = System.nanoTime();

    /**
     * A copy of the session that a message {@code session} is about, without its state.
     *
     * @throws IOException in words, if this program cannot read its plans
     */
    SessionCopy(
            JsonNode message,
            String where,
            Executor owner,
            Executor computing,
            FollowFeed.Acknowledgements acknowledge,
            RemotePictures pictures)
            throws IOException {
        this.pictures = pictures;
        header = FollowJson.header(message.path("header"));
        Optional<String> other = RuleVersion.difference(header.settings());
        if (other.isPresent()) {
            throw new IOException(where + ": " + other.get());
        }
        JournalAddress named = JournalAddress.of(Path.of("session"));
        Vocabulary vocabulary = JournalPlans.vocabulary(named, header);
        Project project = JournalPlans.project(named, header, vocabulary);
        clock(message.path("now").asLong());
        followed = new FollowedSession(
                vocabulary, project, owner, this::nowMillis, computing, acknowledge, pictures.folder());
    }

    /** Whether a message is about a session of these plans. */
    boolean isOf(JsonNode message) {
        return header.equals(FollowJson.header(message.path("header")));
    }

    FollowedSession followed() {
        return followed;
    }

    /** The server's name for the session's run; empty text before the first. */
    String id() {
        return id;
    }

    /** The number of the last item that is known here. */
    long reached() {
        return reached;
    }

    /** The session's time. From any thread. */
    long nowMillis() {
        return clockMillis + TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - clockNanos);
    }

    private void clock(long millis) {
        clockNanos = System.nanoTime();
        clockMillis = millis;
    }

    /** Begins with the state of a message {@code session}. */
    void begin(JsonNode message) {
        clock(message.path("now").asLong());
        List<TelemetryRow> rows = new ArrayList<>();
        message.path("rows").forEach(row -> rows.add(FollowJson.row(row)));
        List<TelemetryRow> held =
                rows.stream().filter(RemotePictures::isHeldBack).toList();
        rows.removeAll(held);
        HostState state = new HostState(
                message.path("index").asLong(),
                Base64.getDecoder().decode(message.path("state").asText()));
        followed.begin(state, FollowJson.texts(message.path("documents")), rows);
        id = message.path("session").asText();
        reached = message.path("n").asLong();
        boats.clear();
        pictures.restart();
        held.forEach(this::fetch);
    }

    /**
     * Takes a message {@code journal}.
     *
     * @throws UnreadableJsonException if this program does not know an input in it
     */
    void journal(JsonNode message) throws UnreadableJsonException {
        for (JsonNode item : message.path("items")) {
            if (FollowJson.isEntry(item)) {
                followed.take(FollowJson.entry(item));
            } else {
                TelemetryRow row = FollowJson.row(item);
                if (RemotePictures.isHeldBack(row)) {
                    fetch(row);
                } else {
                    followed.take(row);
                }
            }
        }
        reached = message.path("n").asLong();
        followed.look();
    }

    private void fetch(TelemetryRow row) {
        pictures.fetch(
                row, here -> followed.take(new TelemetryRow(nowMillis(), here.proxy(), here.kind(), here.json())));
    }

    /** Takes a message {@code rows}. */
    void rows(JsonNode message) {
        long now = message.path("now").asLong();
        clock(now);
        Set<String> changed = tables.take(message);
        FollowFeed feed = followed.feed();
        if (changed.contains("settings")) {
            settings.clear();
            tables.rows("settings")
                    .forEach(row -> LinkRowReader.settings(row)
                            .ifPresent(known -> settings.put(row.path("id").asText(), known)));
        }
        if (changed.contains("settings")) { // they are shown with the rest of a boat, which may be as it was
            boats(tables.rows("boats"), now);
        } else if (changed.contains("boats")) {
            boats(message.path("set").path("boats"), now);
        }
        if (changed.contains("messages")) {
            feed.messages(
                    tables.rows("messages").stream().map(LinkRowReader::message).toList());
        }
        if (changed.contains("alarms")) {
            feed.alarms(tables.rows("alarms").stream().map(LinkRowReader::alarm).toList());
        }
        if (changed.contains("faults")) {
            feed.faults(tables.rows("faults").stream().map(LinkRowReader::fault).toList());
        }
        if (changed.contains("stuck")) {
            feed.stuck(tables.rows("stuck").stream().map(LinkRowReader::stuck).toList());
        }
        if (changed.contains("unreached")) {
            feed.unreached(tables.rows("unreached").stream()
                    .map(LinkRowReader::unreached)
                    .toList());
        }
        if (changed.contains("fleet")) {
            tables.rows("fleet")
                    .forEach(row -> feed.stopsEveryBoat(row.path("every").asBoolean()));
        }
        followed.look();
    }

    /** Whether the base reports that no mission of the session goes on. */
    boolean standsStill() {
        return tables.rows("fleet").stream()
                .anyMatch(row -> row.path("standStill").asBoolean());
    }

    /** The rows of the session's bases. */
    List<JsonNode> bases() {
        return tables.rows("bases");
    }

    private void boats(Iterable<JsonNode> rows, long now) {
        for (JsonNode row : rows) {
            Optional<BoatSample> sample = LinkRowReader.boat(
                    row, now, Optional.ofNullable(settings.get(row.path("id").asText())));
            sample.ifPresent(one -> {
                boats.add(one.boat());
                followed.take(one);
            });
        }
        Set<String> present = new HashSet<>();
        tables.rows("boats").forEach(row -> present.add(row.path("id").asText()));
        for (String gone : List.copyOf(boats)) {
            if (!present.contains(gone)) {
                boats.remove(gone);
                followed.gone(gone);
            }
        }
    }
}
