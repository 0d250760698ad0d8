package org.sami.mavlink.onboard;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** How often each message is sent by itself, and which are due. For one thread. */
final class MessageStreams {
    static final int HEARTBEAT = 0;
    static final int STATUS = 1;
    static final int GPS = 24;
    static final int ATTITUDE = 30;
    static final int POSITION = 33;
    static final int MISSION = 42;
    static final int HUD = 74;
    static final int BATTERY = 147;
    static final int FENCE = 162;
    static final int FILTER = 193;
    static final int HOME = 242;

    private static final long SHORTEST_MS = 100; // a boat's server ticks so often
    private static final long NEVER = Long.MAX_VALUE;
    private static final long SECOND_MS = 1_000;
    private static final Map<Integer, Long> USUAL = usual();
    /** The groups of the older way to ask, REQUEST_DATA_STREAM. */
    private static final Map<Integer, List<Integer>> GROUPS = Map.of(
            2, List.of(STATUS, GPS, MISSION, BATTERY, FENCE),
            6, List.of(POSITION),
            10, List.of(ATTITUDE),
            11, List.of(HUD),
            12, List.of(FILTER));

    private final Map<Integer, Long> every = new LinkedHashMap<>(USUAL);
    private final Map<Integer, Long> dueMs = new HashMap<>();

    private static Map<Integer, Long> usual() {
        Map<Integer, Long> usual = new LinkedHashMap<>();
        usual.put(HEARTBEAT, SECOND_MS);
        usual.put(POSITION, SECOND_MS / 4);
        usual.put(ATTITUDE, SECOND_MS / 4);
        usual.put(HUD, SECOND_MS / 2);
        usual.put(STATUS, SECOND_MS);
        usual.put(GPS, SECOND_MS);
        usual.put(MISSION, SECOND_MS);
        usual.put(FENCE, SECOND_MS);
        usual.put(FILTER, SECOND_MS);
        usual.put(BATTERY, 2 * SECOND_MS);
        usual.put(HOME, 10 * SECOND_MS);
        return usual;
    }

    /** The messages that are to be sent now. */
    List<Integer> due(long nowMs) {
        List<Integer> due = new ArrayList<>();
        every.forEach((message, period) -> {
            if (period != NEVER && nowMs >= dueMs.getOrDefault(message, Long.MIN_VALUE)) {
                due.add(message);
                long next = dueMs.getOrDefault(message, nowMs) + period;
                dueMs.put(message, next > nowMs ? next : nowMs + period);
            }
        });
        return due;
    }

    /** The interval of a message in microseconds, -1 where it is not sent by itself; empty where there is none of this number. */
    Optional<Integer> intervalUs(int message) {
        return Optional.ofNullable(every.get(message)).map(period -> period == NEVER ? -1 : (int) (period * 1000));
    }

    /**
     * Sets the interval of a message.
     *
     * @param us microseconds; 0 for the usual interval, negative for never. Shorter ones than a tenth of a second are that
     * @return whether it can be: heartbeats come once a second whatever is asked for
     */
    boolean set(int message, double us, long nowMs) {
        Long usual = USUAL.get(message);
        if (usual == null || Double.isNaN(us) || message == HEARTBEAT) {
            return false;
        }
        long period = us < 0 ? NEVER : us == 0 ? usual : Math.max(SHORTEST_MS, Math.round(us / 1000));
        every.put(message, period);
        dueMs.put(message, nowMs);
        return true;
    }

    /** Sets the rate of a group of messages; group 0 are all, rate 0 none. */
    void setGroup(int group, int hz, boolean starts, long nowMs) {
        GROUPS.forEach((number, messages) -> {
            if (group == 0 || group == number) {
                messages.forEach(message -> set(message, starts && hz > 0 ? 1e6 / hz : -1, nowMs));
            }
        });
    }
}
