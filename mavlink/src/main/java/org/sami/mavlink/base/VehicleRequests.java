package org.sami.mavlink.base;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import org.sami.mavlink.command.CommandMessages;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.link.ReceivedMessage;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.param.VehicleParameters;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleTable;

/** What a base asks of each vehicle and has no answer to yet: commands, lists, parameters, and the key with which it is to sign. Used by the base's thread. */
final class VehicleRequests implements MessageAsking.Requests {
    private static final long ITEM_MS = 20; // what an autopilot needs for an item of a list

    private final VehicleTable table;
    private final MavlinkBaseOptions options;
    private final LongSupplier nowMs;
    private final BaseThread thread;
    private final BiConsumer<VehicleId, Object> send;
    private final Map<VehicleId, VehicleExchanges> exchanges = new HashMap<>();
    private final Map<VehicleId, KeyGiving> keys = new HashMap<>();
    private boolean movesLists; // the tick of lists is scheduled

    /**
     * Nothing is asked yet.
     *
     * @param nowMs a clock of milliseconds that only goes on
     * @param thread which looks after lists more often than at each tick
     * @param send sends a message to a vehicle; may lose it
     */
    VehicleRequests(
            VehicleTable table,
            MavlinkBaseOptions options,
            LongSupplier nowMs,
            BaseThread thread,
            BiConsumer<VehicleId, Object> send) {
        this.table = table;
        this.options = options;
        this.nowMs = nowMs;
        this.thread = thread;
        this.send = send;
    }

    private VehicleExchanges of(VehicleId vehicle) {
        return exchanges.computeIfAbsent(
                vehicle, id -> new VehicleExchanges(id, options.parameters(), message -> send(id, message)));
    }

    /** Looks at each message that goes out, as commands are sent again: what may fly by now is never made to fall. */
    private void send(VehicleId vehicle, Object message) {
        send.accept(vehicle, table.mayFly(vehicle, nowMs.getAsLong()) ? CommandMessages.unforced(message) : message);
    }

    /** Reads a list that a vehicle holds, after the transfers that were asked for before. */
    CompletableFuture<List<MissionItem>> held(VehicleId vehicle, HeldKind kind) {
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        of(vehicle).lists().read(kind, nowMs.getAsLong(), result);
        moveLists();
        return result;
    }

    /** Replaces a list that a vehicle holds, in steps where there are several, after the transfers that were asked for before, and reads it back. */
    CompletableFuture<List<MissionItem>> replace(VehicleId vehicle, HeldKind kind, List<List<MissionItem>> lists) {
        if (table.sharesId(vehicle)) {
            return refused(vehicle);
        }
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        of(vehicle).lists().replace(kind, lists, nowMs.getAsLong(), result);
        moveLists();
        return result;
    }

    /** Sets a parameter of a vehicle; the result is what it holds then. */
    CompletableFuture<Double> setParameter(VehicleId vehicle, String name, double value) {
        return table.sharesId(vehicle) ? refused(vehicle) : parameters(vehicle).set(name, value, nowMs.getAsLong());
    }

    private static <T> CompletableFuture<T> refused(VehicleId vehicle) {
        return CompletableFuture.failedFuture(new IllegalStateException(CommandOutcome.ambiguous(vehicle)));
    }

    /** The parameters of a vehicle. */
    VehicleParameters parameters(VehicleId vehicle) {
        return of(vehicle).parameters();
    }

    /** Gives a vehicle the key of this base; completes once the vehicle signs with it. Fails where this base has none. */
    CompletableFuture<Void> giveKey(VehicleId vehicle) {
        if (table.sharesId(vehicle)) {
            return refused(vehicle);
        }
        return options.signing()
                .map(signing -> keys.computeIfAbsent(
                                vehicle, id -> new KeyGiving(id, signing, message -> send.accept(id, message)))
                        .begin(nowMs.getAsLong()))
                .orElseGet(() -> CompletableFuture.failedFuture(
                        new IllegalStateException("this base has no key that it could give")));
    }

    /** Gives a vehicle a command, and again until it answers. Where two vehicles have the id, none but disarming is given, and no list, parameter or key is changed. */
    CompletableFuture<CommandOutcome> command(VehicleId vehicle, VehicleCommand command, IntConsumer progress) {
        CompletableFuture<CommandOutcome> result = new CompletableFuture<>();
        if (table.sharesId(vehicle) && !command.isDisarming()) {
            result.complete(CommandOutcome.ambiguous(vehicle, command));
        } else {
            of(vehicle).commands().give(command, nowMs.getAsLong(), progress, result::complete);
        }
        return result;
    }

    /** A vehicle that does not answer is asked slowly: one message after the other. */
    @Override
    public void askAll(VehicleId vehicle, MessagePlan plan, MessageAsking.Answered answered) {
        if (plan.isTight()) {
            send.accept(vehicle, StreamStop.of(vehicle)); // what it sends by itself
        }
        of(vehicle).commands().withdrawUnsent(VehicleCommand.SEND_EVERY);
        plan.messages().forEach(message -> askOne(vehicle, message, answered));
    }

    @Override
    public void askOne(VehicleId vehicle, AskedMessage message, MessageAsking.Answered answered) {
        of(vehicle)
                .commands()
                .give(
                        VehicleCommand.sendEvery(message.number(), message.everyS()),
                        nowMs.getAsLong(),
                        percent -> {},
                        outcome -> answered.answered(message, outcome.verdict()));
    }

    /**
     * Receives what a vehicle has sent; one that is signed has a valid signature.
     *
     * @param events what happened to the vehicle by it
     */
    void take(VehicleId vehicle, ReceivedMessage message, List<VehicleEvent> events, long now) {
        if (message.signed()) {
            Optional.ofNullable(keys.get(vehicle)).ifPresent(KeyGiving::signed);
        }
        Optional.ofNullable(exchanges.get(vehicle))
                .ifPresent(open -> open.take(message.payload(), message.number(), events, now));
    }

    /** A vehicle's autopilot has started again. */
    void restarted(VehicleId vehicle) {
        Optional.ofNullable(exchanges.get(vehicle)).ifPresent(VehicleExchanges::restarted);
    }

    /** Another vehicle answers with this id: what was asked of the one before fails, and nothing of it is sent again. */
    void replaced(VehicleId vehicle) {
        Optional.ofNullable(exchanges.remove(vehicle)).ifPresent(VehicleExchanges::close);
        Optional.ofNullable(keys.remove(vehicle)).ifPresent(KeyGiving::replaced);
    }

    /** Sends again where an answer is overdue. */
    void tick(long now) {
        exchanges.values().forEach(open -> open.tick(now));
        keys.values().removeIf(giving -> giving.tick(now));
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

    /** What was asked and not answered fails. */
    void close() {
        exchanges.values().forEach(VehicleExchanges::close);
    }
}
