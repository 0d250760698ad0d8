package org.sami.crw.handler.boat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.FlightUsed;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;

/**
 * Has the session remember what each aircraft was seen to use in the air, so that a base that goes on knows it. For the fleet's thread.
 */
public final class FlightUseMemory implements Consumer<FleetEvent> {
    private static final String KEY = "flight-use/";
    private static final double STEP_PERCENT = 2; // so seldom the journal gets it: a copter uses that in half a minute

    private final EngineHost host;
    private final ProxyRegistry robots;
    private final Map<String, Remembered> all = new HashMap<>(); // by robot

    /** What was remembered of a robot last, as its proxy had it. */
    private record Remembered(BoatProxy robot, FlightUsed used) {}

    public FlightUseMemory(EngineHost host, ProxyRegistry robots) {
        this.host = host;
        this.robots = robots;
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            robots.find(reported.status().boatId())
                    .filter(BoatProxy::isFlying)
                    .ifPresent(robot -> follow(reported.status().boatId(), robot));
        }
    }

    private void follow(String name, BoatProxy robot) {
        Remembered last = all.get(name);
        if (last == null || last.robot != robot) {
            remembered(name).ifPresent(robot::goOnFrom);
            last = new Remembered(robot, robot.flightUsed());
            all.put(name, last);
        }
        FlightUsed used = robot.flightUsed();
        if (Math.abs(used.percent() - last.used.percent()) >= STEP_PERCENT) {
            all.put(name, new Remembered(robot, used));
            host.post(List.of(new Input.Remember(
                    Ids.NONE,
                    KEY + name,
                    new ListValue(List.of(new RealValue(used.percent()), new RealValue(used.seconds()))))));
        }
    }

    private Optional<FlightUsed> remembered(String name) {
        return host.ask(view -> view.memory(Ids.NONE, KEY + name))
                .filter(ListValue.class::isInstance)
                .map(value -> ((ListValue) value).items())
                .filter(items -> items.size() == 2 && items.stream().allMatch(RealValue.class::isInstance))
                .map(items -> new FlightUsed(real(items.get(0)), real(items.get(1))));
    }

    private static double real(Object value) {
        return Math.max(0, ((RealValue) value).value());
    }
}
