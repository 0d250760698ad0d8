package org.sami.crw.sim.run.record;

import java.util.List;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionNote;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;

/**
 * Follows a run and makes one part of its report: a fold over the journal's entries and telemetry. The caller feeds it, as a run goes on or from a
 * journal; a fold does not know which. Entries come in order, and telemetry of each kind in order of time.
 */
public interface ReportFold extends HostListener {
    /** Takes an entry of the journal and its effects. */
    @Override
    default void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {}

    /** Takes a message to the operator. */
    default void onNote(SessionNote note) {}

    /** Takes a measurement of a boat. */
    default void onReading(SensorValue reading) {}

    /** Takes a boat's report that it visited a point. */
    default void onVisit(String boat, GeoPoint point, long atMillis) {}

    /** Takes a boat's position; each boat's positions come in order of time. */
    default void onPose(long atMillis, BoatState boat) {}

    /** Adds its part to the report; parts of folds before it in the list are there already. */
    void addTo(ReportDraft report);
}
