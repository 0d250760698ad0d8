package org.sami.spn.engine.rule;

import java.util.List;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Reserved;

/** Notifies the operator of presses that no transition can take. */
final class UntakenPresses {
    private final RuleStep step;

    UntakenPresses(RuleStep step) {
        this.step = step;
    }

    /** No transition can take a press: it is not kept, and the operator is notified. */
    void note(Occurrence press) {
        Value name = press.values().get(Reserved.INTERRUPT_NAME);
        MissionState m = step.state.missions.get(press.mission());
        step.note(
                NoteKind.INTERRUPT_REFUSED,
                press.mission(),
                "Nobody is there for the interrupt '" + (name == null ? press.type() : CompiledInput.text(name)) + "'"
                        + (m == null ? "" : whereabouts(m, press.proxies())));
    }

    /** Where the named robots stand instead, in words. */
    private static String whereabouts(MissionState m, List<String> proxies) {
        StringBuilder words = new StringBuilder();
        for (PlaceState place : m.places) {
            for (String proxy : place == null ? List.<String>of() : proxies) {
                if (place.has(new Token.Proxy(proxy))) {
                    words.append("; ")
                            .append(proxy)
                            .append(" is in '")
                            .append(place.place)
                            .append("'");
                }
            }
        }
        return words.toString();
    }
}
