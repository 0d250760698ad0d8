package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.Welcome;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;

/**
 * The boats of a base behind TCP: connects to addresses, learns which boats are there, and drives their proxies on one thread
 * of its own.
 *
 * <p>Links come again by themselves after they broke. What a boat then does is its proxy's matter: a boat whose server has
 * started anew is not moved before {@link BoatProxy#confirmRestart}. Of two boats with one id the first that answered is kept,
 * the other refused and alarmed.
 *
 * <p>Proxies, registry and listeners live on the base's thread; {@link #query} brings others there. Safe for use by several
 * threads.
 */
public final class TcpBase implements AutoCloseable {
    private static final long STOP_MS = 5000;

    private final TcpBaseConfig config;
    private final SteadyClock clock;
    private final BaseListener listener;
    private final ScheduledExecutorService thread;
    private final Future<?> ticks;
    private final Hand hand = new Hand();

    // For the base's thread:
    private final List<BoatLink> links = new ArrayList<>();
    private final ProxyRegistry proxies = new ProxyRegistry();
    private final Set<LinkAlarm> alarmed = new LinkedHashSet<>();
    private boolean stopped;

    /** A base without boats, whose thread runs already. */
    public TcpBase(TcpBaseConfig config, SteadyClock clock, BaseListener listener) {
        this.config = Objects.requireNonNull(config, "config");
        this.clock = Objects.requireNonNull(clock, "clock");
        this.listener = Objects.requireNonNull(listener, "listener");
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, config.proxy().clientId() + "-links");
            made.setDaemon(true);
            return made;
        });
        ticks = thread.scheduleWithFixedDelay(this::tick, config.tickMs(), config.tickMs(), TimeUnit.MILLISECONDS);
    }

    /** Begins to connect to the boat at an address, and keeps at it; an address that is known already is ignored. */
    public void connect(InetSocketAddress address) {
        run("connecting to " + address, () -> {
            boolean known = links.stream().anyMatch(link -> link.address().equals(address));
            if (!known && !stopped) {
                BoatLink link = new BoatLink(address, config, hand, config.seed() + links.size());
                links.add(link);
                link.tick(now());
            }
        });
    }

    /** Asks or tells the proxies something on the base's thread. */
    public <T> CompletableFuture<T> query(Function<ProxyRegistry, T> question) {
        return CompletableFuture.supplyAsync(() -> question.apply(proxies), thread);
    }

    /**
     * The base's thread, for what must run beside the proxies, such as handlers ({@code CrwDomain.install}). What throws is told
     * to the listener; after {@link #close} nothing runs any longer.
     */
    public Executor executor() {
        return work -> run("work for the boats", work);
    }

    /** The boats. For the base's thread alone. */
    public ProxyRegistry boats() {
        return proxies;
    }

    /** How the links stand. */
    public CompletableFuture<List<LinkReport>> links() {
        return CompletableFuture.supplyAsync(
                () -> links.stream().map(BoatLink::report).toList(), thread);
    }

    /** Closes all links and ends all threads. Waits for them for a few seconds; not to be called on the base's thread. */
    @Override
    public void close() {
        ticks.cancel(false);
        List<BoatConnection> closing = new ArrayList<>();
        run("closing", () -> {
            stopped = true;
            links.forEach(link -> link.connection().ifPresent(closing::add));
            closing.forEach(connection -> connection.close("the base stops"));
        });
        thread.shutdown(); // what was said before still comes to the proxies
        try {
            if (thread.awaitTermination(STOP_MS, TimeUnit.MILLISECONDS)) {
                for (BoatConnection connection : closing) {
                    connection.join(STOP_MS);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            thread.shutdownNow();
        }
    }

    private long now() {
        return clock.getAsLong();
    }

    private void tick() {
        for (BoatLink link : links) {
            guarded("a tick of " + link.address(), () -> link.tick(now()));
        }
    }

    private void run(String what, Runnable work) {
        try {
            thread.execute(() -> guarded(what, work));
        } catch (RejectedExecutionException e) {
            // the base has stopped; nothing of this matters any longer
        }
    }

    private void guarded(String what, Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) {
            listener.onFailure(what, e);
        }
    }

    /** Brings what connections tell to the base's thread, and decides which boats are taken. */
    private final class Hand implements BoatLink.Base {
        @Override
        public BoatConnection.Owner ears(BoatLink link) {
            return new BoatConnection.Owner() {
                @Override
                public void opened(BoatConnection connection) {
                    run("an opened link", () -> link.opened(connection, now()));
                }

                @Override
                public void arrived(BoatConnection from, byte[] frame, Runnable done) {
                    run("a frame", () -> {
                        done.run();
                        link.arrived(from, frame, now());
                    });
                }

                @Override
                public void closed(BoatConnection connection, String why) {
                    run("a closed link", () -> link.closed(connection, why, now()));
                }
            };
        }

        @Override
        public Optional<BoatProxy> identified(BoatLink link, Welcome welcome) {
            Optional<BoatProxy> known = proxies.find(welcome.boatId());
            if (known.isPresent()) {
                alarm(link, welcome, known.get());
                return Optional.empty();
            }
            BoatProxy proxy = new BoatProxy(welcome.boatId(), link, listener.found(welcome.boatId()), config.proxy());
            proxies.add(proxy);
            listener.onBoat(proxy);
            return Optional.of(proxy);
        }

        private void alarm(BoatLink link, Welcome welcome, BoatProxy known) {
            BoatLink first = links.stream()
                    .filter(other -> other.report().boatId().equals(Optional.of(welcome.boatId())))
                    .findFirst()
                    .orElseThrow();
            boolean same = known.status().bootId().equals(welcome.bootId());
            String both = first.address() + " and " + link.address();
            LinkAlarm alarm = same
                    ? new LinkAlarm(
                            LinkAlarm.Kind.ONE_BOAT_AT_TWO_ADDRESSES,
                            welcome.boatId(),
                            link.address(),
                            welcome.boatId() + " is one boat at " + both + "; the second link is refused")
                    : new LinkAlarm(
                            LinkAlarm.Kind.TWO_BOATS_WITH_ONE_ID,
                            welcome.boatId(),
                            link.address(),
                            "two boats are named " + welcome.boatId() + ", at " + both + "; the second is refused");
            if (alarmed.add(alarm)) {
                listener.onAlarm(alarm);
            }
        }
    }
}
