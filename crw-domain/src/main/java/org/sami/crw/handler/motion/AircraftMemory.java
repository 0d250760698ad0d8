package org.sami.crw.handler.motion;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** Has the session remember what the base knows of each aircraft's present flight, so that a base that goes on knows it. For the fleet's thread. */
public final class AircraftMemory {
    /** Nothing is known. */
    public static final ListValue NOTHING = new ListValue(List.of());

    private final EngineHost host;
    private final ProxyRegistry robots;
    private final List<Part> parts;
    private final Map<String, BoatProxy> known = new HashMap<>(); // by aircraft: of which what was remembered is loaded
    private final Map<String, Value> remembered = new HashMap<>(); // by key

    /**
     * The memory of a base.
     *
     * @param parts what is remembered
     */
    public AircraftMemory(EngineHost host, ProxyRegistry robots, List<Part> parts) {
        this.host = host;
        this.robots = robots;
        this.parts = List.copyOf(parts);
    }

    /** Something that is known of aircraft. */
    public interface Part {
        /** Begins the key under which the session remembers it. */
        String prefix();

        /** What is known of an aircraft now; {@link #NOTHING} where nothing is. */
        ListValue of(String aircraft);

        /** Goes on with what an earlier base knew; that is not {@link #NOTHING}. */
        void goOn(String aircraft, ListValue before, EngineHost host);
    }

    /** An aircraft has reported: what an earlier base knew of it counts. To be called before anybody else takes the event in. */
    public void load(FleetEvent event) {
        reporting(event)
                .filter(robot -> known.put(robot.boatId(), robot) != robot)
                .ifPresent(robot -> {
                    for (Part part : parts) {
                        String key = part.prefix() + robot.boatId();
                        host.ask(view -> view.memory(Ids.NONE, key))
                                .filter(ListValue.class::isInstance)
                                .map(ListValue.class::cast)
                                .filter(before -> !before.equals(NOTHING))
                                .ifPresent(before -> {
                                    remembered.put(key, before);
                                    part.goOn(robot.boatId(), before, host);
                                });
                    }
                });
    }

    /** The session remembers what has changed. To be called after everybody else has taken the event in. */
    public void save(FleetEvent event) {
        reporting(event).ifPresent(robot -> {
            for (Part part : parts) {
                String key = part.prefix() + robot.boatId();
                ListValue now = part.of(robot.boatId());
                if (!now.equals(remembered.getOrDefault(key, NOTHING))) {
                    remembered.put(key, now);
                    host.post(List.of(new Input.Remember(Ids.NONE, key, now)));
                }
            }
        });
    }

    private Optional<BoatProxy> reporting(FleetEvent event) {
        return event instanceof FleetEvent.StatusReported reported
                ? robots.find(reported.status().boatId()).filter(BoatProxy::isFlying)
                : Optional.empty();
    }
}
