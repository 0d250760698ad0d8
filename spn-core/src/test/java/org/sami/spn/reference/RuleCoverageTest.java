package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every rule of docs/semantics.md names the class that implements it, and what exercises it. */
class RuleCoverageTest {
    private static final Path PAGE = Path.of("../docs/semantics.md");
    /** The engine's module, and that of the language. */
    private static final List<Path> MODULES = List.of(Path.of(""), Path.of("..", "spn-language"));

    private static final Pattern RULE = Pattern.compile("(?m)^- \\*\\*(R-[A-Z]+-\\d+)\\*\\* ");
    private static final Pattern ROW = Pattern.compile("(?m)^\\| (R-[A-Z]+-\\d+) \\| `([\\w.]+)` \\| (.+) \\|$");

    /** One row of the page's table. */
    private record Row(String rule, String implementedBy, String shownBy) {}

    private static List<String> rules() throws IOException {
        return RULE.matcher(Files.readString(PAGE))
                .results()
                .map(m -> m.group(1))
                .toList();
    }

    private static List<Row> table() throws IOException {
        return ROW.matcher(Files.readString(PAGE))
                .results()
                .map(m -> new Row(m.group(1), m.group(2), m.group(3)))
                .toList();
    }

    @Test
    void everyRuleHasItsRow() throws IOException {
        assertThat(rules()).hasSizeGreaterThan(100).doesNotHaveDuplicates();
        assertThat(table().stream().map(Row::rule)).containsExactlyElementsOf(rules());
    }

    @Test
    void thePageSaysHowOftenABuildExercisesARule() throws IOException {
        assertThat(Files.readString(PAGE).replaceAll("\\s+", " "))
                .contains("exercises the rule at least " + DifferentialTest.LEAST + " times in every build");
    }

    @Test
    void theClassOfARuleIsThereAndCitesIt() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Row row : table()) {
            String source = "src/main/java/org/sami/spn/" + row.implementedBy().replace('.', '/') + ".java";
            Optional<Path> file = MODULES.stream()
                    .map(module -> module.resolve(source))
                    .filter(Files::exists)
                    .findFirst();
            if (file.isEmpty() || !cites(Files.readString(file.get()), row.rule())) {
                wrong.add(row.rule() + " is not in " + source);
            }
        }

        assertThat(wrong).isEmpty();
    }

    private static boolean cites(String source, String rule) {
        return Pattern.compile(Pattern.quote(rule) + "\\b").matcher(source).find();
    }

    @Test
    void everyRuleThatCanBeExercisedIs() throws IOException {
        Set<String> byDifferentialTest = new TreeSet<>(new Coverage().rules());
        SpoiltEngineTest.rules().forEach(row -> byDifferentialTest.add((String) row.get()[0]));
        List<String> unshown = new ArrayList<>();
        for (Row row : table()) {
            boolean shown = switch (row.shownBy()) {
                case "definition" -> true;
                case "differential" -> byDifferentialTest.contains(row.rule());
                default -> isTest(row.shownBy());
            };
            if (!shown) {
                unshown.add(row.toString());
            }
        }

        assertThat(unshown).as("Rules that nothing exercises").isEmpty();
        assertThat(rules())
                .as("Rules that the differential test says it exercises")
                .containsAll(byDifferentialTest);
    }

    /** Whether a test of that class and method is there. */
    private static boolean isTest(String quoted) throws IOException {
        Matcher name = Pattern.compile("`(\\w+)\\.(\\w+)`").matcher(quoted);
        if (!name.matches()) {
            return false;
        }
        for (Path module : MODULES) {
            try (Stream<Path> all = Files.walk(module.resolve("src/test/java"))) {
                Optional<Path> source = all.filter(path -> path.endsWith(name.group(1) + ".java"))
                        .findFirst();
                if (source.isPresent()) {
                    return Pattern.compile(
                                    "@(?:[\\w.]+\\.)?(?:Parameterized)?Test\\b(?:(?!\\bvoid\\b)[\\s\\S])*\\bvoid "
                                            + name.group(2) + "\\(")
                            .matcher(Files.readString(source.get()))
                            .find();
                }
            }
        }
        return false;
    }
}
