package org.sami.crw.operator.health;

import java.util.List;
import java.util.Optional;
import org.sami.spn.protocol.Priority;

/**
 * How a session is.
 *
 * @param entries all faults that are not over: the worst first, of equal ones the oldest
 */
public record Health(List<HealthEntry> entries) {
    /** Nothing is wrong. */
    public static final Health WELL = new Health(List.of());

    public Health {
        entries = List.copyOf(entries);
    }

    /** Whether nothing is wrong. */
    public boolean isWell() {
        return entries.isEmpty();
    }

    /** The worst fault; of equal ones the oldest. */
    public Optional<HealthEntry> worst() {
        return entries.stream().findFirst();
    }

    /** How many faults are as bad as this, or worse. */
    public long countFrom(Priority severity) {
        return entries.stream()
                .filter(entry -> entry.severity().compareTo(severity) >= 0)
                .count();
    }

    /** Whether no mission goes on, whatever it says itself: the engine waits for its journal or has stopped. */
    public boolean missionsStandStill() {
        return entries.stream()
                .map(HealthEntry::fault)
                .anyMatch(fault -> fault.kind() == HealthKind.ENGINE
                        || (fault.kind() == HealthKind.JOURNAL
                                && fault.subject().isEmpty()));
    }

    /** The faults of one kind. */
    public List<HealthEntry> of(HealthKind kind) {
        return entries.stream().filter(entry -> entry.fault().kind() == kind).toList();
    }
}
