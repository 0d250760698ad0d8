package org.sami.crw.fleet;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.listener.BoatListener;
import org.sami.crw.proxy.listener.BoatListeners;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.LinkAlarm;
import org.sami.crw.task.TaskNews;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.value.TaskId;

/**
 * The event bus of a base's boats. Proxies and links report to it as a {@link BoatListener} and a {@link BaseListener}; subscribers receive {@link
 * FleetEvent}s, in order, before plans do.
 *
 * <p>Events are published on the fleet's thread. Any thread may subscribe and unsubscribe. What a subscriber throws is logged, published to the
 * others as a {@link FleetEvent.Fault}, and stops no other subscriber.
 */
public final class FleetEvents implements BaseListener {
    private static final long SLOW_MILLIS = 50;

    private final ListenerList<Consumer<? super FleetEvent>> subscribers;
    private final BoatListener publisher = new BoatEventPublisher(this::publish);
    private volatile BoatListener proxies = new BoatListeners(publisher);

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

    /** Tells all subscribers. For the fleet's thread. */
    public void publish(FleetEvent event) {
        subscribers.each(subscriber -> subscriber.accept(event), (subscriber, fault) -> {
            if (!(event instanceof FleetEvent.Fault)) { // who fails at faults is not told of more
                publish(new FleetEvent.Fault("a subscriber of fleet events, " + nameOf(subscriber), fault));
            }
        });
    }

    private static String nameOf(Object subscriber) {
        return subscriber.getClass().getName();
    }

    /** What every proxy must be given: it tells the subscribers, then the domain. */
    public BoatListener boatListener() {
        return proxies;
    }

    /** From now on the domain is told of boats as well, after the subscribers; before the first proxy is made. */
    public void passTo(BoatListener domain) {
        proxies = new BoatListeners(publisher, domain);
    }

    /** Tells of a task. For the fleet's thread. */
    public void onTask(TaskNews news, List<TaskId> names) {
        publish(new FleetEvent.TaskChanged(news, names));
    }

    @Override
    public BoatListener found(String boatId) {
        return proxies;
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
