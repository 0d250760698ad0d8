package org.sami.session.server;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Base64;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.sami.crw.session.Session;
import org.sami.session.follow.FollowJson;
import org.sami.session.record.LostLinkWishRows;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostState;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.Registration;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/**
 * A session's inputs and telemetry since this server began, for fronts that follow it with an engine of their own (docs/session-link.md, Following). Each has a number;
 * the latest are kept, so that a front which was cut off goes on where it was. Safe for use by several threads.
 */
final class JournalFeed implements HostListener, AutoCloseable {
    /** So many of the latest are kept. */
    static final int KEPT = 20_000;

    private static final int MOST_IN_MESSAGE = 1000;

    private final String id = UUID.randomUUID().toString();
    private final Session session;
    private final RecentTelemetry rows = new RecentTelemetry();
    private final Map<String, String> documents = new LinkedHashMap<>(); // of loaded projects, by SHA-256
    private final Queue<Item> arrived = new ConcurrentLinkedQueue<>(); // without numbers yet
    private final Deque<Item> items = new ArrayDeque<>();
    private List<Registration> registrations = List.of();
    private long last;

    /** An input, or a row. */
    private record Item(long number, Optional<JournalEntry> entry, Optional<TelemetryRow> row) {
        ObjectNode json() {
            return entry.map(FollowJson::write).orElseGet(() -> FollowJson.write(row.orElseThrow()));
        }
    }

    /** A feed of a session that has not begun. */
    JournalFeed(Session session) {
        this.session = session;
    }

    /**
     * Begins; before the session does.
     *
     * @throws IOException if the session's journal cannot be read
     */
    void start() throws IOException {
        session.setup().journal().earlier().forEach(row -> rows.take(0, row));
        documents.putAll(session.setup().journal().earlierDocuments());
        registrations = List.of(session.telemetry().addListener(this::take), session.addListener(this));
    }

    @Override
    public void close() {
        registrations.forEach(Registration::close);
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        arrived.add(new Item(0, Optional.of(new JournalEntry(index, atMillis, input)), Optional.empty()));
    }

    private void remember(Input input) {
        if (input instanceof Input.LoadProject load) {
            documents.put(load.sha256(), load.document());
        }
    }

    private void take(TelemetryRow row) {
        arrived.add(new Item(0, Optional.empty(), Optional.of(row)));
    }

    /** Takes up what has arrived; to be called several times a second. */
    synchronized void takeUp() {
        for (Item next = arrived.poll(); next != null; next = arrived.poll()) {
            items.add(new Item(++last, next.entry(), next.row()));
            next.entry().ifPresent(entry -> remember(entry.input()));
            next.row().ifPresent(row -> rows.take(last, row));
            if (items.size() > KEPT) {
                items.poll();
            }
        }
    }

    /** Whether a front that has this session's feed up to a number can go on from there. */
    synchronized boolean has(String session, long number) {
        takeUp();
        long first = items.isEmpty() ? last + 1 : items.element().number();
        return session.equals(id) && number >= first - 1 && number <= last;
    }

    /** A message with the items after a number, at most as many as one message holds; empty where there are none. Its {@code n} is the number of its last item. */
    synchronized Optional<ObjectNode> after(long number) {
        takeUp();
        if (number >= last) {
            return Optional.empty();
        }
        ObjectNode message = JsonNodeFactory.instance.objectNode().put("t", "journal");
        ArrayNode list = message.putArray("items");
        long reached = number;
        for (Item item : newer(number)) {
            if (list.size() < MOST_IN_MESSAGE) {
                list.add(item.json());
                reached = item.number();
            }
        }
        return Optional.of(message.put("n", reached));
    }

    private Deque<Item> newer(long number) {
        Deque<Item> newer = new ArrayDeque<>();
        for (Iterator<Item> back = items.descendingIterator(); back.hasNext(); ) {
            Item item = back.next();
            if (item.number() <= number) {
                break;
            }
            newer.addFirst(item);
        }
        return newer;
    }

    /** What is wished now, which may stand in the journal's settings alone; a later change is also an item. */
    private TelemetryRow wish(long nowMillis) {
        String wish = LostLinkWishRows.json(session.fleet().lostLinkWish()).toString();
        return new TelemetryRow(nowMillis, "", LostLinkWishRows.KIND, wish);
    }

    /** Whether items after a number, which a front at that number lacks, are kept no longer. */
    synchronized boolean lacks(long number) {
        return !has(id, number);
    }

    /** A message with all that somebody needs who begins with a state of now. */
    ObjectNode beginning(JournalHeader header, HostState state, long nowMillis) {
        ObjectNode message = JsonNodeFactory.instance.objectNode().put("t", "session");
        message.put("session", id).put("index", state.index()).put("now", nowMillis);
        message.set("header", FollowJson.write(header));
        message.put("state", Base64.getEncoder().encodeToString(state.state()));
        synchronized (this) {
            takeUp();
            long number = items.stream()
                    .filter(item -> item.entry()
                            .filter(entry -> entry.index() > state.index())
                            .isPresent())
                    .mapToLong(item -> item.number() - 1)
                    .findFirst()
                    .orElse(last);
            message.put("n", number);
            documents.forEach(message.putObject("documents")::put);
            ArrayNode list = message.putArray("rows");
            rows.upTo(number).forEach(row -> list.add(FollowJson.write(row)));
            list.add(FollowJson.write(wish(nowMillis)));
        }
        return message;
    }
}
