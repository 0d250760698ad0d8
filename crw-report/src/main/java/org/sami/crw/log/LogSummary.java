package org.sami.crw.log;

import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What a log holds, in numbers.
 *
 * @param source the file, as it was named
 * @param entries lines that were understood
 * @param firstClock the phone's time of day at the first entry, as written
 * @param durationMillis from the first entry to the latest
 * @param topics how many entries of each topic, in the order in which they first came
 * @param poses where the boat took itself to be
 * @param fixes raw satellite fixes
 */
public record LogSummary(
        String source,
        long bytes,
        long lines,
        long entries,
        String firstClock,
        long durationMillis,
        Map<String, Long> topics,
        LoggedTrack poses,
        LoggedTrack fixes,
        List<ChannelSummary> channels,
        List<FaultCount> problems) {
    public LogSummary {
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(firstClock, "firstClock");
        Objects.requireNonNull(topics, "topics");
        Objects.requireNonNull(poses, "poses");
        Objects.requireNonNull(fixes, "fixes");
        channels = List.copyOf(channels);
        problems = List.copyOf(problems);
    }

    /** How many lines could not be used. */
    public long unreadLines() {
        return problems.stream()
                .filter(p -> p.fault().unread())
                .mapToLong(FaultCount::count)
                .sum();
    }
}
