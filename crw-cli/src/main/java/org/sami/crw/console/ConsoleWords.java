package org.sami.crw.console;

import java.util.Locale;
import java.util.Objects;
import org.sami.crw.fleet.RobotKind;

/** The console's own texts, by the domain's word for its robots. What plans and people wrote is not for it. */
final class ConsoleWords {
    private static final String BOATS = "boats";

    private final RobotKind robots;

    ConsoleWords(RobotKind robots) {
        this.robots = Objects.requireNonNull(robots, "robots");
    }

    /** A text about boats. */
    String say(String text) {
        return robots.say(text);
    }

    /** One of three texts, where one about boats is not true of copters. A team's names the two by {@link RobotKind#SURFACE_BOAT} and copter. */
    String of(String boats, String copters, String team) {
        return switch (robots) {
            case BOAT -> boats;
            case COPTER -> copters;
            case ROBOT -> team;
        };
    }

    /** The same command as typed in this domain: {@code boats} is {@code copters}, and its help has the domain's words. */
    ConsoleCommand of(ConsoleCommand command) {
        return new ConsoleCommand(
                typed(command.name()),
                usage(command.usage()),
                say(command.help()),
                command.action(),
                command.completions());
    }

    /** A command of which each line is about robots, none by a plan's author. */
    ConsoleCommand aboutRobots(ConsoleCommand command) {
        return new ConsoleCommand(
                command.name(),
                command.usage(),
                command.help(),
                (arguments, out) -> command.action().run(arguments, line -> out.accept(say(line))),
                command.completions());
    }

    /** A word of a command as typed in this domain. */
    String typed(String word) {
        return word.equals(BOATS) ? robots.word() + "s" : word;
    }

    private String usage(String usage) {
        return usage.replaceAll("\\bBOAT\\b", robots.word().toUpperCase(Locale.ROOT))
                .replaceAll("\\bboats\\b", typed(BOATS));
    }
}
