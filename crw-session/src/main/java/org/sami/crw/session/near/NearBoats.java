package org.sami.crw.session.near;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.crw.proxy.near.BoatFinder;
import org.sami.crw.proxy.near.FoundBoats;
import org.sami.crw.proxy.near.NearBoat;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.session.Session;
import org.sami.session.api.RefusedException;

/**
 * The boats near a session, live: looks for announcements and at the session's links until it is closed, on a thread of its own, which also reads this base's
 * keys. To be used on the session's front, on which changes are notified.
 */
public final class NearBoats implements Closeable {
    private static final long PERIOD_MS = 500; // links change without an announcement

    private final Session session;
    private final BoatFinder finder;
    private final BaseProtection protection;
    private final Executor front;
    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread made = new Thread(work, "boats near");
        made.setDaemon(true);
        return made;
    });
    private final Future<?> looks;
    private NearList list = NearList.NONE;
    private Runnable changed = () -> {};
    private boolean closed;

    /**
     * Begins to look.
     *
     * @param finder is closed with this
     * @param protection whose keys say which boats are paired
     * @param front runs what is to happen on the session's front
     */
    public NearBoats(Session session, BoatFinder finder, BaseProtection protection, Executor front) {
        this.session = session;
        this.finder = finder;
        this.protection = protection;
        this.front = front;
        finder.addListener(this::lookNow);
        looks = thread.scheduleWithFixedDelay(this::look, 0, PERIOD_MS, TimeUnit.MILLISECONDS);
    }

    private void lookNow() {
        try {
            thread.execute(this::look);
        } catch (RejectedExecutionException isClosed) {
            // nobody looks any longer
        }
    }

    private void look() {
        try {
            FoundBoats found = finder.snapshot();
            List<String> problems = new ArrayList<>(found.problems());
            problems.addAll(found.unreadable());
            List<NearBoat> near = near(found, problems);
            session.fleet().links().whenComplete((links, fault) -> {
                if (fault == null) { // otherwise the session is ending
                    front.execute(() -> show(near, links, problems));
                }
            });
        } catch (RuntimeException fault) {
            session.faults().guard().lost(Thread.currentThread().getName(), fault);
        }
    }

    /** Where the keys cannot be read, no boat is offered: it is not known which are paired. */
    private List<NearBoat> near(FoundBoats found, List<String> problems) {
        try {
            return NearBoat.of(found.boats(), protection, Set.of());
        } catch (IOException fault) {
            problems.add("the keys of this base cannot be read: " + fault.getMessage());
            return List.of();
        }
    }

    private void show(List<NearBoat> near, List<LinkReport> links, List<String> problems) {
        NearList next = NearList.of(near, links, problems);
        if (!closed && !next.equals(list)) {
            list = next;
            changed.run();
        }
    }

    /** Sets who is notified after each change, in place of whoever was. */
    public void onChange(Runnable listener) {
        changed = listener;
    }

    /** The boats as they were seen last. */
    public NearList list() {
        return list;
    }

    /**
     * Connects to an address, and keeps trying.
     *
     * @param refused receives the reason where it is not tried
     */
    public void connect(BoatAddress address, Consumer<String> refused) {
        session.fleet().connect(address).whenComplete((boat, fault) -> {
            if (fault != null) {
                refused.accept(address + " is refused: " + RefusedException.reason(fault));
            }
        });
        lookNow();
    }

    /**
     * Connects to all that are paired or need no pairing.
     *
     * @param refused receives reasons of addresses that are not tried
     * @return what is connected, and what not
     */
    public ConnectAll connectAll(Consumer<String> refused) {
        ConnectAll all = ConnectAll.of(list);
        all.connects().forEach(address -> connect(address, refused));
        return all;
    }

    /** Ends the search. What it connected goes on. */
    @Override
    public void close() {
        closed = true;
        looks.cancel(false);
        thread.shutdown();
        finder.close();
    }
}
