package org.sami.crw.operator;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.boat.link.PhoneReadings;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.picture.TakenPictures;
import org.sami.crw.proxy.ProxyRegistry;

/** Tells the models what happens to the fleet, and samples its boats. On the fleet's thread; all of it reaches the models by one hop. */
final class FleetFeed {
    private final OperatorModels models;
    private final ModelInbox inbox;
    private final LongSupplier nowMillis;
    private final AtomicBoolean ticking = new AtomicBoolean();
    private volatile Optional<FleetSampler> sampler = Optional.empty();

    /** Tells nothing yet. */
    FleetFeed(OperatorModels models, ModelInbox inbox, LongSupplier nowMillis) {
        this.models = models;
        this.inbox = inbox;
        this.nowMillis = nowMillis;
    }

    /**
     * What is to be subscribed to the fleet's events, once.
     *
     * @param periodMillis how long a boat is left alone after a snapshot of it
     */
    Consumer<FleetEvent> listener(ProxyRegistry boats, long periodMillis) {
        FleetSampler made =
                new FleetSampler(boats, models.missions()::title, nowMillis, periodMillis, models.fleet()::seen);
        sampler = Optional.of(made);
        models.alarms().sampledEvery(periodMillis);
        return event -> {
            made.happened(event);
            if (event instanceof FleetEvent.Measured measured) {
                models.map().measured(measured);
                ofPhone(measured);
            }
            if (TakenPictures.concerns(event)) {
                long at = nowMillis.getAsLong();
                inbox.post(() -> models.pictures().apply(event, at));
            }
            if (CommandModel.concerns(event)
                    || event instanceof FleetEvent.LinkAlarmed
                    || event instanceof FleetEvent.TooMuchSent
                    || event instanceof FleetEvent.Moved) {
                long at = nowMillis.getAsLong();
                inbox.post(() -> {
                    if (CommandModel.concerns(event)) {
                        models.commands().apply(event, at);
                        models.map().refresh();
                    }
                    models.alarms().apply(event, at);
                });
            }
        };
    }

    /** Other readings raise no alarm, and come too often for a hop each. */
    private void ofPhone(FleetEvent.Measured measured) {
        if (measured.reading().sensor().equals(PhoneReadings.SENSOR)) {
            long at = nowMillis.getAsLong();
            inbox.post(() -> models.alarms().apply(measured, at));
        }
    }

    /** Looks at all boats, as ages and reasons change by themselves. To be called ten times a second on the fleet's thread. */
    void look() {
        sampler.ifPresent(FleetSampler::look);
        long now = nowMillis.getAsLong();
        models.map().look(now);
        if (ticking.compareAndSet(false, true)) {
            inbox.post(() -> {
                ticking.set(false);
                models.map().tick(now);
                models.messages().tick(now);
                models.alarms().tick(now);
            });
        }
    }
}
