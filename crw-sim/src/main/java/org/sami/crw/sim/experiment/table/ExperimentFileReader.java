package org.sami.crw.sim.experiment.table;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.sim.experiment.table.ExperimentFile.DerivedVariable;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads an experiment's file. Every problem is a finding with its place; a file with one is not used. */
public final class ExperimentFileReader {
    /** The word that marks such a file. */
    public static final String FORMAT = "crw-experiment";

    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();
    private static final int VERSION = 1;
    private static final List<String> TOP = List.of(
            "$schema",
            "format",
            "version",
            "id",
            "title",
            "settings",
            "factors",
            "derived",
            "configuration",
            "undisturbed",
            "incidents",
            "places",
            "delays",
            "background",
            "sensitivity",
            "resolution",
            "versions",
            "columns",
            "published",
            "notes");
    private static final int MOST_CONFIGURATIONS = 10_000;

    private final Vocabulary vocabulary;
    private final Project project;
    private final DocumentFaults faults = new DocumentFaults();

    private ExperimentFileReader(Vocabulary vocabulary, Project project) {
        this.vocabulary = vocabulary;
        this.project = project;
    }

    /** Whether a text is an experiment's file, perhaps a faulty one, and no other document. */
    public static boolean isExperiment(String text) {
        try {
            JsonNode top = MAPPER.readTree(text);
            return top != null && FORMAT.equals(top.path("format").asText());
        } catch (JsonProcessingException noJson) {
            return false;
        }
    }

    /**
     * Reads the text of a file.
     *
     * @param project with all plans that scripts may start
     */
    public static Reading<ExperimentFile> read(String text, Vocabulary vocabulary, Project project) {
        return new ExperimentFileReader(vocabulary, project).read(text).locatedIn("", text);
    }

    private Reading<ExperimentFile> read(String text) {
        try {
            JsonNode top = MAPPER.readTree(text);
            if (top == null || !faults.isObject(top, "", TOP)) {
                return new Reading<>(Optional.empty(), faults.findings());
            }
            Optional<ExperimentFile> file = file(top);
            file.filter(read -> faults.areNone()).ifPresent(this::checkConfigurations);
            return new Reading<>(faults.areNone() ? file : Optional.empty(), faults.findings());
        } catch (JsonProcessingException e) {
            Finding syntax = Finding.error("E-SYNTAX", "", e.getOriginalMessage());
            JsonLocation at = e.getLocation();
            return new Reading<>(
                    Optional.empty(),
                    List.of(
                            at == null || at.getLineNr() <= 0 || at.getColumnNr() <= 0
                                    ? syntax
                                    : syntax.at(new SourceLocation("", at.getLineNr(), at.getColumnNr()))));
        }
    }

    private Optional<ExperimentFile> file(JsonNode top) {
        if (!FORMAT.equals(top.path("format").asText())) {
            faults.add("E-VERSION", "/format", "The format is \"" + FORMAT + "\"");
        }
        if (top.path("version").asInt() != VERSION) {
            faults.add("E-VERSION", "/version", "This program reads version " + VERSION);
        }
        String id = faults.text(top.path("id"), "/id").orElse("");
        return Optional.of(new ExperimentFile(
                id,
                faults.text(top, "title", "", id),
                texts(top.path("settings"), "/settings"),
                lists(top.path("factors"), "/factors"),
                top.has("sensitivity") ? lists(top.path("sensitivity"), "/sensitivity") : Map.of(),
                ExperimentFile.Design.EVERY_COMBINATION,
                derived(top.path("derived")),
                list(top.path("configuration"), "/configuration"),
                faults.text(top, "undisturbed", "", ""),
                top,
                columns(top.path("columns")),
                rows(top.path("published")),
                list(top.path("notes"), "/notes")));
    }

    private Map<String, String> texts(JsonNode node, String pointer) {
        Map<String, String> texts = new LinkedHashMap<>();
        if (!node.isMissingNode() && !node.isObject()) {
            faults.add("E-WRONG-TYPE", pointer, "An object stands here, not " + DocumentFaults.shown(node));
        }
        node.properties()
                .forEach(member -> faults.text(
                                member.getValue(), pointer + "/" + DocumentFaults.escaped(member.getKey()))
                        .ifPresent(text -> texts.put(member.getKey(), text)));
        return texts;
    }

    private Map<String, List<String>> lists(JsonNode node, String pointer) {
        Map<String, List<String>> lists = new LinkedHashMap<>();
        if (!node.isObject() || node.isEmpty()) {
            faults.add("E-WRONG-TYPE", pointer, "An object with a list of values for each factor stands here");
            return lists;
        }
        node.properties().forEach(member -> {
            String at = pointer + "/" + DocumentFaults.escaped(member.getKey());
            List<String> values = list(member.getValue(), at);
            if (values.isEmpty()) {
                faults.add("E-BAD-VALUE", at, "A factor has one value or more");
            }
            lists.put(member.getKey(), values);
        });
        return lists;
    }

    private List<String> list(JsonNode node, String pointer) {
        List<String> values = new ArrayList<>();
        if (!node.isMissingNode() && faults.isList(node, pointer)) {
            for (int i = 0; i < node.size(); i++) {
                faults.text(node.get(i), pointer + "/" + i).ifPresent(values::add);
            }
        }
        return values;
    }

    private Map<String, DerivedVariable> derived(JsonNode node) {
        Map<String, DerivedVariable> all = new LinkedHashMap<>();
        node.properties().forEach(member -> {
            String at = "/derived/" + DocumentFaults.escaped(member.getKey());
            if (faults.isObject(member.getValue(), at, List.of("of", "values", "otherwise"))) {
                all.put(
                        member.getKey(),
                        new DerivedVariable(
                                faults.text(member.getValue().path("of"), at + "/of")
                                        .orElse(""),
                                texts(member.getValue().path("values"), at + "/values"),
                                faults.text(member.getValue(), "otherwise", at, "")));
            }
        });
        return all;
    }

    private List<TableColumn> columns(JsonNode node) {
        List<TableColumn> columns = new ArrayList<>();
        if (!faults.isList(node, "/columns")) {
            return columns;
        }
        for (int i = 0; i < node.size(); i++) {
            column(node.get(i), "/columns/" + i).ifPresent(columns::add);
        }
        return columns;
    }

    private Optional<TableColumn> column(JsonNode node, String at) {
        if (!faults.isObject(node, at, List.of("title", "mean", "gain", "change", "of", "against", "published"))) {
            return Optional.empty();
        }
        for (TableColumn.Kind kind : TableColumn.Kind.values()) {
            String word = kind.name().toLowerCase(Locale.ROOT);
            if (node.has(word)) {
                Optional<Measure> measure =
                        faults.text(node.get(word), at + "/" + word).flatMap(Measure::of);
                if (measure.isEmpty()) {
                    faults.add(
                            "E-BAD-VALUE",
                            at + "/" + word,
                            "A measure is time, clicks, recharges, resolution or measurements, not "
                                    + DocumentFaults.shown(node.get(word)));
                }
                String against = kind == TableColumn.Kind.MEAN ? "" : version(node.path("against"), at + "/against");
                String of = version(node.path("of"), at + "/of");
                return measure.map(known -> new TableColumn(
                        faults.text(node, "title", at, known.word()),
                        known,
                        kind,
                        of,
                        against,
                        faults.text(node, "published", at, "")));
            }
        }
        faults.add("E-MISSING", at, "A column has a mean, a gain or a change");
        return Optional.empty();
    }

    private String version(JsonNode node, String at) {
        return faults.text(node, at).orElse("");
    }

    private List<Map<String, String>> rows(JsonNode node) {
        List<Map<String, String>> rows = new ArrayList<>();
        if (!node.isMissingNode() && faults.isList(node, "/published")) {
            for (int i = 0; i < node.size(); i++) {
                rows.add(texts(node.get(i), "/published/" + i));
            }
        }
        return rows;
    }

    private void checkConfigurations(ExperimentFile file) {
        if (file.factors().values().stream()
                        .mapToLong(List::size)
                        .reduce(1, (a, b) -> Math.min(a * b, Integer.MAX_VALUE))
                > MOST_CONFIGURATIONS) {
            faults.add("E-BAD-VALUE", "/factors", "There are more than " + MOST_CONFIGURATIONS + " configurations");
            return;
        }
        faults.addAll(check(file));
        if (faults.areNone() && !file.sensitivity().isEmpty()) {
            faults.addAll(check(file.oneFactorAtATime()));
        }
    }

    private List<Finding> check(ExperimentFile file) {
        return check(file, vocabulary, project);
    }

    /** What is wrong with an experiment whose variables were changed after it was read. */
    public static List<Finding> check(ExperimentFile file, Vocabulary vocabulary, Project project) {
        DocumentFaults all = new DocumentFaults();
        for (ExperimentFile.Configuration one : file.configurations()) {
            Reading<ConfigurationScripts> scripts = ScriptsReader.read(file, one.variables(), vocabulary, project);
            all.addAll(scripts.findings());
            all.addAll(ScenarioVariables.check(one.variables()));
        }
        return all.findings();
    }
}
