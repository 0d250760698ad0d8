package org.sami.dreamm.profile;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;

/** Reads profiles (docs/author-guide.md): {@code {"formatVersion": 1, "name": …, "hide": […], "lock": […], "keep": […]}}. */
public final class ProfileFile {
    private static final int VERSION = 1;
    private static final Set<String> MEMBERS = Set.of("formatVersion", "name", "hide", "lock", "keep");
    private static final Pattern PATTERN = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*(-?\\*)?|\\*");
    private static final ObjectMapper JSON = new ObjectMapper()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

    private ProfileFile() {}

    /**
     * Reads one.
     *
     * @throws IOException if it cannot be read or is none, saying in one sentence what is wrong and where
     */
    public static Profile read(Path file) throws IOException {
        try {
            return profile(JSON.readTree(Files.readString(file)));
        } catch (NoSuchFileException e) {
            throw new IOException("there is no profile " + file, e);
        } catch (JsonProcessingException e) {
            throw new IOException(
                    "the profile " + file + " is not JSON, line "
                            + e.getLocation().getLineNr() + ": " + e.getOriginalMessage(),
                    e);
        } catch (IllegalArgumentException e) {
            throw new IOException("the profile " + file + " cannot be used: " + e.getMessage(), e);
        } catch (IOException e) {
            throw new IOException("the profile " + file + " cannot be read: it is not UTF-8 text or not accessible", e);
        }
    }

    private static Profile profile(JsonNode root) {
        if (!root.isObject()) {
            throw new IllegalArgumentException("it is no object");
        }
        for (Iterator<String> names = root.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (!MEMBERS.contains(name)) {
                throw new IllegalArgumentException("it has a member \"" + name + "\", which profiles do not have");
            }
        }
        if (root.path("formatVersion").asInt() != VERSION) {
            throw new IllegalArgumentException("its \"formatVersion\" is not " + VERSION);
        }
        if (!root.path("name").isTextual()) {
            throw new IllegalArgumentException("its \"name\" is missing, a text");
        }
        return new Profile(
                root.get("name").asText(), patterns(root, "hide"), patterns(root, "lock"), patterns(root, "keep"));
    }

    private static List<String> patterns(JsonNode root, String member) {
        List<String> patterns = new ArrayList<>();
        if (root.has(member) && !root.get(member).isArray()) {
            throw new IllegalArgumentException("\"" + member + "\" is no list of ids");
        }
        for (JsonNode node : root.path(member)) {
            if (!node.isTextual() || !PATTERN.matcher(node.asText()).matches()) {
                throw new IllegalArgumentException("\"" + member + "\" holds " + node
                        + ", which is no id in kebab case, nor the beginning of one with a * at its end");
            }
            patterns.add(node.asText());
        }
        return patterns;
    }
}
