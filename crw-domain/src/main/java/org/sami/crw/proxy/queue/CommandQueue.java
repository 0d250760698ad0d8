package org.sami.crw.proxy.queue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;

/**
 * The commands that missions have for one boat, and which of them the boat should carry out (decision 0040).
 *
 * <ul>
 *   <li>Higher priority first; within one priority in order of submission. What runs goes on until it is done.
 *   <li>A command of higher priority takes the boat at once, and what ran is withdrawn ({@link Withdrawal#PREEMPTED}). A
 *       critical one only interrupts: what ran goes back to its place in the queue and returns with its progress.
 *   <li>A mission moves a boat for one purpose at a time: its newer command for the boat takes the place of the older one
 *       ({@link Withdrawal#SUPERSEDED}), running or waiting. A critical command does not do that to one that is not
 *       critical, nor the other way round: there, the critical one runs and the other waits.
 *   <li>A blocking command keeps the boat for its mission once it has run, until that mission is withdrawn; of several
 *       blocks the newest counts. Critical commands pass.
 * </ul>
 *
 * <p>It only decides; telling the boat is the proxy's work. For one thread.
 */
public final class CommandQueue {
    private static final Comparator<QueuedCommand> FIRST_IN_TURN = Comparator.comparing(
                    (QueuedCommand queued) -> queued.command().priority())
            .reversed()
            .thenComparingLong(QueuedCommand::order);

    private final List<QueuedCommand> entries = new ArrayList<>();
    private final List<Long> blockingMissions = new ArrayList<>();
    private Optional<QueuedCommand> current = Optional.empty();
    private long submitted;
    private long changes;

    /** The command that the boat should carry out now. */
    public Optional<QueuedCommand> current() {
        return current;
    }

    /** How many commands are queued, the running one included. */
    public int size() {
        return entries.size();
    }

    /** Those that wait for their turn, in the order in which they would have it. */
    public List<QueuedCommand> waiting() {
        List<QueuedCommand> waiting = new ArrayList<>(entries);
        current.ifPresent(waiting::remove);
        waiting.sort(FIRST_IN_TURN);
        return Collections.unmodifiableList(waiting);
    }

    /** Why a command that waits does not have its turn. */
    public TurnWait whyNot(QueuedCommand waiting) {
        Optional<Long> blocker = blockedBy();
        if (waiting.isInterrupted()) {
            return TurnWait.because("it is interrupted and returns afterwards");
        } else if (blocker.isPresent() && blocker.get() != waiting.command().mission()) {
            return TurnWait.keptBy(blocker.get());
        }
        return TurnWait.because(current.map(QueuedCommand::command)
                .filter(running -> running.priority() != waiting.command().priority())
                .map(running -> "its priority is " + waiting.command().priority() + ", not " + running.priority())
                .orElse("the other came first"));
    }

    /** Counts changes of the queue and of the command whose turn it is. */
    public long changes() {
        return changes;
    }

    /** The mission that keeps the boat for itself. */
    public Optional<Long> blockedBy() {
        return blockingMissions.isEmpty()
                ? Optional.empty()
                : Optional.of(blockingMissions.get(blockingMissions.size() - 1));
    }

    /** The missions that keep the boat for themselves, the newest last. */
    public List<Long> blocks() {
        return List.copyOf(blockingMissions);
    }

    /** Has missions keep the boat as they did under an earlier process of the base, the newest last; a command that they do not allow waits again. */
    public void restoreBlocks(List<Long> missions) {
        changes++;
        blockingMissions.clear();
        blockingMissions.addAll(missions);
        current = Optional.empty();
        choose();
    }

    /** Queues a command; one whose id is queued already is ignored. Returns the commands that it displaced for good, with the reasons. */
    public Map<BoatCommand, Withdrawal> submit(BoatCommand command) {
        if (find(command.commandId()).isPresent()) {
            return Map.of();
        }
        QueuedCommand newcomer = new QueuedCommand(command, submitted++);
        Map<BoatCommand, Withdrawal> displaced = new LinkedHashMap<>();
        for (QueuedCommand entry : List.copyOf(entries)) {
            if (entry.command().mission() == command.mission() && entry.isCritical() == newcomer.isCritical()) {
                remove(entry);
                displaced.put(entry.command(), Withdrawal.SUPERSEDED);
            }
        }
        entries.add(newcomer);
        changes++;
        if (current.isPresent() && takesBoatFrom(newcomer, current.get())) {
            if (newcomer.isCritical()) {
                current.get().setInterrupted(true);
            } else {
                displaced.put(current.get().command(), Withdrawal.PREEMPTED);
                entries.remove(current.get());
            }
            current = Optional.empty();
        }
        choose();
        return displaced;
    }

    private boolean takesBoatFrom(QueuedCommand newcomer, QueuedCommand running) {
        return isAllowed(newcomer)
                && newcomer.command().priority().compareTo(running.command().priority()) > 0;
    }

    /** Takes back all that a mission has here, and its block. Returns what was taken back. */
    public List<BoatCommand> withdraw(long mission) {
        changes += blockingMissions.removeIf(blocking -> blocking == mission) ? 1 : 0;
        List<BoatCommand> withdrawn = new ArrayList<>();
        for (QueuedCommand entry : List.copyOf(entries)) {
            if (entry.command().mission() == mission) {
                remove(entry);
                withdrawn.add(entry.command());
            }
        }
        choose();
        return withdrawn;
    }

    /** Takes back one command; a block of its mission stays. Empty where it is not queued. */
    public Optional<BoatCommand> withdraw(String commandId) {
        Optional<QueuedCommand> found = find(commandId);
        found.ifPresent(entry -> {
            remove(entry);
            choose();
        });
        return found.map(QueuedCommand::command);
    }

    /** Takes back all blocks and no command: others have their turn again. Returns the missions that kept the boat. */
    public List<Long> unblock() {
        List<Long> kept = List.copyOf(blockingMissions);
        changes += kept.isEmpty() ? 0 : 1;
        blockingMissions.clear();
        choose();
        return kept;
    }

    /** Takes back everything, and all blocks. Returns the commands in the order of their turn. */
    public List<BoatCommand> clear() {
        List<BoatCommand> all = new ArrayList<>();
        current.ifPresent(running -> all.add(running.command()));
        waiting().forEach(queued -> all.add(queued.command()));
        changes++;
        blockingMissions.clear();
        entries.clear();
        current = Optional.empty();
        return all;
    }

    /** The queued command with an id. */
    public Optional<QueuedCommand> find(String commandId) {
        return entries.stream()
                .filter(e -> e.command().commandId().equals(commandId))
                .findFirst();
    }

    /** A command is done, or has failed; if it ran, the next one has its turn. */
    public void finish(QueuedCommand queued) {
        remove(queued);
        choose();
    }

    private void remove(QueuedCommand entry) {
        changes++;
        entries.remove(entry);
        if (current.isPresent() && current.get() == entry) {
            current = Optional.empty();
        }
    }

    private void choose() {
        if (current.isPresent()) {
            return;
        }
        current = entries.stream().filter(this::isAllowed).min(FIRST_IN_TURN);
        current.ifPresent(chosen -> {
            changes++;
            chosen.setInterrupted(false);
            long mission = chosen.command().mission();
            if (chosen.command().block() && !blockingMissions.contains(mission)) {
                blockingMissions.add(mission);
            }
        });
    }

    private boolean isAllowed(QueuedCommand queued) {
        Optional<Long> blocker = blockedBy();
        return queued.isCritical()
                || blocker.isEmpty()
                || blocker.get() == queued.command().mission();
    }
}
