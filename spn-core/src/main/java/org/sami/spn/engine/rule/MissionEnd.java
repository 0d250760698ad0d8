package org.sami.spn.engine.rule;

import java.util.List;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;

/**
 * Ends missions. A mission that has ended never reacts again.
 *
 * <p>Implements R-END-2, R-END-4, R-END-5, R-END-6, R-SUB-10.
 */
final class MissionEnd {
    private final MissionRules rules;

    MissionEnd(MissionRules rules) {
        this.rules = rules;
    }

    /** A firing entered an end place: what was commanded before is withdrawn, what the end place asks is sent after. */
    void lastWords(MissionState m) {
        rules.emit(new Effect.CommandsWithdrawn(m.id, List.of()));
    }

    /** An abort or a completion was asked of a mission: that is its outcome, however it ends. An abort is the stronger. */
    void asked(MissionState m, Outcome outcome) {
        if (m.asked != Outcome.ABORTED) {
            m.asked = outcome;
        }
    }

    private static Outcome outcome(MissionState m, Outcome otherwise) {
        return m.asked == null || otherwise == Outcome.ABORTED ? otherwise : m.asked;
    }

    /** The firing that entered an end place is complete. */
    void ended(MissionState m) {
        end(m, outcome(m, Outcome.ENDED), false);
    }

    /** Ends a mission from outside, with all its descendants. */
    void stop(MissionState m, Outcome outcome) {
        end(m, outcome(m, outcome), true);
    }

    private void end(MissionState m, Outcome outcome, boolean withdraw) {
        if (m.instance != null && outcome != Outcome.ABORTED) {
            rules.subMissions.collect(m);
        }
        endTree(m, outcome, withdraw);
        tellParent(m, outcome);
    }

    /** Ends an instance that nobody waits for any longer. */
    void stopSilently(MissionState m, Outcome outcome) {
        endTree(m, outcome, true);
    }

    private void tellParent(MissionState m, Outcome outcome) {
        if (m.instance != null && m.parent != null && !m.parent.ended) {
            if (outcome == Outcome.ABORTED) {
                rules.subMissions.aborted(m.instance);
            } else {
                rules.subMissions.completed(m.instance);
            }
        }
    }

    private void endTree(MissionState m, Outcome ofAncestor, boolean withdraw) {
        if (m.ended) {
            return;
        }
        Outcome outcome = outcome(m, ofAncestor);
        for (MissionState child : List.copyOf(m.children.values())) {
            endTree(child, outcome, true);
        }
        m.ended = true;
        for (OpenDecision d : rules.state().decisionsOf(m)) {
            rules.questions.close(d);
        }
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            rules.visits.close(v);
            rules.visits.forget(v);
        }
        for (PlaceState place : m.places) {
            if (place != null && place.lastVisits != null) {
                place.lastVisits.values().forEach(rules.visits::forget);
            }
        }
        rules.state().remove(m);
        if (m.instance != null) {
            m.instance.child = null;
        }
        if (withdraw) {
            rules.emit(new Effect.CommandsWithdrawn(m.id, List.of()));
        }
        rules.emit(new Effect.MissionEnded(m.id, outcome));
    }

    /** Stops a livelock: the marking stays, the mission does not react until it is aborted. */
    void halt(MissionState m, String why) {
        m.status = MissionStatus.HALTED;
        rules.note(NoteKind.LIVELOCK, m.id, "'" + m.name + "' is halted after " + why);
        rules.emit(new Effect.MissionEnded(m.id, Outcome.HALTED));
    }
}
