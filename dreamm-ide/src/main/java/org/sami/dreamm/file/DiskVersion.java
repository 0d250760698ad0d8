package org.sami.dreamm.file;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collections;
import java.util.HexFormat;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What the files of a project hold on disk at a moment: the project's file alone, or in a folder {@code project.json} and the plan files that it
 * names. Two are equal where every byte is.
 *
 * @param hashes of each file that is there
 */
record DiskVersion(Map<Path, String> hashes) {
    private static final ObjectMapper JSON = new ObjectMapper();

    DiskVersion {
        hashes = Collections.unmodifiableMap(new TreeMap<>(hashes));
    }

    /** What is there now; nothing where the file is not there. May be called on any thread. */
    static DiskVersion of(Path project) throws IOException {
        Map<Path, String> hashes = new TreeMap<>();
        Path main = main(project);
        add(main, hashes);
        for (Path file : planFiles(project)) {
            add(file, hashes);
        }
        return new DiskVersion(hashes);
    }

    /** Whether any file is there. */
    boolean isThere() {
        return !hashes.isEmpty();
    }

    /** The file that holds the project itself. */
    static Path main(Path project) {
        return Files.isDirectory(project) ? project.resolve("project.json") : project;
    }

    /** The plan files that a folder's {@code project.json} names; none where it is not readable. */
    static Set<Path> planFiles(Path project) throws IOException {
        Set<Path> files = new TreeSet<>();
        Path main = main(project);
        if (Files.isRegularFile(main)) {
            for (JsonNode plan : read(main).path("plans")) {
                if (plan.path("file").isTextual()) {
                    files.add(main.resolveSibling(plan.get("file").asText()).normalize());
                }
            }
        }
        return files;
    }

    private static JsonNode read(Path main) throws IOException {
        try {
            return JSON.readTree(Files.readAllBytes(main));
        } catch (com.fasterxml.jackson.core.JsonProcessingException broken) {
            return JSON.createObjectNode();
        }
    }

    private static void add(Path file, Map<Path, String> hashes) throws IOException {
        if (Files.isRegularFile(file)) {
            hashes.put(file, HexFormat.of().formatHex(sha256().digest(Files.readAllBytes(file))));
        }
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException("every Java has SHA-256", impossible);
        }
    }
}
