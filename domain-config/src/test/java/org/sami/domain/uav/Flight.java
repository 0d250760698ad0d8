package org.sami.domain.uav;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** The domain's handlers: what plans ask of aircraft, done by simulated ones, and answered when it is done. All on the test's thread. */
final class Flight implements HostListener {
    private static final double CEILING_M = 120;

    private final Map<String, SimulatedUav> fleet = new LinkedHashMap<>();
    private final Map<String, Wish> wishes = new LinkedHashMap<>(); // by aircraft

    /** What an aircraft does, for whom, and how that answers. */
    private record Wish(Activation activation, HandlerContext context, String answer) {}

    /** Puts the handlers on a host. */
    void install(EngineHost host) {
        Map<String, ActivationHandler> handlers =
                Map.of("FlyTo", this::flyTo, "Land", this::land, "LookAround", this::lookAround);
        handlers.forEach((type, handler) -> host.register(type, handler, Runnable::run));
        host.addListener(this);
    }

    void add(String name, SimulatedUav aircraft) {
        fleet.put(name, aircraft);
    }

    private void flyTo(Activation activation, HandlerContext context) {
        GeoPoint to = (GeoPoint) activation.value("location").orElseThrow();
        double speedMps = ((RealValue) activation.value("speed").orElseThrow()).value();
        for (String name : activation.proxies()) {
            if (to.altM() > CEILING_M) {
                Value reason = new TextValue(to.altM() + " m is above the ceiling of " + CEILING_M + " m");
                answer(activation, context, "CannotFly", name, Map.of("reason", reason));
            } else {
                fleet.get(name).flyTo(to, speedMps);
                wishes.put(name, new Wish(activation, context, "ReachedLocation"));
            }
        }
    }

    private void land(Activation activation, HandlerContext context) {
        for (String name : activation.proxies()) {
            fleet.get(name).land();
            wishes.put(name, new Wish(activation, context, "Landed"));
        }
    }

    private void lookAround(Activation activation, HandlerContext context) {
        for (String name : activation.proxies()) {
            answer(
                    activation,
                    context,
                    "PictureTaken",
                    name,
                    Map.of("from", fleet.get(name).position()));
        }
    }

    private static void answer(
            Activation activation, HandlerContext context, String type, String name, Map<String, Value> values) {
        context.post(new Input.Received(Occurrence.answer(type, activation, List.of(name), List.of(), values)));
    }

    /** Lets time pass for all aircraft. */
    void step(double seconds) {
        for (Map.Entry<String, SimulatedUav> each : fleet.entrySet()) {
            each.getValue().step(seconds);
            Optional.ofNullable(wishes.get(each.getKey()))
                    .filter(wish -> each.getValue().isThere())
                    .ifPresent(wish -> {
                        wishes.remove(each.getKey());
                        answer(wish.activation(), wish.context(), wish.answer(), each.getKey(), Map.of());
                    });
        }
    }

    /** What is withdrawn is done no longer: the aircraft stands in the air. */
    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.CommandsWithdrawn withdrawn) {
                List<String> named = withdrawn.proxies().isEmpty() ? List.copyOf(fleet.keySet()) : withdrawn.proxies();
                for (String name : new ArrayList<>(named)) {
                    Wish wish = wishes.get(name);
                    if (wish != null && wish.activation().mission() == withdrawn.mission()) {
                        wishes.remove(name);
                        fleet.get(name).hover();
                    }
                }
            }
        }
    }
}
