package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.cli.CommandResult;

/** {@code crw run --script}: runs whose missions and interrupts a script gives. */
class ScriptedRunTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final List<String> SMALL =
            List.of("--area", "100", "--locations", "4", "--seed", "7", "--speed", "max", "--json");

    @TempDir
    private Path folder;

    private Path script(String text) throws Exception {
        return Files.writeString(folder.resolve("day.script"), text);
    }

    private static CommandResult run(String... first) {
        List<String> words = new ArrayList<>(List.of("run"));
        words.addAll(List.of(first));
        words.addAll(SMALL);
        return CommandResult.crw(words.toArray(String[]::new));
    }

    @Test
    void scriptRunsAsTheSameRunByOptions() throws Exception {
        Path script = script("""
                start clv-interrupts
                wait 60
                start clv-interrupts
                wait 60
                press recharge 2
                wait 0.5
                press alarm
                """);

        CommandResult scripted = run("clv-interrupts", "--script", script.toString());
        CommandResult options = run(
                "clv-interrupts",
                "--also",
                "clv-interrupts@60",
                "--interrupt",
                "recharge:2@120",
                "--interrupt",
                "alarm@120.5");

        assertThat(scripted.exitCode()).as(scripted.err()).isEqualTo(options.exitCode());
        JsonNode report = JSON.readTree(scripted.out());
        assertThat(report.path("runHash"))
                .isEqualTo(JSON.readTree(options.out()).path("runHash"));
        assertThat(report.path("interrupts")).hasSize(2);
    }

    @Test
    void missionsOfSeveralPlansHaveTheirValuesAndInterruptsAndTheJournalKeepsThem() throws Exception {
        Path script = script("""
                start clv
                wait 30
                start station-keep watch-time.duration=1h
                wait 600
                press "End station keeping"
                """);
        Path journal = folder.resolve("journal");

        CommandResult ran = run("--script", script.toString(), "--journal", journal.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        JsonNode report = JSON.readTree(ran.out());
        assertThat(report.path("outcome").asText()).isEqualTo("ended");
        assertThat(report.path("plan").asText()).isEqualTo("clv");
        assertThat(report.path("simulatedSeconds").asDouble()).isBetween(630.0, 3000.0);
        assertThat(report.path("interrupts").path(0).path("state").asText()).isNotEqualTo("refused");

        Files.delete(script);
        CommandResult again = CommandResult.crw("resume", journal.toString(), "--speed", "max", "--json");

        assertThat(again.exitCode()).as(again.err()).isZero();
        assertThat(JSON.readTree(again.out()).path("runHash")).isEqualTo(report.path("runHash"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "start search                         | the project has no plan 'search'; it has ",
                "start station-keep depth=3           | the plan has no parameter 'depth'",
                "start station-keep spacing=wide      | 'spacing' cannot be 'wide'",
                "press 'End station keeping' boat1    | 'End station keeping' is for the whole team; it takes no boat",
                "press recharge                       | 'recharge@0.0': the plan has no interrupt 'recharge'"
            })
    void lineThatDoesNotFitTheProjectIsNamed(String line, String message) throws Exception {
        Path script = script("start station-keep\n" + line + "\n");

        CommandResult refused = run("--script", script.toString());

        assertThat(refused.exitCode()).as(refused.err()).isEqualTo(2);
        assertThat(refused.err()).contains(script + ":2: ", message);
        assertThat(refused.out()).isEmpty();
    }

    @Test
    void planOrScriptIsNeededAndOptionsOfWhichTheScriptSpeaksAreRefused() throws Exception {
        Path script = script("start clv\n");

        assertThat(run().err()).contains("Missing required parameter: 'PLAN|FILE'", "--script");
        CommandResult both = run("clv", "--script", script.toString(), "--also", "clv");
        assertThat(both.exitCode()).isEqualTo(2);
        assertThat(both.err()).contains("leave out --plan, --set, --also and --interrupt");
    }

    @Test
    void lineOfAnExperimentTakesAScriptOfItsFolder() throws Exception {
        script("start clv\nwait 20\nstart clv\n");
        Path runs = Files.writeString(
                folder.resolve("my.runs"), "--script day.script --label day --area 100 --locations 2\n");

        CommandResult ran = CommandResult.crw(
                "experiment", "--runs", runs.toString(), "--seeds", "1", "--conditions", "calm", "--jobs", "1");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out()).containsPattern("day +calm +1 +1 ");
    }
}
