package org.sami.crw.sim.experiment.table;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;

/**
 * An experiment as its file says it (docs/experiments.md). Settings, factors and derived values are variables, which scripts name with {@code $}.
 *
 * @param settings values of variables in all configurations, by name
 * @param factors values of variables that differ, by name; the last one changes fastest
 * @param sensitivity further values of variables, for {@link #oneFactorAtATime()}
 * @param design which configurations there are
 * @param derived variables that follow from another one
 * @param configuration names of the variables that the table's first column shows
 * @param undisturbed the version whose run without incidents says when incidents can happen; empty text where none is needed
 * @param scripts what is made into scripts once a configuration is known: incidents, versions, places, delays
 * @param published what was published, each with the factors' values and cells by name
 * @param notes lines below the table
 */
public record ExperimentFile(
        String id,
        String title,
        Map<String, String> settings,
        Map<String, List<String>> factors,
        Map<String, List<String>> sensitivity,
        Design design,
        Map<String, DerivedVariable> derived,
        List<String> configuration,
        String undisturbed,
        JsonNode scripts,
        List<TableColumn> columns,
        List<Map<String, String>> published,
        List<String> notes) {
    public ExperimentFile {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(title, "title");
        settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
        factors = Collections.unmodifiableMap(new LinkedHashMap<>(factors));
        sensitivity = Collections.unmodifiableMap(new LinkedHashMap<>(sensitivity));
        Objects.requireNonNull(design, "design");
        derived = Collections.unmodifiableMap(new LinkedHashMap<>(derived));
        configuration = List.copyOf(configuration);
        Objects.requireNonNull(undisturbed, "undisturbed");
        Objects.requireNonNull(scripts, "scripts");
        columns = List.copyOf(columns);
        published = List.copyOf(published);
        notes = List.copyOf(notes);
    }

    /** Which configurations an experiment has. */
    public enum Design {
        /** Every combination of the factors' values. */
        EVERY_COMBINATION,
        /** A base, in which each factor has its first value, and those that differ from it in one variable. */
        ONE_FACTOR_AT_A_TIME
    }

    /**
     * A variable whose value follows from another one's.
     *
     * @param of the other variable
     * @param values by the other's value
     * @param otherwise the value for all others
     */
    public record DerivedVariable(String of, Map<String, String> values, String otherwise) {
        public DerivedVariable {
            Objects.requireNonNull(of, "of");
            values = Map.copyOf(values);
            Objects.requireNonNull(otherwise, "otherwise");
        }
    }

    /** The same experiment with other values: one value is a setting, several are a factor. */
    public ExperimentFile with(Map<String, List<String>> others) {
        Map<String, String> newSettings = new LinkedHashMap<>(settings);
        Map<String, List<String>> newFactors = new LinkedHashMap<>(factors);
        List<String> shown = new ArrayList<>(configuration);
        others.forEach((name, values) -> {
            if (newFactors.containsKey(name) || values.size() > 1) {
                newFactors.put(name, List.copyOf(values));
                if (!shown.contains(name)) {
                    shown.add(name);
                }
            } else {
                newSettings.put(name, values.get(0));
            }
        });
        return new ExperimentFile(
                id,
                title,
                newSettings,
                newFactors,
                sensitivity,
                design,
                derived,
                shown,
                undisturbed,
                scripts,
                columns,
                published,
                notes);
    }

    /** The same experiment with the configurations that show how much each variable matters: those of its factors, and of its sensitivity. */
    public ExperimentFile oneFactorAtATime() {
        return new ExperimentFile(
                id,
                title + ", one factor at a time",
                settings,
                factors,
                sensitivity,
                Design.ONE_FACTOR_AT_A_TIME,
                derived,
                configuration,
                undisturbed,
                scripts,
                columns,
                published,
                notes);
    }

    /** All configurations, in the table's order. */
    public List<Configuration> configurations() {
        List<Map<String, String>> all = design == Design.EVERY_COMBINATION ? everyCombination() : oneByOne();
        return all.stream().map(this::configuration).toList();
    }

    private List<Map<String, String>> everyCombination() {
        List<Map<String, String>> all = new ArrayList<>(List.of(Map.of()));
        factors.forEach((name, values) -> {
            List<Map<String, String>> longer = new ArrayList<>();
            for (Map<String, String> begun : all) {
                for (String value : values) {
                    longer.add(with(begun, name, value));
                }
            }
            all.clear();
            all.addAll(longer);
        });
        return all;
    }

    private List<Map<String, String>> oneByOne() {
        Map<String, String> base = new LinkedHashMap<>();
        factors.forEach((name, values) -> base.put(name, values.get(0)));
        List<Map<String, String>> all = new ArrayList<>(List.of(base));
        factors.forEach((name, values) -> values.stream().skip(1).forEach(value -> all.add(with(base, name, value))));
        sensitivity.forEach((name, values) -> values.stream()
                .filter(value -> !value.equals(base.getOrDefault(name, usual(name))))
                .map(value -> with(base, name, value))
                .filter(one -> !all.contains(one))
                .forEach(all::add));
        return all;
    }

    private static Map<String, String> with(Map<String, String> values, String name, String value) {
        Map<String, String> more = new LinkedHashMap<>(values);
        more.put(name, value);
        return more;
    }

    private Configuration configuration(Map<String, String> factorValues) {
        Map<String, String> variables = new LinkedHashMap<>(ScenarioVariables.USUAL);
        variables.putAll(settings);
        variables.putAll(factorValues);
        derived.forEach((name, follows) -> variables.put(
                name, follows.values().getOrDefault(variables.getOrDefault(follows.of(), ""), follows.otherwise())));
        List<String> shown = configuration.stream()
                .map(name -> variables.getOrDefault(name, "-"))
                .collect(Collectors.toCollection(ArrayList::new));
        factorValues.forEach((name, value) -> {
            if (!factors.containsKey(name)) {
                shown.add(name + " " + value);
            }
        });
        return new Configuration(factorValues, variables, String.join(", ", shown));
    }

    private String usual(String name) {
        return settings.getOrDefault(name, ScenarioVariables.USUAL.getOrDefault(name, ""));
    }

    /** What was published about a configuration, by the names of columns; empty where nothing was. */
    public Map<String, String> publishedFor(Configuration one) {
        return published.stream()
                .filter(row -> factors.keySet().stream()
                        .filter(row::containsKey)
                        .allMatch(name ->
                                Objects.equals(row.get(name), one.factors().get(name))))
                .filter(row -> one.factors().entrySet().stream()
                        .allMatch(factor -> row.containsKey(factor.getKey())
                                || factor.getValue().equals(usual(factor.getKey()))))
                .findFirst()
                .orElse(Map.of());
    }

    /**
     * One row of the table.
     *
     * @param factors its values of the factors
     * @param variables all its variables, settings included
     * @param text its values for the first column
     */
    public record Configuration(Map<String, String> factors, Map<String, String> variables, String text) {
        public Configuration {
            factors = Collections.unmodifiableMap(new LinkedHashMap<>(factors));
            variables = Collections.unmodifiableMap(new LinkedHashMap<>(variables));
            Objects.requireNonNull(text, "text");
        }

        /** Tells it from others, such as {@code locations=20 alarms=1 boats=3}. */
        public String key() {
            List<String> parts = new ArrayList<>();
            factors.forEach((name, value) -> parts.add(name + "=" + value));
            return String.join(" ", parts);
        }
    }
}
