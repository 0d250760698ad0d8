package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.json.Reading;
import org.sami.spn.json.UnreadableJsonException;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.Vocabulary;

/** Whatever happens to a file, reading it gives the whole or nothing, findings, and never an exception. */
@Tag("long")
class DamagedFilesTest {
    private static final int ROUNDS = 4_000;

    private final Vocabulary words =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private final ProjectReader reader = new ProjectReader(words);
    private final ProjectWriter writer = new ProjectWriter(words);
    private final String text;

    DamagedFilesTest() throws IOException {
        text = Files.readString(Path.of("src/test/resources/everything.json"));
    }

    @Test
    void damagedTreeIsReadWholeOrRefused() throws IOException {
        Random random = new Random(7);
        int read = 0;
        for (int i = 0; i < ROUNDS; i++) {
            JsonNode root = Schemas.MAPPER.readTree(text);
            for (int n = 1 + random.nextInt(2); n > 0; n--) {
                Damage.damage(root, random);
            }

            Reading<Project> reading = reader.read(root.toString());

            assertThat(reading.result().isPresent()).isNotEqualTo(reading.hasErrors());
            if (reading.result().isPresent()) {
                read++;
                Project project = reading.orThrow();
                assertThat(reader.read(writer.text(project)).orThrow()).isEqualTo(project);
                PlanChecks.check(project, words);
            }
        }
        assertThat(read).isBetween(ROUNDS / 20, ROUNDS / 2);
    }

    @Test
    void damagedVocabularyIsReadWholeOrRefused() throws IOException {
        Map<String, String> texts =
                VocabularyFiles.fromClassPath("/org/sami/domain/crw").orThrow().texts();
        Random random = new Random(8);
        int read = 0;
        for (int i = 0; i < ROUNDS / 4; i++) {
            Map<String, String> damaged = new LinkedHashMap<>(texts);
            List<String> names = List.copyOf(texts.keySet());
            String name = names.get(random.nextInt(names.size()));
            JsonNode root = Schemas.MAPPER.readTree(texts.get(name));
            Damage.damage(root, random);
            damaged.put(name, root.toString());

            Reading<Vocabulary> reading = VocabularyReader.read(new VocabularyFiles(damaged));

            assertThat(reading.result().isPresent()).isNotEqualTo(reading.hasErrors());
            read += reading.result().isPresent() ? 1 : 0;
        }
        assertThat(read).isPositive();
    }

    @Test
    void damagedInputIsReadOrRefusedByItsOneException() throws IOException {
        Occurrence occurrence = new Occurrence(
                "A",
                1,
                2,
                List.of("b"),
                List.of(new TaskId(1, "T")),
                Map.of("x", new GeoPath(List.of(GeoPoint.of(1, 2)))));
        List<Input> inputs = List.of(
                new Input.Received(occurrence),
                new Input.AnswerDecision(1, new Answer.Fields(Map.of("a", new RealValue(1))), Answerer.OPERATOR),
                new Input.AllocateTasks(Map.of(new TaskId(1, "T"), Optional.of("b"))),
                new Input.AddTasks(1, List.of(new TaskSpec("T", "Camera", Map.of("a", new RealValue(1))))));
        Random random = new Random(9);
        int refused = 0;
        for (int i = 0; i < ROUNDS; i++) {
            JsonNode root = ProtocolJson.input(inputs.get(random.nextInt(inputs.size())));
            Damage.damage(root, random);
            try {
                ProtocolJson.readInput(root.toString());
            } catch (UnreadableJsonException e) {
                assertThat(e).hasMessageNotContaining("null pointer");
                refused++;
            }
        }
        assertThat(refused).isBetween(ROUNDS / 4, ROUNDS);
    }

    @Test
    void textThatEndsAnywhereIsRefused() {
        for (int end = 0; end < text.lastIndexOf('}'); end += 7) {
            assertThat(reader.read(text.substring(0, end)).hasErrors()).isTrue();
        }
    }
}
