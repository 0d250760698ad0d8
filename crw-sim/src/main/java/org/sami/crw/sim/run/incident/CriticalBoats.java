package org.sami.crw.sim.run.incident;

import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.handler.activation.EventNames;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** Boats whose batteries are critical and for which nothing has been done yet. For the engine's thread. */
final class CriticalBoats implements HostListener {
    private final Set<String> waiting = new LinkedHashSet<>();
    private final Set<String> known = new HashSet<>(); // critical ones, also those that are being looked after

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (!(input instanceof Input.Received received)) {
            return;
        }
        String type = received.occurrence().type();
        if (type.equals(EventNames.BATTERY_CRITICAL)) {
            received.occurrence().proxies().stream().filter(known::add).forEach(waiting::add);
        } else if (type.equals(EventNames.BATTERY_NOMINAL) || type.equals(EventNames.BATTERY_LOW)) {
            received.occurrence().proxies().forEach(boat -> {
                known.remove(boat);
                waiting.remove(boat);
            });
        }
    }

    /** The boat that has waited longest; it is looked after from now on. */
    Optional<String> next() {
        Optional<String> first = waiting.stream().findFirst();
        first.ifPresent(waiting::remove);
        return first;
    }
}
