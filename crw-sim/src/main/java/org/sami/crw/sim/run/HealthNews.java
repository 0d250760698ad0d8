package org.sami.crw.sim.run;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.host.Registration;

/**
 * Prints faults of the session itself (engine, journal, disk, memory, threads) and missions that cannot go on: when they begin, become worse and end.
 * Faults of boats are reported elsewhere. Called on the models' thread.
 */
public final class HealthNews implements AutoCloseable {
    private static final Set<HealthKind> SESSION_KINDS = EnumSet.of(
            HealthKind.ENGINE,
            HealthKind.JOURNAL,
            HealthKind.DISK,
            HealthKind.MEMORY,
            HealthKind.THREAD,
            HealthKind.MISSION);

    private final Consumer<String> out;
    private final Map<Long, HealthEntry> shown = new HashMap<>(); // by number
    private final Registration registration;

    /** Prints faults that begin from now on. */
    public HealthNews(OperatorModels models, Consumer<String> out) {
        this.out = Objects.requireNonNull(out, "out");
        registration = models.health().addListener(this::show);
    }

    private void show(Health health) {
        Set<Long> now = new HashSet<>();
        for (HealthEntry entry : health.entries()) {
            if (SESSION_KINDS.contains(entry.fault().kind())) {
                now.add(entry.number());
                HealthEntry before = shown.get(entry.number());
                if (before == null || before.severity().compareTo(entry.severity()) < 0) {
                    shown.put(entry.number(), entry);
                    out.accept("FAULT: " + entry.fault().text());
                    out.accept("    " + entry.fault().advice());
                    if (!entry.fault().details().isEmpty()) {
                        out.accept("    " + entry.fault().details());
                    }
                }
            }
        }
        boolean stopped = !health.of(HealthKind.ENGINE).isEmpty();
        shown.values().removeIf(entry -> {
            boolean over = !now.contains(entry.number());
            if (over && !stopped) { // the engine has stopped: no fault is over
                out.accept("over: " + entry.fault().text());
            }
            return over;
        });
    }

    @Override
    public void close() {
        registration.close();
    }
}
