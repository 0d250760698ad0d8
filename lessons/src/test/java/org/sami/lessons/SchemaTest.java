package org.sami.lessons;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The schemas of lessons and jobs, which editors check and complete with. */
class SchemaTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final Path RESOURCES = Path.of("src/main/resources/org/sami");

    private static Schema schema(String name) throws IOException {
        return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(JSON.readTree(
                        Files.readString(RESOURCES.resolve("schemas").resolve(name))));
    }

    private static List<Path> files(String like) throws IOException {
        try (Stream<Path> all = Files.walk(RESOURCES.resolve("lessons/course"))) {
            return all.filter(file -> file.toString().replace('\\', '/').matches(like))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @CsvSource({"lesson-1.schema.json, .*/lesson[.]json", "lesson-job-1.schema.json, .*/jobs/[^/]+[.]json"})
    void everyFileOfTheCourseKeepsToItsSchema(String name, String like) throws IOException {
        Schema schema = schema(name);
        List<Path> files = files(like);

        assertThat(files).isNotEmpty();
        for (Path file : files) {
            assertThat(schema.validate(JSON.readTree(Files.readString(file))))
                    .as(file.toString())
                    .isEmpty();
        }
    }

    @Test
    void whatTheFormatDoesNotKnowIsRefused() throws IOException {
        JsonNode lesson =
                JSON.readTree(Files.readString(files(".*/lesson[.]json").get(0)));
        JsonNode job =
                JSON.readTree(Files.readString(files(".*/jobs/[^/]+[.]json").get(0)));
        ((ObjectNode) lesson.path("steps").path(0)).put("titel", "A typing error");
        ((ObjectNode) job).put("hint", "One hint");

        assertThat(schema("lesson-1.schema.json").validate(lesson)).isNotEmpty();
        assertThat(schema("lesson-job-1.schema.json").validate(job)).isNotEmpty();
    }
}
