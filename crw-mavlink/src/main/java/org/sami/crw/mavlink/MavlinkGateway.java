package org.sami.crw.mavlink;

import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.gateway.BoatGateway;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.base.MavlinkBaseOptions;
import org.sami.mavlink.link.SigningKey;
import org.sami.spn.value.GeoArea;

/**
 * Reaches vehicles that speak MAVLink for one base. One thread owns everything about the boats, and one {@link MavlinkBase} all links: a vehicle that is heard
 * on several is one boat. Safe for use by several threads.
 */
public final class MavlinkGateway implements BoatGateway {
    private static final System.Logger LOG = System.getLogger(MavlinkGateway.class.getName());
    private static final long TICK_MS = 100;
    private static final long LOOK_MS = 20;
    private static final long LEAVE_MS = 1_500; // an answer, and the heartbeat after it

    private final LongSupplier nowMs;
    private final ScheduledExecutorService thread;
    private final Future<?> ticks;
    private final VehicleLinks links; // this and the next for the thread
    private boolean closed;

    /**
     * A gateway without links, whose thread runs.
     *
     * @param nowMs a clock of milliseconds that only goes on
     * @param files stores what the next base needs after a crash of this one
     * @param fleetKey signs all that is sent, where this base has one; who has signed with it is not taken without a signature any longer
     */
    public MavlinkGateway(LongSupplier nowMs, VehicleFiles files, Optional<SigningKey> fleetKey) {
        this(nowMs, files, () -> fleetKey);
    }

    /**
     * The same with a key that may be replaced while the gateway runs.
     *
     * @param fleetKey reads the key where it is kept, now and then again every second; throws an {@link IllegalStateException} in words where it cannot
     */
    public MavlinkGateway(LongSupplier nowMs, VehicleFiles files, Supplier<Optional<SigningKey>> fleetKey) {
        this.nowMs = Objects.requireNonNull(nowMs, "nowMs");
        FleetKeyInUse key = new FleetKeyInUse(fleetKey);
        MavlinkBase base = new MavlinkBase(List.of(), nowMs, new MavlinkBaseOptions(Optional.empty(), key.signing()));
        links = new VehicleLinks(base, executor(), nowMs, Objects.requireNonNull(files, "files"), key);
        ScheduledThreadPoolExecutor executor = new ScheduledThreadPoolExecutor(1, work -> {
            Thread made = new Thread(work, "mavlink boats");
            made.setDaemon(true);
            return made;
        });
        executor.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
        thread = executor;
        ticks = thread.scheduleWithFixedDelay(
                () -> GuardedWork.run(links::tick), TICK_MS, TICK_MS, TimeUnit.MILLISECONDS);
    }

    @Override
    public GatewayLink connect(InetSocketAddress address, GatewayLink.Listener listener) {
        VehicleConnection connection = new VehicleConnection(address, listener, executor());
        executor().execute(() -> add(connection));
        return connection;
    }

    @Override
    public void keepTo(Optional<GeoArea> within, List<GeoArea> avoid, RobotKind robots) {
        executor()
                .execute(
                        () -> links.keepTo(new SessionFence(FenceItems.of(within, avoid), robots == RobotKind.COPTER)));
    }

    private void add(VehicleConnection connection) {
        try {
            links.add(connection, nowMs.getAsLong());
        } catch (IllegalArgumentException e) {
            connection.end(String.valueOf(e.getMessage()));
        }
    }

    /** Its thread; what is thrown there is logged, and after the end nothing runs. */
    private Executor executor() {
        return work -> {
            try {
                thread.execute(() -> {
                    if (!closed) { // else links are closed already that it would need
                        GuardedWork.run(work);
                    }
                });
            } catch (RejectedExecutionException e) {
                // the gateway has ended; nothing of this matters any longer
            }
        };
    }

    /** Ends it after the last orders, such as to keep the place, were carried out; waits for that at most 1.5 s. */
    @Override
    public void close() {
        if (thread.isShutdown()) {
            return;
        }
        CountDownLatch quiet = new CountDownLatch(1);
        var unused = thread.scheduleWithFixedDelay( // after what was asked before
                () -> {
                    if (!links.isBusy()) {
                        quiet.countDown();
                    }
                },
                0,
                LOOK_MS,
                TimeUnit.MILLISECONDS);
        try {
            if (!quiet.await(LEAVE_MS, TimeUnit.MILLISECONDS)) {
                LOG.log(Level.WARNING, "a vehicle had not carried out its last order when the base ended");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            end();
        }
    }

    private void end() {
        ticks.cancel(false);
        executor().execute(() -> {
            closed = true;
            links.close();
        });
        thread.shutdown();
    }
}
