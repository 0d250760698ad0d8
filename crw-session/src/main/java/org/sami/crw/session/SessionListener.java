package org.sami.crw.session;

import java.util.List;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionNote;
import org.sami.spn.value.GeoPoint;

/**
 * Receives the notes of a session besides the engine's steps. Called on the thread of the event, mostly the fleet's: it must be quick and must not
 * wait for the session.
 */
public interface SessionListener {
    /** A message to the operator; kept in the journal. On any thread. */
    default void onNote(SessionNote note) {}

    /** A message to the operator that need not be kept, such as why a boat still stands. On the fleet's thread. */
    default void onNotice(String text) {}

    /** A boat says that these points of its path are behind it. On the fleet's thread, before the engine receives it. */
    default void onPassed(String boat, List<GeoPoint> points, long atMillis) {}

    /** A sensor has measured. On the fleet's thread. */
    default void onReading(SensorValue reading) {}

    /** The session cannot go on, for a reason in one sentence. On the engine's thread. */
    default void onBroken(String reason) {}
}
