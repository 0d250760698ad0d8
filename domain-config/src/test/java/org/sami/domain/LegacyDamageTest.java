package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.vocabulary.Vocabulary;

/** Exports that are cut, bent or made to do harm: an error that says where, or a project that is whole. */
@Tag("long")
class LegacyDamageTest {
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final LegacyImport IMPORT = new LegacyImport(
            VOCABULARY,
            LegacyTableReader.fromClassPath("/org/sami/domain/crw/legacy.json", VOCABULARY)
                    .orThrow());
    private static final ObjectMapper MAPPER = new ObjectMapper();

    /** Of each kind of thing one. */
    private static final String WHOLE = """
        {"format": "sami-legacy-project", "version": 1,
         "globalVariables": [{"name": "@home", "class": "sami.path.Location",
           "value": {"type": "location", "lat": 25.3, "lon": 51.5, "alt": 0.0}}],
         "missionTree": {"label": "Plays", "children": [{"plan": "p1", "children": []}, {"plan": "p2"}]},
         "plans": [
          {"id": "p1", "name": "Parent", "role": "root", "parentPlan": null, "inMissionTree": true,
           "tasks": [{"name": "t", "class": "crw.task.Visit"}],
           "vertices": [
            {"key": "v1", "type": "place", "name": "Begin", "mode": "Nominal", "x": 10.0, "y": 20.0, "isStart": true,
             "outTransitionOrder": ["v2"],
             "events": [{"key": "v1.e0", "class": "crw.event.output.ui.DisplayMessage", "direction": "output",
               "locked": false, "fieldValues": {"message": {"type": "string", "value": "Hello"}},
               "editable": {"message": false}, "markups": [
                {"class": "sami.markup.Priority", "options": {"ranking": "HIGH"}, "parameters": {}}]}],
             "subMissions": [{"plan": "p2", "planName": "a.Child", "instanceMode": "dynamic", "taskMap": []}]},
            {"key": "v2", "type": "transition", "mode": "Recovery", "inPlaceOrder": ["v1"], "outPlaceOrder": ["v3"],
             "events": [{"key": "v2.e0", "class": "sami.event.TimerExpired", "direction": "input"}]},
            {"key": "v3", "type": "place", "isEnd": true}],
           "edges": [
            {"key": "e1", "type": "in", "from": "v1", "to": "v2", "requirements": [
              {"kind": "Generic", "match": "GreaterThanEqualTo", "quantity": 1}]},
            {"key": "e2", "type": "out", "from": "v2", "to": "v3", "requirements": [
              {"kind": "AnyProxy", "match": "All", "action": "Take"}]}]},
          {"id": "p2", "name": "a.Child", "role": "sub-mission-instance", "parentPlan": "p1",
           "vertices": [{"key": "v1", "type": "place", "isStart": true, "isEnd": true}], "edges": []}],
         "notes": []}
        """;

    private static LegacyImport.Result read(String text) {
        return IMPORT.read(text, "damaged");
    }

    @Test
    void theWholeOneArrives() {
        assertThat(read(WHOLE).project()).isPresent();
        assertThat(read(WHOLE).isAccountedFor()).isTrue();
    }

    @Test
    void anExportThatIsCutAnywhereIsRefusedWithThePlaceOfTheCut() {
        String whole = WHOLE.strip();
        for (int percent = 0; percent < 100; percent++) {
            assertCutIsRefused(whole, percent);
        }
    }

    private static void assertCutIsRefused(String whole, int percent) {
        LegacyImport.Result cut = read(whole.substring(0, (int) ((long) whole.length() * percent / 100)));
        assertThat(cut.project()).as("%d %%", percent).isEmpty();
        assertThat(cut.findings())
                .as("%d %%", percent)
                .anySatisfy(
                        f -> assertThat(f.message()).matches("(?s)(Line \\d+, column \\d+: |The document is empty).*"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "crw"})
    void realExportsThatAreCutAnywhereAreRefusedToo(String name) throws IOException {
        Path file = Path.of("../../shared/legacy-plans", name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        String whole = Files.readString(file).strip();
        for (int percent = 0; percent < 100; percent++) {
            assertCutIsRefused(whole, percent);
        }
    }

    @Test
    void whatStandsSomewhereElseThanItShouldIsAnErrorWithItsPlaceOrArrivesWhole() throws IOException {
        int refused = 0;
        for (int seed = 0; seed < 3000; seed++) {
            String bent = bent(new Random(seed));

            LegacyImport.Result result = read(bent);

            if (result.project().isEmpty()) {
                refused++;
                assertThat(result.findings())
                        .as("seed %d: %s", seed, bent)
                        .anyMatch(f -> f.isError() && !f.message().isBlank());
            } else {
                assertThat(result.isAccountedFor())
                        .as("seed %d: %s %s %s %s", seed, bent, result.source(), result.imported(), result.findings())
                        .isTrue();
                String written =
                        new ProjectWriter(VOCABULARY).text(result.project().get());
                assertThat(new ProjectReader(VOCABULARY).read(written).result())
                        .as(
                                "seed %d: %s %s",
                                seed,
                                bent,
                                new ProjectReader(VOCABULARY).read(written).findings())
                        .isEqualTo(result.project());
            }
        }
        assertThat(refused).isBetween(500, 2900);
    }

    /** The whole with one node replaced, removed or doubled. */
    private static String bent(Random random) throws IOException {
        JsonNode root = MAPPER.readTree(WHOLE);
        List<Runnable> edits = new ArrayList<>();
        collect(root, random, edits);
        edits.get(random.nextInt(edits.size())).run();
        return root.toString();
    }

    private static void collect(JsonNode node, Random random, List<Runnable> edits) {
        if (node instanceof ObjectNode object) {
            object.fieldNames().forEachRemaining(name -> {
                edits.add(() -> object.set(name, junk(random, object.get(name))));
                edits.add(() -> object.remove(name));
            });
        } else if (node instanceof ArrayNode array) {
            for (int i = 0; i < array.size(); i++) {
                int at = i;
                edits.add(() -> array.set(at, junk(random, array.get(at))));
                edits.add(() -> array.add(array.get(at).deepCopy()));
                edits.add(() -> array.remove(at));
            }
        }
        node.forEach(child -> collect(child, random, edits));
    }

    private static JsonNode junk(Random random, JsonNode before) {
        JsonNodeFactory made = JsonNodeFactory.instance;
        return switch (random.nextInt(9)) {
            case 0 -> made.nullNode();
            case 1 -> made.numberNode(random.nextInt(5) - 2);
            case 2 -> made.numberNode(1e300);
            case 3 -> made.textNode("");
            case 4 -> made.textNode("v99");
            case 5 -> made.booleanNode(random.nextBoolean());
            case 6 -> made.objectNode().put("type", "string");
            case 7 -> made.arrayNode().add(before.deepCopy());
            default -> made.textNode("some.other.Class");
        };
    }

    @Test
    void plansThatRunEachOtherInARingAreRefused() {
        LegacyImport.Result result = read(WHOLE.replace(
                "{\"key\": \"v1\", \"type\": \"place\", \"isStart\": true, \"isEnd\": true}",
                "{\"key\": \"v1\", \"type\": \"place\", \"isStart\": true, \"subMissions\": [{\"plan\": \"p1\", "
                        + "\"instanceMode\": \"dynamic\"}]}"));

        assertThat(result.project()).isEmpty();
        assertThat(result.findings())
                .filteredOn(Finding::isError)
                .map(f -> f.code() + " " + f.pointer())
                .containsExactly(
                        "E-CYCLE /plans/0/vertices/0/subMissions/0", "E-CYCLE /plans/1/vertices/0/subMissions/0");
    }

    @Test
    void aPlanThatRunsItselfIsRefused() {
        LegacyImport.Result result =
                read(WHOLE.replace("{\"plan\": \"p2\", \"planName\"", "{\"plan\": \"p1\", \"planName\""));

        assertThat(result.findings())
                .filteredOn(Finding::isError)
                .map(Finding::code)
                .containsExactly("E-CYCLE");
    }

    @ParameterizedTest
    @ValueSource(ints = {900, 5_000, 1_000_000})
    void whatIsNestedDeepIsRefusedOrReadAndBreaksNothing(int depth) {
        String tree = "{\"label\": \"x\", \"children\": [".repeat(depth) + "]}".repeat(depth);

        LegacyImport.Result result = read("{\"format\": \"sami-legacy-project\", \"version\": 1, \"plans\": [],"
                + " \"missionTree\": " + tree + "}");

        assertThat(result.project()).isEmpty();
        assertThat(result.findings()).anySatisfy(f -> assertThat(f.message()).contains("nest"));
    }

    @Test
    void otherFilesAreNamedAsThat() {
        assertThat(read("[]").findings()).anyMatch(Finding::isError);
        assertThat(read("null").findings()).anyMatch(Finding::isError);
        assertThat(read("{}").findings())
                .singleElement()
                .satisfies(f -> assertThat(f.message()).contains("no export of the earlier system"));
        assertThat(read("\u0000").findings()).anyMatch(Finding::isError);
        assertThat(read("PK\u0003\u0004").findings()).anyMatch(Finding::isError);
    }
}
