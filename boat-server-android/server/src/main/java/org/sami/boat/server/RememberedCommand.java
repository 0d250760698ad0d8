package org.sami.boat.server;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Objects;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;

/**
 * A command as a boat remembers it, to answer it again and not to execute it again: its client and id, the SHA-256 of its content, and the answer. Immutable.
 */
public final class RememberedCommand {
    private static final int DIGEST_BYTES = 32;

    private final String clientId;
    private final String commandId;
    private final boolean transfer;
    private final byte[] digest;
    private final LinkMessage answer;

    /**
     * A command that was read from a log.
     *
     * @param clientId who sent it; empty where a log of an earlier version does not say so: the id then counts for all clients
     * @param transfer whether it was a request to take, ask for or grant the command
     * @param digest SHA-256 of the command's body on the link
     */
    public RememberedCommand(String clientId, String commandId, boolean transfer, byte[] digest, LinkMessage answer) {
        if (digest.length != DIGEST_BYTES) {
            throw new IllegalArgumentException("a SHA-256 has " + DIGEST_BYTES + " bytes, not " + digest.length);
        }
        this.clientId = Objects.requireNonNull(clientId, "clientId");
        this.commandId = Objects.requireNonNull(commandId, "commandId");
        this.transfer = transfer;
        this.digest = digest.clone();
        this.answer = Objects.requireNonNull(answer, "answer");
    }

    /** What is remembered of a command that was answered. */
    public static RememberedCommand of(String clientId, CommandMessage command, LinkMessage answer) {
        return new RememberedCommand(
                clientId, command.commandId(), CommandTransfer.isOne(command), digestOf(command), answer);
    }

    private static byte[] digestOf(CommandMessage command) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(LinkCodec.body(command));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }

    /** Who sent it; empty if that is not known. */
    public String clientId() {
        return clientId;
    }

    /** Its id. */
    public String commandId() {
        return commandId;
    }

    /** Whether it was a request to take, ask for or grant the command. */
    public boolean isTransfer() {
        return transfer;
    }

    /** SHA-256 of its body on the link. */
    public byte[] digest() {
        return digest.clone();
    }

    /** What the boat answered. */
    public LinkMessage answer() {
        return answer;
    }

    /** Whether a command has the same content. */
    boolean isSame(CommandMessage command) {
        return Arrays.equals(digest, digestOf(command));
    }
}
