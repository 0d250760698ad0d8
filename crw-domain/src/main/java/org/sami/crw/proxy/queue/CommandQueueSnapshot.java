package org.sami.crw.proxy.queue;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;

/**
 * The commands that missions have for one boat, at a moment. Immutable.
 *
 * @param current the command whose turn it is, if any
 * @param waiting the others, in the order of their turns
 * @param blockedBy the mission that reserves the boat for itself; the newest of several
 */
public record CommandQueueSnapshot(Optional<Entry> current, List<Entry> waiting, OptionalLong blockedBy) {
    /** No command waits or runs. */
    public static final CommandQueueSnapshot EMPTY =
            new CommandQueueSnapshot(Optional.empty(), List.of(), OptionalLong.empty());

    /**
     * One queued command.
     *
     * @param visited points of its path that are behind the boat
     * @param points points of its path; 0 for a command that has none
     * @param why why it waits
     */
    public record Entry(BoatCommand command, int visited, int points, TurnWait why) {
        public Entry {
            Objects.requireNonNull(command, "command");
            Objects.requireNonNull(why, "why");
        }

        /** The same, further on its path. */
        public Entry withVisited(int count) {
            return new Entry(command, Math.max(visited, count), points, why);
        }
    }

    public CommandQueueSnapshot {
        Objects.requireNonNull(current, "current");
        waiting = List.copyOf(waiting);
        Objects.requireNonNull(blockedBy, "blockedBy");
    }

    /** What a queue holds now. */
    public static CommandQueueSnapshot of(CommandQueue queue) {
        return new CommandQueueSnapshot(
                queue.current().map(running -> entry(running, TurnWait.NOT)),
                queue.waiting().stream()
                        .map(waiting -> entry(waiting, queue.whyNot(waiting)))
                        .toList(),
                queue.blockedBy().map(OptionalLong::of).orElse(OptionalLong.empty()));
    }

    private static Entry entry(QueuedCommand queued, TurnWait why) {
        int points = queued.command() instanceof FollowPath path ? path.points().size() : 0;
        return new Entry(queued.command(), queued.visited(), points, why);
    }
}
