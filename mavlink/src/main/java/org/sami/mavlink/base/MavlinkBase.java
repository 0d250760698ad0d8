package org.sami.mavlink.base;

import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.GuidedCourse;
import org.sami.mavlink.command.GuidedTarget;
import org.sami.mavlink.command.HandControl;
import org.sami.mavlink.command.RadioOverride;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.link.LinkEnd;
import org.sami.mavlink.link.MavlinkLink;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.ReceivedMessage;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.MessageOrigin;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import org.sami.mavlink.vehicle.VehicleTable;

/**
 * A ground station's end of MAVLink: keeps links open, says on each once a second that it is there, and knows the vehicles that it hears. It asks vehicles to
 * report, reads what they hold, and gives them the commands that it is given. One thread owns its state; any thread may call it.
 */
public final class MavlinkBase implements AutoCloseable {
    private static final long HEARTBEAT_TICKS = 10; // a second
    private static final long ITEM_MS = 20; // what an autopilot needs for an item of a list
    private static final int UNHANDLED = 2_000; // messages that may wait; a link that brings more waits itself

    private final LongSupplier nowMs;
    private final List<MavlinkLink> links;
    private final BaseThread thread;
    private final boolean hasOwnThread;
    private final Executor owner;
    private final Object closing = new Object();
    private boolean closed; // guarded by closing
    private final Runnable everyTick = this::tick;
    private long ticks;
    private final Semaphore room = new Semaphore(UNHANDLED);
    private final VehicleTable table = new VehicleTable();
    private final MessageAsking asking;
    private final MavlinkBaseOptions options;
    private final Map<VehicleId, VehicleExchanges> exchanges = new HashMap<>();
    private final Map<VehicleId, KeyGiving> keys = new HashMap<>();
    private boolean movesLists; // the tick of lists is scheduled
    private final List<Consumer<VehicleEvent>> listeners = new CopyOnWriteArrayList<>();

    /** A base that keeps nothing and signs nothing. */
    public MavlinkBase(List<MavlinkAddress> addresses, LongSupplier nowMs) {
        this(addresses, nowMs, MavlinkBaseOptions.none());
    }

    /**
     * Begins to open links; returns at once.
     *
     * @param nowMs a clock of milliseconds that only goes on
     */
    public MavlinkBase(List<MavlinkAddress> addresses, LongSupplier nowMs, MavlinkBaseOptions options) {
        this(addresses, nowMs, options, new BaseThread(), true);
    }

    /** The same on a thread that serves several bases, and does not end with this one. */
    public MavlinkBase(
            List<MavlinkAddress> addresses, LongSupplier nowMs, MavlinkBaseOptions options, BaseThread shared) {
        this(addresses, nowMs, options, shared, false);
    }

    private MavlinkBase(
            List<MavlinkAddress> addresses,
            LongSupplier nowMs,
            MavlinkBaseOptions options,
            BaseThread thread,
            boolean hasOwnThread) {
        this.nowMs = Objects.requireNonNull(nowMs, "nowMs");
        this.options = Objects.requireNonNull(options, "options");
        this.thread = thread;
        this.hasOwnThread = hasOwnThread;
        owner = this::execute;
        asking = new MessageAsking(table, options.signing().isPresent());
        List<MavlinkAddress> each = addresses.stream().distinct().toList();
        links = IntStream.range(0, each.size())
                .mapToObj(i -> new MavlinkLink(
                        each.get(i),
                        this::received,
                        LinkEnd.ground(i, options.signing()),
                        ReadMessages.KINDS::contains))
                .toList();
        links.forEach(MavlinkLink::start);
        thread.begin(everyTick);
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
            exchangesOf(vehicle).lists().read(kind, nowMs.getAsLong(), result);
            moveLists();
        });
        return result;
    }

    /**
     * Replaces a list that a vehicle holds, after the transfers that were asked for before, and reads it back. Where only a part differs from what the vehicle
     * is known to hold, that part is sent alone.
     *
     * @param items the new list in its order; an empty one empties it. Item 0 of a mission is the vehicle's home, which it keeps as it is
     * @return what was read back, which is equal; fails with an {@link IllegalStateException} whose message says in words what went wrong
     */
    public CompletableFuture<List<MissionItem>> replace(VehicleId vehicle, HeldKind kind, List<MissionItem> items) {
        List<MissionItem> copy = List.copyOf(items);
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        owner.execute(() -> {
            exchangesOf(vehicle).lists().replace(kind, copy, nowMs.getAsLong(), result);
            moveLists();
        });
        return result;
    }

    private VehicleExchanges exchangesOf(VehicleId vehicle) {
        return exchanges.computeIfAbsent(
                vehicle, id -> new VehicleExchanges(id, options.parameters(), message -> send(id, message)));
    }

    /** All parameters of a vehicle by their names: those that are kept, or else it is asked. Fails as {@link #held} does. */
    public CompletableFuture<SortedMap<String, Double>> parameters(VehicleId vehicle) {
        return on(() -> exchangesOf(vehicle).parameters().all(nowMs.getAsLong()));
    }

    /** The same, but the vehicle is asked in any case. */
    public CompletableFuture<SortedMap<String, Double>> readParameters(VehicleId vehicle) {
        return on(() -> exchangesOf(vehicle).parameters().readAll(nowMs.getAsLong()));
    }

    /** One parameter, as the vehicle holds it now. Fails as {@link #held} does. */
    public CompletableFuture<Double> parameter(VehicleId vehicle, String name) {
        return on(() -> exchangesOf(vehicle).parameters().read(name, nowMs.getAsLong()));
    }

    /** Sets a parameter; the result is what the vehicle holds then, which is equal. Fails as {@link #held} does. */
    public CompletableFuture<Double> setParameter(VehicleId vehicle, String name, double value) {
        return on(() -> exchangesOf(vehicle).parameters().set(name, value, nowMs.getAsLong()));
    }

    private <T> CompletableFuture<T> on(Supplier<CompletableFuture<T>> what) {
        CompletableFuture<T> result = new CompletableFuture<>();
        owner.execute(() -> {
            var unused = what.get().whenComplete((value, failure) -> {
                if (failure == null) {
                    result.complete(value);
                } else {
                    result.completeExceptionally(failure);
                }
            });
        });
        return result;
    }

    /**
     * Gives a vehicle the key with which this base signs, so that from then on it signs too and refuses those who have another. Autopilots take a key only on a
     * link that nobody can listen to, a cable.
     *
     * @return completes once the vehicle has sent something that is signed with it; fails as {@link #held} does where it does not within seconds
     */
    public CompletableFuture<Void> giveKey(VehicleId vehicle) {
        return on(() -> options.signing()
                .map(signing -> keys.computeIfAbsent(
                                vehicle, id -> new KeyGiving(id, signing, message -> send(id, message)))
                        .begin(nowMs.getAsLong()))
                .orElseGet(() -> CompletableFuture.failedFuture(
                        new IllegalStateException("this base has no key that it could give"))));
    }

    /** What the vehicles on each link are asked to send, and what it costs. */
    public CompletableFuture<Map<MavlinkAddress, MessagePlan>> plans() {
        return CompletableFuture.supplyAsync(
                () -> {
                    Map<MavlinkAddress, MessagePlan> plans = new LinkedHashMap<>();
                    links.forEach(link -> plans.put(link.address(), asking.plan(link.address())));
                    return plans;
                },
                owner);
    }

    /**
     * Gives a vehicle a command, and again until it answers. Where two vehicles have the id, none but disarming is given.
     *
     * @return how it ended; it does not fail where the vehicle refuses
     */
    public CompletableFuture<CommandOutcome> command(VehicleId vehicle, VehicleCommand command) {
        return command(vehicle, command, percent -> {});
    }

    /** The same; {@code progress} receives percents while the vehicle is at it, where it says so, on the base's thread. */
    public CompletableFuture<CommandOutcome> command(VehicleId vehicle, VehicleCommand command, IntConsumer progress) {
        CompletableFuture<CommandOutcome> result = new CompletableFuture<>();
        owner.execute(() -> {
            if (table.isTwin(vehicle) && !command.isDisarming()) {
                result.complete(CommandOutcome.ambiguous(vehicle, command));
            } else {
                exchangesOf(vehicle).commands().give(command, nowMs.getAsLong(), progress, result::complete);
            }
        });
        return result;
    }

    /**
     * Changes a vehicle's mode.
     *
     * @param mode as pilots name it, such as {@code AUTO}
     * @return how it ended; fails with an {@link IllegalStateException} where the vehicle was not heard or has no such mode
     */
    public CompletableFuture<CommandOutcome> setMode(VehicleId vehicle, String mode) {
        return CompletableFuture.supplyAsync(() -> table.modeNumber(vehicle, mode), owner)
                .thenCompose(number -> number.map(
                                known -> command(vehicle, VehicleCommand.setMode(known, mode.toUpperCase(Locale.ROOT))))
                        .orElseGet(() -> CompletableFuture.failedFuture(new IllegalStateException(
                                "vehicle " + vehicle + " was not heard, or has no mode " + mode))));
    }

    /** Sends a target to a vehicle that is in mode GUIDED; without an answer, and lost where the link loses it. */
    public void guide(VehicleId vehicle, GuidedTarget target) {
        owner.execute(() -> send(vehicle, target.message(vehicle)));
    }

    /** Sends heading and speed to a boat that is in mode GUIDED; without an answer, and lost where the link loses it. */
    public void guide(VehicleId vehicle, GuidedCourse course) {
        owner.execute(() -> send(vehicle, course.message(vehicle)));
    }

    /** Sends sticks to a vehicle; without an answer. Whoever drives by hand calls it several times a second. */
    public void steer(VehicleId vehicle, HandControl sticks) {
        owner.execute(() ->
                table.vehicle(vehicle).ifPresent(known -> send(vehicle, sticks.message(vehicle, known.kind()))));
    }

    /** Takes the place of radio control, or gives it back; without an answer, and forgotten by the autopilot after its own time. */
    public void overrideRadio(VehicleId vehicle, RadioOverride pulses) {
        owner.execute(() -> send(vehicle, pulses.message(vehicle)));
    }

    /** Has a listener receive what happens to vehicles from now on, on the base's thread: it must return at once and not throw. */
    public void addListener(Consumer<VehicleEvent> listener) {
        listeners.add(listener);
    }

    /** Ends what {@link #addListener} began. */
    public void removeListener(Consumer<VehicleEvent> listener) {
        listeners.remove(listener);
    }

    /** On a link's thread: waits where too much is not handled yet, so that the sender is slowed and memory is not filled. */
    private void received(MavlinkAddress from, List<ReceivedMessage> messages) {
        room.acquireUninterruptibly(messages.size());
        try {
            owner.execute(() -> {
                room.release(messages.size());
                messages.forEach(message -> BaseThread.run(() -> handle(from, message)));
            });
        } catch (RejectedExecutionException closed) {
            room.release(messages.size());
        }
    }

    private void handle(MavlinkAddress from, ReceivedMessage message) {
        long now = nowMs.getAsLong();
        VehicleId id = new VehicleId(message.system(), message.component());
        List<VehicleEvent> events = table.heard(
                new MessageOrigin(from, id.system(), id.component(), message.number()), message.payload(), now);
        for (VehicleEvent event : events) {
            if (event instanceof VehicleEvent.Appeared || event instanceof VehicleEvent.Restarted) {
                asking.renew(id, now);
            }
        }
        if (message.signed()) { // rightly, or the link had refused it
            Optional.ofNullable(keys.get(id)).ifPresent(KeyGiving::signed);
        }
        Optional.ofNullable(exchanges.get(id)).ifPresent(open -> open.take(message.payload(), events, now));
        events.forEach(event -> listeners.forEach(listener -> listener.accept(event)));
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
        if (ticks++ % HEARTBEAT_TICKS == 0) {
            beat();
        }
        long now = nowMs.getAsLong();
        exchanges.values().forEach(open -> open.tick(now));
        keys.values().removeIf(giving -> giving.tick(now));
        asking.tick(now, this::ask);
    }

    /** Looks after lists more often than after all else, as long as any is read or sent. */
    private void moveLists() {
        boolean isAny =
                exchanges.values().stream().anyMatch(open -> open.lists().isBusy());
        if (isAny && !movesLists) {
            movesLists = true;
            thread.later(this::tickLists, ITEM_MS);
        }
    }

    private void tickLists() {
        movesLists = false;
        long now = nowMs.getAsLong();
        exchanges.values().forEach(open -> open.lists().tick(now));
        moveLists();
    }

    private void ask(VehicleId vehicle, MessagePlan plan) {
        if (plan.isTight()) {
            send(vehicle, Silence.of(vehicle)); // what it sends by itself
        }
        plan.messages()
                .forEach(message -> exchangesOf(vehicle)
                        .commands()
                        .give(
                                VehicleCommand.sendEvery(message.number(), message.everyS()),
                                nowMs.getAsLong(),
                                percent -> {},
                                outcome -> {}));
    }

    /** Sends on the link on which a vehicle was heard last. */
    private void send(VehicleId vehicle, Object message) {
        table.linkOf(vehicle)
                .flatMap(address -> links.stream()
                        .filter(link -> link.address().equals(address))
                        .findFirst())
                .ifPresent(link -> link.send(message));
    }

    private void execute(Runnable work) {
        synchronized (closing) {
            if (closed) {
                throw new RejectedExecutionException("this base of vehicles is closed");
            }
            thread.executor().execute(work);
        }
    }

    /** Closes all links; what was asked and not answered fails, and what is asked from then on is rejected, on a thread that goes on as well. */
    @Override
    public void close() {
        thread.end(everyTick);
        links.forEach(MavlinkLink::close);
        CompletableFuture<Void> ended;
        synchronized (closing) { // what was asked before it runs before it, and nothing after it
            if (closed) {
                return;
            }
            ended = CompletableFuture.runAsync(
                    () -> exchanges.values().forEach(VehicleExchanges::close), thread.executor());
            closed = true;
        }
        ended.join();
        if (hasOwnThread) {
            thread.close();
        }
    }
}
