package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import java.util.function.UnaryOperator;
import org.sami.crw.manipulation.ManipulationPolicy;
import org.sami.crw.manipulation.Ruling;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.message.MessageGroup;
import org.sami.crw.message.OperatorMessage;

/**
 * The messages to the operator: the highest priority first, of equal ones the newest first, so that news of little weight does
 * not displace an older critical message. A message replaces the one with the same subject (thesis 6.3.4), and has to be acknowledged
 * again. When the list is full the last one in order goes.
 */
public final class MessageList extends Model<List<MessageEntry>> {
    private static final String COMPONENT = "message list";
    private static final Comparator<MessageEntry> ORDER = Comparator.comparing(
                    (MessageEntry entry) -> entry.message().priority())
            .thenComparingLong(MessageEntry::number)
            .reversed();

    private final int capacity;
    private final Consumer<Runnable> inbox;
    private final OperatorLog log;
    private final TreeSet<MessageEntry> entries = new TreeSet<>(ORDER);
    private final Set<String> muted = new HashSet<>();
    private final ManipulationPolicy policy;
    private final List<Later> waiting = new ArrayList<>();
    private long told;
    private volatile Optional<LongConsumer> elsewhere = Optional.empty(); // acknowledges there

    /** A message whose event waits until it may change the list again. */
    private record Later(OperatorMessage message, long atMillis) {}

    /**
     * A list that keeps so many messages at most.
     *
     * @param inbox brings changes to the owner's thread
     * @param log where the operator's acknowledgements go
     * @param nowMillis the session's clock
     */
    MessageList(int capacity, Consumer<Runnable> inbox, OperatorLog log, LongSupplier nowMillis) {
        super(List.of());
        policy = new ManipulationPolicy(nowMillis);
        if (capacity < 1) {
            throw new IllegalArgumentException("A message list keeps at least one message, not " + capacity);
        }
        this.capacity = capacity;
        this.inbox = inbox;
        this.log = log;
    }

    /**
     * From now on the list is kept by a session elsewhere: it is {@link #show(List) shown} as it is there, nothing else is added, and acknowledgements are given to
     * that session. On the owner's thread.
     */
    void follow(LongConsumer acknowledge) {
        elsewhere = Optional.of(acknowledge);
    }

    /** These are all messages of the session that is followed. On the owner's thread. */
    void show(List<MessageEntry> all) {
        entries.clear();
        all.forEach(entry -> entries.add(new MessageEntry(
                entry.number(),
                entry.message(),
                entry.count(),
                entry.acknowledged(),
                muted.contains(entry.message().keyword()))));
        change();
    }

    /** A message came: it is shown now, or later, or not at all, as the meta-markup of its event says (thesis 5.3). */
    void add(OperatorMessage message) {
        if (elsewhere.isPresent()) {
            return;
        }
        OperatorMessage.Manipulation manipulation = message.manipulation();
        if (manipulation.limits().isEmpty()) {
            show(message);
            return;
        }
        Ruling ruling = policy.rule(source(message), manipulation.limits());
        if (ruling.kind() == Ruling.Kind.NOW) {
            show(message);
        } else if (ruling.kind() == Ruling.Kind.LATER) {
            waiting.add(new Later(message, ruling.untilMillis()));
        }
    }

    private static ManipulationPolicy.Source source(OperatorMessage message) {
        return new ManipulationPolicy.Source(COMPONENT, message.manipulation().event());
    }

    /** Time has passed: messages whose waiting time is up are shown together. */
    void tick(long nowMillis) {
        for (Later later : List.copyOf(waiting)) {
            if (later.atMillis() <= nowMillis) {
                waiting.remove(later);
                Ruling ruling = policy.due(
                        source(later.message()), later.message().manipulation().limits());
                if (ruling.kind() == Ruling.Kind.NOW) {
                    show(later.message());
                }
            }
        }
    }

    /** The operator has used the list: scrolled, typed or pressed there. From any thread. */
    public void touched() {
        inbox.accept(() -> policy.touched(COMPONENT));
    }

    /** The operator's focus has come to the list, or left it. From any thread. */
    public void focus(boolean on) {
        inbox.accept(() -> policy.focus(COMPONENT, on));
    }

    private void show(OperatorMessage message) {
        told++;
        Optional<MessageEntry> replaced = message.subject()
                .flatMap(subject -> entries.stream()
                        .filter(entry -> entry.message().subject().equals(Optional.of(subject)))
                        .findFirst());
        replaced.ifPresent(entries::remove);
        int count = 1 + replaced.map(MessageEntry::count).orElse(0);
        entries.add(new MessageEntry(told, message, count, false, muted.contains(message.keyword())));
        if (entries.size() > capacity) {
            entries.pollLast();
        }
        change();
    }

    /** Forgets the messages, not which are muted. */
    void clear() {
        entries.clear();
        waiting.clear();
        told = 0;
        change();
    }

    /** The operator knows a message; one that is gone changes nothing. From any thread; done a little later. */
    public void acknowledge(long number) {
        touched();
        if (elsewhere.isPresent()) {
            elsewhere.get().accept(number);
            return;
        }
        inbox.accept(() -> replace(entry -> entry.number() == number ? acknowledged(entry) : entry));
    }

    private MessageEntry acknowledged(MessageEntry entry) {
        OperatorMessage message = entry.message();
        if (!entry.acknowledged()) {
            log.add(
                    OperatorLogEntry.Kind.ACKNOWLEDGED,
                    "message " + entry.number() + ": " + message.text(),
                    message.mission(),
                    message.boats());
        }
        return new MessageEntry(entry.number(), message, entry.count(), true, entry.muted());
    }

    /** Messages with a keyword are muted from now on, or no longer; those without one cannot be. From any thread. */
    public void mute(String keyword, boolean mute) {
        if (keyword.isEmpty()) {
            throw new IllegalArgumentException("Only messages with a keyword can be muted");
        }
        inbox.accept(() -> {
            if (mute) {
                muted.add(keyword);
            } else {
                muted.remove(keyword);
            }
            replace(entry -> entry.message().keyword().equals(keyword)
                    ? new MessageEntry(entry.number(), entry.message(), entry.count(), entry.acknowledged(), mute)
                    : entry);
        });
    }

    private void replace(UnaryOperator<MessageEntry> with) {
        List<MessageEntry> after = new ArrayList<>();
        entries.forEach(entry -> after.add(with.apply(entry)));
        entries.clear();
        entries.addAll(after);
        change();
    }

    @Override
    List<MessageEntry> take() {
        return List.copyOf(entries);
    }

    /** The messages that are kept, in groups by keyword. From any thread. */
    public List<MessageGroup> groups() {
        return MessageGroup.of(snapshot());
    }

    /** The messages that are kept, in order. From any thread. */
    public List<OperatorMessage> messages() {
        return snapshot().stream().map(MessageEntry::message).toList();
    }
}
