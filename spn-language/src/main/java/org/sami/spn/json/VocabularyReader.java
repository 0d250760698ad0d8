package org.sami.spn.json;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Geography;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Reads a domain's files into its vocabulary, or says everything that is wrong with them. Pointers of findings begin with
 * the file: {@code events.json#/events/3/fields/0}.
 */
public final class VocabularyReader {
    /** The version of the format that is read and shipped. */
    public static final int FORMAT_VERSION = 1;

    private final VocabularyFiles files;
    private final Problems problems = new Problems();
    private final Map<String, JsonObjectReader> roots = new LinkedHashMap<>();
    private final Map<String, NamedType> types = new LinkedHashMap<>();
    private final JoinedWords joined = new JoinedWords(problems);

    private VocabularyReader(VocabularyFiles files) {
        this.files = files;
    }

    /** The vocabulary of the files. */
    public static Reading<Vocabulary> read(VocabularyFiles files) {
        return new VocabularyReader(files).read();
    }

    /** The vocabulary of a domain on the class path, its folder given as {@code /org/sami/domain/NAME}. */
    public static Reading<Vocabulary> fromClassPath(String folder) {
        Reading<VocabularyFiles> found = VocabularyFiles.fromClassPath(folder);
        return found.result()
                .map(VocabularyReader::read)
                .orElseGet(() -> new Reading<>(Optional.empty(), found.findings()));
    }

    private Reading<Vocabulary> read() {
        files.texts().forEach((name, text) -> {
            Problems syntax = new Problems();
            JsonText.parse(text, syntax)
                    .flatMap(node -> JsonObjectReader.of(node, name + "#", problems))
                    .ifPresent(m -> roots.put(name, m));
            problems.addAll(syntax.findings(), name + "#");
        });
        roots.keySet().removeIf(files::isCombinedIndex);
        JsonObjectReader index = roots.get(VocabularyFiles.INDEX);
        if (index == null) {
            return Reading.nothing(problems);
        }
        String domain = readIndex(index);
        List<String> combines = index.texts(VocabularyFiles.COMBINES);
        joined.join(combines, roots);
        Optional<Geography> geography = index.object("geography").flatMap(VocabularyReader::geography);
        Map<String, String> robotNames = index.textMap("robotNames");
        readTypes();
        FieldTypeReader fields = new FieldTypeReader(types, problems);
        Names eventNames = new Names(problems);
        List<EventType> events = all("events", eventNames, new EventTypeReader(fields)::read);
        List<MarkupType> markups = all("markups", fields::markup);
        List<TaskClass> tasks = all("taskClasses", fields::taskClass);
        roots.values().forEach(root -> {
            root.text(ProjectReader.SCHEMA, "");
            root.done();
        });
        Vocabulary vocabulary = new Vocabulary(
                domain, List.copyOf(types.values()), events, markups, tasks, geography, robotNames, combines);
        if (problems.none()) {
            new VocabularyChecks(vocabulary, eventNames, problems).check();
            robotNames.forEach((of, field) -> checkRobotName(vocabulary, of, field, index.at("robotNames") + "/" + of));
        }
        return Reading.of(vocabulary, problems);
    }

    private String readIndex(JsonObjectReader index) {
        int version = index.integer("formatVersion", 0);
        if (version != FORMAT_VERSION) {
            index.problem(
                    Codes.VERSION,
                    "formatVersion",
                    "This program reads vocabularies of version " + FORMAT_VERSION + ", not " + version);
        }
        index.text("label");
        index.texts("files");
        index.texts("library");
        index.text(VocabularyFiles.COMPONENTS, "");
        index.text(VocabularyFiles.AUTHORING, "");
        return index.text("domain");
    }

    private static Optional<Geography> geography(JsonObjectReader m) {
        long farM = m.whole("farM");
        long rangeM = m.whole("rangeM");
        m.done();
        if (farM < 1 || rangeM < 1) {
            m.problem(Codes.BAD_VALUE, "", "\"farM\" and \"rangeM\" are whole metres from 1");
            return Optional.empty();
        }
        return Optional.of(new Geography(farM, rangeM));
    }

    private void checkRobotName(Vocabulary vocabulary, String of, String field, String pointer) {
        Optional<ValueType> inEvent =
                vocabulary.event(of).flatMap(event -> event.field(field)).map(FieldType::type);
        Optional<ValueType> inRecord = vocabulary.types().get(of) instanceof NamedType.RecordType record
                ? Optional.ofNullable(record.fields().get(field))
                : Optional.empty();
        if (inEvent.or(() -> inRecord)
                .filter(type -> type == ValueType.Simple.TEXT)
                .isEmpty()) {
            problems.add(
                    Codes.BAD_VALUE,
                    pointer,
                    "There is no record or event " + of + " with a field \"" + field + "\" of type text");
        }
    }

    private void readTypes() {
        NamedTypeReader reader = new NamedTypeReader(problems);
        for (NamedType type : all("types", (m, taken) -> reader.read(m, taken))) {
            types.put(type.name(), type);
        }
        reader.checkReferences(types);
    }

    /** Reads the items of a list that any of the files may hold; names taken so far are shared over the files. */
    private <T> List<T> all(String member, BiFunction<JsonObjectReader, Names, Optional<T>> reader) {
        return all(member, new Names(problems), reader);
    }

    private <T> List<T> all(String member, Names taken, BiFunction<JsonObjectReader, Names, Optional<T>> reader) {
        List<T> items = new ArrayList<>();
        for (JsonObjectReader root : roots.values()) {
            if (root.has(member)) {
                root.objects(member).stream()
                        .filter(m -> !joined.isReplaced(m.pointer()))
                        .forEach(m -> {
                            reader.apply(m, taken).ifPresent(items::add);
                            m.done();
                        });
            }
        }
        return items;
    }
}
