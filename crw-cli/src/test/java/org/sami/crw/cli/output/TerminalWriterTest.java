package org.sami.crw.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.Crw;
import org.sami.crw.console.PlainLines;
import picocli.CommandLine;

/** Nothing that crw prints is obeyed by a terminal. */
class TerminalWriterTest {
    private static final String HOSTILE = "a\u001b]0;title\u0007b\u001b[2Jc\rd\u009b31me\u007ff\u202eg";
    private static final String SHOWN = "a\\u001b]0;title\\u0007b\\u001b[2Jc\\u000dd\\u009b31me\\u007ff\\u202eg";

    private final StringWriter text = new StringWriter();
    private final PrintWriter out = TerminalWriter.of(new PrintWriter(text));

    private String printed() {
        out.flush();
        return text.toString();
    }

    @Test
    void controlCharactersAreShownHoweverTheyArePrinted() {
        out.println(HOSTILE);
        out.printf("%s|%n", HOSTILE);
        out.write(HOSTILE.toCharArray(), 0, HOSTILE.length());
        out.append(HOSTILE).append('\u001b');
        assertThat(printed()).isEqualTo(SHOWN + "\n" + SHOWN + "|\n" + SHOWN + SHOWN + "\\u001b");
    }

    @Test
    void linesTabsAndLettersOfAllLanguagesStay() {
        String plain = "Ünder\twater 中 🚤\r\nnext\n";
        out.print(plain);
        assertThat(printed()).isEqualTo(plain);
    }

    @Test
    void onlyTheProgramItselfWritesOverALine() {
        ProgressDisplay display = new ProgressDisplay(out, true, () -> 1_000_000_000L);
        display.show(() -> HOSTILE);
        assertThat(printed()).isEqualTo("\r\u001b[K" + SHOWN);
        text.getBuffer().setLength(0);

        out.print(new String("\r\u001b[K"));
        assertThat(printed()).isEqualTo("\\u000d\\u001b[K");
    }

    @Test
    void logAndConsoleShowThemToo() {
        assertThat(new LogFormatter(false).format(new LogRecord(Level.WARNING, HOSTILE)))
                .contains(SHOWN);

        new PlainLines("standard input", new StringReader(""), new PrintWriter(text, true)).print(HOSTILE);
        assertThat(text.toString()).isEqualTo(SHOWN + System.lineSeparator());
    }

    @Test
    void namesInFilesAreShownByEveryCommandThatPrintsThem(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("plan.json");
        Files.writeString(file, """
                {"formatVersion": 1, "id": "p", "name": "n\\u001b[31m", "domain": "crw", "plans": [
                 {"id": "p", "name": "plan\\u001b]0;x\\u0007", "places": [{"id": "q\\u001b[2J", "start": true,
                   "outputs": [{"id": "o", "type": "No\\u001b[31mSuch"}]}],
                  "transitions": [], "inEdges": [], "outEdges": []}]}
                """);
        for (List<String> command : List.of(
                List.of("check", file.toString()),
                List.of("plans", file.toString()),
                List.of("--verbose", "check", file.toString()),
                List.of("phases", file.toString()),
                List.of("check", folder.resolve("no\u001b[31mfile").toString()))) {
            StringWriter told = new StringWriter();
            CommandLine line = Crw.commandLine();
            line.setOut(new PrintWriter(told));
            line.setErr(new PrintWriter(told));
            line.execute(command.toArray(String[]::new));
            line.getOut().flush();
            line.getErr().flush();

            assertThat(told.toString()).as("%s", command).isNotEmpty().doesNotContain("\u001b", "\u0007");
            if (command.contains("check")) {
                assertThat(told.toString()).as("%s", command).contains("\\u001b[");
            }
        }
    }

    @Test
    void helpHasNoEscapeSequences() {
        StringWriter told = new StringWriter();
        CommandLine line = Crw.commandLine();
        line.setOut(new PrintWriter(told));
        line.execute("--help");
        assertThat(told.toString()).contains("Usage:").doesNotContain("\u001b", "\\u001b");
    }
}
