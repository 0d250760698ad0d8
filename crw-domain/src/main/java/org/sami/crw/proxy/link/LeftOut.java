package org.sami.crw.proxy.link;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Messages of a boat that the base left out because they were too many.
 *
 * @param active whether the boat still sends too much
 * @param counts number of messages left out since it began, by kind in words
 */
public record LeftOut(boolean active, Map<String, Long> counts) {
    public LeftOut {
        counts = Collections.unmodifiableMap(new LinkedHashMap<>(counts));
    }

    /** How many messages were left out. */
    public long total() {
        return counts.values().stream().mapToLong(Long::longValue).sum();
    }

    /** All of it in a sentence without a full stop. */
    public String words(String boat) {
        String what = counts.entrySet().stream()
                .map(one -> one.getValue() + " " + one.getKey())
                .collect(Collectors.joining(", "));
        return active
                ? boat + " sends more than this base takes; left out so far: " + what
                : boat + " no longer sends more than this base takes; left out were " + what;
    }
}
