package org.sami.crw.proxy;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.crw.proxy.execution.CommandDriver;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.crw.proxy.queue.Withdrawal;

/**
 * The commands that missions have for one boat, and how they stand: what is asked of it, what waits, and how its paths go to it. Which of them is carried
 * out is decided by {@link org.sami.crw.proxy.queue.CommandQueue}. For the proxy's thread.
 */
public final class ProxyCommands {
    private final CommandDriver driver;
    private final BoatCondition condition;
    private final Runnable afterwards;

    /**
     * The commands of a boat that has none yet.
     *
     * @param afterwards called after each change
     */
    ProxyCommands(CommandDriver driver, BoatCondition condition, Runnable afterwards) {
        this.driver = driver;
        this.condition = condition;
        this.afterwards = afterwards;
    }

    /** The command that the boat is to carry out now. */
    public Optional<BoatCommand> current() {
        return driver.queue().current().map(QueuedCommand::command);
    }

    /** The commands that wait for their turn, in the order in which they would have it. */
    public List<BoatCommand> waiting() {
        return driver.queue().waiting().stream().map(QueuedCommand::command).toList();
    }

    /** The commands that missions have for the boat, and why each that waits does. */
    public CommandQueueSnapshot queue() {
        return CommandQueueSnapshot.of(driver.queue());
    }

    /** How many points of the path of a queued command are behind the boat; empty if it is not queued. */
    public Optional<Integer> visitedCount(String commandId) {
        return driver.queue().find(commandId).map(QueuedCommand::visited);
    }

    /** Whether a try to have the boat carry out a command is under way. It may be so where another client has the boat since; not after a restart of the boat's server. */
    public boolean isBegun(String commandId) {
        return driver.run()
                .filter(run -> run.queued().command().commandId().equals(commandId))
                .isPresent();
    }

    /** The list that the boat said last that it holds; the name is empty if it said that it holds none. */
    public Optional<String> heldListId() {
        return condition.heldListId;
    }

    /** How far the path that went to the boat last has come on its way; empty if none ever went. */
    public Optional<Upload> upload() {
        return driver.uploads().latest();
    }

    /** How many paths have gone to the boat, and how far they came. */
    public UploadCount uploads() {
        return driver.uploads().count();
    }

    /**
     * Queues a command for the boat. A command whose id is queued already is ignored. A newer command of a mission replaces its older one; {@link
     * Withdrawal} describes the displaced ones.
     */
    public void submit(BoatCommand command) {
        driver.submit(Objects.requireNonNull(command, "command"));
        afterwards.run();
    }

    /** Says whether there is a command that waits for the boat to say where it is; {@link BoatProxy#explain} names it. */
    public void awaitPosition(boolean waits) {
        driver.awaitPosition(waits);
    }

    /**
     * Takes back all that a mission has for this boat, and its block; the boat goes on with the next command of another
     * mission, or stops. Not reported to the listener.
     *
     * @return what was taken back
     */
    public List<BoatCommand> withdraw(long mission) {
        List<BoatCommand> withdrawn = driver.withdraw(mission);
        afterwards.run();
        return withdrawn;
    }

    /**
     * Sends the path of the current command to the boat once more, whole and under a new list id, and starts it at its first
     * unvisited point; where the boat cannot be reached, as soon as it can.
     *
     * @return the command; empty if there is none that moves the boat
     */
    public Optional<BoatCommand> sendPathAgain() {
        Optional<BoatCommand> path =
                current().filter(command -> command instanceof FollowPath || command instanceof KeepStation);
        if (path.isPresent()) {
            driver.abandonMoving("its waypoints are sent to the boat again");
            afterwards.run();
        }
        return path;
    }

    /**
     * Takes back one command, whose mission may have others; the boat goes on with the next one, or stops. Not reported to the
     * listener.
     *
     * @return whether the boat had it
     */
    public boolean withdraw(String commandId) {
        boolean withdrawn = driver.withdraw(commandId).isPresent();
        afterwards.run();
        return withdrawn;
    }

    /**
     * Takes back one command, which for its mission has failed, for a reason in words; the boat goes on with the next one, or stops.
     *
     * @return whether the boat had it
     */
    public boolean cancel(String commandId, String reason) {
        boolean cancelled = driver.fail(commandId, reason);
        afterwards.run();
        return cancelled;
    }

    /**
     * Ends all blocks by which missions keep the boat for themselves; their commands stay, and others have their turn again.
     *
     * @return the missions that kept it
     */
    public List<Long> clearBlocks() {
        List<Long> kept = driver.queue().unblock();
        afterwards.run();
        return kept;
    }

    /** The missions that keep the boat for themselves, the newest last. */
    public List<Long> blocks() {
        return driver.queue().blocks();
    }

    /** Has missions keep the boat as they did under an earlier process of this base, the newest last, in place of those that keep it now. */
    public void restoreBlocks(List<Long> missions) {
        driver.queue().restoreBlocks(missions);
        afterwards.run();
    }

    /**
     * Names the waypoint list that an earlier process of this base, in the same session, sent to the boat last. Where the boat still
     * holds it when its command comes again, the boat goes on with it; what it has visited meanwhile is behind it.
     */
    public void knownList(String listId) {
        driver.earlierList(listId);
    }
}
