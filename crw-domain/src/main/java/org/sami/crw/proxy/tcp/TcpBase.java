package org.sami.crw.proxy.tcp;

import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;

/**
 * The boats of a base behind TCP: it connects to addresses, learns the boats' names, and drives their proxies on one thread of its own.
 *
 * <p>Broken links reconnect by themselves; the proxy decides what its boat does then. A boat whose server has restarted does not move before {@link
 * BoatProxy#confirmRestart}. Of two boats with one id the first is kept, the other refused with an alarm. A boat that is silent at one address and
 * answers at another has moved.
 *
 * <p>Proxies, registry and listeners live on the base's thread; {@link #query} runs work there. Safe for use by several threads.
 */
public final class TcpBase implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(TcpBase.class.getName());
    private static final long STOP_MS = 5000;

    private final SteadyClock clock;
    private final BaseListener listener;
    private final ScheduledExecutorService thread;
    private final Future<?> ticks;
    private volatile @Nullable Thread own; // that of the executor
    private final TcpBaseConfig config;
    private final Gateways gateways = new Gateways(); // this and the next: for the base's thread
    private final LinkTable links;
    private boolean stopped; // as well

    /** A base without boats, whose thread runs already. */
    public TcpBase(TcpBaseConfig config, SteadyClock clock, BaseListener listener) {
        this.clock = Objects.requireNonNull(clock, "clock");
        this.listener = Objects.requireNonNull(listener, "listener");
        this.config = Objects.requireNonNull(config, "config");
        links = new LinkTable(config, listener, this::connection, this::guarded);
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, config.proxy().clientId() + "-links");
            made.setDaemon(true);
            own = made;
            return made;
        });
        ticks = thread.scheduleWithFixedDelay(this::tick, config.tickMs(), config.tickMs(), TimeUnit.MILLISECONDS);
    }

    /** Begins to connect to the boat at an address, and keeps at it; an address that is known already is ignored. */
    public void connect(InetSocketAddress address) {
        run("connecting to " + address, () -> {
            if (!stopped) {
                links.add(address, now());
            }
        });
    }

    /**
     * Makes a proxy for a boat whose address is still unknown; its commands wait until the boat answers. At once where it is called on the base's
     * thread: what comes on it next may be a command for the boat.
     */
    public void expect(String boatId) {
        String what = "expecting " + boatId;
        Runnable work = () -> {
            if (!stopped) {
                links.expect(boatId);
            }
        };
        if (Thread.currentThread() == own) {
            guarded(what, work);
        } else {
            run(what, work);
        }
    }

    /**
     * Gives up a boat and its address. Its commands fail, it is stopped if it can be reached, and is then left alone. Gives whether
     * it was known.
     */
    public CompletableFuture<Boolean> remove(String boatId) {
        return CompletableFuture.supplyAsync(() -> links.remove(boatId, now()), thread);
    }

    /** Gives up an address, and as {@link #remove} the boat that it leads to. Gives whether it was known. */
    public CompletableFuture<Boolean> disconnect(InetSocketAddress address) {
        return CompletableFuture.supplyAsync(() -> links.remove(address, now()), thread);
    }

    /**
     * The area in which boats may go from now on, for those vehicles that keep to a fence by themselves; it moves and stops no boat of ours.
     *
     * @param within the area to stay in; empty without one
     * @param avoid areas that boats may not enter
     */
    public void keepTo(Optional<GeoArea> within, List<GeoArea> avoid, RobotKind robots) {
        run("the area in which boats may go", () -> gateways.keepTo(within, avoid, robots));
    }

    /** Asks or tells the proxies something on the base's thread. */
    public <T> CompletableFuture<T> query(Function<ProxyRegistry, T> question) {
        return CompletableFuture.supplyAsync(() -> question.apply(boats()), thread);
    }

    /**
     * The base's thread, for work that must not run in parallel with the proxies, such as handlers ({@code CrwDomain.install}). The listener receives
     * what it throws; after {@link #close} nothing runs.
     */
    public Executor executor() {
        return work -> run("work for the boats", work);
    }

    /** The boats. For the base's thread alone. */
    public ProxyRegistry boats() {
        return links.proxies();
    }

    /** How the links stand. For the base's thread alone. */
    public List<LinkReport> linkReports() {
        return links.reports();
    }

    /** How the links stand. */
    public CompletableFuture<List<LinkReport>> links() {
        return CompletableFuture.supplyAsync(links::reports, thread);
    }

    /** Closes all links and ends all threads. Waits for them for a few seconds; not to be called on the base's thread. */
    @Override
    public void close() {
        ticks.cancel(false);
        List<BoatConnection> closing = new ArrayList<>();
        run("closing", () -> {
            stopped = true;
            closing.addAll(links.connections());
            closing.forEach(connection -> connection.close("the base stops"));
            gateways.close();
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
        guarded("the links' clock", () -> links.tick(now())); // else nothing would ever tick again
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
            report(what, e);
        } catch (Error e) {
            report(what, new IllegalStateException(e));
        }
    }

    private void report(String what, RuntimeException cause) {
        LOG.log(Level.ERROR, "a fault in " + what, cause);
        try {
            listener.onFailure(what, cause);
        } catch (RuntimeException | Error e) { // else no boat would be ticked any longer
            LOG.log(Level.ERROR, "the listener threw when it was told of a fault in " + what, e);
        }
    }

    private BoatConnection connection(BoatLink link) {
        BoatConnection.Owner owner = ownerOf(link);
        return gateways.to(link.address())
                .<BoatConnection>map(gateway -> new GatewayConnection(gateway, link.address(), owner))
                .orElseGet(() -> new TcpConnection(link.address(), config, owner));
    }

    /** Brings what connections tell to the base's thread. */
    private BoatConnection.Owner ownerOf(BoatLink link) {
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

            @Override
            public void refused(BoatConnection connection, String why) {
                run("a refused link", () -> link.refused(connection, why, now()));
            }

            @Override
            public void found(InetSocketAddress boat) {
                run("a boat that was found", () -> {
                    if (!stopped) {
                        links.found(link.address(), boat, now());
                    }
                });
            }

            @Override
            public void said(Priority priority, String text) {
                run("a message of a boat", () -> links.said(link, priority, text));
            }
        };
    }
}
