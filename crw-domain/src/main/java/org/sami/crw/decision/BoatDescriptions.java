package org.sami.crw.decision;

import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;

/** What plans have called boats, such as SHORE or WATER; kept in the session's journal (Proxy Set Description). */
public final class BoatDescriptions {
    private static final String KEY = Reserved.DESCRIPTION_KEY;

    private BoatDescriptions() {}

    /** The input that describes a boat, in place of what it was called before. */
    public static Input remember(String boat, String description) {
        return new Input.Remember(Ids.NONE, KEY + boat, new TextValue(description));
    }

    /** What a boat is called; empty if no plan has described it. */
    public static Optional<String> of(EngineView view, String boat) {
        return view.memory(Ids.NONE, KEY + boat)
                .filter(TextValue.class::isInstance)
                .map(value -> ((TextValue) value).value());
    }
}
