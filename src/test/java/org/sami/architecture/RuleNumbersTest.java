package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Code and documents cite the rules of docs/semantics.md by numbers that are there, and no document that is not. */
class RuleNumbersTest {
    private static final Pattern RULE = Pattern.compile("(?m)^- \\*\\*R-([A-Z]+)-(\\d+)\\*\\* ");
    private static final Pattern CITED = Pattern.compile("\\bR-([A-Z]{2,5})-(\\d+|\\*)");
    private static final Pattern ABSENT =
            Pattern.compile("\\b(?:SEMANTICS|DESIGN|UI)(?:\\.md)?(?:,|;|:|\\)| says|\\.md)");

    /** How many rules each area has. */
    private static Map<String, Integer> areas() throws IOException {
        Map<String, Integer> areas = new LinkedHashMap<>();
        RULE.matcher(Files.readString(Path.of("docs", "semantics.md")))
                .results()
                .forEach(rule -> {
                    int number = Integer.parseInt(rule.group(2));
                    assertThat(number).as(rule.group()).isEqualTo(areas.getOrDefault(rule.group(1), 0) + 1);
                    areas.put(rule.group(1), number);
                });
        return areas;
    }

    @Test
    void everyCitedRuleIsThere() throws IOException {
        Map<String, Integer> areas = areas();
        List<String> wrong = new ArrayList<>();
        int[] cited = {0};
        for (Path text : texts()) {
            CITED.matcher(Files.readString(text)).results().forEach(citation -> {
                cited[0]++;
                int rules = areas.getOrDefault(citation.group(1), 0);
                boolean known =
                        citation.group(2).equals("*") ? rules > 0 : Integer.parseInt(citation.group(2)) <= rules;
                if (!known) {
                    wrong.add(text + ": " + citation.group());
                }
            });
        }

        assertThat(cited[0]).as("citations").isGreaterThan(300);
        assertThat(wrong).isEmpty();
    }

    @Test
    void nothingCitesADocumentThatIsNotInTheTree() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Path text : texts()) {
            ABSENT.matcher(Files.readString(text)).results().forEach(found -> wrong.add(text + ": " + found.group()));
        }

        assertThat(wrong).isEmpty();
    }

    private static List<Path> texts() throws IOException {
        List<Path> texts = new ArrayList<>();
        Arrays.stream(SamiModule.values()).forEach(module -> {
            texts.addAll(module.mainSources());
            texts.addAll(module.testSources());
        });
        try (Stream<Path> top = Files.list(Path.of(""));
                Stream<Path> docs = Files.walk(Path.of("docs"))) {
            Stream.concat(top, docs)
                    .filter(path -> path.toString().endsWith(".md"))
                    .forEach(texts::add);
        }
        return texts;
    }
}
