package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/**
 * Which activations wait for boats to join. When the last of its boats has, Proxy Created answers the activation, naming
 * them, and is news in all other missions. For the fleet's thread.
 */
final class NewBoats {
    private final List<Request> requests = new ArrayList<>();

    private static final class Request {
        private final Activation activation;
        private final List<String> boats;
        private final Set<String> missing;

        Request(Activation activation, List<String> boats, Set<String> missing) {
            this.activation = activation;
            this.boats = boats;
            this.missing = missing;
        }
    }

    /** An activation waits for boats that have been found; where all have joined before, it is answered now. */
    void await(Activation activation, List<String> boats, HandlerContext context) {
        Set<String> missing = new LinkedHashSet<>(boats);
        missing.removeAll(context.query(view -> Set.copyOf(view.proxies())));
        if (missing.isEmpty()) { // no news to anybody else
            context.post(new Input.Received(
                    Occurrence.answer(EventNames.PROXY_CREATED, activation, boats, List.of(), Map.of())));
        } else {
            requests.add(new Request(activation, List.copyOf(boats), missing));
        }
    }

    /** What is posted because a boat joins. */
    List<Input> joined(String boat) {
        List<Input> inputs = new ArrayList<>();
        inputs.add(new Input.ProxyJoined(boat));
        boolean awaited = false;
        for (Request request : List.copyOf(requests)) {
            awaited |= request.missing.remove(boat);
            if (request.missing.isEmpty()) {
                requests.remove(request);
                inputs.add(new Input.Received(new Occurrence(
                        EventNames.PROXY_CREATED,
                        Ids.NONE,
                        request.activation.id(),
                        request.boats,
                        List.of(),
                        Map.of())));
            }
        }
        if (!awaited) {
            inputs.add(new Input.Received(Occurrence.news(EventNames.PROXY_CREATED, List.of(boat), Map.of())));
        }
        return inputs;
    }
}
