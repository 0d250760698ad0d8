package org.sami.crw.console;

import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.crw.console.ConsoleCommand.Action;

/**
 * A command of the console.
 *
 * @param name the word with which its line begins
 * @param usage the whole form of its line
 * @param help what it does, in one line
 * @param completions the words that can stand behind those that were typed, the command's name left out
 */
record ConsoleCommand(
        String name, String usage, String help, Action action, Function<List<String>, List<String>> completions) {
    /** What a command does. */
    interface Action {
        /**
         * Carries it out; returns when it is done or under way.
         *
         * @param out takes the lines of its answer
         * @throws ConsoleFault if it cannot be done
         */
        void run(Arguments arguments, Consumer<String> out);
    }

    ConsoleCommand {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(usage, "usage");
        Objects.requireNonNull(help, "help");
        Objects.requireNonNull(action, "action");
        Objects.requireNonNull(completions, "completions");
    }

    /** A command behind whose name nothing is completed. */
    static ConsoleCommand of(String usage, String help, Action action) {
        return of(usage, help, action, words -> List.of());
    }

    /** A command; its name is the first word of its usage. */
    static ConsoleCommand of(
            String usage, String help, Action action, Function<List<String>, List<String>> completions) {
        return new ConsoleCommand(usage.split(" ", 2)[0], usage, help, action, completions);
    }
}
