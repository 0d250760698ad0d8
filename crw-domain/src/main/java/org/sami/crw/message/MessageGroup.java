package org.sami.crw.message;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * The messages with one keyword (markup Keyword), or those without any.
 *
 * @param keyword empty text for those without
 * @param entries in the order of the list: the most urgent first, of equal ones the newest; at least one
 */
public record MessageGroup(String keyword, List<MessageEntry> entries) {
    public MessageGroup {
        Objects.requireNonNull(keyword, "keyword");
        entries = List.copyOf(entries);
        if (entries.isEmpty()) {
            throw new IllegalArgumentException("A group without messages");
        }
    }

    /** Messages in groups; the group that has the first message of the list comes first. */
    public static List<MessageGroup> of(List<MessageEntry> entries) {
        Map<String, List<MessageEntry>> byKeyword = new LinkedHashMap<>();
        entries.forEach(entry -> byKeyword
                .computeIfAbsent(entry.message().keyword(), keyword -> new ArrayList<>())
                .add(entry));
        return byKeyword.entrySet().stream()
                .map(group -> new MessageGroup(group.getKey(), group.getValue()))
                .toList();
    }

    /** How many messages there were, those that were replaced included. */
    public int count() {
        return entries.stream().mapToInt(MessageEntry::count).sum();
    }

    /** How many of those that are there the operator has not acknowledged. */
    public int unacknowledged() {
        return (int) entries.stream().filter(entry -> !entry.acknowledged()).count();
    }

    /** The message that came last. */
    public MessageEntry newest() {
        return entries.stream()
                .max(Comparator.comparingLong(MessageEntry::number))
                .orElseThrow();
    }

    /** The boats that its messages are about, each once. */
    public Set<String> boats() {
        Set<String> boats = new LinkedHashSet<>();
        entries.forEach(entry -> boats.addAll(entry.message().boats()));
        return boats;
    }

    /** Whether its messages are muted. */
    public boolean muted() {
        return entries.get(0).muted();
    }
}
