package org.sami.crw.console;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.session.api.FrontSession;
import org.sami.spn.finding.Suggestions;

/**
 * An operator's console on a session: reads commands line by line until there are no more or one ends it, and prints what happens
 * meanwhile. Used by one thread, which is none of the session's.
 */
public final class Console implements AutoCloseable {
    private final ConsoleContext context;
    private final Map<String, ConsoleCommand> commands = new LinkedHashMap<>();
    private final SessionCommands session;
    private int faults;

    /** A console that has printed nothing yet. */
    public Console(FrontSession session) {
        context = new ConsoleContext(Objects.requireNonNull(session, "session"));
        this.session = new SessionCommands(context, commands::values);
        new MissionCommands(context).all().forEach(this::add);
        new OperatorCommands(context).all().forEach(this::add);
        new SituationCommands(context).all().forEach(this::add);
        new MapCommands(context).all().forEach(this::add);
        new BoatCommands(context)
                .all().stream().map(context.words()::aboutRobots).forEach(this::add);
        this.session.all().forEach(this::add);
    }

    private void add(ConsoleCommand given) {
        ConsoleCommand command = context.words().of(given);
        if (commands.put(command.name(), command) != null) {
            throw new IllegalStateException("two commands are called " + command.name());
        }
    }

    /**
     * Reads and carries out commands until the end. A command that cannot be carried out is answered by a line that begins with
     * {@code crw:}, and the next one is read.
     *
     * @return how many commands were not carried out
     */
    public int run(LineSource lines) throws IOException {
        AnswerText answers = new AnswerText(context.vocabulary().types());
        try (ConsoleNews news = new ConsoleNews(context.models(), answers, lines::print)) {
            context.listen();
            Optional<String> line = session.hasEnded() ? Optional.empty() : lines.next();
            while (line.isPresent()) {
                execute(line.get(), lines::print);
                line = session.hasEnded() ? Optional.empty() : lines.next();
            }
        }
        return faults;
    }

    /** Ends it: a command that waits is given up, and no other line is read. From any thread. */
    public void end() {
        session.end();
        context.end();
    }

    private void execute(String line, Consumer<String> out) {
        try {
            List<String> words = CommandLineText.words(line);
            if (!words.isEmpty()) {
                ConsoleCommand command = commands.get(context.words().typed(words.get(0)));
                if (command == null) {
                    throw new ConsoleFault("there is no command '" + words.get(0) + "'"
                            + Suggestions.meant(commands.keySet(), words.get(0)) + "; 'help' lists them");
                }
                context.await(context.models().shown()); // what was done before is seen
                command.action().run(new Arguments(command.usage(), words.subList(1, words.size())), out);
            }
        } catch (ConsoleFault fault) {
            faults++;
            out.accept("crw: " + context.words().say(String.valueOf(fault.getMessage())));
        }
    }

    /**
     * The words that can stand next.
     *
     * @param before the whole words before it, the command's name first
     */
    public List<String> completions(List<String> before) {
        if (before.isEmpty()) {
            return List.copyOf(commands.keySet());
        }
        ConsoleCommand command = commands.get(context.words().typed(before.get(0)));
        if (command == null) {
            return List.of();
        }
        List<String> typed = new ArrayList<>(before.subList(1, before.size()));
        typed.add(""); // the word that is being typed
        return command.completions().apply(typed);
    }

    @Override
    public void close() {
        context.close();
    }
}
