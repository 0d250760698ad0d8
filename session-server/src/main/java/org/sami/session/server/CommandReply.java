package org.sami.session.server;

import java.util.List;
import java.util.OptionalLong;

/**
 * What came of a command.
 *
 * @param text one sentence; may be empty
 * @param warnings doubts about an answer
 * @param mission a mission that it started; empty for none
 * @param boats the boats that it reached, where it says so
 */
record CommandReply(String text, List<String> warnings, OptionalLong mission, List<String> boats) {
    static final CommandReply DONE = of("");

    CommandReply {
        warnings = List.copyOf(warnings);
        boats = List.copyOf(boats);
    }

    static CommandReply of(String text) {
        return of(text, List.of());
    }

    static CommandReply of(String text, List<String> warnings) {
        return new CommandReply(text, warnings, OptionalLong.empty(), List.of());
    }

    static CommandReply ofMission(String text, long mission) {
        return new CommandReply(text, List.of(), OptionalLong.of(mission), List.of());
    }

    static CommandReply ofBoats(List<String> boats) {
        return new CommandReply("", List.of(), OptionalLong.empty(), boats);
    }
}
