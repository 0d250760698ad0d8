package org.sami.spn.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.analysis.PlanCheckCases.begin;
import static org.sami.spn.analysis.PlanCheckCases.child;
import static org.sami.spn.analysis.PlanCheckCases.drive;
import static org.sami.spn.analysis.PlanCheckCases.endsWith;
import static org.sami.spn.analysis.PlanCheckCases.fetch;
import static org.sami.spn.analysis.PlanCheckCases.parent;
import static org.sami.spn.analysis.PlanCheckCases.passOn;
import static org.sami.spn.testing.NetBuilder.project;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.DurationValue;

/** For each code a tiny plan that must be found, and one like it that must pass without that finding. */
class PlanChecksTest {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/spn/analysis");
    private static final Path DEEP_SOURCES = Path.of("../spn-authoring/src/main/java/org/sami/spn/statespace");
    private static final Path DOCUMENT = Path.of("../docs/plan-checks.md");
    private static final String ONLY_WITH_A_PROGRAM = "W-NO-HANDLER";
    private static final int LEAST_CODES = 50;

    static List<PlanCheckCase> cases() {
        return PlanCheckCases.all();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void badPlanIsFoundAndGoodOneIsNot(PlanCheckCase c) {
        assertThat(PlanChecks.check(c.bad(), c.words()))
                .extracting(Finding::code)
                .contains(c.code());
        assertThat(PlanChecks.check(c.good(), c.words()))
                .extracting(Finding::code)
                .doesNotContain(c.code());
    }

    @ParameterizedTest
    @MethodSource("cases")
    void findingSaysWhatItIsAboutSoThatAWindowCanShowIt(PlanCheckCase c) {
        assertThat(PlanChecks.check(c.bad(), c.words())).allSatisfy(finding -> {
            assertThat(finding.plan()).isNotEmpty();
            assertThat(finding.elements()).as("elements of %s", finding).isNotEmpty();
        });
    }

    @Test
    void everyCodeHasAPairAndIsDocumented() throws IOException {
        Set<String> codes = codesByClass(SOURCES).keySet();
        Set<String> documented = new TreeSet<>();
        Matcher code = Pattern.compile("`([EW]-[A-Z-]+[A-Z])`").matcher(Files.readString(DOCUMENT));
        while (code.find()) {
            documented.add(code.group(1));
        }

        assertThat(codes).hasSizeGreaterThan(LEAST_CODES);
        Set<String> tried =
                new TreeSet<>(cases().stream().map(PlanCheckCase::code).toList());
        tried.add(ONLY_WITH_A_PROGRAM);
        assertThat(tried).isEqualTo(codes);
        Set<String> all = new TreeSet<>(codes);
        all.addAll(codesByClass(DEEP_SOURCES).keySet());
        assertThat(documented).isEqualTo(all);
    }

    @Test
    void everyCodeIsOfOneClass() throws IOException {
        assertThat(codesByClass(SOURCES))
                .allSatisfy((code, classes) ->
                        assertThat(classes).as("who finds %s", code).hasSize(1));
    }

    private static Map<String, Set<String>> codesByClass(Path folder) throws IOException {
        Map<String, Set<String>> codes = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Matcher code = Pattern.compile("\"([EW]-[A-Z-]+)\"").matcher(Files.readString(file));
                while (code.find()) {
                    codes.computeIfAbsent(code.group(1), c -> new TreeSet<>())
                            .add(file.getFileName().toString());
                }
            }
        }
        return codes;
    }

    @Test
    void outputEventThatTheProgramHasNoHandlerForIsNamed() {
        Project project = project(drive().build());

        assertThat(PlanChecks.checkHandled(project, CheckWords.WORDS, Set.of("Drive")))
                .isEmpty();
        assertThat(PlanChecks.checkHandled(project, CheckWords.WORDS, Set.of("Other")))
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.code()).isEqualTo(ONLY_WITH_A_PROGRAM);
                    assertThat(finding.isError()).isFalse();
                    assertThat(finding.message()).contains("Drive");
                });
    }

    @Test
    void eachFailureThatNothingAfterThePlaceWaitsForIsNamed() {
        assertThat(PlanChecks.check(project(fetch().build()), CheckWords.WORDS))
                .extracting(Finding::message)
                .hasSize(2)
                .anyMatch(message -> message.contains("Fetch at the place \"go\" ends with NotFetched"))
                .anyMatch(message -> message.contains("BatteryOut"));
    }

    @Test
    void failureThatIsNewsMayBeAwaitedElsewhere() {
        NetBuilder net = endsWith(fetch(), "failed", "NotFetched")
                .transition("empty", "BatteryOut")
                .in("start", "empty", "generic >= 1")
                .out("empty", "end", "take all any");

        assertThat(PlanChecks.check(project(net.build()), CheckWords.WORDS))
                .extracting(Finding::code)
                .doesNotContain("W-FAILURE-IGNORED");
    }

    @Test
    void ringThatClosesOverAnInhibitorIsNoLivelock() {
        NetBuilder net = passOn(begin())
                .places("stranded")
                .out("first", "stranded", "take all proxy")
                .transition("nobody")
                .in("stranded", "nobody", "proxy >= 1")
                .in("go", "nobody", "proxy = 0")
                .out("nobody", "go", "take all proxy");

        assertThat(PlanChecks.check(project(net.build()), CheckWords.WORDS))
                .extracting(Finding::code)
                .doesNotContain("W-LIVELOCK");
    }

    @Test
    void ordinaryPlanHasNoFinding() {
        assertThat(PlanChecks.check(project(drive().build()), CheckWords.WORDS)).isEmpty();
    }

    @Test
    void findingNamesItsElementAndItsPlaceInTheDocument() {
        Project project = project(drive().places("island").build());

        List<Finding> findings = PlanChecks.check(project, CheckWords.WORDS);

        assertThat(findings)
                .containsExactly(Finding.warning(
                                "W-UNREACHABLE", "/plans/0/places/3", "Nothing leads to the place \"island\"", "island")
                        .inPlan("plan"));
    }

    @Test
    void findingAboutAValueSaysWhereItIsAndWhatIsUsual() {
        Project project = project(
                ValueCheckCases.watching(Map.of("every", new DurationValue(0))).build());

        assertThat(PlanChecks.check(project, CheckWords.WORDS))
                .extracting(Finding::message)
                .contains("every in Watch at the place \"go\" is 0 s; usual is 0.1 s to 1 h: is it right?");
    }

    @Test
    void partThatNeverRunsIsNamedOnceAndNotForEachOfItsFaults() {
        NetBuilder net = fetch();
        NetBuilder draft = drive().output("draft", "Fetch")
                .transition("fetched", "Fetched")
                .in("draft", "fetched", "relevant all")
                .out("fetched", "later", "take all relevant")
                .in("later", "back", "any >= 1")
                .out("back", "draft", "take all any");

        assertThat(PlanChecks.check(project(net.build()), CheckWords.WORDS))
                .extracting(Finding::code)
                .contains("W-FAILURE-IGNORED");
        assertThat(PlanChecks.check(project(draft.build()), CheckWords.WORDS))
                .singleElement()
                .satisfies(finding -> {
                    assertThat(finding.message())
                            .isEqualTo("Nothing leads to the place \"draft\", nor to the 3 places and transitions"
                                    + " connected with it");
                    assertThat(finding.elements()).containsExactlyInAnyOrder("draft", "fetched", "later", "back");
                });
    }

    @Test
    void headingWithoutAStartIsNamedOnce() {
        NetBuilder heading = new NetBuilder("heading")
                .end("end")
                .in("a", "there", "any >= 1")
                .out("there", "b", "take all any")
                .in("b", "back", "any >= 1")
                .out("back", "a", "take all any")
                .transition("stop", "AbortReceived")
                .out("stop", "end", "take all any");

        assertThat(PlanChecks.check(project(heading.build()), CheckWords.WORDS))
                .extracting(Finding::code)
                .containsExactly("E-NO-START");
    }

    @Test
    void findingsComeInTheOrderOfTheDocument() {
        NetBuilder net = drive().in("go", "a", "any >= 1").out("a", "end");
        for (int i = 0; i < 11; i++) {
            net.places("island" + i);
        }

        List<Finding> findings = PlanChecks.check(project(drive().build(), net.build()), CheckWords.WORDS);

        assertThat(findings).hasSize(12);
        assertThat(findings.get(0).pointer()).isEqualTo("/plans/1/places/3");
        assertThat(findings.get(10).pointer()).isEqualTo("/plans/1/places/13");
        assertThat(findings.get(11).pointer()).isEqualTo("/plans/1/outEdges/2");
    }

    @Test
    void runOfAPlanIsConcernedByItselfAndItsSubMissionsOnly() {
        Plan broken = new NetBuilder("broken").places("a").build();
        Project project = project(parent("yes").build(), child().build(), broken);

        assertThat(PlanChecks.check(project, CheckWords.WORDS)).isNotEmpty();
        assertThat(PlanChecks.check(project, CheckWords.WORDS, "plan")).isEmpty();
        assertThat(PlanChecks.check(project, CheckWords.WORDS, "broken")).isNotEmpty();
        assertThat(PlanChecks.check(project, CheckWords.WORDS, "absent")).isEmpty();
    }
}
