package org.sami.crw.cli.option;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.cli.output.UsageFault;

/** What a script says of a run, and which lines are refused. */
class RunScriptTest {
    @TempDir
    private Path folder;

    private Path script(String text) throws IOException {
        return Files.writeString(folder.resolve("day.script"), text);
    }

    @Test
    void timesAddUpFromTheFirstMissionOn() throws Exception {
        RunScript script = RunScript.read(script("""
                # a morning
                start clv @speed=1.2 "@name=two words"
                wait 30
                start station-keep watch-time.duration=60s   # behind it
                press alarm
                wait 0.5
                press recharge boat2 3
                wait ended
                quit
                """));

        assertThat(script.parameters()).isEqualTo(Map.of("@speed", "1.2", "@name", "two words"));
        assertThat(script.also()).containsExactly("station-keep@30.0\nwatch-time.duration=60s");
        assertThat(script.interrupts()).containsExactly("alarm@30.0", "recharge:boat2@30.5", "recharge:3@30.5");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "answer all          | 'answer all' cannot be played in a run; a run's script has start PLAN",
                "start               | 'start' cannot be played in a run",
                "start clv depth     | 'depth' is no NAME=VALUE",
                "start clv =3        | '=3' is no NAME=VALUE",
                "wait                | wait takes a number of seconds from 0 to 86400, not ''",
                "wait decision       | wait takes a number of seconds from 0 to 86400, not 'decision'",
                "wait -1             | wait takes a number of seconds from 0 to 86400, not '-1'",
                "press alarm in 2    | in a run an interrupt is pressed in every mission that offers it; leave out 'in'",
                "press 'alarm        | a quote ' is not closed"
            })
    void lineThatCannotBePlayedIsNamed(String line, String message) throws Exception {
        Path file = script("start clv\n\n" + line + "\n");

        assertThatExceptionOfType(UsageFault.class)
                .isThrownBy(() -> RunScript.read(file))
                .withMessageStartingWith(file + ":3: " + message);
    }

    @Test
    void nothingHappensBeforeTheFirstMissionOrAfterTheEnd() throws Exception {
        for (String early : List.of("wait 5", "press alarm")) {
            Path file = script(early + "\nstart clv\n");
            assertThatExceptionOfType(UsageFault.class)
                    .isThrownBy(() -> RunScript.read(file))
                    .withMessageStartingWith(file + ":1: ");
        }
        Path late = script("start clv\nwait ended\nstart clv\n");
        assertThatExceptionOfType(UsageFault.class)
                .isThrownBy(() -> RunScript.read(late))
                .withMessageStartingWith(late + ":3: the script has ended above");
        Path empty = script("# nothing\n");
        assertThatExceptionOfType(UsageFault.class)
                .isThrownBy(() -> RunScript.read(empty))
                .withMessageContaining("starts no mission");
        assertThatExceptionOfType(UsageFault.class)
                .isThrownBy(() -> RunScript.read(folder.resolve("none")))
                .withMessage("--script: cannot read " + folder.resolve("none"));
    }
}
