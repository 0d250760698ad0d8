package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
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

    /**
     * Each finding is a defect of the plan: failures that nothing waits for, drafts that nothing leads to, rings, an exploration that ends
     * with its first boat (p8, p51), a transition that waits for 5 generic tokens of 1 (p50). Of the heading p47 it is said once that it
     * never starts.
     */
    @ParameterizedTest
    @MethodSource("findings")
    void checksRaiseNoFalseAlarmOnRealPlans(String name, Map<String, String> expected) {
        Project project = read(name).project().orElseThrow();

        Map<String, String> found = new TreeMap<>();
        PlanChecks.check(project, VOCABULARY).forEach(f -> found.merge(f.code(), f.plan(), (a, b) -> a + " " + b));

        assertThat(found).isEqualTo(expected);
    }

    static Stream<Arguments> findings() {
        return Stream.of(
                Arguments.of(
                        "thesis",
                        Map.of(
                                "W-ENDS-WITH-FIRST", "p8",
                                "W-FAILURE-IGNORED", "p5 p8 p9 p10 p11 p12 p13 p14 p15 p19 p20",
                                "W-INHIBITORS-ONLY", "p10 p14 p20",
                                "W-LIVELOCK", "p6",
                                "W-NEVER-FIRES", "p7 p7 p7",
                                "W-UNREACHABLE", "p6 p6 p6 p7 p7",
                                "W-VARIABLE-UNREAD", "p11 p13")),
                Arguments.of(
                        "crw",
                        Map.ofEntries(
                                Map.entry("E-NO-START", "p47"),
                                Map.entry("E-RELEVANT-WITHOUT-EVENT", "p44"),
                                Map.entry("W-COMMAND-AT-END", "p35"),
                                Map.entry("W-ENDS-WITH-FIRST", "p51"),
                                Map.entry("W-FAILURE-IGNORED", "p15 p17 p19 p22 p23 p24 p38 p43 p51"),
                                Map.entry("W-INHIBITORS-ONLY", "p45"),
                                Map.entry("W-NO-END", "p15 p19"),
                                Map.entry("W-TOO-MANY-WANTED", "p50"),
                                Map.entry("W-UNREACHABLE", "p45"),
                                Map.entry("W-VARIABLE-UNREAD", "p23"))));
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
