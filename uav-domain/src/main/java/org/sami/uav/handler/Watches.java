package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;
import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.Value;

/**
 * Open activations that answer when something is observed, once for each aircraft and observation. For the fleet's thread; the engine's steps are passed on
 * to it.
 */
final class Watches implements HostListener {
    private final Executor fleet;
    private final Map<Long, Watch> open = new LinkedHashMap<>(); // by activation

    private record Watch(Activation activation, HandlerContext context, List<Addressee> aircraft, Set<String> said) {}

    Watches(Executor fleet) {
        this.fleet = fleet;
    }

    /** Begins to watch for the aircraft that entered; for nobody in particular where none did. */
    void begin(Activation activation, HandlerContext context) {
        open.put(activation.id(), new Watch(activation, context, Addressee.of(activation, context), new HashSet<>()));
    }

    /** Condition on the activation that watches. */
    @FunctionalInterface
    interface Condition {
        boolean isMet(Activation activation);
    }

    /**
     * Answers what watches an aircraft, or all of them.
     *
     * @param what is said; said once
     * @param when which activations say it
     */
    void observed(String aircraft, String what, String event, Map<String, Value> values, Condition when) {
        for (Watch watch : new ArrayList<>(open.values())) {
            boolean all = watch.aircraft.isEmpty();
            List<Addressee> meant = watch.aircraft.stream()
                    .filter(one -> one.boat().equals(aircraft) && one.stands(watch.activation, watch.context))
                    .toList();
            if ((all || !meant.isEmpty())
                    && when.isMet(watch.activation)
                    && watch.said.add((all ? "" : aircraft + " ") + what)) {
                watch.context.post(new Input.Received(
                        all
                                ? Occurrence.answer(event, watch.activation, List.of(), List.of(), values)
                                : meant.get(0).answer(event, watch.activation, values)));
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded ended) {
                fleet.execute(() -> open.remove(ended.activation()));
            }
        }
    }
}
