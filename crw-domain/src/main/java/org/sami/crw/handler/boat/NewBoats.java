package org.sami.crw.handler.boat;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/**
 * Activations that wait for boats to join. When all boats of an activation have joined, its answer names them: Proxy Connected where a following
 * transition waits for that, so that no other mission takes the boats; otherwise Proxy Created, which is news in all other missions. For the fleet's
 * thread.
 */
public final class NewBoats {
    private final List<Request> requests = new ArrayList<>();

    private static final class Request {
        private final Activation activation;
        private final List<String> boats;
        private final Set<String> missing;
        private final boolean own;

        Request(Activation activation, List<String> boats, Set<String> missing, boolean own) {
            this.activation = activation;
            this.boats = boats;
            this.missing = missing;
            this.own = own;
        }

        /** The answer that is this mission's alone where the plan waits for it, else news to all others as well. */
        Input answer() {
            return new Input.Received(
                    own
                            ? Occurrence.answer(EventNames.PROXY_CONNECTED, activation, boats, List.of(), Map.of())
                            : new Occurrence(
                                    EventNames.PROXY_CREATED, Ids.NONE, activation.id(), boats, List.of(), Map.of()));
        }
    }

    /** An activation waits for boats that have been found; where all have joined before, it is answered now. */
    void await(Activation activation, List<String> boats, HandlerContext context) {
        Set<String> missing = new LinkedHashSet<>(boats);
        missing.removeAll(context.query(view -> Set.copyOf(view.proxies())));
        boolean own = context.query(view -> waitsForItsOwn(activation, view));
        if (missing.isEmpty()) { // no news to anybody else
            String type = own ? EventNames.PROXY_CONNECTED : EventNames.PROXY_CREATED;
            context.post(new Input.Received(Occurrence.answer(type, activation, boats, List.of(), Map.of())));
        } else {
            requests.add(new Request(activation, List.copyOf(boats), missing, own));
        }
    }

    /** Whether a transition after the place that asked waits for Proxy Connected. */
    private static boolean waitsForItsOwn(Activation activation, EngineView view) {
        return view.planOf(activation.mission())
                .map(plan -> plan.inEdges().stream()
                        .filter(edge -> edge.place().equals(activation.place()))
                        .flatMap(edge -> plan.transition(edge.transition()).stream())
                        .flatMap(transition -> transition.inputs().stream())
                        .anyMatch(input -> input.type().equals(EventNames.PROXY_CONNECTED)))
                .orElse(false);
    }

    /**
     * What is posted because a boat joins.
     *
     * @param newsIsAwaited whether a transition waits for Proxy Created now
     */
    List<Input> joined(String boat, boolean newsIsAwaited) {
        List<Input> inputs = new ArrayList<>();
        inputs.add(new Input.ProxyJoined(boat));
        boolean awaited = false;
        boolean told = false;
        for (Request request : List.copyOf(requests)) {
            boolean waited = request.missing.remove(boat);
            awaited |= waited;
            told |= waited && !request.own;
            if (request.missing.isEmpty()) {
                requests.remove(request);
                inputs.add(request.answer());
            }
        }
        if (!awaited || (!told && newsIsAwaited)) {
            inputs.add(new Input.Received(Occurrence.news(EventNames.PROXY_CREATED, List.of(boat), Map.of())));
        }
        return inputs;
    }
}
