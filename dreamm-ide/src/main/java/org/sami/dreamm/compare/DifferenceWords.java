package org.sami.dreamm.compare;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/** Vertices and edges by the names that people call them, and in what two versions of one differ. */
final class DifferenceWords {
    private final Vocabulary vocabulary;
    private final Plan before;
    private final Plan after;

    /** Words for the elements of two versions of a plan; those that both have are called as in the later one. */
    DifferenceWords(Plan before, Plan after, Vocabulary vocabulary) {
        this.before = before;
        this.after = after;
        this.vocabulary = vocabulary;
    }

    String name(Place place) {
        return "The " + names(after.place(place.id()).isPresent()).withKind(place);
    }

    String name(Transition transition) {
        return "The " + names(after.transition(transition.id()).isPresent()).withKind(transition);
    }

    String name(InEdge edge) {
        return "The edge from " + vertex(edge.place()) + " to " + vertex(edge.transition());
    }

    String name(OutEdge edge) {
        return "The edge from " + vertex(edge.transition()) + " to " + vertex(edge.place());
    }

    private ElementNames names(boolean isAfter) {
        return new ElementNames(isAfter ? after : before, vocabulary);
    }

    private String vertex(String id) {
        return names(true)
                .of(id)
                .or(() -> names(false).of(id))
                .map(name -> "\"" + name + "\"")
                .orElse("nothing");
    }

    List<String> changes(Place was, Place is) {
        List<String> changes = new ArrayList<>();
        named(was.name(), is.name(), changes);
        if (was.start() != is.start()) {
            changes.add(is.start() ? "the mission begins here" : "the mission begins here no longer");
        }
        if (was.end() != is.end() || was.endsSharedInstance() != is.endsSharedInstance()) {
            changes.add(is.end() ? "the mission ends here" : "the mission ends here no longer");
        }
        mode(was.mode(), is.mode(), changes);
        disabled(was.disabled(), is.disabled(), changes);
        parts(
                "output event ",
                was.outputs(),
                is.outputs(),
                OutputEventSpec::id,
                o -> vocabulary.title(o.type()),
                changes);
        parts("sub-mission ", was.subMissions(), is.subMissions(), SubMissionSpec::id, SubMissionSpec::plan, changes);
        if (!was.transitionOrder().equals(is.transitionOrder())) {
            changes.add("its transitions are looked at in another order");
        }
        return changes;
    }

    List<String> changes(Transition was, Transition is) {
        List<String> changes = new ArrayList<>();
        named(was.name(), is.name(), changes);
        mode(was.mode(), is.mode(), changes);
        disabled(was.disabled(), is.disabled(), changes);
        if (was.waitFor() != is.waitFor()) {
            changes.add(is.waitFor() == WaitFor.ALL ? "it waits for all" : "it fires for each");
        }
        parts("input event ", was.inputs(), is.inputs(), InputEventSpec::id, i -> vocabulary.title(i.type()), changes);
        return changes;
    }

    private static void disabled(boolean was, boolean is, List<String> changes) {
        if (was != is) {
            changes.add(is ? "it is disabled for trying" : "it is disabled for trying no longer");
        }
    }

    List<String> changes(InEdge was, InEdge is) {
        List<String> changes = new ArrayList<>();
        if (!was.place().equals(is.place()) || !was.transition().equals(is.transition())) {
            changes.add("it joined " + vertex(was.place()) + " and " + vertex(was.transition()));
        }
        mode(was.mode(), is.mode(), changes);
        if (!was.requirements().equals(is.requirements())) {
            changes.add("requires " + in(is.requirements()) + ", before " + in(was.requirements()));
        }
        locked(was.locked(), is.locked(), changes);
        return changes;
    }

    List<String> changes(OutEdge was, OutEdge is) {
        List<String> changes = new ArrayList<>();
        if (!was.place().equals(is.place()) || !was.transition().equals(is.transition())) {
            changes.add("it joined " + vertex(was.transition()) + " and " + vertex(was.place()));
        }
        mode(was.mode(), is.mode(), changes);
        if (!was.requirements().equals(is.requirements())) {
            changes.add("does " + out(is.requirements()) + ", before " + out(was.requirements()));
        }
        locked(was.locked(), is.locked(), changes);
        return changes;
    }

    private static String in(List<InRequirement> requirements) {
        return requirements.isEmpty()
                ? "nothing"
                : requirements.stream()
                        .map((InRequirement r) -> RequirementWords.of(r))
                        .collect(Collectors.joining(", "));
    }

    private static String out(List<OutRequirement> requirements) {
        return requirements.isEmpty()
                ? "nothing"
                : requirements.stream()
                        .map((OutRequirement r) -> RequirementWords.of(r))
                        .collect(Collectors.joining(", "));
    }

    private static void named(String was, String is, List<String> changes) {
        if (!was.equals(is)) {
            changes.add("its name was \"" + was + "\"");
        }
    }

    private static void mode(Mode was, Mode is, List<String> changes) {
        if (was != is) {
            changes.add(is == Mode.RECOVERY ? "it is a recovery part now" : "it is a nominal part now");
        }
    }

    private static void locked(boolean was, boolean is, List<String> changes) {
        if (was != is) {
            changes.add(is ? "it is locked" : "it is not locked any more");
        }
    }

    private static <T> void parts(
            String kind,
            List<T> was,
            List<T> is,
            Function<T, String> id,
            Function<T, String> name,
            List<String> changes) {
        Map<String, T> earlier = new LinkedHashMap<>();
        was.forEach(each -> earlier.put(id.apply(each), each));
        boolean other = false;
        for (T each : is) {
            T old = earlier.remove(id.apply(each));
            if (old == null) {
                changes.add("the " + kind + name.apply(each) + " is new");
                other = true;
            } else if (!Objects.equals(old, each)) {
                changes.add("the " + kind + name.apply(each) + " has other settings");
            }
        }
        for (T each : earlier.values()) {
            changes.add("the " + kind + name.apply(each) + " is gone");
            other = true;
        }
        if (!other && !was.stream().map(id).toList().equals(is.stream().map(id).toList())) {
            changes.add("its events stand in another order");
        }
    }
}
