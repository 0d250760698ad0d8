package org.sami.crw.operator.mission;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.motion.Move;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TextValue;

/** What open activations asked and what failed of it, boat by boat. For the engine's thread. */
public final class FailedAnswers {
    /** Stands for all boats of an activation. */
    private static final String ALL = "";

    private final Map<Long, Map<String, Failure>> byActivation = new LinkedHashMap<>();

    /**
     * A failure that the plan received, or that its handler met.
     *
     * @param boat id; empty text where the whole activation failed
     * @param reason in words, without a full stop; empty text where none was given
     * @param atMillis when, on the session's clock
     */
    public record Failure(String boat, String reason, long atMillis) {
        public Failure {
            Objects.requireNonNull(boat, "boat");
            Objects.requireNonNull(reason, "reason");
        }
    }

    /** Takes up which commands of boats failed before the base was restarted, as their missions remember it. */
    public void restore(EngineView view, long atMillis) {
        for (Activation open : view.openActivations()) {
            for (String boat : open.proxies()) {
                Move.failure(open, boat, view).ifPresent(reason -> put(open.id(), new Failure(boat, reason, atMillis)));
            }
        }
    }

    /** Follows a step of the engine. */
    public void take(long atMillis, Input input, List<Effect> effects) {
        if (input instanceof Input.Received received) {
            take(atMillis, received.occurrence());
        } else if (input instanceof Input.HandlerFailed failed) {
            put(failed.activation(), new Failure(ALL, failed.reason(), atMillis));
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded ended) {
                byActivation.remove(ended.activation());
            }
        }
    }

    private void take(long atMillis, Occurrence answer) {
        if (EventNames.OF_FAILURES.contains(answer.type())) {
            String reason = answer.values().get("reason") instanceof TextValue text ? text.value() : "";
            answer.proxies().forEach(boat -> put(answer.activation(), new Failure(boat, reason, atMillis)));
        } else if (byActivation.containsKey(answer.activation())) {
            byActivation.get(answer.activation()).keySet().removeAll(answer.proxies());
        }
    }

    private void put(long activation, Failure failure) {
        byActivation.computeIfAbsent(activation, id -> new LinkedHashMap<>()).put(failure.boat(), failure);
    }

    /** What has failed of an activation, oldest first; none of it where nothing has. */
    public List<Failure> of(long activation) {
        return List.copyOf(byActivation.getOrDefault(activation, Map.of()).values());
    }

    /** Whether nothing has failed. */
    public boolean isEmpty() {
        return byActivation.isEmpty();
    }

    /** An activation is delivered again: what failed of it counts no longer. */
    public void forget(long activation) {
        byActivation.remove(activation);
    }

    /** Forgets all. */
    public void clear() {
        byActivation.clear();
    }
}
