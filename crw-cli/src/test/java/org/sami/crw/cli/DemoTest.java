package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The demonstration as a user has it: boats that are processes. */
@Tag("process")
@Timeout(900)
class DemoTest {
    private static final Pattern BOAT =
            Pattern.compile("(\\w+) is process (\\d+), listening on (127\\.0\\.0\\.1:\\d+)");

    @TempDir
    private Path folder;

    @Test
    void threeProcessesVisitEverythingOverTcpAndEndWithTheDemonstration() {
        CommandResult ran = CommandResult.crw("demo", "--report", folder.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out()).contains("9 of 9");
        List<MatchResult> boats = BOAT.matcher(ran.err()).results().toList();
        assertThat(boats).hasSize(3);
        for (MatchResult boat : boats) {
            assertThat(ran.out()).containsPattern("\n  " + boat.group(1) + " .*tcp " + boat.group(3) + "\n");
            assertThat(ProcessHandle.of(Long.parseLong(boat.group(2))).filter(ProcessHandle::isAlive))
                    .isEmpty();
        }
        assertThat(folder.resolve("map.png")).isNotEmptyFile();
    }
}
