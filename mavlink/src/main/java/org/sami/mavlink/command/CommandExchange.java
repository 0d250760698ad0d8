package org.sami.mavlink.command;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.MavResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * One command until it is answered: sent again when the answer is overdue, with progress while the vehicle works on it. After a refusal the exchange waits a
 * moment for the texts in which autopilots give the reason. Used by one thread.
 *
 * <p>Source: the command protocol of MAVLink's documentation.
 */
final class CommandExchange {
    private static final long ANSWER_MS = 1_000;
    private static final long PROGRESS_MS = 10_000;
    private static final long WORDS_MS = 700;
    private static final int TRIES = 5;
    private static final int NO_PROGRESS = 255;

    private final VehicleId vehicle;
    private final VehicleCommand command;
    private final Consumer<Object> send;
    private final IntConsumer progress;
    private final List<String> said = new ArrayList<>();
    private Optional<CommandVerdict> verdict = Optional.empty();
    private boolean doubtful;
    private boolean over;
    private int tries;
    private long dueMs;

    /**
     * An exchange that is not begun yet.
     *
     * @param doubtful whether the first answer may be to an earlier command of the same number: it is not counted then, and the command is sent again
     */
    CommandExchange(
            VehicleId vehicle, VehicleCommand command, boolean doubtful, Consumer<Object> send, IntConsumer progress) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.command = Objects.requireNonNull(command, "command");
        this.doubtful = doubtful;
        this.send = Objects.requireNonNull(send, "send");
        this.progress = Objects.requireNonNull(progress, "progress");
    }

    void begin(long nowMs) {
        ask(nowMs);
    }

    private void ask(long nowMs) {
        send.accept(CommandMessages.of(vehicle, command, tries));
        tries++;
        dueMs = nowMs + ANSWER_MS;
    }

    /** Goes on where something is due. */
    void tick(long nowMs) {
        if (over || tries == 0 || nowMs < dueMs) {
            return;
        }
        if (verdict.isPresent()) {
            over = true;
        } else if (tries == TRIES) {
            verdict = Optional.of(CommandVerdict.UNANSWERED);
            over = true;
        } else {
            ask(nowMs);
        }
    }

    /** Takes what the vehicle sent. */
    void take(Object message, long nowMs) {
        if (over
                || tries == 0
                || !(message instanceof CommandAck ack)
                || ack.command().value() != command.number()) {
            return;
        }
        if (ack.result().entry() == MavResult.MAV_RESULT_IN_PROGRESS) {
            dueMs = nowMs + PROGRESS_MS;
            if (ack.progress() != NO_PROGRESS) {
                progress.accept(ack.progress());
            }
        } else if (doubtful) {
            doubtful = false;
            tries = 0;
            ask(nowMs);
        } else if (verdict.isEmpty()) {
            CommandVerdict answer = verdict(ack.result().entry());
            verdict = Optional.of(answer);
            over = answer == CommandVerdict.ACCEPTED;
            dueMs = nowMs + WORDS_MS;
        }
    }

    private static CommandVerdict verdict(MavResult result) {
        if (result == null) {
            return CommandVerdict.DENIED;
        }
        return switch (result) {
            case MAV_RESULT_ACCEPTED -> CommandVerdict.ACCEPTED;
            case MAV_RESULT_TEMPORARILY_REJECTED -> CommandVerdict.NOT_NOW;
            case MAV_RESULT_UNSUPPORTED -> CommandVerdict.UNKNOWN_TO_IT;
            case MAV_RESULT_FAILED -> CommandVerdict.FAILED;
            case MAV_RESULT_CANCELLED -> CommandVerdict.CANCELLED;
            default -> CommandVerdict.DENIED;
        };
    }

    /** The autopilot said something, which may be about this command. */
    void heard(StatusText text) {
        boolean matters = text.severity().compareTo(TextSeverity.NOTICE) <= 0;
        if (!over && tries > 0 && matters && !said.contains(text.text())) {
            said.add(text.text());
        }
    }

    /** A later command takes its place. Whether its own answer may still come. */
    boolean replace() {
        over = true;
        boolean answered = verdict.isPresent();
        verdict = Optional.of(CommandVerdict.REPLACED);
        return tries > 0 && !answered;
    }

    boolean isOver() {
        return over;
    }

    VehicleCommand command() {
        return command;
    }

    /** How it ended. */
    CommandOutcome outcome() {
        return new CommandOutcome(vehicle, command, verdict.orElse(CommandVerdict.UNANSWERED), said);
    }
}
