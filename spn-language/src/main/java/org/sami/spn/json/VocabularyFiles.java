package org.sami.spn.json;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The files of one domain as text, by name: {@code domain.json} first, then those that it lists, in its order. A journal
 * stores them as they are, so that a resumed session uses the words with which it began.
 */
public record VocabularyFiles(Map<String, String> texts) {
    /** The file that names the others. */
    public static final String INDEX = "domain.json";

    /** The index's member that names the file of components. No vocabulary: a journal does not need it. */
    static final String COMPONENTS = "components";

    /** The index's member that names the file of groups and sequences of events. No vocabulary either. */
    static final String AUTHORING = "authoring";

    public VocabularyFiles {
        texts = Collections.unmodifiableMap(new LinkedHashMap<>(texts));
    }

    /**
     * Finds the files among the resources of the class path.
     *
     * @param folder absolute, such as {@code /org/sami/domain/NAME}
     */
    public static Reading<VocabularyFiles> fromClassPath(String folder) {
        return load(folder, name -> resource(folder + "/" + name));
    }

    /** Finds the files in a folder. */
    public static Reading<VocabularyFiles> fromFolder(Path folder) {
        return load(folder.toString(), name -> TextFiles.read(folder, name));
    }

    /** A text by name; empty where there is none. */
    interface Source {
        Optional<String> text(String name) throws IOException;
    }

    static Optional<String> resource(String name) throws IOException {
        try (InputStream in = VocabularyFiles.class.getResourceAsStream(name)) {
            return in == null ? Optional.empty() : Optional.of(JsonText.decode(in.readAllBytes()));
        }
    }

    /** The plan files that the index lists, by name. */
    List<String> library() {
        Problems ignored = new Problems();
        return JsonText.parse(texts.getOrDefault(INDEX, "{}"), ignored)
                .flatMap(node -> JsonObjectReader.of(node, "", ignored))
                .map(m -> m.texts("library"))
                .orElse(List.of());
    }

    /** The name of the file that a member of the index gives; empty where it names none. */
    Optional<String> named(String member) {
        Problems ignored = new Problems();
        return JsonText.parse(texts.getOrDefault(INDEX, "{}"), ignored)
                .flatMap(node -> JsonObjectReader.of(node, "", ignored))
                .map(m -> m.text(member, ""))
                .filter(name -> !name.isEmpty());
    }

    private static Reading<VocabularyFiles> load(String folder, Source source) {
        Problems problems = new Problems();
        SourceTexts sources = new SourceTexts();
        Map<String, String> texts = new LinkedHashMap<>();
        fetch(source, INDEX, problems).ifPresent(text -> texts.put(INDEX, text));
        if (texts.containsKey(INDEX)) {
            sources.add(INDEX + "#", folder + "/" + INDEX, texts.get(INDEX));
            Problems inIndex = new Problems();
            JsonText.parse(texts.get(INDEX), inIndex)
                    .flatMap(node -> JsonObjectReader.of(node, "", inIndex))
                    .ifPresent(m -> m.texts("files")
                            .forEach(name -> fetch(source, name, problems).ifPresent(t -> texts.put(name, t))));
            problems.addAll(inIndex.findings(), INDEX + "#");
        }
        return new Reading<>(
                problems.none() ? Optional.of(new VocabularyFiles(texts)) : Optional.empty(),
                sources.locate(problems.findings()));
    }

    static Optional<String> fetch(Source source, String name, Problems problems) {
        if (leadsOut(name)) {
            problems.add(
                    Codes.FILE,
                    name,
                    "The file " + name + " is outside the folder of the file that names it, and is not read");
            return Optional.empty();
        }
        try {
            Optional<String> text = source.text(name);
            if (text.isEmpty()) {
                problems.add(Codes.FILE, name, "The file " + name + " is not there");
            }
            return text;
        } catch (IOException e) {
            problems.add(Codes.FILE, name, "The file " + name + " cannot be read: " + e.getMessage());
            return Optional.empty();
        }
    }

    /** Whether a name means a file that is not in the folder of the index: a domain names its own files only. */
    private static boolean leadsOut(String name) {
        String[] parts = name.split("[/\\\\]", -1);
        return parts[0].isEmpty()
                || name.indexOf(':') >= 0
                || Arrays.asList(parts).contains("..");
    }
}
