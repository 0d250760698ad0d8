package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Each command, in process: exit code, standard output, standard error. */
@Tag("long")
class CommandsTest {
    private static final ObjectMapper JSON = new ObjectMapper().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

    @TempDir
    Path folder;

    @Test
    void plansListsTheLibrary() throws Exception {
        CommandResult text = CommandResult.crw("plans");
        JsonNode json = JSON.readTree(CommandResult.crw("plans", "--json").out());

        assertThat(text.exitCode()).isZero();
        assertThat(text.out()).contains("clv  (Cooperative Location Visit)").contains("station-keep");
        assertThat(json.get("plans").findValuesAsText("id")).contains("clv", "station-keep");
        assertThat(json.get("plans").get(1).get("parameters").toString()).contains("ask-stations.location");
        assertThat(text.out()).contains("--interrupt End station keeping@SECONDS");
        assertThat(json.get("plans").get(1).get("interrupts").toString())
                .isEqualTo("[{\"name\":\"End station keeping\",\"boats\":false}]");
    }

    @Test
    void checkFindsNothingInThePlansThatShip() {
        for (String plan : new String[] {"clv", "station-keep"}) {
            CommandResult ran = CommandResult.crw("check", plan);

            assertThat(ran.exitCode()).as(ran.out()).isZero();
            assertThat(ran.out()).contains(plan + ": 0 errors");
        }
    }

    @Test
    void checkNamesPlaceAndCodeOfAFault() throws Exception {
        Path file = Files.writeString(folder.resolve("bad.json"), "{\"formatVersion\": 99}");

        CommandResult text = CommandResult.crw("check", file.toString());
        CommandResult json = CommandResult.crw("check", file.toString(), "--json");

        assertThat(text.exitCode()).isEqualTo(1);
        assertThat(text.out()).contains("error").contains("/formatVersion").contains("1 errors");
        assertThat(json.exitCode()).isEqualTo(1);
        JsonNode finding = JSON.readTree(json.out()).get("findings").get(0);
        assertThat(finding.get("pointer").asText()).isEqualTo("/formatVersion");
        assertThat(finding.get("severity").asText()).isEqualTo("error");
        assertThat(finding.get("code").asText()).isNotBlank();
    }

    @Test
    void planWithErrorsIsNotRun() throws Exception {
        Path file = Files.writeString(folder.resolve("bad.json"), "{\"formatVersion\": 1, \"id\": 3}");

        CommandResult ran = CommandResult.crw("run", file.toString(), "--json");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).isEmpty();
        assertThat(ran.err()).contains("/id");
    }

    @Test
    void runPrintsOneJsonObjectAndNothingElse() throws Exception {
        CommandResult ran = CommandResult.crw(
                "run",
                "clv",
                "--boats",
                "2",
                "--locations",
                "4",
                "--area",
                "150",
                "--seed",
                "9",
                "--speed",
                "max",
                "--json");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        JsonNode json = JSON.readTree(ran.out());
        assertThat(json.get("outcome").asText()).isEqualTo("ended");
        assertThat(json.get("seed").asLong()).isEqualTo(9);
        assertThat(json.get("locationsVisited").asInt()).isEqualTo(4);
        assertThat(json.get("clicks").asInt()).isEqualTo(1 + 3 + 5 + 1);
        assertThat(json.get("boats")).hasSize(2);
        assertThat(json.get("boats").get(0).get("link").asText()).isEqualTo("in-process");
        assertThat(json.get("interrupts").isArray()).isTrue();
        assertThat(json.get("resumedFrom").isNull()).isTrue();
        assertThat(json.get("runHash").asText()).hasSize(64);
    }

    @Test
    void runOfAFileChoosesItsRootPlan() throws Exception {
        Path file = sample();

        CommandResult ran = CommandResult.crw(
                "run",
                file.toString(),
                "--boats",
                "2",
                "--locations",
                "3",
                "--area",
                "100",
                "--speed",
                "max",
                "--json");

        assertThat(ran.exitCode()).as(ran.err() + ran.out()).isZero();
        assertThat(JSON.readTree(ran.out()).get("plan").asText()).isEqualTo("sample");
    }

    @Test
    void parametersAndAnswersAreUsed() throws Exception {
        Path answers = Files.writeString(
                folder.resolve("answers.json"), org.sami.crw.sim.run.TestRuns.text("sample-answers.json"));

        CommandResult ran = CommandResult.crw(
                "run",
                sample().toString(),
                "--boats",
                "2",
                "--locations",
                "3",
                "--area",
                "100",
                "--speed",
                "max",
                "--answers",
                answers.toString(),
                "--set",
                "watch-time.duration=500s",
                "--json");

        JsonNode json = JSON.readTree(ran.out());
        assertThat(json.get("simulatedSeconds").asDouble()).isGreaterThan(1000);
        assertThat(json.get("locationsVisited").asInt()).isGreaterThanOrEqualTo(6);
    }

    @Test
    void runningMissionHasItsOwnExitCodeAndSaysHowToGoOn() throws Exception {
        Path journal = folder.resolve("a.journal");

        CommandResult ran =
                CommandResult.crw("run", "clv", "--speed", "max", "--for", "60", "--journal", journal.toString());
        CommandResult more = CommandResult.crw("resume", journal.toString(), "--for", "120", "--json");
        CommandResult rest = CommandResult.crw("resume", journal.toString(), "--json");
        CommandResult whole = CommandResult.crw("run", "clv", "--speed", "max", "--json");

        assertThat(ran.exitCode()).isEqualTo(5);
        assertThat(ran.out()).contains("running");
        assertThat(ran.err()).contains("crw resume " + journal);
        assertThat(more.exitCode()).isEqualTo(5);
        assertThat(JSON.readTree(more.out()).get("simulatedSeconds").asDouble()).isEqualTo(120);
        assertThat(JSON.readTree(more.out()).get("resumedFrom").asLong()).isPositive();
        assertThat(rest.exitCode()).isZero();
        assertThat(hash(rest)).isEqualTo(hash(whole));
    }

    @Test
    void resumeOfAFinishedRunSaysSoAndReportsAgain() throws Exception {
        Path journal = folder.resolve("a.journal");
        CommandResult first = CommandResult.crw(
                "run",
                "clv",
                "--boats",
                "2",
                "--locations",
                "4",
                "--area",
                "150",
                "--speed",
                "max",
                "--json",
                "--journal",
                journal.toString());

        CommandResult again = CommandResult.crw("resume", journal.toString(), "--json");

        assertThat(again.exitCode()).isZero();
        assertThat(again.err()).contains("was over already");
        assertThat(hash(again)).isEqualTo(hash(first));
    }

    @Test
    void resumeNamesAFileThatDiffersNow() throws Exception {
        Path file = sample();
        Path journal = folder.resolve("a.journal");
        CommandResult.crw("run", file.toString(), "--speed", "max", "--for", "20", "--journal", journal.toString());
        Files.writeString(file, Files.readString(file).replace("Half a minute over", "Over"));

        CommandResult ran = CommandResult.crw("resume", journal.toString());

        assertThat(ran.err()).contains(file + " differs now");
    }

    @Test
    void resumeNamesAnAnswersFileThatDiffersNowOrIsGone() throws Exception {
        Path answers = folder.resolve("answers.json");
        String text = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": []}";
        Files.writeString(answers, text);
        Path journal = folder.resolve("a.journal");
        CommandResult.crw(
                "run",
                sample().toString(),
                "--speed",
                "max",
                "--for",
                "20",
                "--answers",
                answers.toString(),
                "--journal",
                journal.toString());

        assertThat(CommandResult.crw("resume", journal.toString()).err()).doesNotContain("differs now");
        Files.writeString(answers, text + " ");
        assertThat(CommandResult.crw("resume", journal.toString()).err()).contains(answers + " differs now");
        Files.delete(answers);
        assertThat(CommandResult.crw("resume", journal.toString()).err())
                .contains(answers + ", which cannot be read any longer, differs now");
    }

    @Test
    void reportFolderIsWrittenAndNamed() throws Exception {
        Path reports = folder.resolve("deep/out");

        CommandResult ran = CommandResult.crw(
                "run",
                "clv",
                "--boats",
                "2",
                "--locations",
                "4",
                "--area",
                "150",
                "--speed",
                "max",
                "--report",
                reports.toString());

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.err()).contains(reports.resolve("map.png").toString());
        assertThat(reports.resolve("map.png")).isNotEmptyFile();
        assertThat(JSON.readTree(Files.readString(reports.resolve("report.json")))
                        .get("outcome")
                        .asText())
                .isEqualTo("ended");
        assertThat(ran.out()).contains("completion time", "clicks", "4 of 4", "boat1", "firings");
    }

    @Test
    void abortedMissionHasItsOwnExitCode() throws Exception {
        Path file = Files.writeString(
                folder.resolve("aborts.json"), org.sami.crw.sim.run.TestRuns.text("aborting-project.json"));

        CommandResult ran = CommandResult.crw("run", file.toString(), "--boats", "2", "--speed", "max", "--json");

        assertThat(ran.exitCode()).as(ran.err() + ran.out()).isEqualTo(3);
        assertThat(JSON.readTree(ran.out()).get("outcome").asText()).isEqualTo("aborted");
    }

    @Test
    void missionThatIsStuckHasItsOwnExitCode() throws Exception {
        Path answers = Files.writeString(
                folder.resolve("answers.json"),
                "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": "
                        + "[{\"event\": \"OperatorCreateLocations\", \"answer\": {\"silent\": true}}]}");

        CommandResult ran =
                CommandResult.crw("run", "clv", "--speed", "max", "--answers", answers.toString(), "--json");

        assertThat(ran.exitCode()).isEqualTo(4);
        JsonNode json = JSON.readTree(ran.out());
        assertThat(json.get("outcome").asText()).isEqualTo("failed");
        assertThat(json.get("reason").asText()).contains("nobody answers");
    }

    @Test
    void demoEndsByItselfAndShowsWhereThePictureIs() {
        CommandResult ran = CommandResult.crw(
                "demo", "--speed", "max", "--report", folder.resolve("demo").toString());

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out()).contains("12 of 12");
        assertThat(ran.err()).contains("map.png");
    }

    private Path sample() throws Exception {
        return Files.writeString(
                folder.resolve("sample.json"), org.sami.crw.sim.run.TestRuns.text("sample-project.json"));
    }

    @Test
    void missionMayAskForAnAllocationWithItsFirstEventAndNeedsNoName() throws Exception {
        Path file = Files.writeString(
                folder.resolve("at-once.json"), org.sami.crw.sim.run.TestRuns.text("allocation-at-once.json"));

        CommandResult ran = CommandResult.crw("run", file.toString(), "--boats", "2", "--speed", "max", "--json");

        assertThat(ran.err()).doesNotContain("failed");
        assertThat(ran.exitCode()).isZero();
        assertThat(JSON.readTree(ran.out()).get("planName").asText()).isEqualTo("at-once");
    }

    private static String hash(CommandResult ran) throws Exception {
        return JSON.readTree(ran.out()).get("runHash").asText();
    }
}
