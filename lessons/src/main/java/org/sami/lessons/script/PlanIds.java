package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;

/** Finds the elements that a script speaks of in the plan that is open, and says which may have been meant where there is none. */
final class PlanIds {
    private final Plan plan;

    PlanIds(Plan plan) {
        this.plan = plan;
    }

    private List<String> places() {
        return plan.places().stream().map(Place::id).toList();
    }

    private List<String> transitions() {
        return plan.transitions().stream().map(Transition::id).toList();
    }

    List<String> vertices() {
        List<String> ids = new ArrayList<>(places());
        ids.addAll(transitions());
        return ids;
    }

    void vertex(String id, String pointer) throws ScriptRefusedException {
        known(vertices(), "place or transition", id, pointer);
    }

    void place(String id, String pointer) throws ScriptRefusedException {
        known(places(), "place", id, pointer);
    }

    void transition(String id, String pointer) throws ScriptRefusedException {
        known(transitions(), "transition", id, pointer);
    }

    void all(Collection<String> ids, String pointer) throws ScriptRefusedException {
        Set<String> known = plan.elementIds();
        for (String id : ids) {
            known(known, "element", id, pointer);
        }
    }

    OutputEventSpec output(String id, String pointer) throws ScriptRefusedException {
        List<OutputEventSpec> outputs =
                plan.places().stream().flatMap(p -> p.outputs().stream()).toList();
        known(outputs.stream().map(OutputEventSpec::id).toList(), "output event", id, pointer);
        return outputs.stream().filter(o -> o.id().equals(id)).findFirst().orElseThrow();
    }

    InputEventSpec input(String id, String pointer) throws ScriptRefusedException {
        List<InputEventSpec> inputs =
                plan.transitions().stream().flatMap(t -> t.inputs().stream()).toList();
        known(inputs.stream().map(InputEventSpec::id).toList(), "input event", id, pointer);
        return inputs.stream().filter(i -> i.id().equals(id)).findFirst().orElseThrow();
    }

    /** The type of an event of places or transitions. */
    String event(String id, String pointer) throws ScriptRefusedException {
        Optional<String> output = plan.places().stream()
                .flatMap(p -> p.outputs().stream())
                .filter(o -> o.id().equals(id))
                .map(OutputEventSpec::type)
                .findFirst();
        if (output.isPresent()) {
            return output.get();
        }
        List<String> known = new ArrayList<>();
        plan.places().forEach(p -> p.outputs().forEach(o -> known.add(o.id())));
        plan.transitions().forEach(t -> t.inputs().forEach(i -> known.add(i.id())));
        known(known, "event", id, pointer);
        return input(id, pointer).type();
    }

    SubMissionSpec subMission(String id, String pointer) throws ScriptRefusedException {
        List<SubMissionSpec> subs =
                plan.places().stream().flatMap(p -> p.subMissions().stream()).toList();
        known(subs.stream().map(SubMissionSpec::id).toList(), "sub-mission", id, pointer);
        return subs.stream().filter(s -> s.id().equals(id)).findFirst().orElseThrow();
    }

    /** The id of an edge that is named by its id, or by its ends as {@code from>to}. */
    String edge(String name, String pointer) throws ScriptRefusedException {
        List<String> known = new ArrayList<>();
        for (InEdge e : plan.inEdges()) {
            known.add(e.id());
            known.add(e.place() + ">" + e.transition());
        }
        for (OutEdge e : plan.outEdges()) {
            known.add(e.id());
            known.add(e.transition() + ">" + e.place());
        }
        String close = name.replaceAll("\\s*>\\s*", ">");
        known(known, "edge", close, pointer);
        int at = known.indexOf(close);
        return known.get(at - at % 2);
    }

    private void known(Collection<String> known, String kind, String id, String pointer) throws ScriptRefusedException {
        if (!known.contains(id)) {
            String meant = Suggestions.meant(known, id);
            String all = known.isEmpty() ? "it has none" : "those are " + String.join(", ", known);
            throw new ScriptRefusedException(
                    pointer,
                    "The plan \"" + plan.id() + "\" has no " + kind + " \"" + id + "\""
                            + (meant.isEmpty() ? "; " + all : meant));
        }
    }
}
