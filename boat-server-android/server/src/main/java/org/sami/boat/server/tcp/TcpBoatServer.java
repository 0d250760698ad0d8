package org.sami.boat.server.tcp;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.server.BoatServer;

/**
 * One boat on a TCP port: it accepts clients, handles their frames and the ticks on one thread of its own, and drops clients that are too many, send no
 * greeting or do not read.
 *
 * <p>The {@link BoatServer} belongs to that thread from {@link #start} to the end of {@link #close}; no other thread may use it meanwhile. Safe for use by
 * several threads.
 */
public final class TcpBoatServer implements Closeable {
    private static final long STOP_MS = 5000;
    private static final long PAUSE_NANOS = 100_000_000;

    private final BoatServer boat;
    private final TcpServerConfig config;
    private final SteadyClock clock;
    private final LongConsumer beforeTick;
    private final TcpServerListener listener;
    private final String name;
    private final ServerSocket socket = new ServerSocket();
    private final ScheduledExecutorService boatThread;
    private final Thread acceptor;
    private final Set<ClientConnection> connections = ConcurrentHashMap.newKeySet();
    private final Map<ClientConnection, Client> clients = new LinkedHashMap<>(); // for the boat's thread
    private final List<BoatCompanion> companions = new ArrayList<>(); // for the boat's thread
    private final ConnectionSlots places;
    private final FileThread files;
    private final AtomicLong refused = new AtomicLong();
    private long accepts; // for the accepting thread
    private volatile boolean stopping;
    private volatile Future<?> ticks = CompletableFuture.completedFuture(null);

    /**
     * A server that does not listen yet.
     *
     * @param name of the boat, for the names of threads
     * @param clock for all timeouts of the boat
     * @param beforeTick called with the time in ms before each tick, on the boat's thread: a simulated hull moves there
     */
    public TcpBoatServer(
            String name,
            BoatServer boat,
            TcpServerConfig config,
            SteadyClock clock,
            LongConsumer beforeTick,
            TcpServerListener listener)
            throws IOException {
        this.name = Objects.requireNonNull(name, "name");
        this.boat = Objects.requireNonNull(boat, "boat");
        this.config = Objects.requireNonNull(config, "config");
        this.clock = Objects.requireNonNull(clock, "clock");
        this.beforeTick = Objects.requireNonNull(beforeTick, "beforeTick");
        this.listener = Objects.requireNonNull(listener, "listener");
        places = new ConnectionSlots(config.maxClients());
        boatThread = Executors.newSingleThreadScheduledExecutor(work -> daemon(work, name + "-boat"));
        files = new FileThread(name, config.files(), this::onBoat);
        acceptor = daemon(this::accept, name + "-accepts");
    }

    private static Thread daemon(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Begins to listen and to tick the boat.
     *
     * @throws IOException if the address cannot be had; the server is then closed
     */
    public void start() throws IOException {
        try {
            socket.setReuseAddress(true);
            socket.bind(config.address());
        } catch (IOException e) {
            close();
            throw e;
        }
        ticks = boatThread.scheduleWithFixedDelay(this::tick, 0, config.tickMs(), TimeUnit.MILLISECONDS);
        acceptor.start();
    }

    /** Where it listens, with the port that it got. */
    public InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    /** Has something work with the boat's server from now on. */
    public void attach(BoatCompanion companion) {
        onBoat(() -> {
            companion.begin(boat, this::onBoat, now());
            companions.add(companion);
        });
    }

    /** Ends what {@link #attach} began; otherwise it ends with the server. */
    public void detach(BoatCompanion companion) {
        onBoat(() -> {
            if (companions.remove(companion)) {
                companion.end(now());
            }
        });
    }

    /** How many clients are connected. */
    public int clientCount() {
        return connections.size();
    }

    /** How many connections were refused because they could not be protected, or for the client's key. */
    public long refusedConnections() {
        return refused.get();
    }

    /**
     * Stops listening, drops all clients and ends all threads; for the boat that is a lost link. Waits for the threads for a
     * few seconds. Closing again does nothing.
     */
    @Override
    public void close() throws IOException {
        stopping = true;
        socket.close();
        try {
            acceptor.join(STOP_MS); // from now on nobody comes in
            List<ClientConnection> open = new ArrayList<>(connections);
            open.forEach(connection -> connection.close("the boat's server stops"));
            ticks.cancel(false);
            files.close(STOP_MS);
            onBoat(this::endCompanions);
            boatThread.shutdown(); // the ends of the links still reach the boat
            boatThread.awaitTermination(STOP_MS, TimeUnit.MILLISECONDS);
            for (ClientConnection connection : open) {
                connection.join(STOP_MS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            boatThread.shutdownNow();
        }
    }

    private void tickCompanions(long nowMs) {
        for (BoatCompanion companion : companions) {
            try {
                companion.tick(nowMs);
            } catch (RuntimeException e) { // the boat and its clients go on
                listener.failed("what works with the boat's server failed", e);
            }
        }
    }

    private void endCompanions() {
        for (BoatCompanion companion : companions) {
            companion.end(now());
        }
        companions.clear();
    }

    private void accept() {
        while (!stopping) {
            try {
                admit(socket.accept());
            } catch (IOException | RuntimeException | Error e) {
                if (!stopping) {
                    listener.failed("a client could not be let in", e);
                    LockSupport.parkNanos(PAUSE_NANOS); // it may be for want of file handles or threads
                }
            }
        }
    }

    private void admit(Socket accepted) throws IOException {
        if (connections.size() >= places.withWaiting()) {
            makeRoom();
        }
        ClientConnection connection;
        try {
            connection = new ClientConnection(accepted, accepts++, config, name, new Hand());
        } catch (IOException e) {
            accepted.close();
            throw e;
        }
        connections.add(connection);
        listener.connected(connection.name());
        onBoat(() -> clients.put(connection, new Client(connection, boat.connect(connection, files), now())));
        try {
            connection.start();
        } catch (RuntimeException | Error e) {
            connection.close("there is no thread for it");
            throw e;
        }
    }

    /** Waits for the boat's thread, so that not more come than it can look at. */
    private void makeRoom() {
        try {
            boatThread.submit(() -> places.makeRoom(clients.values(), now())).get();
        } catch (ExecutionException e) {
            throw new IllegalStateException("no room could be made", e.getCause());
        } catch (RejectedExecutionException e) {
            // the server stops
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void tick() {
        try {
            long nowMs = now();
            beforeTick.accept(nowMs);
            boat.tick(nowMs);
            tickCompanions(nowMs);
            for (Client client : new ArrayList<>(clients.values())) {
                client.closeIfLeaving(nowMs);
                if (client.tick() * config.tickMs() > config.silentAfterMs()) {
                    client.connection().close("it says nothing that can be read");
                }
                if (client.isOverdue(nowMs, config.helloWithinMs())) {
                    client.connection().close("it does not say who it is");
                }
            }
            places.clear(clients.values(), nowMs);
        } catch (RuntimeException | Error e) { // whatever escapes would end all ticks, with the motors as they are
            listener.failed("a tick of the boat failed", e);
        }
    }

    private long now() {
        return clock.getAsLong();
    }

    private void onBoat(Runnable work) {
        try {
            boatThread.execute(() -> {
                try {
                    work.run();
                } catch (RuntimeException | Error e) {
                    listener.failed("a message could not be handled", e);
                }
            });
        } catch (RejectedExecutionException e) {
            if (!stopping) {
                throw e;
            }
        }
    }

    /** Brings the events of connections to the boat's thread. */
    private final class Hand implements ClientConnection.Owner {
        @Override
        public void secured(ClientConnection connection, Fingerprint key) {
            onBoat(() -> {
                Client client = clients.get(connection);
                if (client != null) {
                    client.protectedBy(config.keys().orElseThrow(IllegalStateException::new), key);
                }
            });
        }

        @Override
        public void notSecured(ClientConnection connection, String why) {
            refused.incrementAndGet();
        }

        @Override
        public void arrived(ClientConnection from, byte[] frame, Runnable done) {
            onBoat(() -> {
                done.run();
                Client client = clients.get(from);
                if (client != null) {
                    client.receive(frame, now());
                    places.clear(clients.values(), now());
                }
            });
        }

        @Override
        public void closed(ClientConnection connection, String why) {
            listener.closed(connection.name(), why);
            onBoat(() -> {
                Client client = clients.remove(connection);
                if (client != null) {
                    refused.addAndGet(client.isRefusedForItsKey() ? 1 : 0);
                    client.closed(now());
                }
            });
            connections.remove(connection); // the boat gets to know of it before any newer client
        }
    }
}
