package org.sami.boat.server;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;

/**
 * The commands that a boat has received, with its answers: a repeated command is answered again and not executed again. An id belongs to one client
 * and one command. The same id from another client is another command, and other content under a known id is refused.
 *
 * <p>The ledger keeps the newest 4,096 commands and, separately, the newest 4,096 transfers of the command: no observer can make the boat forget a
 * command. The boat's log has one of its own, with which it begins a new file.
 */
public final class CommandLedger {
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

    private final Map<String, RememberedCommand> commands = new Bounded();
    private final Map<String, RememberedCommand> transfers = new Bounded();

    Known of(String clientId, CommandMessage command) {
        RememberedCommand entry = find(clientId, command.commandId());
        if (entry == null) {
            return Known.NEW;
        }
        return entry.isSame(command) ? Known.REPEATED : Known.DIFFERS;
    }

    /** The answer to a command that is {@link Known#REPEATED}. */
    LinkMessage answerTo(String clientId, CommandMessage command) {
        RememberedCommand known = find(clientId, command.commandId());
        if (known == null) {
            throw new IllegalStateException("no answer to " + command.commandId() + ": it was never received");
        }
        return known.answer();
    }

    /** Keeps the answer to a command. */
    public void record(RememberedCommand command) {
        String key = key(command.clientId(), command.commandId());
        (command.isTransfer() ? commands : transfers).remove(key); // a stop is executed under whatever id it has
        (command.isTransfer() ? transfers : commands).put(key, command);
    }

    /** What it keeps; recorded in this order, another ledger keeps the same. */
    public List<RememberedCommand> entries() {
        List<RememberedCommand> all = new ArrayList<>(commands.values());
        all.addAll(transfers.values());
        return all;
    }

    private @Nullable RememberedCommand find(String clientId, String commandId) {
        RememberedCommand own = find(key(clientId, commandId));
        return own == null ? find(key("", commandId)) : own;
    }

    private @Nullable RememberedCommand find(String key) {
        RememberedCommand command = commands.get(key);
        return command == null ? transfers.get(key) : command;
    }

    private static String key(String clientId, String commandId) {
        return clientId.length() + ":" + clientId + commandId;
    }

    private static final class Bounded extends LinkedHashMap<String, RememberedCommand> {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, RememberedCommand> eldest) {
            return size() > CAPACITY;
        }
    }
}
