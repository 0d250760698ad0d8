package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code crw new}, and {@code crw test} on what it made. */
class NewProjectTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    @Test
    void newProjectIsFreeOfFindingsTestedAndRuns() throws Exception {
        Path file = folder.resolve("plans/Harbour survey.json");

        CommandResult made =
                CommandResult.crw("new", folder.resolve("plans/Harbour survey").toString());
        CommandResult check = CommandResult.crw("check", file.toString());
        CommandResult test = CommandResult.crw("test", file.toString());
        CommandResult run = CommandResult.crw("run", file.toString(), "--area", "100", "--speed", "max", "--json");

        assertThat(made.out()).startsWith("made " + file);
        assertThat(check.out()).isEqualTo(file + ": 0 errors, 0 warnings\n");
        assertThat(test).isEqualTo(new CommandResult(0, test.out(), ""));
        assertThat(test.out())
                .isEqualTo("passed  harbour-survey: one boat arrives, one cannot\n" + file + ": 1 passed, 0 failed\n");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(JSON.readTree(run.out()).get("planName").asText()).isEqualTo("Harbour survey");
    }

    @Test
    void newProjectEndsInEachOfTheConditions() {
        Path file = folder.resolve("survey.json");
        CommandResult.crw("new", file.toString());

        CommandResult ran = CommandResult.crw("experiment", file.toString(), "--seeds", "1..5");

        assertThat(ran.exitCode()).as(ran.out()).isZero();
        assertThat(ran.err()).endsWith("15 of 15 runs ended\n");
    }

    @Test
    void projectCanNameTheSchemaThatLiesBesideIt() throws Exception {
        Path file = folder.resolve("survey.json");
        Path schema = folder.resolve("project-1.schema.json");

        CommandResult made = CommandResult.crw("new", file.toString(), "--schema");
        String printed = Files.readString(schema);
        Files.writeString(schema, "mine");
        CommandResult.crw("new", folder.resolve("other.json").toString(), "--schema");

        assertThat(made.out()).startsWith("made " + schema + "\nmade " + file);
        assertThat(printed).isEqualTo(CommandResult.crw("schema").out());
        assertThat(schema).hasContent("mine");
        assertThat(JSON.readTree(file.toFile()).path("$schema").asText()).isEqualTo("project-1.schema.json");
        assertThat(CommandResult.crw("check", file.toString()).out()).isEqualTo(file + ": 0 errors, 0 warnings\n");
    }

    @Test
    void fileThatIsThereIsKeptUnlessItIsToBeReplaced() throws Exception {
        Path file = Files.writeString(folder.resolve("mine.json"), "mine");

        CommandResult refused = CommandResult.crw("new", file.toString());
        String kept = Files.readString(file);
        CommandResult replaced = CommandResult.crw("new", file.toString(), "--replace");

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains(file + " is there already", "--replace");
        assertThat(kept).isEqualTo("mine");
        assertThat(replaced.exitCode()).isZero();
        assertThat(replaced.out()).startsWith("replaced " + file);
    }

    @Test
    void failedTestCaseIsNamedWithItsStep() throws Exception {
        Path file = folder.resolve("wrong.json");
        CommandResult.crw("new", file.toString());
        Files.writeString(
                file,
                Files.readString(file)
                        .replace(
                                "\"place\": \"there\", \"proxies\": [\"b1\"]",
                                "\"place\": \"lost\", \"proxies\": [\"b1\"]"));

        CommandResult text = CommandResult.crw("test", file.toString());
        JsonNode json = JSON.readTree(
                CommandResult.crw("test", file.toString(), "--json").out());

        assertThat(text.exitCode()).isEqualTo(1);
        assertThat(text.out())
                .contains(
                        "FAILED  wrong: one boat arrives, one cannot",
                        "/plans/0/testCases/0/steps/5",
                        "0 passed, 1 failed");
        assertThat(json.get("failed").asInt()).isEqualTo(1);
        assertThat(json.at("/testCases/0/passed").asBoolean()).isFalse();
        assertThat(json.at("/testCases/0/message").asText()).contains("expected in Not there");
    }

    @Test
    void planWithErrorsIsNotTested() throws Exception {
        Path file = folder.resolve("wrong.json");
        CommandResult.crw("new", file.toString());
        Files.writeString(
                file, Files.readString(file).replace("\"kind\": \"unconditional\"", "\"kind\": \"uncondicional\""));

        CommandResult ran = CommandResult.crw("test", file.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).isEmpty();
        assertThat(ran.err()).contains("uncondicional", "is not started");
    }

    @Test
    void projectWithoutTestCasesDoesNotPass() throws Exception {
        Path file = Files.writeString(
                folder.resolve("sample.json"), org.sami.crw.sim.run.TestRuns.text("sample-project.json"));

        CommandResult ran = CommandResult.crw("test", file.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.err()).contains("has no test cases");
    }

    @Test
    void testCasesOfTheLibraryPass() {
        assertThat(CommandResult.crw("test", "clv").exitCode()).isZero();
    }

    @Test
    void plansShowsParametersByNameWithTypeAndDefault() throws Exception {
        CommandResult one = CommandResult.crw("plans", "station-keep");
        JsonNode json = JSON.readTree(
                CommandResult.crw("plans", "station-keep", "--json").out());
        Path file = folder.resolve("mine.json");
        CommandResult.crw("new", file.toString());

        assertThat(one.out())
                .startsWith("station-keep  (Station keeping)")
                .contains("--set ask-stations.location=point\n", "--set watch-time.duration=duration  (\"PT3M\")\n")
                .doesNotContain("clv");
        assertThat(json.at("/plans/0/parameters/1").toString())
                .isEqualTo("{\"name\":\"ask-stations.spacing\",\"type\":\"real\",\"default\":20,\"editable\":true}");
        assertThat(CommandResult.crw("plans", file.toString()).out())
                .contains("mine  (mine)", "ask-stations.spacing=real");
    }
}
