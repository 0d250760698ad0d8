package org.sami.mavlink.base;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.command.CommandMessages;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.GuidedCourse;
import org.sami.mavlink.command.GuidedTarget;
import org.sami.mavlink.command.HandControl;
import org.sami.mavlink.command.RadioOverride;
import org.sami.mavlink.command.VehicleCommand;
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
 * A ground station's end of MAVLink: keeps links open, says on each once a second that it is there, and knows the vehicles that it hears, each on one link or on
 * several. It asks vehicles to report, reads what they hold, and gives them the commands that it is given. One thread owns its state; any thread may call it.
 */
public final class MavlinkBase implements AutoCloseable {
    private static final long HEARTBEAT_TICKS = 10; // a second

    private final LongSupplier nowMs;
    private final BaseLinks links;
    private final BaseThread thread;
    private final boolean hasOwnThread;
    private final Executor owner;
    private final Object closing = new Object();
    private boolean closed; // guarded by closing
    private final Runnable everyTick = this::tick;
    private long ticks;
    private final VehicleTable table = new VehicleTable();
    private final MessageAsking asking;
    private final LinkRecognition recognition;
    private final VehicleRequests requests;
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
        Objects.requireNonNull(options, "options");
        this.thread = thread;
        this.hasOwnThread = hasOwnThread;
        owner = this::execute;
        asking = new MessageAsking(table, options.signing().isPresent(), nowMs);
        requests = new VehicleRequests(table, options, nowMs, thread, this::send);
        links = new BaseLinks(addresses, options, owner, this::handle);
        recognition = new LinkRecognition(
                table,
                (vehicle, link, command) ->
                        links.send(link, vehicle.system(), CommandMessages.of(vehicle, command, 0)));
        links.start();
        thread.begin(everyTick);
    }

    /**
     * Opens one more link, if its address is another than those that are open; returns at once. One that is open at the same {@linkplain MavlinkAddress#place()
     * place} with another speed is closed first; the vehicles that were heard on it are expected on the new one. For one thread at a time.
     */
    public void open(MavlinkAddress address) {
        links.open(address, before -> owner.execute(() -> table.moved(before, address)));
    }

    /** Closes the link of an address, if there is one, so that others may have its port; returns at once. It may be opened again. For one thread at a time. */
    public void close(MavlinkAddress address) {
        links.close(address);
    }

    /** What is known of each link, in the order of the addresses. */
    public List<MavlinkLinkReport> links() {
        return links.reports();
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
        return on(() -> requests.held(vehicle, kind));
    }

    /**
     * Replaces a list that a vehicle holds, after the transfers that were asked for before, and reads it back. Where only a part differs from what the vehicle
     * is known to hold, that part is sent alone.
     *
     * @param items the new list in its order; an empty one empties it. Item 0 of a mission is the vehicle's home, which it keeps as it is
     * @return what was read back, which is equal; fails with an {@link IllegalStateException} whose message says in words what went wrong
     */
    public CompletableFuture<List<MissionItem>> replace(VehicleId vehicle, HeldKind kind, List<MissionItem> items) {
        return replaceInSteps(vehicle, kind, List.of(items));
    }

    /**
     * The same in steps: each list is sent only once the vehicle has taken the one before, whatever comes between; the last one is read back. So a vehicle whose
     * link is lost holds at each moment what follows from a part of the steps in their order.
     *
     * @param lists one at least
     */
    public CompletableFuture<List<MissionItem>> replaceInSteps(
            VehicleId vehicle, HeldKind kind, List<List<MissionItem>> lists) {
        List<List<MissionItem>> copy = lists.stream().map(List::copyOf).toList();
        return on(() -> requests.replace(vehicle, kind, copy));
    }

    /** All parameters of a vehicle by their names, as it holds them now. Fails as {@link #held} does. */
    public CompletableFuture<SortedMap<String, Double>> readParameters(VehicleId vehicle) {
        return on(() -> requests.parameters(vehicle).readAll(nowMs.getAsLong()));
    }

    /** One parameter, as the vehicle holds it now. Fails as {@link #held} does. */
    public CompletableFuture<Double> parameter(VehicleId vehicle, String name) {
        return on(() -> requests.parameters(vehicle).read(name, nowMs.getAsLong()));
    }

    /** Sets a parameter; the result is what the vehicle holds then, which is equal. Fails as {@link #held} does. */
    public CompletableFuture<Double> setParameter(VehicleId vehicle, String name, double value) {
        return on(() -> requests.setParameter(vehicle, name, value));
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
        return on(() -> requests.giveKey(vehicle));
    }

    /** What the vehicles on each link are asked to send, and what it costs. */
    public CompletableFuture<Map<MavlinkAddress, MessagePlan>> plans() {
        return CompletableFuture.supplyAsync(() -> asking.plans(links.addresses()), owner);
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
        IntConsumer told = percent -> {
            progress.accept(percent);
            tell(List.of(new VehicleEvent.CommandProgressed(vehicle, command.does(), percent)));
        };
        return on(() -> requests.command(vehicle, command, told));
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

    /** Has all know that a vehicle's autopilot has started again, as who asks found out by another way than its clock; does nothing for a vehicle that was not heard. */
    public void restarted(VehicleId vehicle) {
        owner.execute(() -> {
            if (table.has(vehicle)) {
                table.restarted(vehicle);
                asking.renew(vehicle);
                requests.restarted(vehicle);
                tell(List.of(new VehicleEvent.Restarted(vehicle)));
            }
        });
    }

    private void tell(List<VehicleEvent> events) {
        events.forEach(event -> listeners.forEach(listener -> listener.accept(event)));
    }

    /** Has a listener receive what happens to vehicles from now on, on the base's thread: it must return at once and not throw. */
    public void addListener(Consumer<VehicleEvent> listener) {
        listeners.add(listener);
    }

    /** Ends what {@link #addListener} began. */
    public void removeListener(Consumer<VehicleEvent> listener) {
        listeners.remove(listener);
    }

    private void handle(MavlinkAddress from, ReceivedMessage message) {
        if (links.isOwnHeartbeat(message.payload())) {
            return;
        }
        long now = nowMs.getAsLong();
        VehicleId id = new VehicleId(message.system(), message.component());
        List<VehicleEvent> events = table.heard(
                new MessageOrigin(from, id.system(), id.component(), message.number()), message.payload(), now);
        for (VehicleEvent event : events) {
            if (event instanceof VehicleEvent.Appeared
                    || event instanceof VehicleEvent.Restarted
                    || event instanceof VehicleEvent.Replaced) {
                asking.renew(id);
            }
        }
        if (!table.isForeign(id, from)) {
            requests.take(id, message, events, now); // signed with the right key, or the link had refused it
        }
        tell(events);
        if (table.has(id) && !table.isForeign(id, from)) {
            AnswerTargets.obeyed(message.payload())
                    .ifPresent(station -> tell(List.of(new VehicleEvent.ObeyedStation(id, station))));
        }
        if (events.stream().anyMatch(VehicleEvent.Replaced.class::isInstance)) {
            requests.replaced(id); // once who asked knows why
        }
    }

    private void tick() {
        if (ticks++ % HEARTBEAT_TICKS == 0) {
            links.sendHeartbeat();
            table.radios(links.radios());
        }
        long now = nowMs.getAsLong();
        tell(table.tick(now));
        requests.tick(now);
        asking.tick(requests);
        recognition.tick(now);
    }

    /** Sends on the link that is chosen for a vehicle. */
    private void send(VehicleId vehicle, Object message) {
        table.linkOf(vehicle).ifPresent(address -> links.send(address, vehicle.system(), message));
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
        links.close();
        CompletableFuture<Void> ended;
        synchronized (closing) { // what was asked before it runs before it, and nothing after it
            if (closed) {
                return;
            }
            ended = CompletableFuture.runAsync(requests::close, thread.executor());
            closed = true;
        }
        ended.join();
        if (hasOwnThread) {
            thread.close();
        }
    }
}
