package org.sami.crw.handler.boat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;

/**
 * Keeps in the session's journal which missions keep each boat for themselves, and has them keep it again under a base that goes on with the session. A
 * block outlasts the visit that asked for it, so no activation that is delivered again brings it back. For the fleet's thread.
 */
public final class BoatBlocks implements Consumer<FleetEvent> {
    private static final String SEPARATOR = ",";

    private final EngineHost host;
    private final ProxyRegistry boats;
    private final Map<String, List<Long>> remembered = new HashMap<>(); // by boat, of those that this process has met

    public BoatBlocks(EngineHost host, ProxyRegistry boats) {
        this.host = host;
        this.boats = boats;
    }

    /** A boat is met with its link or with its first command, whichever comes first. */
    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.LinkChanged || event instanceof FleetEvent.QueueChanged) {
            boats.find(event.boat()).ifPresent(this::look);
        }
    }

    private void look(BoatProxy boat) {
        if (!remembered.containsKey(boat.boatId())) {
            restore(boat);
        }
        List<Long> now = boat.commands().blocks();
        if (!now.equals(remembered.put(boat.boatId(), now))) {
            String missions = now.stream().map(String::valueOf).collect(Collectors.joining(SEPARATOR));
            host.post(SessionMemory.BLOCKS.remember(boat.boatId(), missions));
        }
    }

    private void restore(BoatProxy boat) {
        remembered.put(boat.boatId(), host.ask(view -> missions(boat.boatId(), view)));
        List<Long> running = host.ask(view -> missions(boat.boatId(), view).stream()
                .filter(mission -> view.mission(mission).isPresent())
                .toList());
        if (!running.isEmpty()) {
            boat.commands().restoreBlocks(running);
        }
    }

    private static List<Long> missions(String boatId, EngineView view) {
        return SessionMemory.BLOCKS
                .of(boatId, view)
                .filter(missions -> !missions.isEmpty())
                .map(missions -> Arrays.stream(missions.split(SEPARATOR))
                        .map(Long::valueOf)
                        .toList())
                .orElse(List.of());
    }
}
