package org.sami.crw.operator.boat;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;

/**
 * The commands of one boat: what runs, what waits and why, and what became of the latest that are gone.
 *
 * @param queue what missions have for it now
 * @param upload how far the path that went to it last has come
 * @param inOtherHands who has it, in words, so that all of its commands wait; empty text where nobody else has
 * @param concluded the latest that have left the queue, oldest first
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
