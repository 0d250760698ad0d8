package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Locale;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.report.OperatorAction;
import org.sami.spn.value.GeoPoint;

/** The operator's log as a report has it. */
public final class OperatorActions {
    private OperatorActions() {}

    /** The entries, in order. */
    public static List<OperatorAction> of(List<OperatorLogEntry> entries) {
        return entries.stream().map(OperatorActions::action).toList();
    }

    private static OperatorAction action(OperatorLogEntry entry) {
        return new OperatorAction(
                entry.number(),
                entry.atMillis(),
                entry.kind().name().toLowerCase(Locale.ROOT),
                entry.text(),
                entry.mission(),
                entry.boats(),
                entry.position().map(GeoPoint::latDeg),
                entry.position().map(GeoPoint::lonDeg));
    }
}
