package org.sami.mavlink.command;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * The commands that one vehicle has not answered yet. Commands of one number are sent one after the other, because an answer names only the number; commands of
 * different numbers do not wait for each other. Used by one thread.
 */
public final class PendingCommands {
    private final VehicleId vehicle;
    private final Consumer<Object> send;
    private final TreeMap<Integer, Deque<Waiting>> byNumber = new TreeMap<>();

    /** A command and who waits for it. */
    private record Waiting(CommandExchange exchange, Consumer<CommandOutcome> outcome) {}

    /**
     * No commands yet.
     *
     * @param send sends a message of the library to the vehicle; may lose it
     */
    public PendingCommands(VehicleId vehicle, Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.send = Objects.requireNonNull(send, "send");
    }

    /**
     * Gives a command.
     *
     * @param progress receives percents while the vehicle is at it, where it says so
     * @param outcome receives once how it ended
     */
    public void give(VehicleCommand command, long nowMs, IntConsumer progress, Consumer<CommandOutcome> outcome) {
        Deque<Waiting> waiting = byNumber.computeIfAbsent(command.number(), number -> new ArrayDeque<>());
        List<Waiting> replaced = new ArrayList<>();
        boolean doubtful = false;
        if (command.newestWins()) {
            for (Waiting each : waiting) {
                doubtful |= each.exchange().replace();
                replaced.add(each);
            }
            waiting.clear();
        }
        CommandExchange exchange = new CommandExchange(vehicle, command, doubtful, send, progress);
        waiting.addLast(new Waiting(exchange, outcome));
        if (waiting.size() == 1) {
            exchange.begin(nowMs);
        }
        replaced.forEach(PendingCommands::report);
    }

    /** Ends those of a number that wait to be sent: others take their place. One that was sent already goes on. */
    public void withdrawUnsent(int number) {
        Deque<Waiting> waiting = byNumber.getOrDefault(number, new ArrayDeque<>());
        List<Waiting> withdrawn = waiting.stream().skip(1).toList();
        waiting.removeAll(withdrawn);
        withdrawn.forEach(each -> {
            each.exchange().replace();
            report(each);
        });
    }

    private static void report(Waiting over) {
        over.outcome().accept(over.exchange().outcome());
    }

    /** Takes what the vehicle sent. */
    public void take(Object message, long nowMs) {
        forFirst(exchange -> exchange.take(message, nowMs));
        goOn(nowMs);
    }

    /** The autopilot said something. */
    public void heard(StatusText text) {
        forFirst(exchange -> exchange.heard(text));
    }

    /** Sends again what is overdue. */
    public void tick(long nowMs) {
        forFirst(exchange -> exchange.tick(nowMs));
        goOn(nowMs);
    }

    private void forFirst(Consumer<CommandExchange> what) {
        byNumber.values().stream()
                .filter(waiting -> !waiting.isEmpty())
                .forEach(waiting -> what.accept(waiting.getFirst().exchange()));
    }

    private void goOn(long nowMs) {
        List<Waiting> over = new ArrayList<>();
        for (Deque<Waiting> waiting : byNumber.values()) {
            while (!waiting.isEmpty() && waiting.getFirst().exchange().isOver()) {
                over.add(waiting.removeFirst());
                if (!waiting.isEmpty()) {
                    waiting.getFirst().exchange().begin(nowMs);
                }
            }
        }
        over.forEach(PendingCommands::report); // which may give further commands
    }

    /** Ends all of them unanswered. */
    public void close() {
        List<Waiting> open = byNumber.values().stream().flatMap(Deque::stream).toList();
        byNumber.clear();
        open.forEach(PendingCommands::report);
    }
}
