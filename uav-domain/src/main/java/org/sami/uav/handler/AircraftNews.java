package org.sami.uav.handler;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/** Posts news to plans: a link is lost or back, or a task has lost its aircraft. Only news for which a transition waits are posted. */
final class AircraftNews implements Consumer<FleetEvent>, HostListener {
    private final EngineHost host;
    private final Set<String> lost = new HashSet<>();

    AircraftNews(EngineHost host) {
        this.host = host;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.LinkChanged changed) {
            String aircraft = changed.status().boatId();
            if (changed.status().link() == LinkState.LOST && lost.add(aircraft)) {
                tell(UavEvents.LINK_LOST, aircraft);
            } else if (changed.status().link() == LinkState.LINKED && lost.remove(aircraft)) {
                tell(UavEvents.LINK_BACK, aircraft);
            }
        }
    }

    private void tell(String type, String aircraft) {
        if (host.ask(view -> view.awaits(type))) {
            host.post(List.of(new Input.Received(Occurrence.news(type, List.of(aircraft), Map.of()))));
        }
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
