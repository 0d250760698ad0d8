package org.sami.spn.json;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The files of one domain as text, by name: {@code domain.json} first, then those that it lists, in its order, then those of the domains that it
 * combines, as {@code NAME/FILE} (docs/writing-a-domain.md). A journal stores them as they are, so that a resumed session uses the words with which it began.
 */
public record VocabularyFiles(Map<String, String> texts) {
    /** The file that names the others. */
    public static final String INDEX = "domain.json";

    /** The index's member that names the domains whose words are joined; their folders lie beside this domain's. */
    static final String COMBINES = "combines";

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
        return load(folder, DomainSources.ofClassPath(folder));
    }

    /** Finds the files in a folder. */
    public static Reading<VocabularyFiles> fromFolder(Path folder) {
        return load(folder.toString(), DomainSources.ofFolder(folder));
    }

    /** The plan files that the index lists, by name. */
    List<String> library() {
        return texts("library", texts.getOrDefault(INDEX, "{}"));
    }

    /** The names of the domains whose words are joined. */
    List<String> combines() {
        return texts(COMBINES, texts.getOrDefault(INDEX, "{}"));
    }

    private static List<String> texts(String member, String index) {
        Problems ignored = new Problems();
        return JsonText.parse(index, ignored)
                .flatMap(node -> JsonObjectReader.of(node, "", ignored))
                .filter(m -> m.has(member))
                .map(m -> m.texts(member))
                .orElse(List.of());
    }

    private static String indexOf(String domain) {
        return domain + "/" + INDEX;
    }

    /** Whether a name is that of the index of a combined domain, whose members are not this domain's. */
    boolean isCombinedIndex(String name) {
        return combines().stream().anyMatch(domain -> indexOf(domain).equals(name));
    }

    /** The names of the files that a member of the index gives, and of the indexes of the combined domains after it. */
    List<String> named(String member) {
        List<String> names = new ArrayList<>();
        file(member, texts.getOrDefault(INDEX, "{}")).ifPresent(names::add);
        for (String domain : combines()) {
            file(member, texts.getOrDefault(indexOf(domain), "{}")).ifPresent(name -> names.add(domain + "/" + name));
        }
        return names;
    }

    private static Optional<String> file(String member, String index) {
        Problems ignored = new Problems();
        return JsonText.parse(index, ignored)
                .flatMap(node -> JsonObjectReader.of(node, "", ignored))
                .map(m -> m.text(member, ""))
                .filter(name -> !name.isEmpty());
    }

    private static Reading<VocabularyFiles> load(String folder, DomainSources domain) {
        DomainSources.Source source = domain.own();
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
            List<String> combines = texts(COMBINES, texts.get(INDEX));
            combines.forEach(other -> join(other, domain.with(combines), texts, problems));
        }
        return new Reading<>(
                problems.none() ? Optional.of(new VocabularyFiles(texts)) : Optional.empty(),
                sources.locate(problems.findings()));
    }

    private static void join(String domain, DomainSources.Source source, Map<String, String> texts, Problems problems) {
        String index = indexOf(domain);
        Optional<String> text = fetch(source, index, problems);
        text.ifPresent(t -> texts.put(index, t));
        if (text.isPresent() && !texts(COMBINES, text.get()).isEmpty()) {
            problems.add(
                    Codes.BAD_VALUE,
                    INDEX + "#/" + COMBINES,
                    "The domain " + domain + " combines others itself: name those, " + texts(COMBINES, text.get()));
        } else if (text.isPresent()) {
            for (String file : texts("files", text.get())) {
                String name = domain + "/" + file;
                fetch(source, name, problems).ifPresent(t -> texts.put(name, t));
            }
        }
    }

    static Optional<String> fetch(DomainSources.Source source, String name, Problems problems) {
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
