package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.option.PlanSource;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.ListValue;

class ImportLocationsCommandTest {
    private static final String TWO_LISTS = """
            # two triangles
            [
            [
            45,10
            45.001,10
            45,10.001
            ]
            [
            46,10
            46.001,10
            46,10.001
            ]
            ]
            """;

    @TempDir
    Path folder;

    @Test
    void writesANewProjectThatCanBeRead() throws Exception {
        Path project = folder.resolve("bay.json");

        CommandResult ran = CommandResult.crw("import-locations", file(TWO_LISTS), project.toString(), "--as", "areas");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("@beach: list<area>, 2")
                .contains("3 points, 438")
                .contains("m²");
        VariableSpec variable = read(project).globals().get(0);
        assertThat(variable.name()).isEqualTo("@beach");
        assertThat(((ListValue) variable.initial().orElseThrow()).items()).hasSize(2);
    }

    @Test
    void addsToAProjectWithoutTouchingTheRest() throws Exception {
        Path project = folder.resolve("clv.json");
        Files.copy(Path.of("../domain-config/src/main/resources/org/sami/domain/crw/plans/clv.json"), project);
        Project before = read(project);

        CommandResult ran =
                CommandResult.crw("import-locations", file(TWO_LISTS), project.toString(), "--as", "areas", "--each");

        assertThat(ran.exitCode()).isZero();
        Project after = read(project);
        assertThat(after.plans()).isEqualTo(before.plans());
        assertThat(after.globals()).extracting(VariableSpec::name).endsWith("@beach1", "@beach2");
    }

    @Test
    void doesNotGuessWhatPointsMean() throws Exception {
        Path project = folder.resolve("bay.json");

        CommandResult ran = CommandResult.crw("import-locations", file(TWO_LISTS), project.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("a list of 2 lists of points").contains("--as paths or areas");
        assertThat(project).doesNotExist();
        assertThat(CommandResult.crw("import-locations", file(TWO_LISTS), "--as", "path")
                        .err())
                .contains("can be paths or areas, not path");
    }

    @Test
    void keepsVariablesThatAreThereUnlessTold() throws Exception {
        Path project = folder.resolve("bay.json");
        CommandResult.crw("import-locations", file(TWO_LISTS), project.toString(), "--as", "areas", "--each");
        String before = Files.readString(project);
        String moved = file(TWO_LISTS.replace("46", "47"));

        CommandResult refused =
                CommandResult.crw("import-locations", moved, project.toString(), "--as", "areas", "--each");

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains("@beach1, @beach2 already");
        assertThat(project).hasContent(before);

        CommandResult replaced =
                CommandResult.crw("import-locations", moved, project.toString(), "--each", "--replace");

        assertThat(replaced.exitCode()).isZero();
        GeoArea second = (GeoArea) read(project).globals().get(1).initial().orElseThrow();
        assertThat(second.outline().get(0).latDeg()).isEqualTo(47);
    }

    @Test
    void doesNotChangeAVariablesType() throws Exception {
        Path project = folder.resolve("bay.json");
        CommandResult.crw("import-locations", file(TWO_LISTS), project.toString(), "--as", "areas");

        CommandResult ran = CommandResult.crw(
                "import-locations", file(TWO_LISTS), project.toString(), "--as", "paths", "--replace");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("is of the type list<area>, not list<path>");
    }

    @Test
    void namesTheLineOfWhatIsWrongAndWritesNothing() throws Exception {
        Path project = folder.resolve("bay.json");
        String bad = file("[\n45,10\n45\n]");

        CommandResult ran = CommandResult.crw("import-locations", bad, project.toString(), "--as", "path");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.err()).contains(bad + ":3: error: ");
        assertThat(project).doesNotExist();
    }

    @Test
    void projectWithErrorsIsLeftAlone() throws Exception {
        Path project = Files.writeString(folder.resolve("bay.json"), "{\"formatVersion\": 99}");

        CommandResult ran = CommandResult.crw("import-locations", file(TWO_LISTS), project.toString(), "--as", "areas");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.err()).contains("E-VERSION");
        assertThat(project).hasContent("{\"formatVersion\": 99}");
    }

    @Test
    void realFileOfTheEarlierSystemIsRead() throws Exception {
        Path example = Path.of("..", "..", "shared", "field-data", "sami-crw-import-areas-example.txt");
        Assumptions.assumeTrue(Files.exists(example), "skipped: there is no " + example);
        Path project = folder.resolve("beach.json");

        CommandResult ran = CommandResult.crw(
                "import-locations", example.toString(), project.toString(), "--as", "areas", "--name", "@katara");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out()).contains("@katara: list<area>, 2");
        assertThat(((ListValue) read(project).globals().get(0).initial().orElseThrow()).items())
                .hasSize(2)
                .allSatisfy(area -> assertThat(((GeoArea) area).outline()).hasSize(4));
    }

    private String file(String content) throws Exception {
        return Files.writeString(folder.resolve("beach.txt"), content).toString();
    }

    private static Project read(Path project) {
        return new ProjectReader(PlanSource.library().vocabulary())
                .read(project)
                .orThrow();
    }
}
