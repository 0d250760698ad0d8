package org.sami.dreamm.learn.show;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.lessons.script.ScriptElement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;

/** Says for an element of a script where an author's pointer would go: to the palette, to the net, to the inspector. Knows no window. */
final class ShowStops {
    private final Plan plan;

    private ShowStops(Plan plan) {
        this.plan = plan;
    }

    /**
     * The stops of an element, in order; none where it has no place of its own.
     *
     * @param plan the open plan before the edit
     */
    static List<ShowStop> of(ScriptElement element, Plan plan) {
        return new ShowStops(plan).of(element);
    }

    private List<ShowStop> of(ScriptElement element) {
        if (element instanceof ScriptElement.Add e) {
            List<ShowStop> stops = new ArrayList<>(List.of(new ShowStop.Item(e.item())));
            e.on().ifPresent(on -> stops.add(new ShowStop.Element(on)));
            e.at().filter(at -> e.on().isEmpty()).ifPresent(at -> stops.add(new ShowStop.Spot(at)));
            return stops;
        }
        if (element instanceof ScriptElement.Connect e) {
            return List.of(new ShowStop.Element(e.from()), new ShowStop.Element(e.to()));
        }
        if (element instanceof ScriptElement.Move e) {
            return List.of(new ShowStop.Element(e.what()), new ShowStop.Spot(e.at()));
        }
        if (element instanceof ScriptElement.Select e) {
            return elements(e.what());
        }
        if (element instanceof ScriptElement.Delete e) {
            return elements(e.what());
        }
        if (element instanceof ScriptElement.InMode e) {
            return elements(e.what());
        }
        return inInspector(element);
    }

    private List<ShowStop> inInspector(ScriptElement element) {
        if (element instanceof ScriptElement.Rename e) {
            return e.what().startsWith("@") ? ofPlan(variable(e.what())) : ofVertex(e.what(), "", "inspector-name");
        }
        if (element instanceof ScriptElement.Start e) {
            return ofVertex(e.what(), "", "inspector-start");
        }
        if (element instanceof ScriptElement.End e) {
            return ofVertex(e.what(), "", "inspector-end");
        }
        if (element instanceof ScriptElement.Waiting e) {
            return ofVertex(e.what(), "", "inspector-wait-for");
        }
        if (element instanceof ScriptElement.Require e) {
            String edge = edge(e.edge());
            return List.of(new ShowStop.Element(edge), new ShowStop.Editor(List.of(edge), "", "inspector-edge"));
        }
        if (element instanceof ScriptElement.Variable e) {
            return ofPlan(variable(e.name()));
        }
        if (element instanceof ScriptElement.Task e) {
            return ofPlan("task-" + e.name());
        }
        return ofEvent(element);
    }

    private List<ShowStop> ofEvent(ScriptElement element) {
        if (element instanceof ScriptElement.Field e) {
            return ofEvent(e.event(), field(e.field()));
        }
        if (element instanceof ScriptElement.Write e) {
            return ofEvent(e.event(), field(e.field()) + "-write");
        }
        if (element instanceof ScriptElement.SelectBy e) {
            return ofEvent(
                    e.event(),
                    Optional.of(e.fields().fieldNames())
                            .filter(names -> names.hasNext())
                            .map(names -> field(names.next()))
                            .orElse(""));
        }
        if (element instanceof ScriptElement.Markup e) {
            return ofEvent(e.event(), "event-markups");
        }
        if (element instanceof ScriptElement.SubMission e) {
            return ofEvent(e.what(), "");
        }
        return List.of();
    }

    private static List<ShowStop> elements(List<String> ids) {
        return ids.stream()
                .filter(id -> !id.startsWith("@"))
                .map(id -> (ShowStop) new ShowStop.Element(id))
                .toList();
    }

    private static List<ShowStop> ofPlan(String name) {
        return List.of(new ShowStop.Editor(List.of(), "inspector-plan", name));
    }

    private static String variable(String name) {
        return "variable-" + name.substring(1);
    }

    private static String field(String name) {
        return "field-" + name.replaceAll("([a-z0-9])([A-Z])", "$1-$2").toLowerCase(Locale.ROOT);
    }

    private static List<ShowStop> ofVertex(String vertex, String within, String name) {
        return List.of(new ShowStop.Element(vertex), new ShowStop.Editor(List.of(vertex), within, name));
    }

    private List<ShowStop> ofEvent(String event, String name) {
        for (Place place : plan.places()) {
            int output = index(place.outputs().stream().map(OutputEventSpec::id), event);
            int sub = index(place.subMissions().stream().map(SubMissionSpec::id), event);
            if (output >= 0 || sub >= 0) {
                return ofVertex(place.id(), output >= 0 ? "event-" + output : "sub-mission-" + sub, name);
            }
        }
        for (Transition transition : plan.transitions()) {
            int input = index(transition.inputs().stream().map(InputEventSpec::id), event);
            if (input >= 0) {
                return ofVertex(transition.id(), "event-" + input, name);
            }
        }
        return List.of();
    }

    private static int index(Stream<String> ids, String id) {
        return ids.toList().indexOf(id);
    }

    /** The id of an edge that a script may name by its ends. */
    private String edge(String name) {
        String close = name.replaceAll("\\s*>\\s*", ">");
        return plan.inEdges().stream()
                .filter(e -> (e.place() + ">" + e.transition()).equals(close))
                .map(e -> e.id())
                .findFirst()
                .or(() -> plan.outEdges().stream()
                        .filter(e -> (e.transition() + ">" + e.place()).equals(close))
                        .map(e -> e.id())
                        .findFirst())
                .orElse(name);
    }
}
