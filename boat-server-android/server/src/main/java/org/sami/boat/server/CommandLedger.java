package org.sami.boat.server;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;

/**
 * The commands that this boat has received, with its answers: a repeated command is answered again and not executed again. An id belongs to one client
 * and one command. The same id from another client is another command, and other content under a known id is refused.
 *
 * <p>The ledger keeps the newest 4,096 commands and, separately, the newest 4,096 transfers of the command: no observer can make the boat forget a
 * command.
 */
final class CommandLedger {
    /** What the ledger knows of a command. */
    enum Known {
        /** Nothing. */
        NEW,
        /** The boat has received this command from this client before. */
        REPEATED,
        /** The client has used the id for another command. */
        DIFFERS
    }

    private static final int CAPACITY = 4096;

    private final Map<String, Answered> commands = new Bounded();
    private final Map<String, Answered> transfers = new Bounded();

    Known of(String clientId, CommandMessage command) {
        Answered entry = find(clientId, command.commandId());
        if (entry == null) {
            return Known.NEW;
        }
        return Arrays.equals(entry.digest, digest(command)) ? Known.REPEATED : Known.DIFFERS;
    }

    /** The answer to a command that is {@link Known#REPEATED}. */
    LinkMessage answerTo(String clientId, CommandMessage command) {
        Answered known = find(clientId, command.commandId());
        if (known == null) {
            throw new IllegalStateException("no answer to " + command.commandId() + ": it was never received");
        }
        return known.answer;
    }

    /**
     * Keeps the answer to a command.
     *
     * @param clientId who sent it; empty where a log of an earlier version does not say so: the id then counts for all clients
     */
    void record(String clientId, CommandMessage command, LinkMessage answer) {
        String key = key(clientId, command.commandId());
        boolean transfer = CommandTransfer.isOne(command);
        (transfer ? commands : transfers).remove(key); // a stop is executed under whatever id it has
        (transfer ? transfers : commands).put(key, new Answered(digest(command), answer));
    }

    private @Nullable Answered find(String clientId, String commandId) {
        Answered own = find(key(clientId, commandId));
        return own == null ? find(key("", commandId)) : own;
    }

    private @Nullable Answered find(String key) {
        Answered command = commands.get(key);
        return command == null ? transfers.get(key) : command;
    }

    private static String key(String clientId, String commandId) {
        return clientId.length() + ":" + clientId + commandId;
    }

    private static byte[] digest(CommandMessage command) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(LinkCodec.body(command));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }

    private static final class Answered {
        private final byte[] digest;
        private final LinkMessage answer;

        Answered(byte[] digest, LinkMessage answer) {
            this.digest = digest;
            this.answer = answer;
        }
    }

    private static final class Bounded extends LinkedHashMap<String, Answered> {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Answered> eldest) {
            return size() > CAPACITY;
        }
    }
}
