package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What {@code crw check} says of an author's mistakes: where they stand, about what, and what may have been meant. */
@Tag("long")
class CheckCommandTest {
    private static final Path CLV = Path.of("../domain-config/src/main/resources/org/sami/domain/crw/plans/clv.json");
    private static final Path UAV = Path.of("../domain-config/src/main/resources/org/sami/domain/uav");

    private static final String PANORAMAS = "../domain-config/src/test/resources/plans/panorama-";

    @TempDir
    Path folder;

    private String clv;

    @BeforeEach
    void readPlan() throws IOException {
        clv = Files.readString(CLV);
    }

    private Path write(String text) throws IOException {
        return Files.writeString(folder.resolve("plan.json"), text);
    }

    /** The plan with one mistake in it. */
    private Path mistaken(String right, String wrong) throws IOException {
        assertThat(clv).contains(right);
        return write(clv.replace(right, wrong));
    }

    /** FILE:LINE:COLUMN of the first place where the file holds a text. */
    private static String place(Path file, String text) throws IOException {
        List<String> lines = Files.readAllLines(file);
        for (int i = 0; i < lines.size(); i++) {
            int column = lines.get(i).indexOf(text);
            if (column >= 0) {
                return file + ":" + (i + 1) + ":" + (column + 1);
            }
        }
        throw new IllegalArgumentException(file + " does not hold " + text);
    }

    private static String line(Path file, String text) throws IOException {
        return Files.readAllLines(file).stream()
                .filter(line -> line.contains(text))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void deepSearchOnTheEngineEndsWithItsBudgetAndSaysSo() throws Exception {
        long begin = System.nanoTime();

        CommandResult ran = CommandResult.crw("check", "clv", "--deep", "--boats", "5", "--budget", "0.2");
        JsonNode json = new ObjectMapper()
                .readTree(CommandResult.crw("check", "clv", "--deep", "--boats", "5", "--budget", "0.2", "--json")
                        .out());

        assertThat(ran.out()).contains("clv: bounded search only, as 0.2 s were used up. Of the first ");
        assertThat(json.get("deep").get(0).get("timeUsedUp").asBoolean()).isTrue();
        assertThat(System.nanoTime() - begin).isLessThan(60_000_000_000L);
    }

    @Test
    void eachFindingSaysWhyItMattersAndHowToMendItWhereThatIsAsked() throws Exception {
        Path file = mistaken("\"type\": \"ProxyExecutePath\"", "\"type\": \"ProxyExecutPath\"");

        assertThat(CommandResult.crw("check", file.toString()).out()).doesNotContain("why: ");
        assertThat(CommandResult.crw("check", file.toString(), "--explain")
                        .out()
                        .lines())
                .contains(
                        "    why: The domain has no such event: nobody can carry it out or send it.",
                        "    mend: Choose an event of the domain, or correct the name.");
        JsonNode finding = new ObjectMapper()
                .readTree(CommandResult.crw("check", file.toString(), "--json").out())
                .get("findings")
                .get(0);
        assertThat(finding.get("why").asText()).startsWith("The domain has no such event");
        assertThat(finding.get("mend").asText()).startsWith("Choose an event of the domain");
    }

    @Test
    void whatTheReaderRefusesIsToldWithFileLineColumnAndElement() throws Exception {
        Path file = mistaken("\"type\": \"ProxyExecutePath\"", "\"type\": \"ProxyExecutPath\"");

        CommandResult ran = CommandResult.crw("check", file.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out())
                .contains(place(file, "\"ProxyExecutPath\"")
                        + ": error E-UNKNOWN-EVENT at /plans/0/places/4/outputs/0/type (go): ")
                .contains(": 1 errors");
    }

    @Test
    void whatTheChecksFindIsToldWithFileLineColumnAndElements() throws Exception {
        Path file = mistaken("\"writes\": {\"paths\": \"@paths\"}", "\"writes\": {\"paths\": \"@allocations\"}");

        CommandResult text = CommandResult.crw("check", file.toString());
        JsonNode json = new ObjectMapper()
                .readTree(CommandResult.crw("check", file.toString(), "--json").out());

        String where = place(file, "\"writes\": {\"paths\": \"@allocations\"}")
                .replaceAll(":\\d+$", ":" + (1 + line(file, "\"paths\": \"@all").indexOf("\"@all")));
        assertThat(text.out()).contains(where + ": error E-VARIABLE-TYPE at ").contains("(yes): ");
        JsonNode finding = json.get("findings").get(1);
        assertThat(finding.get("file").asText() + ":" + finding.get("line") + ":" + finding.get("column"))
                .isEqualTo(where);
        assertThat(finding.get("elements").get(0).asText()).isEqualTo("yes");
    }

    @Test
    void textThatIsNoJsonIsToldWithFileLineAndColumn() throws Exception {
        Path file = write("{\n  \"formatVersion\": 1,\n  \"id\" \"x\"\n}");

        assertThat(CommandResult.crw("check", file.toString()).out()).startsWith(file + ":3:8: error E-SYNTAX");
    }

    @Test
    void findingOfAPlanInAFileOfItsOwnNamesThatFile() throws Exception {
        JsonNode root = new ObjectMapper().readTree(clv);
        Path plan = Files.writeString(
                folder.resolve("visit.json"),
                root.get("plans").get(0).toString().replace("\"writes\":{\"paths\":\"@paths\"}", "\"writes\":{}"));
        Files.writeString(
                folder.resolve("project.json"),
                "{\"formatVersion\": 1, \"id\": \"p\", \"domain\": \"crw\", \"plans\": [{\"file\": \"visit.json\"}]}");

        CommandResult ran = CommandResult.crw("check", folder.toString());

        assertThat(ran.out()).contains(plan + ":1:").contains("warning W-VARIABLE-NEVER-WRITTEN at /plans/0/");
    }

    @Test
    void aTypeClashNamesBothTypes() throws Exception {
        CommandResult written = CommandResult.crw(
                "check",
                mistaken("\"writes\": {\"paths\": \"@paths\"}", "\"writes\": {\"paths\": \"@locations\"}")
                        .toString());
        CommandResult given = CommandResult.crw(
                "check",
                mistaken("{\"message\": {\"value\": \"All boats have finished\"}}", "{\"message\": {\"value\": 7}}")
                        .toString());

        assertThat(written.out()).contains("list<point>").contains("map<proxy,path>");
        assertThat(given.out()).contains("text").contains("7");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        "kind": "relevant"    | "kind": "relevnt"      | is relevant meant?
        "kind": "any-proxy"   | "kind": "any-proxi"    | is any-proxy meant?
        "action": "take"      | "action": "tak"        | is take meant?
        "match": "at-least"   | "match": "at-leat"     | is at-least meant?
        {"locations": {"var   | {"location": {"var     | is locations meant?
        {"variable": "@paths  | {"variabel": "@paths   | is variable meant?
        "place": "execute"    | "place": "excute"      | is execute meant?
        "transition": "visited" | "transition": "visted" | is visited meant?
        "variable": "@allocations" | "variable": "@alocations" | or @allocations meant?
        "children": [{"plan": "clv"}] | "children": [{"plan": "clw"}] | is clv meant?
        "start": true         | "strat": true          | is start meant?
        """)
    void aWordThatIsNearlyOneIsAnsweredWithThatOne(String right, String wrong, String said) throws Exception {
        CommandResult ran = CommandResult.crw("check", mistaken(right, wrong).toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains(said);
    }

    @Test
    void aByteOrderMarkIsAccepted() throws Exception {
        CommandResult ran = CommandResult.crw("check", write("\uFEFF" + clv).toString());

        assertThat(ran.exitCode()).as(ran.out()).isZero();
    }

    @Test
    void aSchemaMayBeNamed() throws Exception {
        CommandResult ran = CommandResult.crw(
                "check",
                write(clv.replaceFirst("\\{", "{\"\\$schema\": \"project-1.schema.json\","))
                        .toString());

        assertThat(ran.exitCode()).as(ran.out()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"project,plans", "vocabulary,events"})
    void schemaPrintsTheSchemaOfAKindOfFile(String kind, String member) throws Exception {
        CommandResult ran = CommandResult.crw("schema", kind);

        assertThat(ran.exitCode()).isZero();
        JsonNode schema = new ObjectMapper().readTree(ran.out());
        assertThat(schema.path("$schema").asText()).contains("2020-12");
        assertThat(schema.path("properties").has(member)).isTrue();
    }

    @Test
    void schemaWithoutAKindIsTheProjects() {
        assertThat(CommandResult.crw("schema")).isEqualTo(CommandResult.crw("schema", "project"));
        assertThat(CommandResult.crw("schema", "projct").exitCode()).isEqualTo(2);
        assertThat(CommandResult.crw("schema", "projct").err())
                .contains("project")
                .contains("vocabulary");
    }

    @Test
    void plansOfAnotherDomainAreCheckedWithItsWords() throws Exception {
        Path plan = UAV.resolve("plans/look.json");
        Path wrong = write(Files.readString(plan).replace("\"FlyTo\"", "\"FlyToo\""));

        CommandResult good = CommandResult.crw("check", "--domain", UAV.toString(), plan.toString());
        CommandResult byId = CommandResult.crw("check", "--domain", UAV.toString(), "look");
        CommandResult bad = CommandResult.crw("check", "--domain", UAV.toString(), wrong.toString());
        CommandResult ofBoats = CommandResult.crw("check", plan.toString());

        assertThat(good.exitCode()).as(good.out()).isZero();
        assertThat(byId.exitCode()).as(byId.out()).isZero();
        assertThat(bad.exitCode()).isEqualTo(1);
        assertThat(bad.out()).contains("is FlyTo meant?");
        assertThat(ofBoats.out()).contains("E-DOMAIN");
    }

    @Test
    void aDomainIsCheckedByItself() throws Exception {
        copyDomain();

        CommandResult good = CommandResult.crw("check", "--domain", folder.toString());
        Path events = folder.resolve("events.json");
        Files.writeString(
                events,
                Files.readString(events)
                        .replace(
                                "\"options\", \"type\": \"list<Allocation>\"",
                                "\"options\", \"type\": \"list<Alocation>\"")
                        .replace("\"answers\": [\"Landed\"", "\"answers\": [\"Landet\""));
        CommandResult bad = CommandResult.crw("check", "--domain", folder.toString());

        assertThat(good.exitCode()).as(good.out()).isZero();
        assertThat(good.out()).contains("0 errors");
        assertThat(bad.exitCode()).isEqualTo(1);
        assertThat(bad.out())
                .contains(place(events, "\"list<Alocation>\"") + ": error E-UNKNOWN-TYPE")
                .contains("is Allocation meant?");
    }

    @Test
    void whatEventsOfADomainSayOfEachOtherIsToldWithItsPlace() throws Exception {
        copyDomain();
        Path events = folder.resolve("events.json");
        Files.writeString(
                events, Files.readString(events).replace("\"answers\": [\"Landed\"", "\"answers\": [\"Landet\""));

        CommandResult ran = CommandResult.crw("check", "--domain", folder.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains(events + ":").contains("E-ANSWERS").contains("is Landed meant?");
    }

    @Test
    void aFolderThatIsNoDomainIsSaidToBeNone() {
        CommandResult ran = CommandResult.crw("check", "--domain", folder.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains("domain.json").contains(folder.toString());
    }

    @Test
    void deepCheckTellsWhatItFindsWithARunThatShowsIt() throws Exception {
        CommandResult ran =
                CommandResult.crw("check", PANORAMAS + "T5a-sync-at-least-1.json", "--deep", "--states", "300");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out())
                .contains("warning W-WAITS-FOR-NOBODY at /plans/0 (ready, go2): Nobody ever waits in place 12")
                .contains("    Task Started of Camera 1")
                .contains("plan: Of the first 300 states with 2 robots");
    }

    @Test
    void deepCheckOfARightPlanFindsNothing() throws Exception {
        CommandResult ran =
                CommandResult.crw("check", PANORAMAS + "T5c-sync-right.json", "--deep", "--states", "300", "--json");

        assertThat(ran.exitCode()).as(ran.out()).isZero();
        JsonNode deep = new ObjectMapper().readTree(ran.out()).get("deep").get(0);
        assertThat(deep.get("plan").asText()).isEqualTo("plan");
        assertThat(deep.get("states").asInt()).isEqualTo(300);
        assertThat(deep.get("complete").asBoolean()).isFalse();
        assertThat(deep.get("findings")).isEmpty();
        assertThat(deep.get("summary").asText()).contains("the mission can still end");
    }

    @Test
    void runsOfADeepCheckStandInItsJson() throws Exception {
        CommandResult ran = CommandResult.crw(
                "check", PANORAMAS + "T5a-sync-at-least-1.json", "--deep", "--states", "300", "--json");

        JsonNode found = new ObjectMapper()
                .readTree(ran.out())
                .get("deep")
                .get(0)
                .get("findings")
                .get(0);
        assertThat(found.get("code").asText()).isEqualTo("W-WAITS-FOR-NOBODY");
        assertThat(found.get("run").get(2).asText()).isEqualTo("Task Started of Camera 1");
    }

    @Test
    void deepCheckLeavesOutPlansWithErrorsOnly() throws Exception {
        ObjectMapper json = new ObjectMapper();
        JsonNode project =
                json.readTree(Path.of(PANORAMAS + "T5a-sync-at-least-1.json").toFile());
        ArrayNode plans = (ArrayNode) project.get("plans");
        ObjectNode broken = plans.get(0).deepCopy();
        broken.put("id", "broken");
        broken.get("places").forEach(place -> ((ObjectNode) place).remove("start"));
        plans.add(broken);

        CommandResult ran =
                CommandResult.crw("check", write(project.toString()).toString(), "--deep", "--states", "300");

        assertThat(ran.out())
                .contains("E-NO-START", "W-WAITS-FOR-NOBODY", "plan: Of the first 300 states")
                .doesNotContain("broken: Of");
    }

    @Test
    void deepCheckNeedsAPlanAndABound() throws Exception {
        assertThat(CommandResult.crw("check", "--domain", "uav", "--deep").exitCode())
                .isEqualTo(2);
        assertThat(CommandResult.crw("check", "clv", "--deep", "--states", "0").exitCode())
                .isEqualTo(2);
    }

    private void copyDomain() throws IOException {
        try (Stream<Path> files = Files.walk(UAV)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path copy = folder.resolve(UAV.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        }
    }

    @Test
    void edgeIsSuggestedNothingWhereNothingIsFound() throws Exception {
        CommandResult ran = CommandResult.crw("check", "station-keep", "--suggest", edgeOf("station-keep"));

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out()).contains("Nothing is found in this plan").contains("states were looked at");
    }

    @Test
    void requirementsAreSuggestedAtAnEdgeThatLostItsOwn() throws Exception {
        ObjectMapper mapper = new ObjectMapper();
        JsonNode lost = mapper.readTree(clv);
        for (JsonNode edge : lost.at("/plans/0/inEdges")) {
            if (edge.path("id").asText().equals("go-home.all-visited")) {
                ((ObjectNode) edge).putArray("requirements").addObject().put("kind", "unconditional");
            }
        }

        CommandResult ran = CommandResult.crw(
                "check", write(mapper.writeValueAsString(lost)).toString(), "--suggest", "go-home.all-visited");

        assertThat(ran.out())
                .contains("go-home.all-visited: 1. No Proxy (2 findings fewer")
                .contains("    + \"Home reached\", \"Home not reached\" can fire")
                .contains("15 of 15 sets of requirements were tried");
    }

    @Test
    void edgeThatNoPlanHasIsRefusedWithThoseThatThereAre() throws Exception {
        CommandResult ran = CommandResult.crw("check", "station-keep", "--suggest", "nowhere");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("there is no edge \"nowhere\"").contains(edgeOf("station-keep"));
    }

    private static String edgeOf(String plan) throws IOException {
        JsonNode file =
                new ObjectMapper().readTree(CLV.resolveSibling(plan + ".json").toFile());
        return file.at("/plans/0/inEdges/0/id").asText();
    }
}
