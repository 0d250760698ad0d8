package org.sami.session.server;

import java.util.List;

/**
 * What came of a command.
 *
 * @param text one sentence; may be empty
 * @param warnings doubts about an answer
 */
record CommandReply(String text, List<String> warnings) {
    static final CommandReply DONE = new CommandReply("", List.of());

    CommandReply {
        warnings = List.copyOf(warnings);
    }

    static CommandReply of(String text) {
        return new CommandReply(text, List.of());
    }
}
