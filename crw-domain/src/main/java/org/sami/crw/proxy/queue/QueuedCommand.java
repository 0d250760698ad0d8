package org.sami.crw.proxy.queue;

import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.protocol.Priority;

/** A command in the queue, with what has become of it so far. */
public final class QueuedCommand {
    private final BoatCommand command;
    private final long order;
    private int visited;
    private int tries;
    private boolean interrupted;

    /** A command that nothing of is done; its place among those of its priority is by this order. */
    public QueuedCommand(BoatCommand command, long order) {
        this.command = command;
        this.order = order;
        visited = command instanceof FollowPath path ? path.startIndex() : 0;
    }

    /** The command. */
    public BoatCommand command() {
        return command;
    }

    /** Position in order of submission. */
    long order() {
        return order;
    }

    /** Points of the path that are behind the boat. */
    public int visited() {
        return visited;
    }

    /** Takes the boat's word on its progress; returns whether that is more than was known. */
    public boolean visitedUpTo(int count) {
        boolean more = count > visited;
        visited = Math.max(visited, count);
        return more;
    }

    /** Counts one more try that went wrong. */
    public int failedTry() {
        return ++tries;
    }

    boolean isInterrupted() {
        return interrupted;
    }

    void setInterrupted(boolean value) {
        interrupted = value;
    }

    boolean isCritical() {
        return command.priority() == Priority.CRITICAL;
    }
}
