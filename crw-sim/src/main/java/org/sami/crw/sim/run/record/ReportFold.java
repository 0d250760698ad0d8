package org.sami.crw.sim.run.record;

import java.util.List;
import org.sami.crw.session.archive.SensorValue;
import org.sami.crw.session.archive.SessionNote;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;

/**
 * Follows a run and owns one part of its report: a fold over the journal's entries and telemetry. The caller that reads them feeds
 * it, a run as they are made or a reader of a journal; a fold does not know which. Entries come in order, telemetry of each kind in order of time.
 */
public interface ReportFold extends HostListener {
    /** An entry of the journal, with what followed from it. */
    @Override
    default void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {}

    /** A message to the operator. */
    default void onNote(SessionNote note) {}

    /** A boat measured something. */
    default void onReading(SensorValue reading) {}

    /** A boat says that it was at a point. */
    default void onVisit(String boat, GeoPoint point, long atMillis) {}

    /** Where a boat was; each boat's points come in order of time. */
    default void onPose(long atMillis, BoatState boat) {}

    /** Puts its part into the report; what folds before it in the list have put there can be read. */
    void addTo(ReportDraft report);
}
