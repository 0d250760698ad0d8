package org.sami.crw.handler.subscription;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.activation.OptionalAnswer;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;

/**
 * Take Measurement: answers with the next reading of the sensor on each boat that entered, while the boat stands in the place. Sensors read at their
 * own rates. A sensor is named by its channel ({@code temperature}), its instrument ({@code ctd}) or both ({@code ctd/temperature}); of several
 * values the first counts. Without a reading for a while, a message to the operator lists the sensors, and the measurement fails: for the plan where
 * a transition waits for that, otherwise in the journal only, and the boat waits on. For the fleet's thread; it passes the engine's steps on to it.
 */
public final class MeasurementHandler implements ActivationHandler, Consumer<FleetEvent>, HostListener {
    public static final String TYPE = "TakeMeasurement";

    /** A measurement fails after this time, in ms, without a reading. */
    public static final long FAILED_AFTER_MS = 60_000;

    /** The field that names what is measured. */
    public static final String SENSOR = "sensor";

    private final MessageSink messages;
    private final Executor fleet;
    private final List<Wish> open = new ArrayList<>();
    private final Map<String, Set<String>> sensors = new LinkedHashMap<>(); // by boat, as far as they have spoken

    public MeasurementHandler(MessageSink messages, Executor fleet) {
        this.messages = messages;
        this.fleet = fleet;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, SENSOR) instanceof TextValue sensor)) {
            throw new IllegalArgumentException("\"" + SENSOR + "\" is no text: " + activation.value(SENSOR));
        }
        for (Addressee addressee : Addressee.of(activation, context)) {
            open.add(new Wish(activation, context, addressee, sensor.value()));
        }
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.Measured measured) {
            onReading(measured.boat(), measured.reading());
        } else if (event instanceof FleetEvent.StatusReported reported) {
            onStatus(reported.status());
        }
    }

    private void onReading(String boatId, BoatReading reading) {
        sensors.computeIfAbsent(boatId, id -> new TreeSet<>()).add(reading.sensor() + "/" + reading.channel());
        List<Wish> met = open.stream()
                .filter(wish -> wish.isOf(boatId) && wish.isMetBy(reading))
                .toList();
        open.removeAll(met);
        met.stream().filter(Wish::stands).forEach(wish -> wish.answer(reading));
    }

    private void onStatus(BoatStatus status) {
        for (Wish wish : List.copyOf(open)) {
            if (wish.isOf(status.boatId()) && wish.isOverdue()) {
                wish.told = true;
                String reason = wish.reason(sensors.getOrDefault(status.boatId(), Set.of()));
                OperatorMessage overdue = wish.overdue(reason);
                messages.tell(overdue);
                if (wish.stands() && wish.fail(reason)) {
                    open.remove(wish);
                } else {
                    wish.context.post(new Input.HandlerFailed(wish.activation.id(), overdue.text()));
                }
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded over) {
                fleet.execute(() -> open.removeIf(wish -> wish.activation.id() == over.activation()));
            }
        }
    }

    /** What one activation wants of one boat. */
    private static final class Wish {
        private final Activation activation;
        private final HandlerContext context;
        private final Addressee addressee;
        private final String sensor;
        private final long sinceMs;
        private boolean told;

        Wish(Activation activation, HandlerContext context, Addressee addressee, String sensor) {
            this.activation = activation;
            this.context = context;
            this.addressee = addressee;
            this.sensor = sensor;
            sinceMs = context.nowMillis();
        }

        boolean isOf(String boat) {
            return addressee.boat().equals(boat);
        }

        boolean isMetBy(BoatReading reading) {
            return sensor.equals(reading.channel())
                    || sensor.equals(reading.sensor())
                    || sensor.equals(reading.sensor() + "/" + reading.channel());
        }

        boolean stands() {
            return addressee.stands(activation, context);
        }

        boolean isOverdue() {
            return !told && context.nowMillis() - sinceMs >= FAILED_AFTER_MS;
        }

        void answer(BoatReading reading) {
            context.post(new Input.Received(addressee.answer(
                    EventNames.MEASUREMENT_TAKEN,
                    activation,
                    Map.of(
                            "sensor", new TextValue(sensor),
                            "value", new RealValue(reading.values().get(0)),
                            "location", reading.position()))));
        }

        /** Says that the measurement failed; false where no transition waits for that. */
        boolean fail(String reason) {
            List<Input> failure = OptionalAnswer.of(
                    addressee.answer(
                            EventNames.MEASUREMENT_FAILED, activation, Map.of("reason", new TextValue(reason))),
                    context);
            if (!failure.isEmpty()) {
                context.post(failure);
            }
            return !failure.isEmpty();
        }

        String reason(Set<String> known) {
            String has = known.isEmpty() ? "it has sent no reading at all" : "it has " + String.join(", ", known);
            return "no reading in " + FAILED_AFTER_MS / 1000 + " s; " + has;
        }

        OperatorMessage overdue(String reason) {
            return ActivationMessages.of(
                    activation,
                    context,
                    Priority.HIGH,
                    addressee.boat() + " has not measured \"" + sensor + "\" for " + activation.place() + ": " + reason,
                    List.of(addressee.boat()));
        }
    }
}
