package org.sami.crw.operator;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.fleet.RobotKind;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;

/**
 * What operators did in the session, oldest first: every action that was carried out, and free notes. The latest entries are here; all of
 * them are where the session keeps them. Entries may be added from any thread.
 */
public final class OperatorLog extends Model<List<OperatorLogEntry>> {
    private static final int KEPT = 2000;

    private final Consumer<Runnable> inbox;
    private final LongSupplier nowMillis;
    private final RobotKind robots;
    private final AtomicLong numbers = new AtomicLong();
    private final Deque<OperatorLogEntry> entries = new ArrayDeque<>();
    private volatile Consumer<OperatorLogEntry> keeper = entry -> {};

    /** The log of a session of boats. */
    OperatorLog(Consumer<Runnable> inbox, LongSupplier nowMillis) {
        this(inbox, nowMillis, RobotKind.BOAT);
    }

    /** @param robots what entries about robots call them */
    OperatorLog(Consumer<Runnable> inbox, LongSupplier nowMillis, RobotKind robots) {
        super(List.of());
        this.inbox = inbox;
        this.nowMillis = nowMillis;
        this.robots = robots;
    }

    /** From now on each entry is given to somebody who keeps it; on the thread that adds it, so it must not wait. */
    public void keepWith(Consumer<OperatorLogEntry> newKeeper) {
        keeper = newKeeper;
    }

    /** Takes up what earlier processes of the session kept, in order; before anything is added. */
    public void restore(List<OperatorLogEntry> earlier) {
        earlier.forEach(entry -> numbers.accumulateAndGet(entry.number(), Math::max));
        inbox.accept(() -> earlier.forEach(this::keep));
    }

    /** Forgets all here; who keeps them keeps them. On the owner's thread. */
    void clear() {
        entries.clear();
        change();
    }

    /** An operator did something. */
    public void add(OperatorLogEntry.Kind kind, String text, String... boats) {
        add(kind, text, Ids.NONE, List.of(boats));
    }

    /** An operator did something that concerned a mission. */
    public void add(OperatorLogEntry.Kind kind, String text, long mission, List<String> boats) {
        add(kind, text, mission, boats, Optional.empty());
    }

    /** An operator wrote something down, maybe about a place. */
    public void note(String text, Optional<GeoPoint> position) {
        add(OperatorLogEntry.Kind.NOTE, text, Ids.NONE, List.of(), position);
    }

    private void add(
            OperatorLogEntry.Kind kind, String text, long mission, List<String> boats, Optional<GeoPoint> position) {
        OperatorLogEntry entry = new OperatorLogEntry(
                numbers.incrementAndGet(),
                nowMillis.getAsLong(),
                kind,
                kind == OperatorLogEntry.Kind.BOAT ? robots.say(text) : text, // others have words of plans and people
                mission,
                boats.stream().filter(boat -> !boat.isEmpty()).toList(),
                position);
        keeper.accept(entry);
        inbox.accept(() -> keep(entry));
    }

    private void keep(OperatorLogEntry entry) {
        entries.add(entry);
        if (entries.size() > KEPT) {
            entries.poll();
        }
        change();
    }

    @Override
    List<OperatorLogEntry> take() {
        return List.copyOf(entries);
    }
}
