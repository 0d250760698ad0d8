package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * What an element of a plan is, as text without its id and its position: two elements are alike where their texts are. Names of variables stand
 * apart, in the order of the text.
 *
 * @param words with a mark for each name of a variable
 * @param variables their names
 */
record ElementText(String words, List<String> variables) {
    private static final Pattern VARIABLE = Pattern.compile("@[A-Za-z][A-Za-z0-9_.]*");

    private static ElementText of(String text) {
        List<String> variables =
                VARIABLE.matcher(text).results().map(MatchResult::group).toList();
        return new ElementText(VARIABLE.matcher(text).replaceAll("@"), variables);
    }

    /**
     * The text of a place.
     *
     * @param plans the names by which plans are compared, by their ids
     */
    static ElementText of(Place place, Map<String, String> plans) {
        List<String> parts = new ArrayList<>();
        place.outputs().forEach(o -> parts.add(event(o.type(), sorted(o.fields()), sorted(o.writes()), o.markups())));
        place.subMissions()
                .forEach(s -> parts.add("runs " + plans.getOrDefault(s.plan(), s.plan()) + (s.shared() ? " shared" : "")
                        + sorted(s.tasks()) + sorted(s.variables())));
        return of(
                "place \"" + place.name() + "\"" + (place.start() ? " start" : "") + (place.end() ? " end" : "")
                        + (place.endsSharedInstance() ? " ends-shared" : "") + " " + place.mode()
                        + (place.disabled() ? " disabled" : ""),
                parts);
    }

    static ElementText of(Transition transition) {
        List<String> parts = new ArrayList<>();
        transition
                .inputs()
                .forEach(i -> parts.add(event(i.type(), sorted(i.fields()), sorted(i.writes()), i.markups())));
        return of(
                "transition \"" + transition.name() + "\" " + transition.waitFor() + " " + transition.mode()
                        + (transition.disabled() ? " disabled" : ""),
                parts);
    }

    /** The parts in an order of their own: that of events on a vertex means nothing here. */
    private static ElementText of(String head, List<String> parts) {
        List<ElementText> texts = parts.stream()
                .map(ElementText::of)
                .sorted((a, b) -> a.words.compareTo(b.words))
                .toList();
        return new ElementText(
                head + texts.stream().map(t -> "\n  " + t.words).collect(Collectors.joining()),
                texts.stream().flatMap(t -> t.variables.stream()).toList());
    }

    private static String event(String type, String fields, String writes, Collection<?> markups) {
        List<String> marks = markups.stream().map(Object::toString).sorted().toList();
        return type + fields + (writes.isEmpty() ? "" : " writes" + writes) + (marks.isEmpty() ? "" : " " + marks);
    }

    private static String sorted(Map<String, ?> map) {
        return map.isEmpty() ? "" : " " + new TreeMap<>(map);
    }

    static String of(InEdge edge) {
        return edge.mode() + (edge.locked() ? " locked " : " ") + sorted(edge.requirements());
    }

    static String of(OutEdge edge) {
        return edge.mode() + (edge.locked() ? " locked " : " ") + sorted(edge.requirements());
    }

    private static String sorted(Collection<?> requirements) {
        return requirements.stream().map(Object::toString).sorted().toList().toString();
    }

    /** The texts of all vertices of a plan, by id. */
    static Map<String, ElementText> ofVertices(Plan plan, Map<String, String> plans) {
        Map<String, ElementText> texts = new TreeMap<>();
        plan.places().forEach(p -> texts.put(p.id(), of(p, plans)));
        plan.transitions().forEach(t -> texts.put(t.id(), of(t)));
        return texts;
    }
}
