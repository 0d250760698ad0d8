package org.sami.crw.handler.motion;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sami.crw.decision.DomainQuestion;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.BooleanValue;

/** What the operator has answered about the ways on which an activation sends boats, in the mission's memory: nobody is asked again after a restart. */
record WayAnswers(Activation activation, HandlerContext context) {
    /** Whether a boat may go; empty where that was not asked. Journals from before 2026-11-28 keep one answer for all boats of the activation. */
    Optional<Boolean> of(DomainQuestion kind, String boat) {
        return at(key(kind, boat)).or(() -> at(key(kind)));
    }

    /** Whether a boat may not go, whatever was doubted. */
    boolean refuse(String boat) {
        return Arrays.stream(DomainQuestion.values())
                .filter(DomainQuestion::isAboutWays)
                .flatMap(kind -> of(kind, boat).stream())
                .anyMatch(yes -> !yes);
    }

    /** Has the mission remember the answer for each boat. */
    void remember(DomainQuestion kind, List<String> boats, boolean yes) {
        context.post(boats.stream()
                .<Input>map(boat -> new Input.Remember(activation.mission(), key(kind, boat), new BooleanValue(yes)))
                .toList());
    }

    private Optional<Boolean> at(String key) {
        return context.query(view -> view.memory(activation.mission(), key))
                .filter(BooleanValue.class::isInstance)
                .map(value -> ((BooleanValue) value).value());
    }

    private String key(DomainQuestion kind) {
        return "way/" + kind.kind() + "/" + activation.id();
    }

    private String key(DomainQuestion kind, String boat) {
        return key(kind) + "/" + boat;
    }
}
