package org.sami.crw.operator;

import java.util.Comparator;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Ids;

/**
 * The health of a session: every fault that lasts, from when it begins until it is over, never shorter (decision 0390). Whoever finds a fault reports it, and
 * says when it is over; active alarms are faults as well.
 */
public final class HealthModel extends Model<Health> {
    private static final Comparator<HealthEntry> ORDER = Comparator.comparing(HealthEntry::severity)
            .reversed()
            .thenComparing(entry ->
                    entry.fault().kind() != HealthKind.FLEET_STOP) // that nobody moves comes before all of its severity
            .thenComparingLong(HealthEntry::sinceMillis)
            .thenComparingLong(HealthEntry::number);

    /** What alarms are faults of. */
    private static final Set<HealthKind> OF_ALARMS = EnumSet.of(HealthKind.ALARM, HealthKind.DRIFT);

    private final Consumer<Runnable> inbox;
    private final LongSupplier nowMillis;
    private final RobotKind robots;
    private final Map<Key, HealthEntry> entries = new LinkedHashMap<>();
    private long reported;

    private record Key(HealthKind kind, String subject) {
        static Key of(HealthFault fault) {
            return new Key(fault.kind(), fault.subject());
        }
    }

    /** @param robots what faults are about */
    HealthModel(Consumer<Runnable> inbox, LongSupplier nowMillis, RobotKind robots) {
        super(Health.WELL);
        this.inbox = inbox;
        this.nowMillis = nowMillis;
        this.robots = robots;
    }

    /** A fault is there from now on, or is still there, maybe in other words. From any thread. */
    public void report(HealthFault fault) {
        long now = nowMillis.getAsLong();
        inbox.accept(() -> put(fault, now));
    }

    /** As {@link #report(HealthFault)}, for a fault that began earlier, on the session's clock. From any thread. */
    public void report(HealthFault fault, long sinceMillis) {
        inbox.accept(() -> put(fault, sinceMillis));
    }

    /** A fault is over; one that is not there changes nothing. From any thread. */
    public void over(HealthKind kind, String subject) {
        inbox.accept(() -> {
            if (entries.remove(new Key(kind, subject)) != null) {
                change();
            }
        });
    }

    // ---- on the owner's thread

    /** These are the alarms now. */
    void alarms(List<Alarm> now) {
        Set<Key> active = new HashSet<>();
        for (Alarm alarm : now) {
            if (alarm.active()) {
                HealthFault fault = fault(alarm);
                active.add(Key.of(fault));
                put(fault, alarm.sinceMillis());
            }
        }
        if (entries.keySet().removeIf(key -> OF_ALARMS.contains(key.kind()) && !active.contains(key))) {
            change();
        }
    }

    private static HealthFault fault(Alarm alarm) {
        if (alarm.kind() == Alarm.Kind.DRIFT) {
            return HealthFault.ofBoat(
                    HealthKind.DRIFT,
                    alarm.boat(),
                    alarm.kind().severity(),
                    alarm.text(),
                    alarm.kind().advice());
        }
        String subject = alarm.kind() + " " + alarm.boat() + (alarm.other().isEmpty() ? "" : " " + alarm.other());
        return new HealthFault(
                HealthKind.ALARM,
                subject,
                alarm.kind().severity(),
                alarm.text(),
                alarm.kind().advice(),
                "",
                alarm.boat(),
                Ids.NONE);
    }

    private void put(HealthFault given, long sinceMillis) {
        HealthFault fault = given.inWordsFor(robots);
        HealthEntry before = entries.get(Key.of(fault));
        HealthEntry now = before == null
                ? new HealthEntry(++reported, fault, sinceMillis)
                : new HealthEntry(before.number(), fault, before.sinceMillis());
        if (!now.equals(before)) {
            entries.put(Key.of(fault), now);
            change();
        }
    }

    /** Forgets all faults. */
    void clear() {
        entries.clear();
        reported = 0;
        change();
    }

    @Override
    Health take() {
        return entries.isEmpty()
                ? Health.WELL
                : new Health(entries.values().stream().sorted(ORDER).toList());
    }
}
