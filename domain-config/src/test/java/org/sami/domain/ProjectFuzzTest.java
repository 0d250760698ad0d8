package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Whatever happens to a project file, reading it gives the whole or nothing, findings, and never an exception. */
class ProjectFuzzTest {
    private static final int ROUNDS = 4_000;
    private static final String[] SCRAPS = {
        "null",
        "true",
        "-1",
        "0",
        "1e400",
        "\"\"",
        "\"x\"",
        "\"@x\"",
        "\"all\"",
        "\"p1\"",
        "\"t1\"",
        "\"main\"",
        "[]",
        "{}",
        "[1,2]",
        "{\"lat\":1,\"lon\":2}",
        "{\"variable\":\"@task\"}",
        "\"list<list<point>>\"",
        "\"PT1S\"",
        "\"task\"",
        "9999999999"
    };

    private final Vocabulary words =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private final ProjectReader reader = new ProjectReader(words);
    private final ProjectWriter writer = new ProjectWriter(words);
    private final String text;

    ProjectFuzzTest() throws IOException {
        text = Files.readString(Path.of("src/test/resources/everything.json"));
    }

    @Test
    void damagedTreeIsReadWholeOrRefused() throws IOException {
        Random random = new Random(7);
        int read = 0;
        for (int i = 0; i < ROUNDS; i++) {
            JsonNode root = Schemas.MAPPER.readTree(text);
            for (int n = 1 + random.nextInt(2); n > 0; n--) {
                damage(root, random);
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
    void textThatEndsAnywhereIsRefused() {
        for (int end = 0; end < text.lastIndexOf('}'); end += 7) {
            assertThat(reader.read(text.substring(0, end)).hasErrors()).isTrue();
        }
    }

    private static void damage(JsonNode root, Random random) throws IOException {
        List<JsonNode> containers = new ArrayList<>();
        collect(root, containers);
        JsonNode node = containers.get(random.nextInt(containers.size()));
        JsonNode scrap = Schemas.MAPPER.readTree(SCRAPS[random.nextInt(SCRAPS.length)]);
        if (node instanceof ArrayNode array) {
            int index = random.nextInt(array.size());
            switch (random.nextInt(3)) {
                case 0 -> array.remove(index);
                case 1 -> array.set(index, scrap);
                default -> array.add(array.get(index).deepCopy());
            }
        } else {
            List<String> names = new ArrayList<>();
            node.fieldNames().forEachRemaining(names::add);
            String name = names.get(random.nextInt(names.size()));
            if (random.nextInt(3) == 0) {
                ((ObjectNode) node).remove(name);
            } else {
                ((ObjectNode) node).set(name, scrap);
            }
        }
    }

    private static void collect(JsonNode node, List<JsonNode> containers) {
        if (node.isContainerNode() && !node.isEmpty()) {
            containers.add(node);
        }
        node.forEach(child -> collect(child, containers));
    }
}
