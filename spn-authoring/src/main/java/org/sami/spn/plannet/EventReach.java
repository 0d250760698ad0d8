package org.sami.spn.plannet;

import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Vocabulary;

/** Which tokens the input events of a transition reach. */
final class EventReach {
    private EventReach() {}

    /** Whether it reaches tokens that instances hold (R-INT-5). */
    static boolean reachesHeld(Vocabulary vocabulary, Transition t) {
        return t.inputs().stream()
                .flatMap(input -> vocabulary.event(input.type()).stream())
                .anyMatch(type -> type.role().isPress()
                        || type.role() == EventRole.ABORT_RECEIVED
                        || type.role() == EventRole.COMPLETE_RECEIVED);
    }
}
