package org.sami.spn.phase;

import java.util.Objects;

/**
 * One box of a phase chart: an event with the markup Phase Item or Phase Branch.
 *
 * @param id the id of the event in the plan
 * @param vertex the id of its place or transition
 * @param phase the name of the phase that it belongs to
 * @param actor who acts: the row that it stands in
 * @param label what is written on it
 * @param branch whether it is an option of an earlier action (Phase Branch)
 */
public record PhaseAction(String id, String vertex, String phase, String actor, String label, boolean branch) {
    public PhaseAction {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(vertex, "vertex");
        Objects.requireNonNull(phase, "phase");
        Objects.requireNonNull(actor, "actor");
        Objects.requireNonNull(label, "label");
    }
}
