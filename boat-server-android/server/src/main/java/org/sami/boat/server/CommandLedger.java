package org.sami.boat.server;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.LinkMessage;

/**
 * The answers to the commands that this boat has had, so that a repeated id is answered and not executed again. It keeps
 * the newest 4,096: far more than can be under way.
 */
final class CommandLedger {
    private static final int CAPACITY = 4096;

    private final Map<String, LinkMessage> answers = new LinkedHashMap<String, LinkMessage>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, LinkMessage> eldest) {
            return size() > CAPACITY;
        }
    };

    Optional<LinkMessage> answerTo(String commandId) {
        return Optional.ofNullable(answers.get(commandId));
    }

    void record(String commandId, LinkMessage answer) {
        answers.put(commandId, answer);
    }
}
