package org.sami.crw.handler.boat;

import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;

/**
 * Finds unknown boats in a request, such as a path for {@code boat9}: their part would silently not be done. Each becomes a handler's failure in the
 * journal. A boat that has gone is not unknown.
 */
public final class UnknownBoats implements HostListener {
    private final EngineHost host;
    private final Executor fleet;
    private final Set<String> seen = new HashSet<>(); // for the engine's thread

    public UnknownBoats(EngineHost host, Executor fleet) {
        this.host = host;
        this.fleet = fleet;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (input instanceof Input.ProxyDropped dropped) {
            seen.add(dropped.proxy());
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated) {
                Set<String> unknown = named(activated.activation());
                unknown.removeAll(seen);
                if (!unknown.isEmpty()) {
                    unknown.removeAll(view.proxies());
                    unknown.removeIf(boat ->
                            SessionMemory.BOOT.of(boat, view).isPresent()); // dropped before a restart of the base
                    tell(activated.activation(), unknown);
                }
            }
        }
    }

    private void tell(Activation activation, Set<String> unknown) {
        if (!unknown.isEmpty()) {
            Input failed = new Input.HandlerFailed(
                    activation.id(),
                    "\"" + activation.place() + "\" names " + String.join(", ", unknown)
                            + ", and there is no boat of that name");
            fleet.execute(() -> host.post(failed));
        }
    }

    private static Set<String> named(Activation activation) {
        Set<String> names = new LinkedHashSet<>();
        activation.values().values().forEach(value -> add(value, names));
        activation.taskValues().values().forEach(values -> values.values().forEach(value -> add(value, names)));
        activation.proxies().forEach(names::remove);
        return names;
    }

    private static void add(Value value, Set<String> names) {
        if (value instanceof ProxyValue proxy) {
            names.add(proxy.proxy());
        } else if (value instanceof MapValue map) {
            map.entries().forEach((key, entry) -> {
                add(key, names);
                add(entry, names);
            });
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> add(item, names));
        } else if (value instanceof RecordValue record) {
            record.fields().values().forEach(field -> add(field, names));
        }
    }
}
