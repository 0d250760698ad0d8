package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Saves the values that a session gave to global variables as initial values in a project's file (thesis 3.1;
 * docs/session.md). Only those values are changed; everything else in the file stays, laid out by {@link CanonicalJson}.
 */
public final class GlobalsFile {
    private final Vocabulary vocabulary;

    /** Saves into projects of one domain; has no state of its own. */
    public GlobalsFile(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /**
     * One global variable that has another initial value now.
     *
     * @param before empty where the file gave none
     */
    public record Change(String name, ValueType type, Optional<Value> before, Value after) {
        public Change {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(type, "type");
            Objects.requireNonNull(before, "before");
            Objects.requireNonNull(after, "after");
        }
    }

    /**
     * Saves values to a project's file, or to the {@code project.json} of a folder. The file is replaced as a whole; it is left
     * alone where nothing changes and where there is an error. A global that the file does not declare is a warning.
     *
     * @param values of globals, by name; a global that is not in it keeps what the file says
     * @return what changed; no result where the file cannot be read, or gives a global a type that its value does not have
     */
    public Reading<List<Change>> save(Map<String, Value> values, Path path) throws IOException {
        Path file = Files.isDirectory(path) ? path.resolve("project.json") : path;
        Reading<Project> project = new ProjectReader(vocabulary).read(path);
        Optional<ObjectNode> root = project.result().isEmpty() ? Optional.empty() : objectIn(file);
        if (root.isEmpty()) {
            return new Reading<>(Optional.empty(), project.findings());
        }
        Problems problems = new Problems();
        List<Change> changes = new ArrayList<>();
        List<VariableSpec> declared = project.result().get().globals();
        for (int i = 0; i < declared.size(); i++) {
            VariableSpec spec = declared.get(i);
            Value value = values.get(spec.name());
            if (value != null && !spec.initial().equals(Optional.of(value))) {
                String pointer = "/globals/" + i;
                write(value, spec, pointer, problems)
                        .ifPresent(text -> ((ObjectNode) root.get().at(pointer)).set("initial", text));
                changes.add(new Change(spec.name(), spec.type(), spec.initial(), value));
            }
        }
        if (!problems.none()) {
            return new Reading<>(Optional.empty(), problems.findings());
        }
        if (!changes.isEmpty()) {
            AtomicFile.write(file, CanonicalJson.print(root.get()));
        }
        return new Reading<>(Optional.of(List.copyOf(changes)), undeclared(values, declared));
    }

    /** The value in the file's form, if a reader of the file would find it there again. */
    private Optional<JsonNode> write(Value value, VariableSpec spec, String pointer, Problems problems) {
        if (TypeCheck.accepts(spec.type(), value, vocabulary.types())) {
            JsonNode node = new ValueWriter(vocabulary.types()).write(value, spec.type());
            Problems unreadable = new Problems();
            if (new ValueReader(vocabulary.types(), unreadable)
                    .read(node, spec.type(), "")
                    .equals(Optional.of(value))) {
                return Optional.of(node);
            }
        }
        problems.add(
                Codes.BAD_VALUE,
                pointer,
                "The global " + spec.name() + " has the value " + TaggedValues.write(value)
                        + ", and the file declares it as of type " + TypeNames.of(spec.type()) + "; nothing was saved");
        return Optional.empty();
    }

    private static List<Finding> undeclared(Map<String, Value> values, List<VariableSpec> declared) {
        List<String> names = declared.stream().map(VariableSpec::name).toList();
        return values.keySet().stream()
                .filter(name -> !names.contains(name))
                .map(name -> Finding.warning(
                        Codes.UNKNOWN_GLOBAL,
                        "/globals",
                        "The file declares no global " + name + "; its value is not saved",
                        name))
                .toList();
    }

    private static Optional<ObjectNode> objectIn(Path file) throws IOException {
        return TextFiles.read(file)
                .flatMap(text -> JsonText.parse(text, new Problems()))
                .filter(ObjectNode.class::isInstance)
                .map(ObjectNode.class::cast);
    }
}
