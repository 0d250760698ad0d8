package org.sami.domain;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.Error;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The published schemas, and what they refuse. */
final class Schemas {
    static final ObjectMapper MAPPER = new ObjectMapper();
    private static final Path FOLDER = Path.of("src/main/resources/org/sami/schemas");

    private Schemas() {}

    static Schema load(String name) throws IOException {
        SchemaRegistry registry = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12);
        return registry.getSchema(MAPPER.readTree(Files.readString(FOLDER.resolve(name))));
    }

    static List<String> errors(Schema schema, JsonNode document) {
        return schema.validate(document).stream().map(Error::toString).toList();
    }
}
