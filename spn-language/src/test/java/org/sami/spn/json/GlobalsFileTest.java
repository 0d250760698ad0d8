package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.finding.Finding;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Globals of a session, saved as the initial values of a project's file. */
class GlobalsFileTest {
    private static final String GLOBALS = """
              "globals": [
                {"name": "@speed", "type": "real", "initial": 1.5},
                {"name": "@dock", "type": "point"},
                {"name": "@buoys", "type": "list<point>", "initial": [{"lat": 45.0, "lon": 10.0}]}
              ],
            """;
    private static final String PLAN = """
            {
              "$schema": "../plan.schema.json",
              "id": "p",
              "places": [{"id": "s", "start": true}, {"id": "e", "end": true}],
              "transitions": [{"id": "t"}],
              "inEdges": [
                {"id": "i", "place": "s", "transition": "t", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}
              ],
              "outEdges": [
                {"id": "o", "transition": "t", "place": "e",
                 "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}
              ],
              "notes": ["Keep me."]
            }
            """;

    @TempDir
    Path folder;

    private Path file() {
        return folder.resolve("project.json");
    }

    private String write() throws IOException {
        Files.writeString(folder.resolve("odd name.json"), PLAN);
        String text = CanonicalJson.format(
                        "{\"$schema\": \"x.json\", \"formatVersion\": 1, \"id\": \"a\", \"domain\": \"test\",\n"
                                + GLOBALS + "\"plans\": [{\"file\": \"odd name.json\"}]}")
                .orThrow();
        Files.writeString(file(), text);
        return text;
    }

    private Reading<List<GlobalsFile.Change>> save(Map<String, Value> values, Path path) throws IOException {
        return new GlobalsFile(TestVocabulary.TEST).save(values, path);
    }

    @Test
    void changedGlobalsBecomeInitialValuesAndAllElseStays() throws IOException {
        String before = write();

        Reading<List<GlobalsFile.Change>> saved = save(
                Map.of("@speed", new RealValue(0.5), "@buoys", new ListValue(List.of(GeoPoint.of(45, 10)))), file());

        assertThat(saved.findings()).isEmpty();
        assertThat(saved.orThrow())
                .containsExactly(new GlobalsFile.Change(
                        "@speed", ValueType.Simple.REAL, Optional.of(new RealValue(1.5)), new RealValue(0.5)));
        assertThat(file()).hasContent(before.replace("1.5", "0.5"));
        assertThat(folder.resolve("odd name.json")).hasContent(PLAN);
    }

    @Test
    void aGlobalWithoutInitialValueGetsOneAlsoInAFolder() throws IOException {
        write();

        Reading<List<GlobalsFile.Change>> saved = save(Map.of("@dock", GeoPoint.of(45.25, 10.5)), folder);

        assertThat(saved.orThrow())
                .containsExactly(new GlobalsFile.Change(
                        "@dock", ValueType.Simple.POINT, Optional.empty(), GeoPoint.of(45.25, 10.5)));
        assertThat(new ProjectReader(TestVocabulary.TEST).read(folder).orThrow().globals())
                .extracting(v -> v.name() + " " + v.initial().orElseThrow())
                .contains("@dock " + GeoPoint.of(45.25, 10.5));
    }

    @Test
    void aFileWhoseValuesAreTheSessionsIsNotTouched() throws IOException {
        write();
        String notCanonical = Files.readString(file()).replace("\n", "\n\n");
        Files.writeString(file(), notCanonical);

        assertThat(save(Map.of("@speed", new RealValue(1.5)), file()).orThrow()).isEmpty();

        assertThat(file()).hasContent(notCanonical);
    }

    @Test
    void aValueThatDoesNotFitTheFilesTypeSavesNothing() throws IOException {
        String before = write();

        Reading<List<GlobalsFile.Change>> saved =
                save(Map.of("@speed", new RealValue(0.5), "@dock", new TextValue("pier")), file());

        assertThat(saved.result()).isEmpty();
        assertThat(saved.findings())
                .singleElement()
                .satisfies(finding -> assertThat(finding.message())
                        .contains("@dock")
                        .contains("pier")
                        .contains("nothing was saved"));
        assertThat(file()).hasContent(before);
    }

    @Test
    void aGlobalThatTheFileDoesNotDeclareIsToldAndTheOthersAreSaved() throws IOException {
        write();

        Reading<List<GlobalsFile.Change>> saved =
                save(Map.of("@gone", new IntegerValue(1), "@speed", new RealValue(2)), file());

        assertThat(saved.orThrow()).hasSize(1);
        assertThat(saved.findings()).extracting(Finding::code).containsExactly("W-UNKNOWN-GLOBAL");
        assertThat(saved.findings().get(0).message()).contains("@gone");
    }

    @Test
    void aFileThatCannotBeReadIsLeftAsItIs() throws IOException {
        Files.writeString(file(), "{\"formatVersion\": 1, ");

        Reading<List<GlobalsFile.Change>> saved = save(Map.of("@speed", new RealValue(2)), file());

        assertThat(saved.result()).isEmpty();
        assertThat(saved.findings()).isNotEmpty();
        assertThat(file()).hasContent("{\"formatVersion\": 1, ");
    }
}
