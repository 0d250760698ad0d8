package org.sami.crw.operator.boat;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;

/**
 * The commands of one boat: running, waiting with reasons, and the latest that have ended.
 *
 * @param queue the present queue
 * @param upload progress of the last path on its way to the boat
 * @param inOtherHands who has taken the boat over, in words, so that all of its commands wait; empty text for none
 * @param concluded the latest commands that have left the queue, oldest first
 */
public record BoatCommands(
        String boat,
        CommandQueueSnapshot queue,
        Optional<Upload> upload,
        String inOtherHands,
        List<Concluded> concluded) {

    /** How a command left the queue. */
    public enum End {
        COMPLETED,
        FAILED,
        /** Its mission took it back. */
        WITHDRAWN,
        /** Another command displaced it. */
        DISPLACED
    }

    /**
     * A command that has left the queue.
     *
     * @param why in words; empty where it was completed
     */
    public record Concluded(BoatCommand command, End end, String why, long atMillis) {
        public Concluded {
            Objects.requireNonNull(command, "command");
            Objects.requireNonNull(end, "end");
            Objects.requireNonNull(why, "why");
        }
    }

    public BoatCommands {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(queue, "queue");
        Objects.requireNonNull(upload, "upload");
        Objects.requireNonNull(inOtherHands, "inOtherHands");
        concluded = List.copyOf(concluded);
    }
}
