package org.sami.crw.session.fault;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;

/**
 * Says when the process has nearly no memory left: when of the last minute even the least that was used, which is what the collector could not free, is
 * nearly all there may be. For one thread.
 */
final class MemoryWatch {
    private static final int LOOKS = 60;
    private static final double NEARLY_ALL = HealthDefaults.MEMORY_FULL_SHARE;
    private static final double ENOUGH_FREE = 0.75;

    private final Deque<Long> used = new ArrayDeque<>();
    private boolean warned;

    /** What is to be done with the entry about memory. */
    enum Verdict {
        WELL,
        /** As it was. */
        SAME,
        NEARLY_NONE
    }

    /** Looks, once a second. */
    Verdict look(long usedBytes, long mostBytes) {
        used.add(usedBytes);
        if (used.size() < LOOKS) {
            return Verdict.SAME;
        }
        if (used.size() > LOOKS) {
            used.removeFirst();
        }
        long least = used.stream().mapToLong(Long::longValue).min().orElse(0);
        if (least > mostBytes * NEARLY_ALL) {
            warned = true;
            return Verdict.NEARLY_NONE;
        }
        if (least < mostBytes * ENOUGH_FREE) {
            warned = false;
            return Verdict.WELL;
        }
        return warned ? Verdict.NEARLY_NONE : Verdict.SAME;
    }

    static HealthFault nearlyNone(long mostBytes) {
        return HealthFault.ofSession(
                        HealthKind.MEMORY,
                        Priority.HIGH,
                        String.format(
                                Locale.ROOT, "The program has nearly used up its memory of %d MB", mostBytes >> 20),
                        "Close what is not needed, such as large base maps")
                .withDetails("Start it with more memory the next time (JAVA_OPTS=-Xmx2g)");
    }
}
