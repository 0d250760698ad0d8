package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;

/**
 * The messages to the operator: the highest priority first, of equal ones the newest first, so that news of little weight does
 * not displace an older critical message. A message replaces the one with the same keyword (thesis 6.3.4). When the list is
 * full the last one in order goes. Owned by one thread.
 */
public final class MessageList {
    private static final Comparator<Entry> ORDER = Comparator.comparing(
                    (Entry entry) -> entry.message().priority())
            .thenComparingLong(Entry::number)
            .reversed();

    private final int capacity;
    private final TreeSet<Entry> entries = new TreeSet<>(ORDER);
    private final ListenerList<Consumer<OperatorMessage>> listeners = new ListenerList<>();
    private long told;

    /** A list that keeps so many messages at most. */
    public MessageList(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("A message list keeps at least one message, not " + capacity);
        }
        this.capacity = capacity;
    }

    /** Adds a message. */
    public void add(OperatorMessage message) {
        told++;
        if (!message.keyword().isEmpty()) {
            entries.removeIf(entry -> entry.message().keyword().equals(message.keyword()));
        }
        entries.add(new Entry(told, message));
        if (entries.size() > capacity) {
            entries.pollLast();
        }
        listeners.each(listener -> listener.accept(message));
    }

    /** The messages that are kept, in order. */
    public List<OperatorMessage> messages() {
        List<OperatorMessage> messages = new ArrayList<>(entries.size());
        entries.forEach(entry -> messages.add(entry.message()));
        return messages;
    }

    /** How many messages there were in all, replaced and dropped ones included. */
    public long told() {
        return told;
    }

    /** Adds a listener, called on the owning thread after each message; closing the result takes it away. */
    public Registration addListener(Consumer<OperatorMessage> listener) {
        return listeners.add(listener);
    }

    private record Entry(long number, OperatorMessage message) {}
}
