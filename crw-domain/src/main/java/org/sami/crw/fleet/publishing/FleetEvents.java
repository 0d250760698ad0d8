package org.sami.crw.fleet.publishing;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.task.TaskNews;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.value.TaskId;

/**
 * The event bus of a base's boats. Proxies publish {@link FleetEvent}s here, links report here as to a {@link BaseListener}; subscribers receive the
 * events in order, and before the domain, whose listeners answer plans.
 *
 * <p>Events are published on the fleet's thread. Any thread may subscribe and unsubscribe. What a listener throws is logged, published to the
 * others as a {@link FleetEvent.ListenerFault}, and stops no other listener.
 */
public final class FleetEvents implements BaseListener {
    private static final long SLOW_MILLIS = 50;

    private final ListenerList<Consumer<? super FleetEvent>> subscribers;
    private final ListenerList<Consumer<? super FleetEvent>> domain = new ListenerList<>();

    /** Nobody has subscribed yet. */
    public FleetEvents() {
        this(SLOW_MILLIS);
    }

    /**
     * Nobody has subscribed yet.
     *
     * @param slowMillis from how many milliseconds on a subscriber that holds the fleet's thread is logged as slow
     */
    public FleetEvents(long slowMillis) {
        subscribers = new ListenerList<>("the fleet", slowMillis);
    }

    /**
     * Subscribes to all events from now on, on the fleet's thread itself: for parts of the session that must know something before
     * plans do, such as its journal. Must be quick and wait for nothing; everybody else subscribes with an executor.
     */
    public Registration subscribe(Consumer<? super FleetEvent> subscriber) {
        return subscribers.add(subscriber);
    }

    /**
     * Subscribes to all events from now on, through a serial executor. The fleet never waits for the subscriber; what it does not take
     * waits in the executor.
     */
    public Registration subscribe(Executor executor, Consumer<? super FleetEvent> subscriber) {
        return subscribers.add(new ExecutedSubscriber(executor, subscriber));
    }

    /** Publishes an event to the subscribers, then to the domain. For the fleet's thread; proxies and links publish here as well. */
    public void publish(FleetEvent event) {
        publish(event, subscribers);
        publish(event, domain);
    }

    private void publish(FleetEvent event, ListenerList<Consumer<? super FleetEvent>> to) {
        to.each(listener -> listener.accept(event), (listener, fault) -> {
            if (!(event
                    instanceof
                    FleetEvent.ListenerFault)) { // a listener that fails at faults as well causes no further one
                publish(new FleetEvent.ListenerFault(listener.getClass().getName(), fault));
            }
        });
    }

    /** From now on a listener of the domain receives all events, after all subscribers and after the domain's earlier listeners. */
    public void passTo(Consumer<? super FleetEvent> listener) {
        domain.add(listener);
    }

    /** Publishes what happened to a task. For the fleet's thread. */
    public void onTask(TaskNews news, List<TaskId> names) {
        publish(new FleetEvent.TaskChanged(news, names));
    }

    @Override
    public Consumer<FleetEvent> found(String boatId) {
        return this::publish;
    }

    @Override
    public void onBoat(BoatProxy proxy) {
        publish(new FleetEvent.Found(proxy.boatId()));
    }

    @Override
    public void onMoved(String boatId, InetSocketAddress from, InetSocketAddress to) {
        publish(new FleetEvent.Moved(boatId, from, to));
    }

    @Override
    public void onRemoved(String boatId) {
        publish(new FleetEvent.Removed(boatId));
    }

    @Override
    public void onAlarm(LinkAlarm alarm) {
        publish(new FleetEvent.LinkAlarmed(alarm));
    }

    @Override
    public void onFailure(String what, RuntimeException cause) {
        publish(new FleetEvent.Fault(what, cause));
    }
}
