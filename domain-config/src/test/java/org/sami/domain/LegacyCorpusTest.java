package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** The real plans of the earlier fleet; skipped where they are absent, since their licence keeps them out of the project. */
class LegacyCorpusTest {
    private static final String CRW = "/org/sami/domain/crw";
    private static final Path FOLDER = Path.of("../../shared/legacy-plans");
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath(CRW).orThrow();
    private static final LegacyTable TABLE =
            LegacyTableReader.fromClassPath(CRW + "/legacy.json", VOCABULARY).orThrow();

    private static LegacyImport.Result read(String name) {
        Path file = FOLDER.resolve(name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        return new LegacyImport(VOCABULARY, TABLE).read(file);
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "crw"})
    void everythingOfARealProjectArrivesLessWhatFindingsExplain(String name) {
        LegacyImport.Result result = read(name);

        assertThat(result.findings()).noneMatch(Finding::isError);
        assertThat(result.isComplete())
                .as("%s%n%s%n%s", result.source(), result.imported(), result.explained())
                .isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "crw"})
    void anImportedProjectIsReadBackAsItWasWritten(String name) {
        Project project = read(name).project().orElseThrow();

        Reading<Project> again = new ProjectReader(VOCABULARY).read(new ProjectWriter(VOCABULARY).text(project));

        assertThat(again.findings()).isEmpty();
        assertThat(again.orThrow()).isEqualTo(project);
    }

    @ParameterizedTest
    @CsvSource({"thesis, ''", "crw, 'E-RELEVANT-WITHOUT-EVENT E-NO-START'"})
    void onlyDefectsOfThePlansThemselvesAreErrorsToTheChecks(String name, String expected) {
        Project project = read(name).project().orElseThrow();

        assertThat(PlanChecks.check(project, VOCABULARY).stream()
                        .filter(Finding::isError)
                        .map(Finding::code)
                        .collect(Collectors.joining(" ")))
                .isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"thesis, p11 p13", "crw, p23"})
    void aRedefinitionWithoutItsPrefixIsNamedAndNotRepaired(String name, String plans) {
        assertThat(read(name).findings())
                .filteredOn(f -> f.code().equals("W-PREFIX"))
                .allSatisfy(f -> assertThat(f.message()).contains("@thisAsbLocation"))
                .map(f -> f.elements().get(0))
                .containsExactly(plans.split(" "));
    }
}
