package org.sami.crw.console;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.jline.reader.Candidate;
import org.jline.reader.Completer;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.UserInterruptException;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;

/** Lines typed at a terminal, with editing, history and completion; what happens meanwhile is written above the line. */
public final class TerminalLines implements LineSource {
    private final Terminal terminal;
    private final LineReader reader;
    private final String prompt;

    /**
     * The terminal of this process.
     *
     * @param completions the words that can stand last, given the words before it
     * @param history where typed lines are kept
     * @throws IOException if the terminal cannot be had
     */
    public TerminalLines(String prompt, Function<List<String>, List<String>> completions, Path history)
            throws IOException {
        this(TerminalBuilder.builder().system(true).build(), prompt, completions, history);
    }

    TerminalLines(Terminal terminal, String prompt, Function<List<String>, List<String>> completions, Path history) {
        this.terminal = terminal;
        this.prompt = prompt;
        reader = LineReaderBuilder.builder()
                .terminal(terminal)
                .appName("crw")
                .completer(completer(completions))
                .variable(LineReader.HISTORY_FILE, history)
                .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true) // '!' is a letter like others
                .build();
    }

    private static Completer completer(Function<List<String>, List<String>> completions) {
        return (lineReader, line, candidates) -> {
            List<String> before = new ArrayList<>(line.words().subList(0, line.wordIndex()));
            for (String word : completions.apply(before)) {
                if (!TerminalText.shown(word).equals(word)) {
                    continue; // it could not be typed
                }
                boolean open = word.endsWith("=");
                candidates.add(new Candidate(word, word, null, null, null, null, !open));
            }
        };
    }

    @Override
    public Optional<String> next() {
        try {
            return Optional.of(reader.readLine(prompt));
        } catch (UserInterruptException cleared) {
            return Optional.of(""); // Ctrl-C clears the line, as in a shell
        } catch (EndOfFileException end) {
            return Optional.empty();
        }
    }

    @Override
    public void print(String line) {
        reader.printAbove(TerminalText.shown(line));
    }

    @Override
    public void close() throws IOException {
        terminal.close();
    }
}
