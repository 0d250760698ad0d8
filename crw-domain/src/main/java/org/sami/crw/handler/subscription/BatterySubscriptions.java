package org.sami.crw.handler.subscription;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.event.Numbers;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Battery Level Subscription (appendix .2.1): answers for each boat that entered, at once or when its charge is known, and then at each change of
 * level by the subscription's own thresholds, while the boat stands in the place. The mission's memory keeps the last answer, so that neither a
 * regained link nor a restarted base repeats it. For the fleet's thread; it passes the engine's steps on to it.
 */
public final class BatterySubscriptions implements ActivationHandler, Consumer<FleetEvent>, HostListener {
    public static final String TYPE = "BatteryLevelSubscription";
    private static final String PERIOD = "updatePeriod";
    private static final String LOW = "low";
    private static final String CRITICAL = "critical";

    private final ProxyRegistry boats;
    private final OpenSubscriptions<Subscription> open;

    public BatterySubscriptions(ProxyRegistry boats, Executor fleet) {
        this.boats = boats;
        open = new OpenSubscriptions<>(fleet, subscription -> subscription.byBoat.isEmpty());
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Subscription subscription = new Subscription(activation, context);
        if (!subscription.byBoat.isEmpty() && subscription.isOpen()) {
            open.add(activation.id(), subscription);
            subscription
                    .byBoat
                    .keySet()
                    .forEach(boat -> boats.find(boat)
                            .flatMap(proxy -> proxy.status().battery())
                            .ifPresent(battery -> subscription.look(boat, battery)));
        }
    }

    /** The missions that have subscribed to a boat's battery: only their own thresholds count for them. */
    public Set<Long> subscribers(String boat) {
        return open.stream()
                .filter(subscription -> subscription.byBoat.containsKey(boat))
                .map(subscription -> subscription.activation.mission())
                .collect(Collectors.toSet());
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            onStatus(reported.status());
        } else if (event instanceof FleetEvent.BatteryReported battery) {
            onBattery(battery.boat(), battery.battery());
        }
    }

    private void onStatus(BoatStatus status) {
        status.battery().ifPresent(battery -> look(status.boatId(), battery));
    }

    private void onBattery(String boatId, BatteryState battery) {
        look(boatId, battery);
    }

    private void look(String boat, BatteryState battery) {
        open.tell(subscription -> subscription.look(boat, battery));
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        open.onStep(index, atMillis, input, effects, view);
    }

    /** One activation, and the level that each of its boats reported last to it. */
    private static final class Subscription {
        private final Activation activation;
        private final HandlerContext context;
        private final double low;
        private final double critical;
        private final long periodMs;
        private final Map<String, Watched> byBoat = new HashMap<>();

        Subscription(Activation activation, HandlerContext context) {
            this.activation = activation;
            this.context = context;
            low = Numbers.real(ActivationFields.required(activation, LOW));
            critical = Numbers.real(ActivationFields.required(activation, CRITICAL));
            if (!(critical >= 0 && critical <= low && low <= 100)) {
                throw new IllegalArgumentException(TYPE + " in " + activation.place()
                        + " needs thresholds with 0 <= critical <= low <= 100 %, not critical " + critical + " and low "
                        + low);
            }
            periodMs = activation
                    .value(PERIOD)
                    .filter(DurationValue.class::isInstance)
                    .map(value -> ((DurationValue) value).millis())
                    .orElse(0L);
            for (Addressee addressee : Addressee.of(activation, context)) {
                byBoat.put(addressee.boat(), new Watched(addressee, told(addressee.boat())));
            }
        }

        private Optional<String> told(String boat) {
            return context.query(view -> view.memory(activation.mission(), key(boat)))
                    .filter(TextValue.class::isInstance)
                    .map(value -> ((TextValue) value).value());
        }

        private String key(String boat) {
            return "battery/" + activation.id() + "/" + boat;
        }

        boolean isOpen() {
            return context.query(
                    view -> view.openActivations().stream().anyMatch(each -> each.id() == activation.id()));
        }

        void look(String boat, BatteryState battery) {
            Watched watched = byBoat.get(boat);
            long now = context.nowMillis();
            if (watched == null || now < watched.nextLookMs) {
                return;
            }
            watched.nextLookMs = now + periodMs;
            BatteryLevel level = BatteryLevel.of(battery.percent(), low, critical);
            if (watched.told.equals(Optional.of(level.name()))) {
                return;
            }
            if (!watched.addressee.stands(activation, context)) {
                byBoat.remove(boat);
                return;
            }
            watched.told = Optional.of(level.name());
            Map<String, Value> values = Map.of("percent", new RealValue(battery.percent()));
            context.post(List.of(
                    new Input.Remember(activation.mission(), key(boat), new TextValue(level.name())),
                    new Input.Received(watched.addressee.answer(EventNames.of(level), activation, values))));
        }
    }

    /** A boat of a subscription. */
    private static final class Watched {
        private final Addressee addressee;
        private Optional<String> told;
        private long nextLookMs = Long.MIN_VALUE;

        Watched(Addressee addressee, Optional<String> told) {
            this.addressee = addressee;
            this.told = told;
        }
    }
}
