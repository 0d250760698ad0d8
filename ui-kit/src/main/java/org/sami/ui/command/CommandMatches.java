package org.sami.ui.command;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Which commands are meant by what was typed: the best first, and of equal ones in their order. */
final class CommandMatches {
    private static final int NONE = 0;

    private CommandMatches() {}

    /** All commands for nothing typed; else those whose title or id holds all letters in order. */
    static List<Command> of(String typed, Collection<Command> commands) {
        String wanted = typed.strip().toLowerCase(Locale.ROOT);
        return commands.stream()
                .filter(command -> merit(wanted, command) > NONE)
                .sorted(Comparator.comparingInt((Command command) -> merit(wanted, command))
                        .reversed())
                .toList();
    }

    private static int merit(String wanted, Command command) {
        String title = command.title().toLowerCase(Locale.ROOT);
        if (title.startsWith(wanted)) {
            return 4;
        } else if (title.contains(" " + wanted)) {
            return 3;
        } else if (title.contains(wanted) || command.id().contains(wanted)) {
            return 2;
        }
        return holdsInOrder(title, wanted) ? 1 : NONE;
    }

    private static boolean holdsInOrder(String title, String wanted) {
        int at = 0;
        for (int i = 0; i < wanted.length(); i++) {
            at = title.indexOf(wanted.charAt(i), at) + 1;
            if (at == 0) {
                return false;
            }
        }
        return true;
    }
}
