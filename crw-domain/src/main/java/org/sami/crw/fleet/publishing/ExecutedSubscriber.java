package org.sami.crw.fleet.publishing;

import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.spn.host.ListenerList;

/** A subscriber that is called on an executor of its own; one whose executor has stopped is called no longer. */
final class ExecutedSubscriber implements Consumer<FleetEvent> {
    private final Executor executor;
    private final ListenerList<Consumer<? super FleetEvent>> subscriber = new ListenerList<>();

    ExecutedSubscriber(Executor executor, Consumer<? super FleetEvent> subscriber) {
        this.executor = executor;
        this.subscriber.add(subscriber);
    }

    @Override
    public void accept(FleetEvent event) {
        try {
            executor.execute(() -> subscriber.each(one -> one.accept(event)));
        } catch (RejectedExecutionException stopped) {
            // its executor was stopped: the subscriber has ended
        }
    }
}
