package org.sami.uav.handler;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.boat.SessionMemory;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/**
 * Posts news to plans: a link is lost or back, or a task has lost its aircraft. Only news for which a transition waits are posted. The session remembers
 * which links are lost, so that one that comes back after a restart of the base is news too. For the fleet's thread; it answers the engine's steps on the engine's.
 */
final class AircraftNews implements Consumer<FleetEvent>, HostListener {
    private static final String LOST = "lost";

    private final EngineHost host;
    private final Map<String, Boolean> lost = new HashMap<>(); // by aircraft

    AircraftNews(EngineHost host) {
        this.host = host;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.LinkChanged changed) {
            String aircraft = changed.status().boatId();
            LinkState link = changed.status().link();
            if (link == LinkState.LOST && !isLost(aircraft)) {
                turned(aircraft, true, UavEvents.LINK_LOST);
            } else if (link == LinkState.LINKED && isLost(aircraft)) {
                turned(aircraft, false, UavEvents.LINK_BACK);
            }
        }
    }

    private boolean isLost(String aircraft) {
        return lost.computeIfAbsent(
                aircraft, name -> SessionMemory.LINK.of(name, host).equals(Optional.of(LOST)));
    }

    private void turned(String aircraft, boolean isLost, String news) {
        lost.put(aircraft, isLost);
        List<Input> inputs = new ArrayList<>(List.of(SessionMemory.LINK.remember(aircraft, isLost ? LOST : "")));
        if (host.ask(view -> view.awaits(news))) {
            inputs.add(new Input.Received(Occurrence.news(news, List.of(aircraft), Map.of())));
        }
        host.post(inputs);
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.TasksAllocated allocated) {
                allocated.robots().forEach((task, robot) -> {
                    if (robot.isEmpty()
                            && allocated.before().containsKey(task)
                            && view.awaits(UavEvents.AIRCRAFT_LOST)) {
                        host.post(List.of(new Input.Received(new Occurrence(
                                UavEvents.AIRCRAFT_LOST,
                                task.mission(),
                                Ids.NONE,
                                List.of(),
                                List.of(task),
                                Map.of()))));
                    }
                });
            }
        }
    }
}
