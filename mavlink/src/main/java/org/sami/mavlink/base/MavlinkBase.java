package org.sami.mavlink.base;

import io.dronefleet.mavlink.MavlinkMessage;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.MavlinkLink;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.ListDownload;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import org.sami.mavlink.vehicle.VehicleTable;

/**
 * A ground station's end of MAVLink: keeps links open, says on each once a second that it is there, and knows the vehicles that it hears. It asks vehicles to
 * report, and reads what they hold; it moves none. One thread owns its state; any thread may call it.
 */
public final class MavlinkBase implements AutoCloseable {
    private static final long HEARTBEAT_MS = 1_000;
    private static final long TICK_MS = 100;
    private static final int UNHANDLED = 2_000; // messages that may wait; a link that brings more waits itself
    private static final float REPORTS_EVERY_US = 500_000;

    /** The messages that are asked for: the battery (1), GPS (24), position (33) and state of the filter (193). */
    private static final List<Integer> REPORTS = List.of(1, 24, 33, 193);

    private final LongSupplier nowMs;
    private final List<MavlinkLink> links;
    private final ScheduledExecutorService owner;
    private final List<ScheduledFuture<?>> repeated;
    private final Semaphore room = new Semaphore(UNHANDLED);
    private final VehicleTable table = new VehicleTable();
    private final Set<VehicleId> asked = new HashSet<>();
    private final Map<VehicleId, Deque<Transfer>> transfers = new HashMap<>();

    /** A transfer and who waits for it. */
    private record Transfer(ListDownload download, CompletableFuture<List<MissionItem>> result) {}

    /**
     * Begins to open links; returns at once.
     *
     * @param nowMs a clock of milliseconds that only goes on
     */
    public MavlinkBase(List<MavlinkAddress> addresses, LongSupplier nowMs) {
        this.nowMs = Objects.requireNonNull(nowMs, "nowMs");
        ScheduledThreadPoolExecutor executor = new ScheduledThreadPoolExecutor(1, work -> {
            Thread thread = new Thread(work, "mavlink base");
            thread.setDaemon(true);
            return thread;
        });
        executor.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
        owner = executor;
        links = addresses.stream()
                .distinct()
                .map(address -> new MavlinkLink(address, this::received))
                .toList();
        links.forEach(MavlinkLink::start);
        repeated = List.of(
                owner.scheduleAtFixedRate(this::beat, 0, HEARTBEAT_MS, TimeUnit.MILLISECONDS),
                owner.scheduleAtFixedRate(this::tick, TICK_MS, TICK_MS, TimeUnit.MILLISECONDS));
    }

    /** What is known of each link, in the order of the addresses. */
    public List<MavlinkLinkReport> links() {
        return links.stream().map(MavlinkLink::report).toList();
    }

    /** What is known of each vehicle that was heard, by its id. */
    public CompletableFuture<List<VehicleSnapshot>> vehicles() {
        return CompletableFuture.supplyAsync(table::vehicles, owner);
    }

    /**
     * Reads a list that a vehicle holds, after the lists that were asked of it before.
     *
     * @return the items; fails with an {@link IllegalStateException} whose message says in words what went wrong
     */
    public CompletableFuture<List<MissionItem>> held(VehicleId vehicle, HeldKind kind) {
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        owner.execute(() -> {
            ListDownload download = new ListDownload(vehicle, kind, message -> send(vehicle, message));
            Deque<Transfer> waiting = transfers.computeIfAbsent(vehicle, id -> new ArrayDeque<>());
            waiting.addLast(new Transfer(download, result));
            if (waiting.size() == 1) {
                download.begin(nowMs.getAsLong());
            }
        });
        return result;
    }

    /** On a link's thread: waits where too much is not handled yet, so that the sender is slowed and memory is not filled. */
    private void received(MavlinkAddress from, MavlinkMessage<?> message) {
        room.acquireUninterruptibly();
        try {
            owner.execute(() -> {
                room.release();
                handle(from, message);
            });
        } catch (RejectedExecutionException closed) {
            room.release();
        }
    }

    private void handle(MavlinkAddress from, MavlinkMessage<?> message) {
        long now = nowMs.getAsLong();
        VehicleId id = new VehicleId(message.getOriginSystemId(), message.getOriginComponentId());
        table.heard(from, id.system(), id.component(), message.getPayload(), now);
        if (message.getPayload() instanceof Heartbeat && table.has(id) && asked.add(id)) {
            REPORTS.forEach(report -> send(id, interval(id, report)));
        }
        Deque<Transfer> waiting = transfers.get(id);
        if (waiting != null && !waiting.isEmpty()) {
            waiting.getFirst().download().take(message.getPayload(), now);
            goOn(waiting, now);
        }
    }

    private static CommandLong interval(VehicleId id, int message) {
        return CommandLong.builder()
                .targetSystem(id.system())
                .targetComponent(id.component())
                .command(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL)
                .param1(message)
                .param2(REPORTS_EVERY_US)
                .build();
    }

    private void beat() {
        Heartbeat beat = Heartbeat.builder()
                .type(MavType.MAV_TYPE_GCS)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_INVALID)
                .systemStatus(MavState.MAV_STATE_ACTIVE)
                .mavlinkVersion(3)
                .build();
        links.forEach(link -> link.send(beat));
    }

    private void tick() {
        long now = nowMs.getAsLong();
        transfers.values().forEach(waiting -> {
            if (!waiting.isEmpty()) {
                waiting.getFirst().download().tick(now);
                goOn(waiting, now);
            }
        });
    }

    /** Tells of transfers that are over, and begins the next. */
    private static void goOn(Deque<Transfer> waiting, long now) {
        while (!waiting.isEmpty() && waiting.getFirst().download().isOver()) {
            Transfer over = waiting.removeFirst();
            over.download()
                    .failure()
                    .ifPresentOrElse(
                            why -> over.result().completeExceptionally(new IllegalStateException(why)),
                            () -> over.result().complete(over.download().items()));
            if (!waiting.isEmpty()) {
                waiting.getFirst().download().begin(now);
            }
        }
    }

    /** Sends on the link on which a vehicle was heard last. */
    private void send(VehicleId vehicle, Object message) {
        table.linkOf(vehicle)
                .flatMap(address -> links.stream()
                        .filter(link -> link.address().equals(address))
                        .findFirst())
                .ifPresent(link -> link.send(message));
    }

    /** Closes all links; what was asked and not answered fails. */
    @Override
    public void close() {
        repeated.forEach(each -> each.cancel(false));
        links.forEach(MavlinkLink::close);
        CompletableFuture.runAsync(
                        () -> transfers
                                .values()
                                .forEach(waiting -> waiting.forEach(each -> each.result()
                                        .completeExceptionally(new IllegalStateException("the links are closed")))),
                        owner)
                .join();
        owner.shutdown();
    }
}
