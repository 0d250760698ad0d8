package org.sami.crw.sim.experiment.table;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.crw.sim.experiment.table.ConfigurationScripts.Incidents;
import org.sami.crw.sim.run.incident.BackgroundActions;
import org.sami.crw.sim.run.incident.IncidentRunInput.ResolutionSpan;
import org.sami.crw.sim.run.incident.IncidentScript;
import org.sami.crw.sim.run.incident.PlaceOnWater;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes the scripts of one configuration: puts in the values of variables, written {@code ${name}}, and reads what is then there. */
final class ScriptsReader {
    private static final Pattern VARIABLE = Pattern.compile("\\$\\{([^}]*)\\}");
    private static final int MOST_INCIDENTS = 1000;
    private static final String NOBODY = "none"; // in place of a plan: no actions in the background

    private final Map<String, String> variables;
    private final DocumentFaults faults = new DocumentFaults();
    private final StepReader steps;

    private ScriptsReader(Map<String, String> variables, Vocabulary vocabulary, Project project) {
        this.variables = variables;
        steps = new StepReader(vocabulary, project, faults);
    }

    static Reading<ConfigurationScripts> read(
            ExperimentFile file, Map<String, String> variables, Vocabulary vocabulary, Project project) {
        ScriptsReader reader = new ScriptsReader(variables, vocabulary, project);
        ConfigurationScripts read = reader.read(file);
        return new Reading<>(reader.faults.areNone() ? Optional.of(read) : Optional.empty(), reader.faults.findings());
    }

    private ConfigurationScripts read(ExperimentFile file) {
        Map<String, IncidentScript> versions = new LinkedHashMap<>();
        Map<String, List<EventCriterion>> criteria = new LinkedHashMap<>();
        BackgroundActions background = background(put(file.scripts().path("background"), "/background"));
        Map<String, PlaceOnWater> places = places(file.scripts().path("places"));
        List<IncidentScript.AnswerDelay> delays = delays(file.scripts().path("delays"));
        JsonNode list = file.scripts().path("versions");
        if (!list.isArray() || list.isEmpty()) {
            faults.add("E-WRONG-TYPE", "/versions", "A list of versions stands here");
        }
        for (int i = 0; i < list.size(); i++) {
            String at = "/versions/" + i;
            JsonNode version = put(list.get(i), at);
            if (faults.isObject(version, at, List.of("name", "optimize", "start", "incident"))) {
                String name = faults.text(version.path("name"), at + "/name").orElse("");
                criteria.put(name, steps.criteria(version.path("optimize"), at + "/optimize"));
                versions.put(
                        name,
                        new IncidentScript(
                                steps.read(version.path("start"), at + "/start"),
                                version.has("incident")
                                        ? steps.read(version.path("incident"), at + "/incident")
                                        : List.of(),
                                places,
                                delays,
                                background));
            }
        }
        for (int i = 0; i < file.columns().size(); i++) {
            TableColumn column = file.columns().get(i);
            checkVersion(versions, column.of(), "/columns/" + i + "/of");
            if (column.kind() != TableColumn.Kind.MEAN) {
                checkVersion(versions, column.against(), "/columns/" + i + "/against");
            }
        }
        Incidents incidents = incidents(put(file.scripts().path("incidents"), "/incidents"));
        if (incidents.kind() == Incidents.Kind.TIMES) {
            checkVersion(versions, file.undisturbed(), "/undisturbed");
        }
        return new ConfigurationScripts(
                versions, criteria, incidents, resolution(file.scripts().path("resolution")));
    }

    private void checkVersion(Map<String, IncidentScript> versions, String name, String at) {
        if (!versions.containsKey(name)) {
            faults.add(
                    "E-UNKNOWN-VERSION",
                    at,
                    "There is no version \"" + name + "\"; there are " + String.join(", ", versions.keySet())
                            + Suggestions.meant(versions.keySet(), name));
        }
    }

    private Incidents incidents(JsonNode node) {
        PlaceOnWater none = PlaceOnWater.CENTRE;
        if (node.isMissingNode()) {
            return new Incidents(Incidents.Kind.NONE, 0, false, 0, none);
        }
        String at = "/incidents";
        if (!faults.isObject(node, at, List.of("kind", "count", "boats", "area"))) {
            return new Incidents(Incidents.Kind.NONE, 0, false, 0, none);
        }
        String word = faults.text(node.path("kind"), at + "/kind").orElse("");
        return switch (word) {
            case "times" -> {
                String boats = faults.text(node, "boats", at, "all");
                if (!List.of("all", "one").contains(boats)) {
                    faults.add("E-BAD-VALUE", at + "/boats", "An incident concerns all boats or one, not " + boats);
                }
                int count = (int) faults.number(node.path("count"), at + "/count", 1, MOST_INCIDENTS);
                yield new Incidents(Incidents.Kind.TIMES, count, boats.equals("one"), 0, none);
            }
            case "inside" -> {
                int inside = (int) faults.number(node.path("boats"), at + "/boats", 1, 250);
                yield new Incidents(Incidents.Kind.INSIDE, 0, false, inside, place(node.path("area"), at + "/area"));
            }
            case "battery" -> new Incidents(Incidents.Kind.BATTERY, 0, true, 0, none);
            default -> {
                if (!word.equals("none")) {
                    faults.add(
                            "E-BAD-VALUE",
                            at + "/kind",
                            "Incidents come at times, of a battery, with boats inside, or none; not \"" + word + "\"");
                }
                yield new Incidents(Incidents.Kind.NONE, 0, false, 0, none);
            }
        };
    }

    private Map<String, PlaceOnWater> places(JsonNode given) {
        Map<String, PlaceOnWater> places = new LinkedHashMap<>();
        put(given, "/places")
                .properties()
                .forEach(member -> places.put(
                        member.getKey(),
                        place(member.getValue(), "/places/" + DocumentFaults.escaped(member.getKey()))));
        return places;
    }

    private PlaceOnWater place(JsonNode node, String at) {
        if (node.isTextual()) {
            String word = node.asText().toLowerCase(Locale.ROOT);
            if (word.equals("quay")) {
                return PlaceOnWater.QUAY;
            }
            if (!word.equals("centre")) {
                faults.add("E-BAD-VALUE", at, "A place is quay, centre, or an object; not " + node);
            }
            return PlaceOnWater.CENTRE;
        }
        if (!faults.isObject(node, at, List.of("east", "north", "side"))) {
            return PlaceOnWater.CENTRE;
        }
        return new PlaceOnWater(metres(node, "east", at), metres(node, "north", at), metres(node, "side", at), false);
    }

    private double metres(JsonNode node, String member, String at) {
        return node.has(member) ? faults.number(node.get(member), at + "/" + member, -20_000, 20_000) : 0;
    }

    private List<IncidentScript.AnswerDelay> delays(JsonNode given) {
        List<IncidentScript.AnswerDelay> delays = new ArrayList<>();
        JsonNode list = put(given, "/delays");
        for (int i = 0; i < list.size(); i++) {
            String at = "/delays/" + i;
            if (faults.isObject(list.get(i), at, List.of("plan", "event", "seconds"))) {
                delays.add(new IncidentScript.AnswerDelay(
                        steps.plan(list.get(i).path("plan"), at + "/plan"),
                        faults.text(list.get(i).path("event"), at + "/event").orElse(""),
                        Math.round(faults.number(list.get(i).path("seconds"), at + "/seconds", 0, 86_400) * 1000)));
            }
        }
        return delays;
    }

    private BackgroundActions background(JsonNode node) {
        if (node.isMissingNode() || !faults.isObject(node, "/background", List.of("plan", "noticing"))) {
            return BackgroundActions.NONE;
        }
        if (node.path("plan").asText().equals(NOBODY)) {
            return BackgroundActions.NONE;
        }
        return new BackgroundActions(
                steps.plan(node.path("plan"), "/background/plan"),
                faults.text(node.path("noticing"), "/background/noticing").orElse(""));
    }

    private ResolutionSpan resolution(JsonNode node) {
        if (node.isMissingNode() || !faults.isObject(node, "/resolution", List.of("press", "until"))) {
            return ResolutionSpan.NONE;
        }
        return new ResolutionSpan(
                faults.text(node.path("press"), "/resolution/press").orElse(""),
                faults.text(node.path("until"), "/resolution/until").orElse(""));
    }

    /** The same with the values of variables in its texts. */
    private JsonNode put(JsonNode node, String at) {
        JsonNodeFactory make = JsonNodeFactory.instance;
        if (node.isTextual()) {
            return make.textNode(put(node.asText(), at));
        }
        if (node.isArray()) {
            ArrayNode list = make.arrayNode();
            for (int i = 0; i < node.size(); i++) {
                list.add(put(node.get(i), at + "/" + i));
            }
            return list;
        }
        if (node.isObject()) {
            ObjectNode object = make.objectNode();
            node.properties()
                    .forEach(member -> object.set(
                            member.getKey(),
                            put(member.getValue(), at + "/" + DocumentFaults.escaped(member.getKey()))));
            return object;
        }
        return node;
    }

    private String put(String text, String at) {
        Matcher matcher = VARIABLE.matcher(text);
        StringBuilder done = new StringBuilder();
        while (matcher.find()) {
            String name = matcher.group(1);
            if (!variables.containsKey(name)) {
                faults.add(
                        "E-UNKNOWN-VARIABLE",
                        at,
                        "There is no setting, factor or derived value \"" + name + "\""
                                + Suggestions.meant(variables.keySet(), name));
            }
            matcher.appendReplacement(done, Matcher.quoteReplacement(variables.getOrDefault(name, "0")));
        }
        return matcher.appendTail(done).toString();
    }
}
