package org.sami.figures;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.TreeMap;

/** The table of all benchmarks as a file; every module writes its figures into the same one. */
public final class FigureFile {
    private static final ObjectMapper JSON = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    private FigureFile() {}

    /** The file that the build names in the system property {@code benchmarks.file}. */
    public static Path ofThisBuild() {
        return Path.of(System.getProperty("benchmarks.file", "build/benchmarks.json"));
    }

    /** Puts figures in place of all whose names begin alike. */
    public static void replace(Path file, String prefix, List<Figure> figures) throws IOException {
        ArrayNode all = JSON.createArrayNode();
        if (Files.exists(file)) {
            for (JsonNode entry : JSON.readTree(file.toFile())) {
                if (!entry.path("name").asText().startsWith(prefix)) {
                    all.add(entry);
                }
            }
        }
        for (Figure figure : figures) {
            ObjectNode entry = all.addObject().put("name", figure.name());
            ObjectNode params = entry.putObject("params");
            new TreeMap<>(figure.params()).forEach(params::put);
            entry.put("value", figure.value()).put("unit", figure.unit()).put("error", figure.error());
        }
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, JSON.writeValueAsString(all) + "\n");
    }

    /** Prints figures as a table. */
    public static void print(List<Figure> figures) {
        System.out.println();
        System.out.printf(Locale.ROOT, "%-26s %-34s %14s %12s %s%n", "name", "params", "value", "error", "unit");
        for (Figure figure : figures) {
            System.out.printf(
                    Locale.ROOT,
                    "%-26s %-34s %14.3f %12.3f %s%n",
                    figure.name(),
                    new TreeMap<>(figure.params()),
                    figure.value(),
                    figure.error(),
                    figure.unit());
        }
    }
}
