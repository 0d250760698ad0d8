package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.jline.terminal.Terminal;
import org.jline.terminal.impl.DumbTerminal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;

/** The console at a terminal, whose bytes a test types and reads. */
class TerminalLinesTest {
    private static final String NAME = "\u001b[2J\u202eevil\u0007";

    @TempDir
    private Path folder;

    private final PipedOutputStream keys = new PipedOutputStream();
    private final ByteArrayOutputStream screen = new ByteArrayOutputStream();

    private TerminalLines lines() throws Exception {
        Terminal terminal =
                new DumbTerminal("test", "ansi", new PipedInputStream(keys), screen, StandardCharsets.UTF_8);
        return new TerminalLines(terminal, "crw> ", before -> List.of(NAME, "evident"), folder.resolve("history"));
    }

    private String shown() {
        synchronized (screen) {
            return screen.toString(StandardCharsets.UTF_8);
        }
    }

    @Test
    void escapeSequencesInNamesAreShownAndNotObeyed() throws Exception {
        try (TerminalLines lines = lines()) {
            lines.print("boat " + NAME + " is linked");
            Await.until("it is printed", () -> shown().contains("is linked"));

            assertThat(shown())
                    .contains("boat \\u001b[2J\\u202eevil\\u0007 is linked")
                    .doesNotContain("\u001b[2J")
                    .doesNotContain("\u202e")
                    .doesNotContain("\u0007");
        }
    }
}
