package org.sami.spn.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ReaderAdvice;
import org.sami.spn.legacy.LegacyAdvice;
import org.sami.spn.planspace.BoundNotes;
import org.sami.spn.statespace.DeepChecks;

class FindingAdviceTest {
    private static final Path ROOT = Path.of("").toAbsolutePath().getParent();
    private static final Pattern CODE = Pattern.compile("\"([EWN](?:-[A-Z]+)+)\"");

    private static Set<String> codesIn(String module) throws IOException {
        Set<String> codes = new TreeSet<>();
        try (Stream<Path> files = Files.walk(ROOT.resolve(module).resolve("src/main/java"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
                Matcher matcher = CODE.matcher(Files.readString(file));
                while (matcher.find()) {
                    codes.add(matcher.group(1));
                }
            }
        }
        return codes;
    }

    static List<Advice> all() {
        return List.copyOf(FindingAdvice.all());
    }

    @ParameterizedTest
    @ValueSource(strings = {"spn-language", "spn-core", "spn-authoring"})
    void eachCodeInTheSourcesSaysWhyItMattersAndHowItIsMended(String module) throws IOException {
        assertThat(codesIn(module))
                .isNotEmpty()
                .allSatisfy(code -> assertThat(FindingAdvice.of(Finding.warning(code, "", "something")))
                        .as(code)
                        .isPresent());
    }

    @Test
    void noAdviceIsForACodeThatNobodyReports() throws IOException {
        Set<String> reported = new TreeSet<>(codesIn("spn-language"));
        reported.addAll(codesIn("spn-core"));
        reported.addAll(codesIn("spn-authoring"));

        assertThat(reported)
                .containsAll(FindingAdvice.all().stream().map(Advice::code).toList());
    }

    @ParameterizedTest
    @MethodSource("all")
    void whyAndMendAreTwoSentencesThatDiffer(Advice advice) {
        assertThat(advice.why()).endsWith(".").hasSizeBetween(20, 220);
        assertThat(advice.mend()).endsWith(".").hasSizeBetween(15, 220).isNotEqualTo(advice.why());
    }

    @Test
    void aFindingOfAnUnknownCodeHasNone() {
        assertThat(FindingAdvice.of(Finding.warning("W-OF-SOMEBODY-ELSE", "", "something")))
                .isEmpty();
    }

    @Test
    void eachCodeStandsInThePageOfItsKind() throws IOException {
        assertNamed("plan-checks.md", PlanChecks.advice());
        assertNamed("plan-checks.md", DeepChecks.ALL.get(0).advice());
        assertNamed("plan-checks.md", BoundNotes.ADVICE);
        assertNamed("file-format.md", ReaderAdvice.ALL);
        assertNamed("import-legacy.md", LegacyAdvice.ALL);
    }

    private static void assertNamed(String page, List<Advice> all) throws IOException {
        String text = Files.readString(ROOT.resolve("docs").resolve(page));

        assertThat(all.stream()
                        .map(Advice::code)
                        .filter(code -> !text.contains("`" + code + "`"))
                        .collect(Collectors.joining(" ")))
                .isEmpty();
    }
}
