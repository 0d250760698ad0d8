package org.sami.spn.host;

import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Which types of telemetry ({@link EventFlag#COALESCE}) a transition waits for. May be asked from any thread. */
final class AwaitedTelemetry {
    private final Set<String> telemetry;
    private volatile Set<String> awaited = Set.of();

    /** None of them is awaited yet. */
    AwaitedTelemetry(Vocabulary vocabulary) {
        telemetry = vocabulary.events().values().stream()
                .filter(type -> type.flags().contains(EventFlag.COALESCE))
                .map(EventType::name)
                .collect(Collectors.toUnmodifiableSet());
    }

    /** Whether news of a type are telemetry. */
    boolean isTelemetry(String type) {
        return telemetry.contains(type);
    }

    /** Whether a transition waited for the type when it was last looked. */
    boolean isAwaited(String type) {
        return awaited.contains(type);
    }

    /** Looks what transitions wait for now. For who holds the host's lock. */
    void look(EngineView view) {
        if (!telemetry.isEmpty()) {
            awaited = telemetry.stream().filter(view::awaits).collect(Collectors.toUnmodifiableSet());
        }
    }
}
