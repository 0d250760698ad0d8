package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("long")
class ImportLegacyCommandTest {
    /** A plan that greets the operator and ends; its edges have no requirements, as some field plans' have not. */
    private static final String SMALL = """
        {"format": "sami-legacy-project", "version": 1, "plans": [
          {"id": "p1", "name": "Greeting", "role": "root",
           "vertices": [
            {"key": "v1", "type": "place", "isStart": true, "events": [
              {"key": "v1.e0", "class": "crw.event.output.ui.DisplayMessage", "direction": "output",
               "fieldValues": {"message": {"type": "string", "value": "Hello"}}, "editable": {"message": false}}]},
            {"key": "v2", "type": "transition"},
            {"key": "v3", "type": "place", "isEnd": true}],
           "edges": [
            {"key": "e1", "type": "in", "from": "v1", "to": "v2", "requirements": []},
            {"key": "e2", "type": "out", "from": "v2", "to": "v3", "requirements": []}]},
          {"id": "p2", "name": "--- HEADING ---", "role": "root", "vertices": [], "edges": []}]}
        """;

    @TempDir
    Path folder;

    private Path export(String text) throws IOException {
        return Files.writeString(folder.resolve("old.json"), text);
    }

    @Test
    void writesAProjectThatIsReadCheckedAndRun() throws IOException {
        Path out = folder.resolve("new.json");

        CommandResult ran = CommandResult.crw("import-legacy", export(SMALL).toString(), out.toString());

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("warning W-NO-REQUIREMENT: 2 in Greeting")
                .contains("such as /plans/0/edges/0")
                .containsPattern("places +2 +2 +0")
                .contains("complete: all arrived");
        CommandResult run = CommandResult.crw("run", out.toString(), "--plan", "Greeting", "--speed", "max", "--json");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.out()).contains("Hello");
    }

    @Test
    void writesAFolderWhereTheNameIsNoFiles() throws IOException {
        Path out = folder.resolve("new");

        assertThat(CommandResult.crw("import-legacy", export(SMALL).toString(), out.toString())
                        .exitCode())
                .isZero();

        assertThat(out.resolve("project.json")).exists();
        assertThat(CommandResult.crw("check", out.toString()).out()).contains("E-NO-START");
        try (Stream<Path> left = Files.list(folder)) {
            assertThat(left.map(p -> p.getFileName().toString())).containsExactlyInAnyOrder("old.json", "new");
        }
    }

    @Test
    void saysThatAnImportIsNotCompleteAndWhatItLost() throws IOException {
        Path out = folder.resolve("new.json");
        String markup = "\"markups\": [{\"class\": \"sami.markup.Priority\", \"options\": {\"ranking\": \"HIGH\","
                + " \"colour\": \"RED\"}}], ";

        CommandResult ran = CommandResult.crw(
                "import-legacy",
                export(SMALL.replace("\"fieldValues\"", markup + "\"fieldValues\""))
                        .toString(),
                out.toString(),
                "--all");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("NOT COMPLETE: 1 things of the export say less here (W-UNKNOWN-OPTION 1)")
                .contains("The option colour of the markup Priority of v1.e0 cannot be kept")
                .contains("W-NO-REQUIREMENT at /plans/0/edges/1");
    }

    @Test
    void aCheckOfAnImportPartsWhatTheImportWroteFromWhatThePlansSay() throws IOException {
        Path out = folder.resolve("new.json");
        CommandResult.crw("import-legacy", export(SMALL).toString(), out.toString());

        CommandResult text = CommandResult.crw("check", out.toString());
        CommandResult json = CommandResult.crw("check", out.toString(), "--json");

        assertThat(text.out())
                .contains("imported from old.json; result of the import: W-HEADING 1, W-NO-REQUIREMENT 2")
                .containsSubsequence("of the plans as they were drawn:", "E-NO-START");
        assertThat(new ObjectMapper()
                        .readTree(json.out())
                        .path("imported")
                        .path("ofPlans")
                        .asInt())
                .isPositive();
    }

    @Test
    void printsOneObjectForPrograms() throws IOException {
        CommandResult ran = CommandResult.crw(
                "import-legacy",
                export(SMALL).toString(),
                folder.resolve("n.json").toString(),
                "--json");

        JsonNode json = new ObjectMapper().readTree(ran.out());
        assertThat(json.at("/counts/source/places").asInt()).isEqualTo(2);
        assertThat(json.at("/counts/imported")).isEqualTo(json.at("/counts/source"));
        assertThat(json.path("complete").asBoolean()).isTrue();
    }

    @Test
    void overwritesNothing() throws IOException {
        Path out = Files.writeString(folder.resolve("new.json"), "precious");

        CommandResult ran = CommandResult.crw("import-legacy", export(SMALL).toString(), out.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("is there already");
        assertThat(out).hasContent("precious");
    }

    @Test
    void writesNothingOfATruncatedExport() throws IOException {
        Path out = folder.resolve("new.json");

        CommandResult ran = CommandResult.crw(
                "import-legacy", export(SMALL.substring(0, 500)).toString(), out.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains("E-SYNTAX").contains("nothing is imported");
        assertThat(out).doesNotExist();
    }

    @Test
    void namesAFileThatIsNotThereOrAFolderThatIsNot() throws IOException {
        assertThat(CommandResult.crw(
                        "import-legacy", "no-such.json", folder.resolve("n").toString()))
                .satisfies(r -> assertThat(r.exitCode()).isEqualTo(2))
                .satisfies(r -> assertThat(r.err()).contains("no-such.json"));
        assertThat(CommandResult.crw(
                        "import-legacy",
                        export(SMALL).toString(),
                        folder.resolve("no/n").toString()))
                .satisfies(r -> assertThat(r.exitCode()).isEqualTo(2))
                .satisfies(r -> assertThat(r.err()).contains("there is no folder"));
    }

    /** A plan that connects a boat, one that asks where to go and waits to be interrupted, and one without a start. */
    private static final String TO_RUN = """
        {"format": "sami-legacy-project", "version": 1, "plans": [
          {"id": "p1", "name": "Connect RED", "role": "root",
           "vertices": [
            {"key": "v1", "type": "place", "isStart": true, "events": [
              {"key": "v1.e0", "class": "crw.event.output.proxy.ConnectExistingProxy", "direction": "output",
               "fieldValues": {"name": {"type": "string", "value": "RED"},
                "color": {"type": "color", "value": "#f40000"},
                "server": {"type": "string", "value": "192.168.1.105:11411"}}}]},
            {"key": "v2", "type": "transition", "events": [
              {"key": "v2.e0", "class": "crw.event.input.proxy.ProxyCreated", "direction": "input"}]},
            {"key": "v3", "type": "place", "isEnd": true}],
           "edges": [
            {"key": "e1", "type": "in", "from": "v1", "to": "v2", "requirements": [
              {"kind": "Generic", "match": "GreaterThanEqualTo", "quantity": 1}]},
            {"key": "e2", "type": "out", "from": "v2", "to": "v3", "requirements": [
              {"kind": "RelevantToken", "match": "All", "action": "Add"}]}]},
          {"id": "p2", "name": "Stay", "role": "root",
           "vertices": [
            {"key": "v1", "type": "place", "isStart": true, "name": "Idle"},
            {"key": "v2", "type": "transition", "events": [
              {"key": "v2.e0", "class": "sami.event.OperatorInterruptReceived", "direction": "input",
               "fieldValues": {"interruptName": {"type": "string", "value": "Greet"}}}]},
            {"key": "v3", "type": "place", "name": "Greeted", "events": [
              {"key": "v3.e0", "class": "crw.event.output.ui.DisplayMessage", "direction": "output",
               "fieldValues": {"message": {"type": "string", "value": "Hello"}}}]}],
           "edges": [
            {"key": "e1", "type": "in", "from": "v1", "to": "v2", "requirements": [
              {"kind": "Generic", "match": "GreaterThanEqualTo", "quantity": 1}]},
            {"key": "e2", "type": "out", "from": "v2", "to": "v3", "requirements": [
              {"kind": "Generic", "match": "Number", "quantity": 1, "action": "Add"}]}]},
          {"id": "p3", "name": "HEADING", "role": "root", "vertices": [], "edges": []}]}
        """;

    private JsonNode tried(String seed, String out) throws IOException {
        CommandResult ran = CommandResult.crw(
                "import-legacy",
                export(TO_RUN).toString(),
                folder.resolve(out).toString(),
                "--run",
                "--json",
                "--seed",
                seed);
        assertThat(ran.exitCode()).as(ran.err() + ran.out()).isZero();
        return new ObjectMapper().readTree(ran.out());
    }

    @Test
    void runsEachPlanThatHasAStartPlaceAndSaysWhatItWaitsFor() throws IOException {
        JsonNode json = tried("1", "a.json");

        assertThat(json.path("plans")).hasSize(2);
        JsonNode connect = json.path("plans").get(0);
        assertThat(connect.path("name").asText()).isEqualTo("Connect RED");
        assertThat(connect.path("outcome").asText()).isEqualTo("ended");
        assertThat(connect.path("firings").asInt()).isEqualTo(1);
        assertThat(connect.path("waitsFor")).isEmpty();
        JsonNode stay = json.path("plans").get(1);
        assertThat(stay.path("outcome").asText()).isEqualTo("running");
        assertThat(stay.path("simulatedSeconds").asDouble()).isEqualTo(3600);
        assertThat(stay.path("firings").asInt()).isPositive(); // random interrupts
        assertThat(stay.path("messages").asInt()).isEqualTo(stay.path("firings").asInt());
        assertThat(stay.at("/waitsFor/0/place").asText()).isEqualTo("Idle");
        assertThat(stay.at("/waitsFor/0/occurrence").asText()).isEqualTo("OperatorInterruptReceived 'Greet'");
        assertThat(json.at("/servers/192.168.1.105:11411").asText()).isEqualTo("RED");
    }

    @Test
    void equalSeedsGiveEqualRuns() throws IOException {
        assertThat(tried("7", "a.json").path("plans"))
                .isEqualTo(tried("7", "b.json").path("plans"));
    }

    @Test
    void printsATableOfTheRunsAndWhereServersAre() throws IOException {
        CommandResult ran = CommandResult.crw(
                "import-legacy",
                export(TO_RUN).toString(),
                folder.resolve("n.json").toString(),
                "--run");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .containsPattern("192.168.1.105:11411 +RED")
                .containsPattern("p1 +Connect RED +ended .* 1 +0 +")
                .contains("p2 (Stay) waits in 'Idle' (generic, boat1, boat2, boat3) for OperatorInterruptReceived"
                        + " 'Greet'")
                .contains("2 of 2 plans tried: 1 ended, 1 running; no engine error, no livelock, no event");
        assertThat(ran.err()).contains("plan 1 of 2: Connect RED");
    }
}
