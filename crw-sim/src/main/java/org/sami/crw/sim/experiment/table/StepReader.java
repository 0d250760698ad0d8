package org.sami.crw.sim.experiment.table;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.crw.sim.run.incident.ScriptStep;
import org.sami.crw.sim.run.incident.ScriptStep.BoatChoice;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads steps of scripts: {@code start}, {@code abort}, {@code press}, {@code await} and {@code wait}. */
final class StepReader {
    private static final Map<String, List<String>> MEMBERS = Map.of(
            "start", List.of("start", "set", "boats", "if"),
            "abort", List.of("abort"),
            "press", List.of("press", "boats"),
            "await", List.of("await"),
            "wait", List.of("wait"));

    private final Vocabulary vocabulary;
    private final Project project;
    private final DocumentFaults faults;

    StepReader(Vocabulary vocabulary, Project project, DocumentFaults faults) {
        this.vocabulary = vocabulary;
        this.project = project;
        this.faults = faults;
    }

    List<ScriptStep> read(JsonNode list, String pointer) {
        List<ScriptStep> steps = new ArrayList<>();
        if (faults.isList(list, pointer)) {
            for (int i = 0; i < list.size(); i++) {
                step(list.get(i), pointer + "/" + i).ifPresent(steps::add);
            }
        }
        return steps;
    }

    private Optional<ScriptStep> step(JsonNode node, String at) {
        Optional<String> verb = Stream.of("start", "abort", "press", "await", "wait")
                .filter(node::has)
                .findFirst();
        if (verb.isEmpty()) {
            faults.add(
                    "E-MISSING",
                    at,
                    "A step is a start, abort, press, await or wait, not " + DocumentFaults.shown(node));
            return Optional.empty();
        }
        if (!faults.isObject(node, at, MEMBERS.getOrDefault(verb.get(), List.of()))) {
            return Optional.empty();
        }
        JsonNode what = node.get(verb.get());
        String there = at + "/" + verb.get();
        return Optional.of(
                switch (verb.get()) {
                    case "start" -> start(node, plan(what, there), at);
                    case "abort" -> new ScriptStep.Abort(plan(what, there));
                    case "press" -> new ScriptStep.Press(interrupt(what, there), boats(node, at) != BoatChoice.ALL);
                    case "await" -> new ScriptStep.Await(plan(what, there));
                    default -> new ScriptStep.Pause(Math.round(faults.number(what, there, 0, 86_400) * 1000));
                });
    }

    private ScriptStep start(JsonNode node, String plan, String at) {
        Map<String, String> values = new LinkedHashMap<>();
        node.path("set")
                .properties()
                .forEach(
                        member -> faults.text(member.getValue(), at + "/set/" + DocumentFaults.escaped(member.getKey()))
                                .ifPresent(text -> values.put(member.getKey(), text)));
        Optional<Plan> known = project.plan(plan);
        try {
            known.ifPresent(one -> new Parameters(vocabulary, project, one).read(values));
        } catch (IllegalArgumentException unfit) {
            faults.add("E-BAD-VALUE", at + "/set", String.valueOf(unfit.getMessage()));
        }
        String condition = faults.text(node, "if", at, "always");
        if (!List.of("always", "unvisited").contains(condition)) {
            faults.add("E-BAD-VALUE", at + "/if", "A start happens always or if unvisited, not if " + condition);
        }
        return new ScriptStep.Start(plan, values, boats(node, at), condition.equals("unvisited"));
    }

    private BoatChoice boats(JsonNode node, String at) {
        String word = faults.text(node, "boats", at, "all");
        for (BoatChoice choice : BoatChoice.values()) {
            if (choice != BoatChoice.NEXT
                    && choice.name().toLowerCase(Locale.ROOT).replace('_', '-').equals(word)) {
                return choice;
            }
        }
        faults.add("E-BAD-VALUE", at + "/boats", "Boats are all, incident, others or each-but-one, not " + word);
        return BoatChoice.ALL;
    }

    /** What a version's events are optimised for; none where the member is left out. */
    List<EventCriterion> criteria(JsonNode list, String pointer) {
        List<EventCriterion> criteria = new ArrayList<>();
        if (list.isMissingNode() || !faults.isList(list, pointer)) {
            return criteria;
        }
        for (int i = 0; i < list.size(); i++) {
            String at = pointer + "/" + i;
            if (faults.isObject(list.get(i), at, List.of("plan", "event", "criterion"))) {
                criteria.add(criterion(list.get(i), at));
            }
        }
        return criteria;
    }

    private EventCriterion criterion(JsonNode node, String at) {
        String plan = plan(node.path("plan"), at + "/plan");
        String event = faults.text(node.path("event"), at + "/event").orElse("");
        String word = faults.text(node.path("criterion"), at + "/criterion").orElse("");
        if (project.plan(plan).isPresent() && !EventCriterion.hasEvent(project, plan, event)) {
            faults.add("E-UNKNOWN-EVENT", at + "/event", "Plan " + plan + " has no output event \"" + event + "\"");
        }
        try {
            return new EventCriterion(plan, event, AllocationCriterion.constant(word));
        } catch (IllegalArgumentException unfit) {
            faults.add("E-BAD-VALUE", at + "/criterion", String.valueOf(unfit.getMessage()));
            return new EventCriterion(plan, event, "");
        }
    }

    /** The id of a plan of the project. */
    String plan(JsonNode node, String at) {
        String id = faults.text(node, at).orElse("");
        if (project.plan(id).isEmpty()) {
            List<String> known = project.plans().stream().map(Plan::id).toList();
            faults.add("E-UNKNOWN-PLAN", at, "There is no plan \"" + id + "\"" + Suggestions.meant(known, id));
        }
        return id;
    }

    private String interrupt(JsonNode node, String at) {
        String name = faults.text(node, at).orElse("");
        List<String> known = new PlanInterrupts(vocabulary, project, project.plans()).names();
        if (!known.contains(name)) {
            faults.add(
                    "E-UNKNOWN-INTERRUPT",
                    at,
                    "No plan has the interrupt \"" + name + "\"" + Suggestions.meant(known, name));
        }
        return name;
    }
}
