package org.sami.crw.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.Vocabulary;

/** The table of docs/decisions-model.md says of every event that asks what the vocabulary declares. */
class AutonomyTableTest {
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `(\\w+)` \\| ([^|]+) \\|$");

    private static final Map<AutonomyAnswer, String> BEGINS = Map.of(
            AutonomyAnswer.NONE, "nothing",
            AutonomyAnswer.YES, "yes",
            AutonomyAnswer.NO, "no",
            AutonomyAnswer.ALL, "all boats",
            AutonomyAnswer.FIRST, "the first option",
            AutonomyAnswer.DEFAULTS, "the values");

    @Test
    void thePageSaysWhatAutonomyAnswers() throws IOException {
        Map<String, String> told = new LinkedHashMap<>();
        ROW.matcher(Files.readString(Path.of("../docs/decisions-model.md")))
                .results()
                .forEach(row -> told.put(row.group(1), row.group(2)));
        Map<String, AutonomyAnswer> declared = new LinkedHashMap<>();
        VOCABULARY
                .events()
                .values()
                .forEach(event -> event.decision().ifPresent(asks -> declared.put(event.name(), asks.autonomy())));

        assertThat(told).containsOnlyKeys(declared.keySet());
        declared.forEach(
                (event, answer) -> assertThat(told.get(event)).as(event).startsWith(BEGINS.get(answer)));
    }
}
